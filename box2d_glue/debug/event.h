// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_EVENT_H
#define BOOMERANG_GLUE_EVENT_H

#include "boomerang/box2d_glue.h"
#include "debug/counts.h"

namespace bmr {

/// How one evaluation of two polygons was answered. Those before HandedOver needed no manifold.
enum class Answer : int32_t {
    ApartByPair,   ///< the kinetic structure of their bodies proves them apart (Options::pairsBy)
    ApartByEdge,   ///< the edge that their contact remembers does; of a big ConvexShape its vertices
    ApartBySearch, ///< an edge, or the direction of a big one, was found, and is remembered from now on
    HandedOver,    ///< not known to be apart: a manifold was needed
    Touching       ///< the same, nothing asked: they touched at the last look
};

/// Counts an event of these two bodies, and tells Options::onEvent of it. To be called where
/// Options::statistics is on.
void TellOfEvent(const b2Body *bodyA, const b2Body *bodyB, const bmr_event &event);

/// Counts an answer, and tells whoever observes answers. `here`: a manifold that is needed is made here. The
/// same holds.
void TellOfAnswer(const b2Contact &contact, Answer answer, bool here);

/// Does anybody observe answers?
bool AnswersAreObserved();

namespace internal {

// For the tests and the testbed.
BMR_BOX2D_API Counted ReadCounts();
/// Told of every evaluation, once its manifold is there (implies Options::statistics). Ahead of Install.
using AnswerObserver = void (*)(const b2Contact &contact, Answer answer);
BMR_BOX2D_API void ObserveAnswers(AnswerObserver observer);

} // namespace internal
} // namespace bmr

#endif
