// SPDX-License-Identifier: GPL-3.0-or-later
//
// Temporary folders, and processes with captured output.
#include "cli/run_program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace ncsim::cli_test {

namespace {

std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

Folder::Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "ncsim-cli-XXXXXX").string();
    if (!::mkdtemp(pattern.data())) throw std::runtime_error("mkdtemp failed");
    path_ = pattern;
}

Folder::~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

void Folder::write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
}

std::string Folder::read(const std::string& name) const {
    return contents(path_ / name);
}

std::string Folder::read_cells(const std::string& name) const {
    std::istringstream lines(read(name));
    std::string cells;
    for (std::string line; std::getline(lines, line);) {
        const std::string word = line.substr(0, line.find(' '));
        if (word != "assumed" && word != "source" && word != "surface" && word != "origin")
            cells += line + '\n';
    }
    return cells;
}

bool Folder::has(const std::string& name) const {
    return std::filesystem::exists(path_ / name);
}

std::vector<std::string> Folder::files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

Ran Folder::run(const std::vector<std::string>& arguments) const {
    std::vector<std::string> words{NCSIM_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return execute(std::move(words));
}

Ran Folder::shell(const std::string& script) const {
    return execute({"/bin/sh", "-c", script, NCSIM_PROGRAM});
}

Ran Folder::execute(std::vector<std::string> words) const {
    // Next to the folder and not inside, so files() returns only files that the program made.
    const std::string out = path_.string() + ".out";
    const std::string err = path_.string() + ".err";
    const pid_t child = ::fork();
    if (child == 0) {
        std::vector<char*> argv;
        for (std::string& word : words)
            argv.push_back(word.data());
        argv.push_back(nullptr);
        const int out_fd = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        const int err_fd = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        const int in_fd = ::open("/dev/null", O_RDONLY);
        ::dup2(in_fd, 0), ::dup2(out_fd, 1), ::dup2(err_fd, 2);
        if (::chdir(path_.c_str()) == 0) ::execv(argv[0], argv.data());
        ::_exit(127);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    Ran ran;
    ran.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ran.out = contents(out);
    ran.err = contents(err);
    std::filesystem::remove(out);
    std::filesystem::remove(err);
    return ran;
}

}  // namespace ncsim::cli_test
