// SPDX-License-Identifier: MIT
// The hooks: definitions of Box2D's own functions, ahead of Box2D's (start/hook_list.h). Each hands the call
// to our passes, or to the function of Box2D's that it stands in front of.
#include <optional>

#include <box2d/b2_contact.h>
#include <box2d/b2_contact_manager.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_joint.h>
#include <box2d/b2_time_of_impact.h>
#include <box2d/b2_world.h>

#include "base/rounding_mode.h"
#include "boomerang/box2d_glue.h"
#include "debug/statistics.h"
#include "glue/contacts/solid_contact.h"
#include "glue/pairs/pair_tables.h"
#include "glue/passes.h"
#include "glue/proofs/convex_distance.h"
#include "hooks/start.h"
#include "shapes/big_polygons.h"
#include "start/hook_list.h"
#include "start/settings.h"

#if !defined(BMR_RENAMED)
#    include "interposed/real.h"
#endif

// Box2D's own functions, for the hooks: `stock::FindNewContacts(manager)` is what
// `manager->FindNewContacts()` would be without us. How calls get to a hook, and how a hook gets to what it
// stands in front of, is one of two ways:
//
// - interposed: Box2D is a shared library, and this one stands ahead of it for the loader. What is asked for
//   here is looked up by name behind this library.
// - renamed: boomerang_accelerate compiles Box2D's sources with the plugin, and they define all of this
//   under other names. BMR_RENAMED is defined. What is asked for here is defined in renamed/.
//
// BMR_FOR_LOADERS(name) says by which name loaders ask for a hook; it means something in the first way alone.

#if defined(BMR_RENAMED)
#    define BMR_FOR_LOADERS(name) static_assert(true)
#    define BMR_STOCK BMR_DECLARE_STOCK
#else
#    define BMR_STOCK(name, function, symbol, heard, result, parameters, renamed)                            \
        inline Real<result parameters> name(#symbol);
#endif

namespace bmr::stock {

BMR_HOOKS(BMR_STOCK)

} // namespace bmr::stock

namespace bmr::hooks {

/// A world's destructor begins. (No definition of ours can stand in front of a destructor, which ends its
/// members, too: each way has its own means.)
void NoteWorldEnds(b2World *world);

} // namespace bmr::hooks

using namespace bmr;

#define BMR_SEEN_BY_LOADERS(name, function, symbol, heard, result, parameters, renamed)                      \
    BMR_FOR_LOADERS(#symbol);
BMR_HOOKS(BMR_SEEN_BY_LOADERS)

// A step. It starts the library if bmr::Install was not called.

void b2World::Step(float timeStep, int32 velocityIterations, int32 positionIterations) {
    StartAtFirstStep();
    std::optional<TimedStep> timed;
    if (StepsAreTimed() && !IsInTrialStep())
        timed.emplace();
    if (AnyBigPolygon())
        NoteDrawnByBox2D(nullptr, nullptr); // shapes that were drawn before a step are drawn anew after it
    const bool passesRun = PassesRun(HookOf::Step);
    if (passesRun && (GetSettings().options.statistics || Verifying()))
        GetCounts().steps.fetch_add(1, std::memory_order_relaxed);
    if (passesRun && ClaimStep(*this))
        RunStep(this, timeStep, velocityIterations, positionIterations);
    else
        stock::Step(this, timeStep, velocityIterations, positionIterations);
}

// The search for new pairs, where a step is not ours. It makes no table: one that began in the middle of
// Box2D's step would not know the marks that this step still makes.

void b2ContactManager::FindNewContacts() {
    if (PassesRun(HookOf::FindNewContacts) && FindPairTable(this) != nullptr)
        bmr::FindNewContacts(this);
    else
        stock::FindNewContacts(this);
}

// What ends. A contact's pair goes with it, and a world's table with the world.

void b2ContactManager::Destroy(b2Contact *contact) {
    if (!PassesRun(HookOf::Destroy)) {
        stock::Destroy(this, contact);
        return;
    }
    // A pass ends contacts without this hook. So a callback ends this one, perhaps the very one it is called
    // for.
    if (contact->GetFixtureA()->GetBody()->GetWorld()->IsLocked())
        LeaveTable(this);
    EndContact(this, contact);
}

void hooks::NoteWorldEnds(b2World *world) {
    DropPairTable(&world->GetContactManager());
}

#if !defined(BMR_RENAMED)
// b2World::~b2World, by its mangled names: a destructor that C++ would let us define ends the members, too,
// which Box2D's own is to do.
namespace bmr::hooks {

namespace {

Real<void(b2World *)> realEndWorld("_ZN7b2WorldD1Ev");
Real<void(b2World *)> realEndBaseWorld("_ZN7b2WorldD2Ev");

} // namespace

BMR_BOX2D_API void EndWorld(b2World *world) asm("_ZN7b2WorldD1Ev");
BMR_BOX2D_API void EndBaseWorld(b2World *world) asm("_ZN7b2WorldD2Ev");

void EndWorld(b2World *world) {
    NoteWorldEnds(world);
    realEndWorld(world);
}

void EndBaseWorld(b2World *world) {
    NoteWorldEnds(world);
    realEndBaseWorld(world);
}

} // namespace bmr::hooks

BMR_FOR_LOADERS("_ZN7b2WorldD1Ev");
BMR_FOR_LOADERS("_ZN7b2WorldD2Ev");
#endif

// What flags contacts for filtering: these are due. (SetFilterData's own call of Refilter does not reach its
// hook where Box2D's compiler binds it within its object file, as clang does, or where it is linked with
// --wrap.)

namespace {

/// (A body of a Box2D that is not known is not read.)
void NoteFiltering(const b2Body *body) {
    const b2World *const world = AnyPairTable() && body != nullptr ? body->GetWorld() : nullptr;
    PairTable *table = world != nullptr ? FindPairTable(&world->GetContactManager()) : nullptr;
    if (table == nullptr)
        return;
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next)
        if (ContactAccess::WantsFiltering(*edge->contact))
            table->Flag(edge->contact);
}

} // namespace

void b2Fixture::Refilter() {
    stock::Refilter(this);
    NoteFiltering(GetBody());
}

void b2Fixture::SetFilterData(const b2Filter &filter) {
    stock::SetFilterData(this, filter);
    NoteFiltering(GetBody());
}

b2Joint *b2World::CreateJoint(const b2JointDef *def) {
    b2Joint *joint = stock::CreateJoint(this, def);
    if (!AnyPairTable()) // whose user data may have any size in a Box2D that is not known
        return joint;
    // Box2D reads the definition: a gear joint's own bodies are other ones.
    NoteFiltering(joint != nullptr ? def->bodyB : nullptr);
    return joint;
}

void b2World::DestroyJoint(b2Joint *joint) {
    const b2Body *const body = joint != nullptr && AnyPairTable() ? joint->GetBodyB() : nullptr;
    stock::DestroyJoint(this, joint);
    NoteFiltering(body);
}

// Questions about big polygons. b2DistanceProxy::Set makes a proxy of all vertices, and the others answer for
// it, also if nothing is installed. (b2TestOverlap asks b2Distance.)

void b2DistanceProxy::Set(const b2Shape *shape, int32 child) {
    // (Shapes of a Box2D that is none we know are not ours to read.)
    if (!(PassesRun() || AnyBigPolygon()) || !SetCommonProxy(this, *shape))
        stock::SetProxy(this, shape, child);
}

void b2Distance(b2DistanceOutput *output, b2SimplexCache *cache, const b2DistanceInput *input) {
    if (BMR_RARELY(AnyBigPolygon()) && BigDistance(output, cache, *input))
        return;
    stock::Distance(output, cache, input);
}

bool b2ShapeCast(b2ShapeCastOutput *output, const b2ShapeCastInput *input) {
    bool hit;
    if (AnyBigPolygon() && BigCast(output, *input, &hit))
        return hit;
    return stock::ShapeCast(output, input);
}

/// Box2D's own search takes no more than 256 vertices.
void b2TimeOfImpact(b2TOIOutput *output, const b2TOIInput *input) {
    if (!AnyBigPolygon() || !BigImpact(output, *input))
        stock::TimeOfImpact(output, input);
}

/// The real polygon, in pieces of at most 8 vertices unless Options::drawAs asks for it whole.
void b2World::DrawShape(b2Fixture *fixture, const b2Transform &xf, const b2Color &color) {
    const bmr_convex32_block *block = AnyBigPolygon() ? BigPolygonOf(*fixture->GetShape()) : nullptr;
    if (block == nullptr) {
        stock::DrawShape(this, fixture, xf, color);
        return;
    }
    NoteDrawnByBox2D(this, m_debugDraw);
    DrawBigPolygon(*block, xf, color, GetSettings().options.drawAs, *m_debugDraw);
}
