// SPDX-License-Identifier: MIT
#include "start/process_lock.h"

#include <new>

#if !defined(_WIN32) // which does not fork
#    include <pthread.h>
#endif

namespace bmr {

namespace {

constexpr int kCount = static_cast<int>(ProcessLock::Count);
std::recursive_mutex locks[kCount];

#if !defined(_WIN32)

void TakeAll() {
    for (std::recursive_mutex &lock : locks)
        lock.lock();
}

void GiveAllBack() {
    for (int i = kCount; i-- > 0;)
        locks[i].unlock();
}

/// In the child, whose one thread has another number than the one that took them.
void MakeAnew() {
    for (std::recursive_mutex &lock : locks) {
        lock.unlock(); // refused, for that number; but the thread sanitizer counts it
        new (&lock) std::recursive_mutex();
    }
}

[[maybe_unused]] const int watching = pthread_atfork(TakeAll, GiveAllBack, MakeAnew);

#endif

} // namespace

std::recursive_mutex &LockOf(ProcessLock which) {
    return locks[static_cast<int>(which)];
}

} // namespace bmr
