// SPDX-License-Identifier: MIT
// A plugin that changes nothing but how the game ends.
#include <cstdio>

#include <unistd.h>

namespace {

__attribute__((destructor)) void End() {
    std::fflush(stdout);
    _exit(3);
}

} // namespace
