// SPDX-License-Identifier: MIT
// See names.h. Box2D's b2Island, and what b2World::SolveTOI does with sweeps, as functions that may be called
// from elsewhere, compiled as Box2D is. (A file of its own: beside b2World::SolveTOI the compiler might
// compile that one otherwise.) Nothing is renamed here.
namespace bmr {
namespace stock {
struct BodyMotion;
} // namespace stock
} // namespace bmr

#define b2Island                                                                                             \
    b2Island;                                                                                                \
    friend struct ::bmr::stock::BodyMotion
#include "box2d/b2_body.h"
#undef b2Island

#include BMR_BOX2D_ISLAND

#include "box2d/b2_contact.h"
#include "box2d/b2_joint.h"
#include "box2d/b2_time_step.h"

#include <cfloat>

namespace bmr {

[[noreturn]] void FailAsAssert(const char *assertion, const char *function);

// As in box2d_glue/passes/stock_solver.h, which is not of the language that this is compiled as.
struct IslandParts {
    b2StackAllocator *allocator;
    b2Body *const *bodies;
    b2Contact *const *contacts;
    b2Joint *const *joints;
    uint32 bodyCount, contactCount, jointCount;
};

namespace stock {

struct BodyMotion {
    static void Advance(b2Body *body, float alpha) { body->Advance(alpha); }
    static void SynchronizeTransform(b2Body *body) { body->SynchronizeTransform(); }
    static int32 &Place(b2Body *body) { return body->m_islandIndex; }
};

void SolveIsland(const IslandParts &parts, const b2TimeStep &step, const b2Vec2 &gravity, bool allowSleep,
                 b2ContactListener *listener, b2Profile *profile);
void SolveToiIsland(const IslandParts &parts, const b2TimeStep &step, b2ContactListener *listener);
void AdvanceSweep(b2Sweep *sweep, float alpha);
void AdvanceBody(b2Body *body, float alpha);
void SynchronizeTransform(b2Body *body);
float TimeOfImpact(float from, float partOfTheRest);
bool Asserts();
void Fails(const char *assertion);
bool RoundsByPlace();

namespace {

struct FilledIsland : b2Island {
    FilledIsland(const IslandParts &parts, uint32 bodies, uint32 contacts, b2ContactListener *listener)
        : b2Island(int32(bodies), int32(contacts), int32(parts.jointCount), parts.allocator, listener) {
        for (uint32 i = 0; i < parts.bodyCount; ++i)
            Add(parts.bodies[i]);
        for (uint32 i = 0; i < parts.contactCount; ++i)
            Add(parts.contacts[i]);
        for (uint32 i = 0; i < parts.jointCount; ++i)
            Add(parts.joints[i]);
    }
};

} // namespace

void SolveIsland(const IslandParts &parts, const b2TimeStep &step, const b2Vec2 &gravity, bool allowSleep,
                 b2ContactListener *listener, b2Profile *profile) {
    FilledIsland island(parts, parts.bodyCount, parts.contactCount, listener);
    b2Profile here;
    island.Solve(&here, step, gravity, allowSleep);
    profile->solveInit += here.solveInit;
    profile->solveVelocity += here.solveVelocity;
    profile->solvePosition += here.solvePosition;
}

void SolveToiIsland(const IslandParts &parts, const b2TimeStep &step, b2ContactListener *listener) {
    const uint32 most = 2 * b2_maxTOIContacts;
    int32 places[most]; // as the pass left them: a step of a listener may have changed them since Add
    for (uint32 i = 0; i < parts.bodyCount; ++i)
        places[i] = BodyMotion::Place(parts.bodies[i]);
    FilledIsland island(parts, most, b2_maxTOIContacts, listener);
    for (uint32 i = 0; i < parts.bodyCount; ++i)
        BodyMotion::Place(parts.bodies[i]) = places[i];
    island.SolveTOI(step, places[0], places[1]);
}

void AdvanceSweep(b2Sweep *sweep, float alpha) {
    sweep->Advance(alpha);
}

void AdvanceBody(b2Body *body, float alpha) {
    BodyMotion::Advance(body, alpha);
}

void SynchronizeTransform(b2Body *body) {
    BodyMotion::SynchronizeTransform(body);
}

float TimeOfImpact(float from, float partOfTheRest) {
    return b2Min(from + (1.0f - from) * partOfTheRest, 1.0f);
}

bool Asserts() {
    bool asked = false;
    b2Assert((asked = true));
    return asked;
}

bool RoundsByPlace() {
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||               \
    defined(_M_FP_FAST)
    return true;
#else
    return FLT_EVAL_METHOD != 0;
#endif
}

// What b2Assert is, unless it is the game's own.
#undef assert
#define assert(A) FailAsAssert(assertion, "Box2D")

void Fails(const char *assertion) {
    (void)assertion;
    b2Assert(assertion == nullptr);
}

} // namespace stock
} // namespace bmr
