// SPDX-License-Identifier: MIT
#include "start/this_process.h"

#include <atomic>

#if defined(_WIN32)
#    include <process.h>
#else
#    include <pthread.h>
#    include <unistd.h>
#endif

namespace bmr {

namespace {

std::atomic<bool> announced{false};

} // namespace

long ThisProcess() {
#if defined(_WIN32)
    return _getpid();
#else
    return getpid();
#endif
}

void CallWhenForked([[maybe_unused]] void (*function)()) {
#if !defined(_WIN32) // which does not fork
    pthread_atfork(nullptr, nullptr, function);
#endif
}

bool ClaimAnnouncement() {
    return !announced.exchange(true);
}

bool IsAnnounced() {
    return announced.load();
}

} // namespace bmr
