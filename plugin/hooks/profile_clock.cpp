// SPDX-License-Identifier: MIT
// b2Timer: Box2D reads the time of day several times in each island and each phase of a step, to fill
// b2Profile. Here the processor's time stamp is read instead where it counts at a constant rate, at about a
// third of the cost; its rate is measured against the monotonic clock. A timer that was started by Box2D's
// own clock is read by it. (Other platforms' timers hold other things, and are left alone.)
#include "hooks/profile_clock.h"

#include <atomic>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <mutex>

#include <box2d/b2_timer.h>

#include "base/compiler.h"
#include "reach/stock.h"
#include "start/process_locks.h"
#include "start/settings.h"

#if defined(BMR_TIMERS_ARE_REACHED)

#    if defined(__x86_64__)
#        include <cpuid.h>
#        include <x86intrin.h>
#    endif

namespace bmr::hooks {

namespace {

/// b2Timer's two words. Box2D keeps seconds and microseconds there.
struct TimerWords {
    unsigned long long ticks, mark;
};
static_assert(sizeof(TimerWords) == sizeof(b2Timer));

// No count of microseconds within a second.
constexpr unsigned long long kOurs = ~0ull;

#    if defined(__x86_64__)
uint64_t Ticks() {
    return __rdtsc();
}

bool TicksAreSteady() {
    constexpr unsigned kPowerLeaf = 0x80000007u, kInvariantTimeStamp = 1u << 8;
    unsigned a = 0, b = 0, c = 0, d = 0;
    return __get_cpuid(kPowerLeaf, &a, &b, &c, &d) != 0 && (d & kInvariantTimeStamp) != 0;
}
#    else
uint64_t Ticks() {
    return 0;
}

bool TicksAreSteady() {
    return false;
}
#    endif

/// The two clocks at one moment.
struct Moment {
    uint64_t ticks, nanoseconds;
    uint64_t error; ///< so many ticks may lie between the two, either way
};

/// The best of several readings, for threads are interrupted: the monotonic clock between two readings of the
/// other one, which is taken to be in the middle.
Moment ReadBoth() {
    constexpr int kTries = 8;
    Moment best = {0, 0, ~uint64_t{0}};
    for (int tries = 0; tries < kTries; ++tries) {
        timespec now;
        const uint64_t before = Ticks();
        clock_gettime(CLOCK_MONOTONIC, &now);
        const uint64_t half = (Ticks() - before) / 2;
        if (half < best.error)
            best = {before + half,
                    static_cast<uint64_t>(now.tv_sec) * 1000000000u + static_cast<uint64_t>(now.tv_nsec),
                    half};
    }
    return best;
}

/// How long a tick takes. Measured over all the time since the library was loaded, as soon as that is long
/// enough for the two readings' errors, and anew whenever it has doubled: of any time since then the error is
/// less than four readings'.
class Rate {
public:
    /// 0 where it is not known. `now` is what the ticks are at.
    double MillisecondsPerTick(uint64_t now) {
        if (now - m_first.load(std::memory_order_relaxed) >= m_next.load(std::memory_order_relaxed))
            Measure();
        return m_rate.load(std::memory_order_relaxed);
    }

    BMR_COLD void Measure() {
        const std::unique_lock<std::mutex> lock(LockOf(ProcessLock::Clock), std::try_to_lock);
        if (!lock.owns_lock())
            return; // another thread is at it
        if (!m_started) {
            m_started = true;
            if (!TicksAreSteady()) {
                m_next = kNever;
                return;
            }
            m_start = ReadBoth();
            m_first = m_start.ticks;
            m_next = kErrors * 2 * m_start.error;
            return;
        }
        const Moment now = ReadBoth();
        const uint64_t ticks = now.ticks - m_start.ticks, enough = kErrors * (m_start.error + now.error);
        if (static_cast<int64_t>(ticks) > 0 && ticks >= enough)
            m_rate = static_cast<double>(now.nanoseconds - m_start.nanoseconds) / static_cast<double>(ticks) *
                     1e-6;
        if (static_cast<int64_t>(ticks) > 0)
            m_next = 2 * ticks;
    }

private:
    static constexpr uint64_t kNever = ~uint64_t{0};
    // Right to one in 2,000. Where the clock is read in 50 nanoseconds it takes 100 microseconds: a program
    // that is long at loading and building its world has the rate when it steps it.
    static constexpr uint64_t kErrors = 2000;

    std::atomic<uint64_t> m_first{0}, m_next{0};
    std::atomic<double> m_rate{0.0};
    bool m_started = false;
    Moment m_start = {0, 0, 0};
};
Rate rate; // initialised at compile time: timers may be older than this library's constructors

/// With the hook on. `real`: Box2D's own function.
template <typename Real> BMR_NOINLINE void Start(b2Timer *timer, Real &real) {
    const uint64_t now = PassesRun() ? Ticks() : 0;
    if (now == 0 || rate.MillisecondsPerTick(now) <= 0.0) {
        real(timer);
        return;
    }
    const TimerWords words = {now, kOurs};
    std::memcpy(static_cast<void *>(timer), &words, sizeof words);
}

BMR_NOINLINE float Read(const b2Timer *timer) {
    // (Another Box2D's timer may be smaller: with the hook off nothing is read of it.)
    if (!PassesRun())
        return stock::GetMilliseconds(timer);
    TimerWords words;
    std::memcpy(&words, static_cast<const void *>(timer), sizeof words);
    if (words.mark != kOurs)
        return stock::GetMilliseconds(timer);
    const uint64_t now = Ticks();
    const auto ticks = static_cast<int64_t>(now - words.ticks);
    // Another core's stamp may be a few ticks behind.
    return ticks > 0 ? static_cast<float>(static_cast<double>(ticks) * rate.MillisecondsPerTick(now)) : 0.0f;
}

} // namespace

void StartProfileClock() {
    rate.Measure();
}

} // namespace bmr::hooks

using namespace bmr;
using namespace bmr::hooks;

BMR_FOR_LOADERS("_ZN7b2TimerC1Ev");
BMR_FOR_LOADERS("_ZN7b2TimerC2Ev");
BMR_FOR_LOADERS("_ZN7b2Timer5ResetEv");
BMR_FOR_LOADERS("_ZNK7b2Timer15GetMillisecondsEv");

// cppcheck-suppress uninitMemberVar ; what it holds is Box2D's to know
b2Timer::b2Timer() {
    if (NothingIsInstalled())
        stock::ConstructTimer(this);
    else
        Start(this, stock::ConstructTimer);
}

void b2Timer::Reset() {
    if (NothingIsInstalled())
        stock::ResetTimer(this);
    else
        Start(this, stock::ResetTimer);
}

float b2Timer::GetMilliseconds() const {
    return NothingIsInstalled() ? stock::GetMilliseconds(this) : Read(this);
}

#else

void bmr::hooks::StartProfileClock() {}

#endif
