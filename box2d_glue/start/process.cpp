// SPDX-License-Identifier: MIT
#include "start/process.h"

#include <atomic>
#include <cstring>
#include <new>

#if defined(_WIN32) // which does not fork
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

namespace {
std::atomic<const void *> tableOfRecorders{nullptr};
int recorders = 0; ///< alive, of this table
} // namespace

namespace internal {

void TrustListener(const void *table, int change) {
    const HoldsProcessLock lock(ProcessLock::Data);
    const void *const known = tableOfRecorders.load(std::memory_order_relaxed);
    if (known != nullptr && known != table)
        return;
    recorders += change;
    tableOfRecorders.store(recorders > 0 ? table : nullptr, std::memory_order_relaxed);
}

} // namespace internal

bool IsRecorder(const b2ContactListener &listener) {
    const void *table;
    std::memcpy(&table, static_cast<const void *>(&listener), sizeof table);
    return table == tableOfRecorders.load(std::memory_order_relaxed);
}

} // namespace bmr
