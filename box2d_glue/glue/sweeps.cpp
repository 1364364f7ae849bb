// SPDX-License-Identifier: MIT
#include "glue/sweeps.h"

#include <box2d/b2_body.h>

#include "base/private_members.h"
#include "start/box2d_asserts.h"

namespace bmr {

void Advance(b2Sweep *sweep, float alpha) {
    BMR_BOX2D_ASSERTS(sweep->alpha0 < 1.0f, "alpha0 < 1.0f");
    const float beta = (alpha - sweep->alpha0) / (1.0f - sweep->alpha0);
    sweep->c0.x += beta * (sweep->c.x - sweep->c0.x);
    sweep->c0.y += beta * (sweep->c.y - sweep->c0.y);
    sweep->a0 += beta * (sweep->a - sweep->a0);
    sweep->alpha0 = alpha;
}

void SynchronizeTransform(b2Body *body) {
    const b2Sweep &sweep = SweepOf(*body);
    b2Transform &xf = body->*Named(TransformMember());
    xf.q.s = sinf(sweep.a);
    xf.q.c = cosf(sweep.a);
    const b2Vec2 &center = sweep.localCenter;
    xf.p.x = sweep.c.x - (xf.q.c * center.x - xf.q.s * center.y);
    xf.p.y = sweep.c.y - (xf.q.s * center.x + xf.q.c * center.y);
}

void Advance(b2Body *body, float alpha) {
    b2Sweep &sweep = SweepOf(body);
    Advance(&sweep, alpha);
    sweep.c = sweep.c0;
    sweep.a = sweep.a0;
    SynchronizeTransform(body);
}

} // namespace bmr
