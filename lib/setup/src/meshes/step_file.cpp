// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs ncsim-step and reads the result.
#include "meshes/step_file.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

namespace ncsim::setup {

namespace {

// Limits for ncsim-step: more than any part needs, and bearable on a shared computer.
constexpr rlim_t kMostSeconds = 600, kMostBytes = rlim_t{8'000'000'000};

[[noreturn]] void refuse(const std::string& why) {
    throw std::runtime_error(why);
}

// Returns the path of ncsim-step: next to the running program, or in the package's libexec.
std::optional<std::string> reader() {
    std::error_code error;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error) return std::nullopt;
    for (const char* place : {"ncsim-step", "../libexec/ncsim/ncsim-step"}) {
        const std::filesystem::path path = self.parent_path() / place;
        if (::access(path.c_str(), X_OK) == 0) return path.string();
    }
    return std::nullopt;
}

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

File temporary() {
    File file(std::tmpfile());
    if (!file) refuse(fmt::format("no temporary file: {}", std::strerror(errno)));
    return file;
}

std::string all_of(std::FILE* file) {
    std::string bytes;
    std::rewind(file);
    std::array<char, 1 << 16> buffer{};
    for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), file)) > 0;)
        bytes.append(buffer.data(), n);
    return bytes;
}

// Runs `program` with standard input `in` and standard output `out`. After fork(), only functions
// that are allowed there are called.
int run(const std::string& program, const std::string& argument, std::FILE* in, std::FILE* out) {
    std::string first = program, second = argument;
    std::array<char*, 3> words{first.data(), second.data(), nullptr};
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child < 0) refuse(fmt::format("cannot run ncsim-step: {}", std::strerror(errno)));
    if (child == 0) {
#ifdef __linux__
        // Kills ncsim-step if the waiting process is killed.
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
        if (::getppid() != parent) ::_exit(127);
        const auto limit = [](auto what, rlim_t most) {
            const rlimit both{most, most};
            ::setrlimit(what, &both);
        };
        limit(RLIMIT_CPU, kMostSeconds);
        limit(RLIMIT_AS, kMostBytes);
        limit(RLIMIT_CORE, 0);
        if (::dup2(::fileno(in), STDIN_FILENO) >= 0 && ::dup2(::fileno(out), STDOUT_FILENO) >= 0)
            ::execv(words[0], words.data());
        ::_exit(127);
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) refuse(fmt::format("lost ncsim-step: {}", std::strerror(errno)));
    }
    return status;
}

// Reader of the result: lines of a head, then bytes.
class Reading {
public:
    explicit Reading(std::string_view text) : text_(text) {}

    std::string_view line() {
        const std::size_t end = text_.find('\n');
        if (end == std::string_view::npos) refuse("ncsim-step did not finish");
        const std::string_view line = text_.substr(0, end);
        text_.remove_prefix(end + 1);
        return line;
    }
    std::size_t count(std::string_view key) {
        const std::string_view text = line();
        std::size_t count = 0;
        if (!text.starts_with(key) || text.size() < key.size() + 2 ||
            std::from_chars(text.data() + key.size() + 1, text.data() + text.size(), count).ec !=
                std::errc{})
            refuse("ncsim-step is of another version");
        return count;
    }
    template <typename T>
    void take(std::vector<T>& values, std::size_t count) {
        if (text_.size() / sizeof(T) < count) refuse("ncsim-step did not finish");
        values.resize(count);
        if (count > 0) std::memcpy(values.data(), text_.data(), count * sizeof(T));
        text_.remove_prefix(count * sizeof(T));
    }

private:
    std::string_view text_;
};

StepSurface surface_in(std::string_view text) {
    Reading reading(text);
    if (reading.line() != "NCSIM-STEP 1") refuse("ncsim-step is of another version");
    reading.line();  // the unit; lengths are in mm already
    reading.count("solids");
    const std::size_t vertices = reading.count("vertices");
    const std::size_t triangles = reading.count("triangles");
    const std::size_t faces = reading.count("faces");
    StepSurface surface;
    for (std::size_t i = 0; i < faces; ++i)
        surface.face_names.emplace_back(reading.line());
    std::vector<double> places;
    reading.take(places, 3 * vertices);
    for (std::size_t i = 0; i < vertices; ++i)
        surface.mesh.vertices.push_back({places[3 * i], places[3 * i + 1], places[3 * i + 2]});
    std::vector<std::uint32_t> corners;
    reading.take(corners, 4 * triangles);
    for (std::size_t i = 0; i < triangles; ++i) {
        const std::uint32_t* t = &corners[4 * i];
        if (t[0] >= vertices || t[1] >= vertices || t[2] >= vertices || t[3] >= faces)
            refuse("ncsim-step is of another version");
        surface.mesh.triangles.push_back({t[0], t[1], t[2]});
        surface.mesh.face.push_back(t[3]);
    }
    return surface;
}

}  // namespace

bool is_step(std::string_view bytes) {
    const std::size_t begin = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return begin != std::string_view::npos && bytes.substr(begin).starts_with("ISO-10303-21");
}

StepSurface read_step(const std::string& bytes, double deflection_mm) {
    const auto program = reader();
    if (!program) {
        refuse(
            "it is STEP, which this ncsim cannot read: there is no ncsim-step, which is made "
            "where CMake finds OpenCASCADE; STL and binary glTF can be read");
    }
    // OpenCASCADE would read an incomplete file up to the end of the data.
    if (bytes.find("END-ISO-10303-21") == std::string::npos)
        refuse("it is STEP that does not end: END-ISO-10303-21 is missing");
    const File in = temporary(), out = temporary();
    if (std::fwrite(bytes.data(), 1, bytes.size(), in.get()) != bytes.size() ||
        std::fflush(in.get()) != 0)
        refuse(fmt::format("no temporary file: {}", std::strerror(errno)));
    std::rewind(in.get());
    const int status = run(*program, fmt::format("{}", deflection_mm), in.get(), out.get());
    const std::string said = all_of(out.get());
    if (WIFSIGNALED(status)) {
        refuse(WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL
                   ? fmt::format("it is STEP that takes more than {} s to read", kMostSeconds)
                   : std::string("it is STEP that OpenCASCADE cannot bear: it crashed"));
    }
    constexpr std::string_view kError = "error ";
    if (said.starts_with(kError)) {
        const std::string_view what = std::string_view(said).substr(kError.size());
        refuse(std::string(what.substr(0, what.find('\n'))));
    }
    if (WEXITSTATUS(status) != 0) refuse("ncsim-step failed: memory may have run out");
    return surface_in(said);
}

}  // namespace ncsim::setup
