// SPDX-License-Identifier: MIT
#include "debug/statistics.h"

#include <atomic>
#include <chrono>
#include <cinttypes>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#if !defined(_WIN32)
#    include <unistd.h>
#endif

#include "boomerang/box2d_glue.h"
#include "start/install.h"
#include "start/settings.h"

namespace bmr {

namespace {
internal::AnswerObserver answerObserver = nullptr;
} // namespace

void ReportEvent(const b2Body *bodyA, const b2Body *bodyB, const bmr_event &event) {
    const Options &options = GetSettings().options;
    GetCounts().events[event.kind].fetch_add(1, std::memory_order_relaxed);
    if (options.onEvent != nullptr)
        options.onEvent(options.eventContext, bodyA, bodyB, event);
}

void ReportAnswer(const b2Contact &contact, Answer answer, bool here) {
    Count(&Counts::evaluations);
    Count(IsApart(answer) ? &Counts::provedApart : &Counts::handedOver);
    if (!IsApart(answer) && here)
        Count(&Counts::touchingAnswered);
    if (answer == Answer::Touching)
        Count(&Counts::handedOverTouching);
    if (answerObserver != nullptr)
        answerObserver(contact, answer);
}

void internal::ObserveAnswers(AnswerObserver observer) {
    answerObserver = observer;
}

bool AnswersAreObserved() {
    return answerObserver != nullptr;
}

Counted internal::ReadCounts() {
    Counted read;
    const Counts &counts = GetCounts();
    VisitCounts([](const char *, uint64_t &to, const auto &from) { to = from; }, read, counts);
    for (int kind = 0; kind < BMR_EVENT_KIND_COUNT; ++kind)
        read.events[kind] = counts.events[kind];
    return read;
}

// The line at exit.

bool internal::timesSteps = false;

namespace {

BMR_THREAD bool inStep = false;
bool linesAreWanted = false;
std::atomic<uint64_t> steps{0}, nanoseconds{0};
std::atomic<bool> lineIsSaid{false}, hasStepped{false};
/// Of the process that says it: the one that took the first step, or, where none did, that wanted it said.
/// One that was forked afterwards has its parent's counts, and says nothing.
std::atomic<long> speaker{0};
uint64_t mostSteps = ~uint64_t{0};

constexpr int kMostCalls = 4;
std::atomic<int> callCount{0};
std::atomic<void (*)()> calls[kMostCalls];

int64_t Now() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

long ThisProcess() {
#if defined(_WIN32) // which does not fork
    return 0;
#else
    return getpid();
#endif
}

void SayLine() {
    const auto count = static_cast<double>(steps);
    if (count == 0.0 || lineIsSaid.exchange(true))
        return;
    std::fprintf(stderr, "boomerang: %.0f steps, %.2f us each\n", count,
                 1e-3 * static_cast<double>(nanoseconds) / count);
}

void CallAll() {
    for (int i = speaker == ThisProcess() ? callCount.load() : 0; i-- > 0;)
        if (void (*const call)() = calls[i].exchange(nullptr))
            call();
}

#if !defined(_WIN32)

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

/// The signal's own work is done when this returns.
void EndBySignal(int number) {
    CallAll();
    std::signal(number, SIG_DFL);
    std::raise(number);
}

void Replace(void (*before)(int), void (*after)(int)) {
    for (const int number : kSignals) {
        struct sigaction handled = {};
        if (sigaction(number, nullptr, &handled) == 0 && (handled.sa_flags & SA_SIGINFO) == 0 &&
            handled.sa_handler == before)
            std::signal(number, after);
    }
}

/// The library may be closed before the process ends.
void EndAtExit() {
    CallAll();
    Replace(EndBySignal, SIG_DFL);
}

void WatchForSignals() {
    Replace(SIG_DFL, EndBySignal);
}

#else

void EndAtExit() {
    CallAll();
}
void WatchForSignals() {}

#endif

void WriteCounts() {
    std::FILE *const file =
        IsInstalled() ? std::fopen(ReadEnvironment("BOOMERANG_COUNTS").data(), "w") : nullptr;
    if (file == nullptr)
        return;
    const Counted counted = internal::ReadCounts();
    VisitCounts(
        [file](const char *name, uint64_t count) { std::fprintf(file, "%s %" PRIu64 "\n", name, count); },
        counted);
    std::fprintf(file, "way %s %s\n", TheWay(), VersionOfBox2D());
    std::fclose(file);
}

} // namespace

void CallAtEnd(void (*say)()) {
    if (callCount == 0) {
        speaker = ThisProcess();
        std::atexit(EndAtExit);
    }
    const int place = callCount++;
    if (place < kMostCalls)
        calls[place] = say;
}

void TimeSteps() {
    if (linesAreWanted)
        return;
    const std::string_view most = ReadEnvironment("BOOMERANG_STEPS");
    if (const uint64_t number = most.empty() ? 0 : std::strtoull(most.data(), nullptr, 10); number > 0)
        mostSteps = number;
    CallAtEnd(SayLine);
    linesAreWanted = internal::timesSteps = true;
}

void ReadVerbosity() {
    if (IsVerbose())
        TimeSteps();
    [[maybe_unused]] static const bool once = [] {
        if (CountsAreWanted()) {
            CallAtEnd(WriteCounts);
            internal::timesSteps = true;
        }
        return true;
    }();
}

bool CountsAreWanted() {
    return !ReadEnvironment("BOOMERANG_COUNTS").empty();
}

TimedStep::TimedStep() : m_begin(Now()), m_outermost(!inStep) {
    inStep = true;
    if (hasStepped.load(std::memory_order_relaxed) || hasStepped.exchange(true))
        return;
    speaker = ThisProcess();
    WatchForSignals();
}

TimedStep::~TimedStep() {
    if (!m_outermost)
        return;
    inStep = false;
    if (steps.load(std::memory_order_relaxed) >= mostSteps)
        return;
    nanoseconds.fetch_add(static_cast<uint64_t>(Now() - m_begin), std::memory_order_relaxed);
    if (steps.fetch_add(1, std::memory_order_relaxed) + 1 == mostSteps)
        SayLine();
}

} // namespace bmr
