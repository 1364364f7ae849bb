// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SWEEPS_H
#define BOOMERANG_GLUE_SWEEPS_H

class b2Body;
struct b2Sweep;

namespace bmr {

// Box2D's functions of these names, with the same bits.
void Advance(b2Sweep *sweep, float alpha);
void Advance(b2Body *body, float alpha);
void SynchronizeTransform(b2Body *body);

} // namespace bmr

#endif
