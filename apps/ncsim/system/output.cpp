// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes output files under temporary names.
#include "system/output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ostream>
#include <stdexcept>
#include <streambuf>
#include <system_error>
#include <utility>

namespace ncsim::app {

namespace {

[[noreturn]] void fail(const std::string& path, const char* what, int error) {
    throw std::runtime_error(
        fmt::format("cannot {} '{}': {}", what, path, std::generic_category().message(error)));
}

// Stream buffer on a file descriptor that remembers the first error code; an ostream has only a
// flag.
class DescriptorBuffer final : public std::streambuf {
public:
    explicit DescriptorBuffer(int descriptor) : descriptor_(descriptor) { reset(); }
    int error() const { return error_; }

protected:
    int_type overflow(int_type c) override {
        if (!drain()) return traits_type::eof();
        if (!traits_type::eq_int_type(c, traits_type::eof())) {
            *pptr() = traits_type::to_char_type(c);
            pbump(1);
        }
        return traits_type::not_eof(c);
    }
    int sync() override { return drain() ? 0 : -1; }

private:
    void reset() { setp(buffer_.data(), buffer_.data() + buffer_.size()); }

    bool drain() {
        const char* from = pbase();
        while (error_ == 0 && from != pptr()) {
            const ssize_t n = ::write(descriptor_, from, static_cast<std::size_t>(pptr() - from));
            if (n >= 0) {
                from += n;
            } else if (errno != EINTR) {
                error_ = errno;
            }
        }
        reset();
        return error_ == 0;
    }

    int descriptor_;
    int error_ = 0;
    std::array<char, 1 << 16> buffer_{};
};

// Temporary names for the signal handler, which may neither allocate nor lock: fixed memory,
// written before the file is created and cleared after the file is removed.
constexpr std::size_t kMaxFiles = 16;
constexpr std::size_t kMaxPath = 4096;
char pending[kMaxFiles][kMaxPath];

// True if the standard stream `stream` leads to a file of this `status`. Devices that are no
// terminal (/dev/null) do not count, because several writers do not conflict there.
bool leads_to(int stream, const struct stat& status) {
    struct stat ours {};
    if (::fstat(stream, &ours) != 0) return false;
    if (S_ISCHR(ours.st_mode) && ::isatty(stream) == 0) return false;
    return setup::id_of(ours) == setup::id_of(status);
}

extern "C" void remove_pending_files(int signal_number) {
    for (auto& path : pending) {
        if (path[0] != 0) ::unlink(path);
    }
    ::signal(signal_number, SIG_DFL);
    ::raise(signal_number);
}

}  // namespace

struct OutputSet::File {
    std::string path;       // as named by the user
    std::string target;     // without links
    std::string temporary;  // empty: written directly
    int descriptor = -1;
    bool written = false;
    bool is_new = false;  // Does not replace a file.
    std::size_t slot = kMaxFiles;

    File() = default;
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() {
        if (descriptor >= 0) ::close(descriptor);
        if (!temporary.empty()) ::unlink(temporary.c_str());
        forget();
    }

    void remember() {
        for (slot = 0; slot < kMaxFiles; ++slot) {
            if (pending[slot][0] == 0) break;
        }
        if (slot < kMaxFiles && temporary.size() < kMaxPath) {
            std::memcpy(pending[slot], temporary.c_str(), temporary.size() + 1);
        }
    }
    void forget() {
        if (slot < kMaxFiles) pending[slot][0] = 0;
        slot = kMaxFiles;
    }
};

OutputSet::OutputSet(setup::InputSet& inputs) : inputs_(&inputs) {
    for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction old {};
        ::sigaction(signal_number, nullptr, &old);
        if (old.sa_handler == SIG_DFL) ::signal(signal_number, remove_pending_files);
    }
    // A closed pipe is reported like every error.
    ::signal(SIGPIPE, SIG_IGN);
}

OutputSet::~OutputSet() = default;

void OutputSet::claim_standard_output(const std::string& what) {
    if (!standard_output_.empty()) {
        throw std::runtime_error(fmt::format("the standard output can be one of them: '{}' or '{}'",
                                             standard_output_, what));
    }
    standard_output_ = what;
}

void OutputSet::add(const std::string& path, const setup::FileId& id) {
    if (!ids_.insert(id).second) {
        throw std::runtime_error(fmt::format(
            "'{}' is named twice: an output may overwrite neither an input nor another output",
            path));
    }
    inputs_->forbid(path, id);
}

// Takes ownership of the descriptor, which is written directly.
void OutputSet::open_directly(File& file, int descriptor) {
    if (descriptor < 0) fail(file.path, "write", errno);
    file.descriptor = descriptor;
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) fail(file.path, "write", errno);
    if (S_ISDIR(status.st_mode)) fail(file.path, "write", EISDIR);
    if (leads_to(STDOUT_FILENO, status)) {
        claim_standard_output(file.path);
        takes_standard_output_ = true;
    }
    if (S_ISREG(status.st_mode)) add(file.path, setup::id_of(status));
}

std::unique_ptr<OutputSet::File> OutputSet::opened(const std::string& path) {
    auto file = std::make_unique<File>();
    file->path = path;
    if (path == "-") {
        // The standard output may be a device that leads_to() does not recognise.
        claim_standard_output(path);
        takes_standard_output_ = true;
        file->descriptor = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
        if (file->descriptor < 0) fail(path, "write", errno);
        struct stat status {};
        if (::fstat(file->descriptor, &status) == 0 && S_ISREG(status.st_mode))
            add(path, setup::id_of(status));
        return file;
    }
    file->target = setup::without_links(path);
    const std::string& target = file->target;
    struct stat status {};
    const bool exists = ::stat(target.c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) fail(path, "write", EISDIR);
    if (const int ours = setup::descriptor_named(target); ours >= 0) {
        open_directly(*file, ::fcntl(ours, F_DUPFD_CLOEXEC, 3));
        return file;
    }
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
        if (!exists || !leads_to(stream, status)) continue;
        open_directly(*file, ::fcntl(stream, F_DUPFD_CLOEXEC, 3));
        return file;
    }
    if (exists && !S_ISREG(status.st_mode)) {
        open_directly(*file, ::open(target.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
        return file;
    }
    if (exists && ::access(target.c_str(), W_OK) != 0) fail(path, "overwrite", errno);

    const std::size_t slash = target.rfind('/');
    const std::size_t name = slash == std::string::npos ? 0 : slash + 1;
    if (name == target.size()) fail(path, "write", EISDIR);
    add(path, exists ? setup::id_of(status) : setup::id_of_new(target));
    // The process id distinguishes runs; O_EXCL guarantees uniqueness.
    for (int attempt = 0;; ++attempt) {
        file->temporary = fmt::format("{}.{}.{}-{}.tmp", target.substr(0, name),
                                      target.substr(name), ::getpid(), attempt);
        file->remember();
        file->descriptor =
            ::open(file->temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file->descriptor >= 0) break;
        const int error = errno;
        file->forget();
        file->temporary.clear();
        if (error != EEXIST || attempt == 100) fail(path, "write", error);
    }
    // An overwritten file keeps its permissions.
    if (exists) (void)::fchmod(file->descriptor, status.st_mode & 07777);
    return file;
}

void OutputSet::reserve(const std::string& path) {
    if (!path.empty()) files_.push_back(opened(path));
}

void OutputSet::reserve_new(const std::string& path) {
    struct stat status {};
    if (::lstat(path.c_str(), &status) == 0)
        throw std::runtime_error(fmt::format("'{}' exists and is not replaced", path));
    files_.push_back(opened(path));
    files_.back()->is_new = true;
}

void OutputSet::fill(File& file, const std::function<void(std::ostream&)>& writer) {
    const std::string& path = file.path;
    // Earlier output stays before this output.
    (void)std::fflush(stdout);
    DescriptorBuffer buffer(file.descriptor);
    std::ostream out(&buffer);
    try {
        writer(out);
    } catch (...) {
        if (buffer.error() != 0) fail(path, "write", buffer.error());
        throw;
    }
    out.flush();
    if (buffer.error() != 0) fail(path, "write", buffer.error());
    if (!file.temporary.empty() && ::fsync(file.descriptor) != 0) fail(path, "write", errno);
    const int descriptor = std::exchange(file.descriptor, -1);
    if (::close(descriptor) != 0) fail(path, "write", errno);
    file.written = true;
}

void OutputSet::name(File& file) {
    if (!file.written || file.temporary.empty()) return;
    if (file.is_new) {  // Unlike rename(), link() does not replace a file.
        if (::link(file.temporary.c_str(), file.target.c_str()) != 0)
            fail(file.path, "write", errno);
        return;
    }
    if (::rename(file.temporary.c_str(), file.target.c_str()) != 0) fail(file.path, "write", errno);
    file.temporary.clear();
    file.forget();
}

void OutputSet::write(const std::string& path, const std::function<void(std::ostream&)>& writer) {
    if (path.empty()) return;
    // A device may be named twice.
    const auto found = std::find_if(files_.begin(), files_.end(), [&path](const auto& f) {
        return f->path == path && !f->written;
    });
    if (found == files_.end()) throw std::logic_error("an output was not reserved: " + path);
    inputs_->check();
    fill(**found, writer);
}

void OutputSet::commit() {
    inputs_->check();
    for (auto& file : files_)
        name(*file);
    files_.clear();
}

void OutputSet::write_now(const std::string& path,
                          const std::function<void(std::ostream&)>& writer) {
    const std::unique_ptr<File> file = opened(path);
    fill(*file, writer);
    inputs_->check();
    name(*file);
}

}  // namespace ncsim::app
