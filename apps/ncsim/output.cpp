// SPDX-License-Identifier: GPL-3.0-or-later
#include "output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
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

// Writes to a file descriptor and remembers the first error: an ostream only knows that there
// was one.
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

// Temporary names for the signal handler, which may neither allocate nor lock: fixed room, written
// before the file appears and emptied after it has gone.
constexpr std::size_t kMaxFiles = 16;
constexpr std::size_t kMaxPath = 4096;
char pending[kMaxFiles][kMaxPath];

extern "C" void remove_pending_files(int signal_number) {
    for (auto& path : pending) {
        if (path[0] != 0) ::unlink(path);
    }
    ::signal(signal_number, SIG_DFL);
    ::raise(signal_number);
}

}  // namespace

struct OutputSet::File {
    std::string path;
    std::string temporary;  // empty: `path` is written directly
    int descriptor = -1;
    bool written = false;
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

OutputSet::OutputSet() {
    for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction old {};
        ::sigaction(signal_number, nullptr, &old);
        if (old.sa_handler == SIG_DFL) ::signal(signal_number, remove_pending_files);
    }
    // A closed pipe is an error to report like any other.
    ::signal(SIGPIPE, SIG_IGN);
}

OutputSet::~OutputSet() = default;

void OutputSet::reserve(const std::string& path) {
    if (path.empty()) return;
    auto file = std::make_unique<File>();
    file->path = path;
    struct stat status {};
    const bool exists = ::stat(path.c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) fail(path, "write", EISDIR);
    if (exists && !S_ISREG(status.st_mode)) {
        file->descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
        if (file->descriptor < 0) fail(path, "write", errno);
        files_.push_back(std::move(file));
        return;
    }
    if (exists && ::access(path.c_str(), W_OK) != 0) fail(path, "overwrite", errno);

    const std::size_t slash = path.rfind('/');
    const std::size_t name = slash == std::string::npos ? 0 : slash + 1;
    if (name == path.size()) fail(path, "write", EISDIR);
    // The process id tells runs apart; O_EXCL makes sure.
    for (int attempt = 0;; ++attempt) {
        file->temporary = fmt::format("{}.{}.{}-{}.tmp", path.substr(0, name), path.substr(name),
                                      ::getpid(), attempt);
        file->remember();
        file->descriptor =
            ::open(file->temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file->descriptor >= 0) break;
        const int error = errno;
        file->forget();
        file->temporary.clear();
        if (error != EEXIST || attempt == 100) fail(path, "write", error);
    }
    // What is overwritten keeps its permissions.
    if (exists) (void)::fchmod(file->descriptor, status.st_mode & 07777);
    files_.push_back(std::move(file));
}

void OutputSet::write(const std::string& path, const std::function<void(std::ostream&)>& writer) {
    if (path.empty()) return;
    const auto found = std::find_if(files_.begin(), files_.end(),
                                    [&path](const auto& f) { return f->path == path; });
    if (found == files_.end()) throw std::logic_error("an output was not reserved: " + path);
    File& file = **found;
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

void OutputSet::commit() {
    for (auto& file : files_) {
        if (!file->written || file->temporary.empty()) continue;
        if (::rename(file->temporary.c_str(), file->path.c_str()) != 0) {
            fail(file->path, "write", errno);
        }
        file->temporary.clear();
        file->forget();
    }
    files_.clear();
}

}  // namespace ncsim::app
