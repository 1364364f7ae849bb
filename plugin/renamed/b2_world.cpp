// SPDX-License-Identifier: MIT
// How hooks are reached where Box2D is compiled with the plugin (boomerang_accelerate,
// cmake/BoomerangAccelerate.cmake).
//
// A source of Box2D's that defines what hooks stand in front of is compiled through a file that CMake writes.
// It gives these functions other names (BmrStock...), includes the source as it is (BMR_BOX2D_SOURCE), and
// defines the functions of bmr::stock (hooks/hooks.cpp, start/hook_list.h) that call them. All other files of
// Box2D call Box2D's names, which hooks/ defines. Members that only such a file has do not change how a class
// is laid out.
//
// Functions that are called from other files alone CMake's file renames with one `#define` each. Where there
// is more to do, it includes the file of this folder that has the source's name, in place of the source.
// Functions that their own source calls, too, keep their name in calls and get another one where they are
// defined. The first word in parentheses tells them apart: `#define Destroy(...) BMR_DESTROY_##__VA_ARGS__)`
// makes one name of it and of the word. The definition's is a type, a call's a variable. For each word that
// is known there is a definition of that name; a source with another word does not compile.
//
// All is C++11, and compiled as the rest of Box2D is.
//
// In this file most functions are called from their own source:
//
//   DestroyJoint, DrawShape           told apart by the first word
//   the constructor, the destructor   likewise: the destructor has none, and becomes two functions
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

#define Step BmrStockStep
#define CreateJoint BmrStockCreateJoint
#define ClearForces()                                                                                        \
    ClearForces();                                                                                           \
    void BmrStockDrawShape(b2Fixture *fixture, const b2Transform &xf, const b2Color &color);                 \
    void BmrStockDestroyJoint(b2Joint *joint);                                                               \
    void BmrStockEnd()
#include "box2d/b2_world.h"
#undef ClearForces

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
#undef DrawShape
#undef DestroyJoint
#undef b2World
