// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the choice of a mutant before the constructors of the program.
#include "runtime.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

namespace ncsim_mutants {

int chosen = -1;
unsigned char* reached = nullptr;

namespace {

// Shares the file with this process and its children, so that no exit of a process loses bytes.
unsigned char* shared_bytes(const char* path) {
    const int file = ::open(path, O_RDWR);
    struct stat status {};
    if (file < 0 || ::fstat(file, &status) != 0) std::abort();
    void* bytes = ::mmap(nullptr, static_cast<std::size_t>(status.st_size), PROT_READ | PROT_WRITE,
                         MAP_SHARED, file, 0);
    ::close(file);
    if (bytes == MAP_FAILED) std::abort();
    return static_cast<unsigned char*>(bytes);
}

__attribute__((constructor(101))) void read_choice() {
    if (const char* number = std::getenv("NCSIM_MUTANT")) chosen = std::atoi(number);
    if (const char* path = std::getenv("NCSIM_MUTANTS_REACHED")) reached = shared_bytes(path);
}

}  // namespace

}  // namespace ncsim_mutants
