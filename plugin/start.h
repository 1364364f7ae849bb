// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_PLUGIN_START_H
#define BOOMERANG_PLUGIN_START_H

#include <atomic>

/// @file
/// How the library starts where the program does not call bmr::Install: it was preloaded, or BOOMERANG is on
/// or verify. When it is loaded it only looks; it installs itself at the program's first b2World::Step.

namespace bmr {

namespace internal {
/// Set when the library is loaded, cleared when it has started.
extern std::atomic<bool> startsByItself;
void StartNow();
} // namespace internal

/// The first line of b2World::Step. Whoever comes while another thread is starting waits for it.
inline void StartAtFirstStep() {
    if (internal::startsByItself.load(std::memory_order_acquire))
        internal::StartNow();
}

/// Is this library here because somebody preloaded it? It is if LD_PRELOAD names it, or if it was loaded with
/// the program although nothing that was loaded asks for it (/etc/ld.so.preload).
bool IsPreloaded();

} // namespace bmr

#endif
