// SPDX-License-Identifier: MIT
#include "current_step.h"

#include <atomic>

namespace bmr {

namespace {
std::atomic<uint64_t> begun{0};
}

uint64_t NextStep() {
    return begun.fetch_add(1, std::memory_order_relaxed) + 1;
}

} // namespace bmr
