// SPDX-License-Identifier: MIT
#include "debug/event.h"

#include "start/settings.h"

namespace bmr {

namespace {
internal::AnswerObserver answerObserver = nullptr;
} // namespace

void TellOfEvent(const b2Body *bodyA, const b2Body *bodyB, const bmr_event &event) {
    const Options &options = GetSettings().options;
    GetCounts().events[event.kind].fetch_add(1, std::memory_order_relaxed);
    if (options.onEvent != nullptr)
        options.onEvent(options.eventContext, bodyA, bodyB, event);
}

void TellOfAnswer(const b2Contact &contact, Answer answer, bool here) {
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

} // namespace bmr
