// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SWEEPS_H
#define BOOMERANG_GLUE_SWEEPS_H

class b2Body;
struct b2Sweep;

namespace bmr {

/// The arithmetic of b2World::SolveTOI. There are two tables: our own functions (OurSweeps), which are
/// compiled without fused products; and Box2D's, which plugin/reach/renamed compiles as Box2D is compiled.
/// (Our files must not call Box2D's inline functions: the linker would keep one copy of ours and Box2D's,
/// which were compiled with different flags.)
struct Sweeps {
    void (*advance)(b2Sweep *sweep, float alpha);           ///< b2Sweep::Advance
    void (*advanceBody)(b2Body *body, float alpha);         ///< b2Body::Advance
    void (*synchronizeTransform)(b2Body *body);             ///< b2Body::SynchronizeTransform
    float (*timeOfImpact)(float from, float partOfTheRest); ///< at most 1
};

const Sweeps &OurSweeps();

} // namespace bmr

#endif
