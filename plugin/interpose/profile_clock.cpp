// SPDX-License-Identifier: MIT
// b2Timer: Box2D reads the time of day several times in each island and each phase of a step, to fill
// b2Profile. Here the processor's time stamp is read instead where it counts at a constant rate, at about a
// third of the cost; its rate is measured against the monotonic clock. A timer that was started by Box2D's
// own clock is read by it.
#include <atomic>
#include <cstdint>
#include <ctime>
#include <mutex>

#include <box2d/b2_timer.h>

#include "process_locks.h"
#include "real.h"
#include "settings.h"

#if defined(__x86_64__)
#    include <cpuid.h>
#endif

namespace bmr::interpose {

/// b2Timer's two words. Box2D keeps seconds and microseconds there.
struct TimerWords {
    unsigned long long ticks, mark;
};
static_assert(sizeof(TimerWords) == sizeof(b2Timer));

namespace {

// No count of microseconds within a second.
constexpr unsigned long long kOurs = ~0ull;

Real<void(TimerWords *)> realConstruct("_ZN7b2TimerC1Ev");
Real<void(TimerWords *)> realConstructBase("_ZN7b2TimerC2Ev");
Real<void(TimerWords *)> realReset("_ZN7b2Timer5ResetEv");
Real<float(const TimerWords *)> realGetMilliseconds("_ZNK7b2Timer15GetMillisecondsEv");

#if defined(__x86_64__)
uint64_t Ticks() {
    return __builtin_ia32_rdtsc();
}

bool TicksAreSteady() {
    constexpr unsigned kPowerLeaf = 0x80000007u, kInvariantTimeStamp = 1u << 8;
    unsigned a = 0, b = 0, c = 0, d = 0;
    return __get_cpuid(kPowerLeaf, &a, &b, &c, &d) != 0 && (d & kInvariantTimeStamp) != 0;
}
#else
uint64_t Ticks() {
    return 0;
}

bool TicksAreSteady() {
    return false;
}
#endif

/// The two clocks at one moment.
struct Moment {
    uint64_t ticks, nanoseconds;
};

/// False where the thread was interrupted between the two readings, again and again.
bool ReadBoth(Moment *moment) {
    constexpr uint64_t kUninterrupted = 3000; // a microsecond
    for (int tries = 0; tries < 8; ++tries) {
        timespec now;
        const uint64_t before = Ticks();
        clock_gettime(CLOCK_MONOTONIC, &now);
        if (Ticks() - before < kUninterrupted) {
            *moment = {before,
                       static_cast<uint64_t>(now.tv_sec) * 1000000000u + static_cast<uint64_t>(now.tv_nsec)};
            return true;
        }
    }
    return false;
}

/// How long a tick takes. Not known for the first moments; from then on measured over all the time since the
/// first timer, anew whenever that has doubled: what a microsecond's reading error makes of any time since
/// then is less than two microseconds.
class Rate {
public:
    /// 0 where it is not known. `now` is what the ticks are at.
    double MillisecondsPerTick(uint64_t now) {
        if (now - m_first.load(std::memory_order_relaxed) >= m_next.load(std::memory_order_relaxed))
            Measure();
        return m_rate.load(std::memory_order_relaxed);
    }

private:
    static constexpr uint64_t kNever = ~uint64_t{0};
    // Twenty milliseconds: the first rate is right to one in 20,000.
    static constexpr uint64_t kShortest = 20000000;

    __attribute__((noinline, cold)) void Measure() {
        const std::unique_lock<std::mutex> lock(LockOf(ProcessLock::Clock), std::try_to_lock);
        if (!lock.owns_lock())
            return; // another thread is at it
        Moment now;
        if (!m_started) {
            m_started = true;
            if (!TicksAreSteady() || !ReadBoth(&m_start)) {
                m_next = kNever;
            } else {
                m_first = m_start.ticks;
                m_next = kShortest; // a tick is a nanosecond or less
            }
        } else if (ReadBoth(&now) && now.nanoseconds - m_start.nanoseconds >= kShortest) {
            const uint64_t ticks = now.ticks - m_start.ticks;
            m_rate = static_cast<double>(now.nanoseconds - m_start.nanoseconds) / static_cast<double>(ticks) *
                     1e-6;
            m_next = 2 * ticks;
        }
    }

    std::atomic<uint64_t> m_first{0}, m_next{0};
    std::atomic<double> m_rate{0.0};
    bool m_started = false;
    Moment m_start = {0, 0};
};
Rate rate; // initialised at compile time: timers may be older than this library's constructors

/// `real`: what Box2D does here.
void Start(TimerWords *timer, Real<void(TimerWords *)> &real) {
    const uint64_t now = HookIsOn(Hook::ProfileClock) ? Ticks() : 0;
    if (now == 0 || rate.MillisecondsPerTick(now) <= 0.0)
        real.Get()(timer);
    else
        *timer = {now, kOurs};
}

} // namespace

void Construct(TimerWords *timer) BMR_STANDS_FOR("_ZN7b2TimerC1Ev");
void ConstructBase(TimerWords *timer) BMR_STANDS_FOR("_ZN7b2TimerC2Ev");
void Reset(TimerWords *timer) BMR_STANDS_FOR("_ZN7b2Timer5ResetEv");
float GetMilliseconds(const TimerWords *timer) BMR_STANDS_FOR("_ZNK7b2Timer15GetMillisecondsEv");

void Construct(TimerWords *timer) {
    Start(timer, realConstruct);
}

void ConstructBase(TimerWords *timer) {
    Start(timer, realConstructBase);
}

void Reset(TimerWords *timer) {
    Start(timer, realReset);
}

float GetMilliseconds(const TimerWords *timer) {
    // (Another Box2D's timer may be smaller: with the hook off nothing is read of it.)
    if (!HookIsOn(Hook::ProfileClock) || timer->mark != kOurs)
        return realGetMilliseconds.Get()(timer);
    const uint64_t now = Ticks();
    const auto ticks = static_cast<int64_t>(now - timer->ticks);
    // Another core's stamp may be a few ticks behind.
    return ticks > 0 ? static_cast<float>(static_cast<double>(ticks) * rate.MillisecondsPerTick(now)) : 0.0f;
}

} // namespace bmr::interpose
