// SPDX-License-Identifier: MIT
// See names.h. Here most functions are called from their own source:
//
//   DestroyJoint, SolveTOI, DrawShape   told apart by the first word
//   the constructor, the destructor     likewise: the destructor has none, and becomes two functions
//   Solve                               Step has a b2TimeStep that may be changed; the definition takes
//                                       one that may not. (`&profile`, the word of b2Island::Solve,
//                                       makes no name.)
#include BMR_BOX2D_CONTACT_SOLVER
#include "box2d/b2_block_allocator.h"
#include "box2d/b2_body.h"
#include "box2d/b2_broad_phase.h"
#include "box2d/b2_contact.h"
#include "box2d/b2_contact_manager.h"
#include "box2d/b2_draw.h"
#include "box2d/b2_fixture.h"
#include "box2d/b2_joint.h"
#include "box2d/b2_stack_allocator.h"
#include "box2d/b2_time_step.h"
#include "box2d/b2_world_callbacks.h"

class b2World;

namespace bmr {

namespace hooks {

void NoteWorldEnds(b2World *world);

} // namespace hooks

} // namespace bmr

#define Solve(...)                                                                                           \
    Solve(__VA_ARGS__);                                                                                      \
    void BmrStockSolve(b2Profile *profile, const b2TimeStep &step, const b2Vec2 &gravity, bool allowSleep) { \
        Solve(profile, step, gravity, allowSleep);                                                           \
    }                                                                                                        \
    struct BmrSolves
#include BMR_BOX2D_ISLAND
#undef Solve

#define Step BmrStockStep
#define CreateJoint BmrStockCreateJoint
#define DestroyBody BmrStockDestroyBody
#define ClearForces()                                                                                        \
    ClearForces();                                                                                           \
    void BmrStockSolve(const b2TimeStep &step);                                                              \
    void BmrStockSolve(b2TimeStep &step) {                                                                   \
        Solve(step);                                                                                         \
    }                                                                                                        \
    void BmrStockSolveTOI(const b2TimeStep &step);                                                           \
    void BmrStockDrawShape(b2Fixture *fixture, const b2Transform &xf, const b2Color &color);                 \
    void BmrStockDestroyJoint(b2Joint *joint);                                                               \
    void BmrStockEnd()
#include "box2d/b2_world.h"
#undef ClearForces

#define Solve BmrStockSolve
#define SolveTOI(...) BMR_TOI_##__VA_ARGS__)
#define BMR_TOI_const BmrStockSolveTOI(const
#define BMR_TOI_step SolveTOI(step
#define BMR_TOI_subStep SolveTOI(subStep
#define DrawShape(...) BMR_DRAW_##__VA_ARGS__)
#define BMR_DRAW_b2Fixture BmrStockDrawShape(b2Fixture
#define BMR_DRAW_f DrawShape(f
#define DestroyJoint(...) BMR_DESTROY_##__VA_ARGS__)
#define BMR_DESTROY_b2Joint BmrStockDestroyJoint(b2Joint
#define BMR_DESTROY_je0 DestroyJoint(je0
#define b2World(...) BMR_WORLD_##__VA_ARGS__)
#define BMR_WORLD_const b2World(const
#define BMR_WORLD_                                                                                           \
    b2World() {                                                                                              \
        ::bmr::hooks::NoteWorldEnds(this);                                                                   \
        BmrStockEnd();                                                                                       \
    }                                                                                                        \
    void b2World::BmrStockEnd(
#include BMR_BOX2D_SOURCE
#undef Step
#undef CreateJoint
#undef DestroyBody
#undef Solve
#undef SolveTOI
#undef DrawShape
#undef DestroyJoint
#undef b2World

namespace bmr {
namespace stock {

BMR_HOOKS_OF_b2_world(BMR_DECLARE_STOCK) BMR_HOOKS_OF_b2_world(BMR_DEFINE_STOCK)

} // namespace stock
} // namespace bmr
