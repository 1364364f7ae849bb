// SPDX-License-Identifier: MIT
#include "start/this_process.h"

#include <atomic>
#include <new>

#if defined(_WIN32)
#    include <process.h>
#else
#    include <pthread.h>
#    include <sys/mman.h>
#    include <unistd.h>
#endif

namespace bmr {

namespace {

using Flag = std::atomic<bool>;
Flag ownFlag{false};
Flag *announced = &ownFlag;

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
    return !announced->exchange(true);
}

bool IsAnnounced() {
    return announced->load();
}

void ShareAnnouncement() {
#if !defined(_WIN32) // which does not fork
    void *page = mmap(nullptr, sizeof(Flag), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page != MAP_FAILED)
        announced = new (page) Flag(false);
#endif
}

} // namespace bmr
