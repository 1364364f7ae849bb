// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_STATISTICS_H
#define BOOMERANG_GLUE_STATISTICS_H

#include <atomic>
#include <cstdint>

#include "base/compiler.h"
#include "boomerang/box2d_glue.h"
#include "boomerang/pair.h"

/// @file
/// What is counted of the work, for the tests and the testbed.

namespace bmr {

/// What has been done since the process began, summed over all worlds and threads. Written only where
/// Options::statistics asks for it; steps, verified and differences in Mode::Verify too.
template <typename Number> struct CountsOf {
    Number steps{0}; ///< calls of b2World::Step
    /// Times Box2D asked for a manifold of two polygons, or of a big ConvexShape with anything.
    Number evaluations{0};
    Number edgeChecks{0};         ///< remembered edges re-tested
    Number verdictsReused{0};     ///< answers of a body pair given again at the same poses
    Number provedApart{0};        ///< evaluations answered without Box2D
    Number handedOver{0};         ///< evaluations that needed a manifold, made here or by Box2D
    Number handedOverTouching{0}; ///< of those, because the pair touched at the last update
    Number touchingAnswered{0};   ///< of those handed over, made here instead of by b2CollidePolygons
    Number toiAnswered{0};        ///< times of impact that a step asked for, answered without Box2D
    Number pairs{0};              ///< contacts of awake bodies, summed over the steps of worlds with a table
    Number updates{0};            ///< of the pairs, the ones whose contact or geometry was read
    Number renewals{0};           ///< of the pairs, the ones that their own line renewed
    Number verified{0};           ///< answers compared with Box2D's (Mode::Verify)
    Number differences{0};        ///< of those, the ones that differed
    Number structures{0};         ///< body pairs that got a kinetic structure
    Number hulls{0};              ///< hulls built
    Number hullChecks{0};         ///< certificates of structures of hulls, asked again
    Number events[BMR_EVENT_KIND_COUNT] = {};
};
using Counts = CountsOf<std::atomic<uint64_t>>; ///< as they are counted
using Counted = CountsOf<uint64_t>;             ///< as they are read

/// visit(name, count...) for each of them but the events, of these side by side.
template <typename Visit, typename... Some> void VisitCounts(const Visit &visit, Some &...of) {
    visit("steps", of.steps...);
    visit("evaluations", of.evaluations...);
    visit("edge_checks", of.edgeChecks...);
    visit("verdicts_reused", of.verdictsReused...);
    visit("proved_apart", of.provedApart...);
    visit("handed_over", of.handedOver...);
    visit("handed_over_touching", of.handedOverTouching...);
    visit("touching_answered", of.touchingAnswered...);
    visit("toi_answered", of.toiAnswered...);
    visit("pairs", of.pairs...);
    visit("updates", of.updates...);
    visit("renewals", of.renewals...);
    visit("verified", of.verified...);
    visit("differences", of.differences...);
    visit("structures", of.structures...);
    visit("hulls", of.hulls...);
    visit("hull_checks", of.hullChecks...);
}

/// How an evaluation of two polygons was answered: apart; or by the exact test, ours or Box2D's.
enum class Answer : int32_t {
    ApartByPair,   ///< the kinetic structure of their bodies proves them apart (Options::pairsBy)
    ApartByEdge,   ///< the edge that their contact remembers does; of a big ConvexShape its vertices
    ApartBySearch, ///< an edge, or the direction of a big one, was found, and is remembered from now on
    HandedOver,    ///< not known to be apart
    Touching       ///< handed over, and nothing asked: they touched at the last update
};
inline bool IsApart(Answer answer) {
    return answer < Answer::HandedOver;
}

/// Counts an event of these two bodies, and hands it to Options::onEvent. To be called where
/// Options::statistics is on.
void ReportEvent(const b2Body *bodyA, const b2Body *bodyB, const bmr_event &event);

/// Counts an answer, and hands it to the observer, if there is one. `here`: a manifold that is needed is made
/// here. The same holds.
void ReportAnswer(const b2Contact &contact, Answer answer, bool here);

/// Does anybody observe answers?
bool AnswersAreObserved();

namespace internal {

// For the tests and the testbed.
BMR_BOX2D_API Counted ReadCounts();
/// Called for every evaluation, once its manifold is there (implies Options::statistics). Ahead of Install.
using AnswerObserver = void (*)(const b2Contact &contact, Answer answer);
BMR_BOX2D_API void ObserveAnswers(AnswerObserver observer);

} // namespace internal

// What the library says when the process ends. With BOOMERANG_VERBOSE=1, also in Mode::Off, it is one line
// on stderr: how many steps the process took, and how long each was.
//
// `boomerang try` (plugin/boomerang.sh.in) reads that line. BOOMERANG_STEPS=N, which it sets, ends the count
// after N steps, and says the line at once.

namespace internal {
extern bool timesSteps;
} // namespace internal

/// Are steps timed? A load and a test.
inline bool StepsAreTimed() {
    return BMR_RARELY(internal::timesSteps);
}

/// From here on. Also for Options::verbosity.
void TimeSteps();
/// Does so if the environment asks for it. To be called ahead of the first step, any number of times.
void ReadVerbosity();
/// Do tests want counts (BOOMERANG_COUNTS names a file, which gets them when the process ends)?
bool CountsAreWanted();

/// Lives as long as a step that is timed. A step inside another one is a part of it.
class TimedStep {
public:
    TimedStep();
    ~TimedStep();
    TimedStep(const TimedStep &) = delete;
    TimedStep &operator=(const TimedStep &) = delete;

private:
    int64_t m_begin;
    bool m_outermost;
};

/// Calls it when the process ends: by exit, or by SIGINT, SIGTERM or SIGHUP where steps are timed and the
/// game does not handle that signal itself. Not in a process that was forked from the one that took the first
/// step. At most four functions.
void CallAtEnd(void (*say)());

} // namespace bmr

#endif
