// SPDX-License-Identifier: MIT
#include "start/process_lock.h"

#include <new>

#if !defined(_WIN32) // which does not fork
#    include <pthread.h>
#endif

namespace bmr {

namespace {

std::recursive_mutex lock;

#if !defined(_WIN32)

void Take() {
    lock.lock();
}

void GiveBack() {
    lock.unlock();
}

/// In the child, whose one thread has another number than the one that took it.
void MakeAnew() {
    new (&lock) std::recursive_mutex();
}

[[maybe_unused]] const int watching = pthread_atfork(Take, GiveBack, MakeAnew);

#endif

} // namespace

std::recursive_mutex &ProcessLock() {
    return lock;
}

} // namespace bmr
