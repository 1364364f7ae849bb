// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SWEEPS_H
#define BOOMERANG_GLUE_SWEEPS_H

#include <box2d/b2_body.h>

#include "base/private_members.h"
#include "start/box2d_asserts.h"

/// @file
/// What Box2D does with sweeps of bodies while it looks for impacts, with its bits where it was built without
/// fused products. (Its own inline functions are not called: a program that compiles Box2D with other flags
/// than the glue would get one of the two for both.)

namespace bmr {

inline b2Sweep &SweepOf(b2Body *body) {
    return body->*Named(SweepMember());
}

/// b2Sweep::Advance.
inline void Advance(b2Sweep *sweep, float alpha) {
    BMR_BOX2D_ASSERTS(sweep->alpha0 < 1.0f, "alpha0 < 1.0f");
    const float beta = (alpha - sweep->alpha0) / (1.0f - sweep->alpha0);
    sweep->c0.x += beta * (sweep->c.x - sweep->c0.x);
    sweep->c0.y += beta * (sweep->c.y - sweep->c0.y);
    sweep->a0 += beta * (sweep->a - sweep->a0);
    sweep->alpha0 = alpha;
}

/// b2Body::SynchronizeTransform.
inline void SynchronizeTransform(b2Body *body) {
    const b2Sweep &sweep = SweepOf(body);
    b2Transform &xf = body->*Named(TransformMember());
    xf.q.s = sinf(sweep.a);
    xf.q.c = cosf(sweep.a);
    const b2Vec2 &center = sweep.localCenter;
    xf.p.x = sweep.c.x - (xf.q.c * center.x - xf.q.s * center.y);
    xf.p.y = sweep.c.y - (xf.q.s * center.x + xf.q.c * center.y);
}

/// b2Body::Advance: to the new transform, and no farther in this step.
inline void AdvanceBody(b2Body *body, float alpha) {
    b2Sweep &sweep = SweepOf(body);
    Advance(&sweep, alpha);
    sweep.c = sweep.c0;
    sweep.a = sweep.a0;
    SynchronizeTransform(body);
}

} // namespace bmr

#endif
