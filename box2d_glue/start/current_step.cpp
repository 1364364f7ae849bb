// SPDX-License-Identifier: MIT
#include "start/current_step.h"

#include <atomic>

#include "base/rounding_mode.h"

namespace bmr {

namespace {
std::atomic<uint64_t> begun{0};
thread_local uint32_t stepsUnderWay = 0;
} // namespace

uint64_t NextStep() {
    // Each thread takes many at a time: threads that step small worlds would wait for each other otherwise.
    constexpr uint64_t kAtOnce = 1024;
    static thread_local uint64_t last = 0;
    if (last % kAtOnce == 0)
        last = begun.fetch_add(kAtOnce, std::memory_order_relaxed);
    return ++last;
}

StepUnderWay::StepUnderWay() {
    ++stepsUnderWay;
    LatestStep() = CurrentStep() = NextStep();
    GameRan() = IsInner();
    StepIsToNearest() = CurrentRounding() == kToNearest;
}

StepUnderWay::~StepUnderWay() {
    if (stepsUnderWay > 0) // (A stack may go on with another thread.)
        --stepsUnderWay;
    CurrentStep() = 0;
    GameRan() = true;
    StepIsToNearest() = false;
}

bool StepUnderWay::IsInner() {
    return stepsUnderWay > 1;
}

} // namespace bmr
