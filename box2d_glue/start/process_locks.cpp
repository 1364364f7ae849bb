// SPDX-License-Identifier: MIT
#include "start/process_locks.h"

#if !defined(_WIN32) // which does not fork
#    include <pthread.h>
#endif

namespace bmr {

namespace {

constexpr int kCount = static_cast<int>(ProcessLock::Count);
std::mutex locks[kCount];

#if !defined(_WIN32)

void TakeAll() {
    for (std::mutex &lock : locks)
        lock.lock();
}

/// In the parent and in the child, whose one thread is the one that took them.
void GiveAllBack() {
    for (int i = kCount; i-- > 0;)
        locks[i].unlock();
}

[[maybe_unused]] const int watching = pthread_atfork(TakeAll, GiveAllBack, GiveAllBack);

#endif

} // namespace

std::mutex &LockOf(ProcessLock which) {
    return locks[static_cast<int>(which)];
}

} // namespace bmr
