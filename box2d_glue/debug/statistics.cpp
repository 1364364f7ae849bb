// SPDX-License-Identifier: MIT
#include "debug/statistics.h"

#include <algorithm>
#include <iterator>

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
    Count(answer < Answer::HandedOver ? &Counts::provedApart : &Counts::handedOver);
    if (answer >= Answer::HandedOver && here)
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

Presence GetPresence() {
    Presence presence;
    presence.way = TheWay();
    presence.box2d = VersionOfBox2D();
    if (const char *const why = WhyRefused())
        presence.whyNot = why;
    return presence;
}

Counted internal::ReadCounts() {
    Counted read;
    const Counts &counts = GetCounts();
    VisitCounts([](const char *, uint64_t &to, const auto &from) { to = from; }, read, counts);
    for (int kind = 0; kind < BMR_EVENT_KIND_COUNT; ++kind)
        read.events[kind] = counts.events[kind];
    return read;
}

Statistics GetStatistics() {
    const Counted counted = internal::ReadCounts();
    Statistics s;
    s.steps = counted.steps;
    s.pairs = counted.pairs;
    s.looks = counted.looks;
    s.renewals = counted.renewals;
    std::copy(std::begin(counted.events), std::end(counted.events), s.events);
    s.verified = counted.verified;
    s.differences = counted.differences;
    return s;
}

} // namespace bmr
