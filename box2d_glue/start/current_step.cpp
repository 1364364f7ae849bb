// SPDX-License-Identifier: MIT
#include "start/current_step.h"

#include <atomic>

namespace bmr {

namespace {
std::atomic<uint64_t> begun{0};
}

uint64_t NextStep() {
    // Each thread takes many at a time: threads that step small worlds would wait for each other otherwise.
    constexpr uint64_t kAtOnce = 1024;
    static thread_local uint64_t last = 0;
    if (last % kAtOnce == 0)
        last = begun.fetch_add(kAtOnce, std::memory_order_relaxed);
    return ++last;
}

} // namespace bmr
