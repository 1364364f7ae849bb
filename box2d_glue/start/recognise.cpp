// SPDX-License-Identifier: MIT
#include "start/recognise.h"

#include <atomic>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <new>

#include <box2d/b2_block_allocator.h>
#include <box2d/b2_body.h>
#include <box2d/b2_broad_phase.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_friction_joint.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_time_of_impact.h>
#include <box2d/b2_world.h>

#include "base/compiler.h"
#include "shapes/shapes32.h"
#include "start/settings.h"

namespace bmr {

namespace {

const char *(*libraryCheck)() = nullptr;
const b2ContactListener *listenerOfNewWorlds = nullptr;
const b2ContactFilter *filterOfNewWorlds = nullptr;

/// The answer: of a constant, or of a hook.
char sentence[160];

struct HookInTrial {
    const char *name;
    bool isHeard; ///< in the trial step; Box2D has to call these
};
constexpr bool kHeard = true, kAny = false;
constexpr HookInTrial kHooks[] = {
#define BMR_NAME_HOOK(name, function, symbol, heard, result, parameters, renamed) {#function, heard},
    BMR_HOOKS(BMR_NAME_HOOK)};

thread_local bool inTrialStep = false;
std::atomic<uint32_t> noted{0}; ///< a bit for each hook that was called in the trial step

constexpr unsigned char kUntouched = 0xa5;
/// Room behind an object for a Box2D whose own is larger.
constexpr size_t kMargin = 4096;

/// A metre or more, in units of length. A power of two, for nothing is to be rounded.
constexpr float kTrialMetre = [] {
    float metre = 1.0f;
    while (metre < b2_lengthUnitsPerMeter)
        metre *= 2.0f;
    return metre;
}();

/// The sizes that Box2D's block allocator rounds up to. (A game's own user data may be large.)
constexpr size_t BlockSize(size_t size) {
    for (const size_t block :
         {16u, 32u, 64u, 96u, 128u, 160u, 192u, 224u, 256u, 320u, 384u, 448u, 512u, 640u})
        if (size <= block)
            return block;
    return size;
}

/// The block that Box2D's allocator hands out next for an object of class T, each of its bytes known.
template <typename T> class NextBlock {
public:
    explicit NextBlock(b2BlockAllocator *allocator) {
        m_block = allocator->Allocate(static_cast<int32>(kBytes));
        std::memset(m_block, kUntouched, kBytes);
        allocator->Free(m_block, static_cast<int32>(kBytes));
    }

    /// Did `object` get the block, and is the part behind a T unwritten? (Reads to the end of the block; the
    /// address sanitizer would allow no more than the bytes of a T.)
    BMR_NOT_FOR_ADDRESS_SANITIZER bool HoldsNoMoreThan(const T *object) const {
        constexpr unsigned char kFreedForDebugging = 0xfd; // what Free writes with _DEBUG
        if (object != m_block)
            return false;
        const auto *bytes = static_cast<const volatile unsigned char *>(m_block);
        for (size_t i = sizeof(T); i < kBytes; ++i)
            if (bytes[i] != kUntouched && bytes[i] != kFreedForDebugging)
                return false;
        return true;
    }

private:
    static constexpr size_t kBytes = BlockSize(sizeof(T));
    void *m_block;
};

/// A definition with zeros behind it: a Box2D whose own is larger reads zeros there. All others of its fields
/// are zero, too.
template <typename Def> struct ZeroDef {
    ZeroDef() { std::memset(static_cast<void *>(this), 0, sizeof *this); }
    Def *Get() { return reinterpret_cast<Def *>(room); }
    alignas(Def) unsigned char room[sizeof(Def) + 256];
};

// A record that is too large writes behind ours; one that is too small leaves our last member unwritten.

/// Bodies and fixtures end with what a game's own settings may make of their user data.
const char *WhyRecordsAreOthers(b2World *world, const b2PolygonShape &box) {
    b2BlockAllocator *allocator = world->GetContactManager().m_allocator;
    const NextBlock<b2Body> blockOfBody(allocator);
    b2Body *body = world->CreateBody(ZeroDef<b2BodyDef>().Get());
    if (!blockOfBody.HoldsNoMoreThan(body) || body->GetUserData().pointer != 0)
        return "b2Body or its user data have not the size that they have in 2.4.1";
    const NextBlock<b2Fixture> blockOfFixture(allocator);
    ZeroDef<b2FixtureDef> def;
    def.Get()->shape = &box;
    b2Fixture *fixture = body->CreateFixture(def.Get());
    if (!blockOfFixture.HoldsNoMoreThan(fixture) || fixture->GetUserData().pointer != 0)
        return "b2Fixture or its user data have not the size that they have in 2.4.1";
    const NextBlock<b2PolygonShape> blockOfShape(allocator);
    const auto *shape = static_cast<const b2PolygonShape *>(box.Clone(allocator)); // it ends with the world
    if (!blockOfShape.HoldsNoMoreThan(shape) || shape->m_count != box.m_count)
        return "b2PolygonShape has not the size that it has in 2.4.1";
    world->DestroyBody(body);
    return nullptr;
}

/// Hooks note that they are called: two boxes with a contact move, and one of them ends.
void StepWatched(b2World *world) {
    inTrialStep = true;
    internal::state = internal::State::Watching;
    world->Step(1.0f / 60.0f, 1, 1);
    world->DestroyBody(world->GetBodyList());
    internal::state = internal::State::Nothing;
    inTrialStep = false;
}

/// Two boxes in one place have a contact.
const char *WhyContactsAreOthers(b2World *world, const b2PolygonShape &box) {
    auto &manager = const_cast<b2ContactManager &>(world->GetContactManager());
    b2BodyDef def;
    def.type = b2_dynamicBody;
    b2FixtureDef fixtureDef;
    fixtureDef.shape = &box;
    for (int i = 0; i < 2; ++i)
        world->CreateBody(&def)->CreateFixture(&fixtureDef);
    const NextBlock<b2Contact> block(manager.m_allocator);
    manager.FindNewContacts();
    const b2Contact *contact = world->GetContactList();
    return contact != nullptr && block.HoldsNoMoreThan(contact) && contact->GetTangentSpeed() == 0.0f
               ? nullptr
               : "b2Contact has not the size that it has in 2.4.1";
}

/// Zeros that CreateJoint takes for a static body without joints and contacts. The last byte of its address
/// is 0, which is `false`.
struct alignas(256) NoBody {
    unsigned char room[sizeof(b2Body) + 256];
    b2Body *Get() { return reinterpret_cast<b2Body *>(room); }
};

/// Does Box2D find the bodies of a joint's definition, which stand behind its user data, where we do? Where
/// it looks elsewhere, there are two others.
bool JointsAreRight(b2World *world) {
    NoBody a = {}, b = {}, elsewhere = {};
    b2Body *places[2] = {b.Get(), elsewhere.Get()};
    alignas(b2FrictionJointDef) unsigned char room[sizeof(b2FrictionJointDef) + 32 * sizeof places];
    for (size_t at = 0; at + sizeof places <= sizeof room; at += sizeof places)
        std::memcpy(room + at, places, sizeof places);
    auto *def = reinterpret_cast<b2JointDef *>(room);
    def->type = e_frictionJoint;
    def->bodyA = a.Get();
    b2Joint *joint = world->CreateJoint(def);
    if (joint->GetBodyA() != a.Get() || joint->GetBodyB() != def->bodyB ||
        joint->GetUserData().pointer != def->userData.pointer)
        return false;
    world->DestroyJoint(joint);
    return true;
}

struct Constant {
    const char *name;
    float here, expected;
};

const char *IsAnother(const Constant &constant) {
    std::snprintf(sentence, sizeof sentence, "%s is %.5g here, %.5g in the Box2D this was built for",
                  constant.name, static_cast<double>(constant.here), static_cast<double>(constant.expected));
    return sentence;
}

/// Makes `shape`, which has room behind it, a box whose half-width is a metre.
const char *WhyVerticesAreOthers(b2PolygonShape *shape) {
    const b2Vec2 firstNormal(0.0f, -1.0f);
    shape->SetAsBox(kTrialMetre, kTrialMetre);
    if (shape->m_count == 4 && shape->m_normals[0] == firstNormal)
        return nullptr;
    // Behind as many vertices as there are in this Box2D stand the normals.
    const auto *bytes = reinterpret_cast<const unsigned char *>(shape->m_vertices);
    const size_t most = kMargin / sizeof(b2Vec2);
    for (size_t i = 4; i < most; ++i) {
        b2Vec2 there;
        std::memcpy(&there, bytes + i * sizeof there, sizeof there);
        if (there == firstNormal && i != b2_maxPolygonVertices)
            return IsAnother({"b2_maxPolygonVertices", static_cast<float>(i), b2_maxPolygonVertices});
    }
    return "b2PolygonShape has not the size that it has in 2.4.1";
}

/// How far the fat box of a point reaches.
float MeasureExtension(b2BroadPhase *broadPhase) {
    b2AABB box;
    box.lowerBound.SetZero();
    box.upperBound.SetZero();
    const int32 proxy = broadPhase->CreateProxy(box, nullptr);
    const float extension = broadPhase->GetFatAABB(proxy).upperBound.x;
    broadPhase->DestroyProxy(proxy);
    return extension;
}

/// How far apart are two points that touch? One flies at the other from a metre away.
float MeasureSlop() {
    const b2Vec2 origin(0.0f, 0.0f), way(kTrialMetre, 0.0f);
    b2TOIInput input;
    for (b2DistanceProxy *proxy : {&input.proxyA, &input.proxyB}) {
        proxy->m_vertices = &origin;
        proxy->m_count = 1;
        proxy->m_radius = 0.0f;
    }
    std::memset(static_cast<void *>(&input.sweepA), 0, sizeof input.sweepA);
    std::memset(static_cast<void *>(&input.sweepB), 0, sizeof input.sweepB);
    input.sweepA.c = input.sweepB.c0 = input.sweepB.c = way;
    input.tMax = 1.0f;
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input);
    return output.state == b2TOIOutput::e_touching ? kTrialMetre * (1.0f - output.t) : -1.0f;
}

const char *WhyConstantsAreOthers(b2BroadPhase *broadPhase) {
    const Constant extension = {"b2_aabbExtension", MeasureExtension(broadPhase), b2_aabbExtension};
    const Constant slop = {"b2_linearSlop", MeasureSlop(), b2_linearSlop};
    // Does one factor make the second of both?
    constexpr float kError = 1e-3f;
    const float factor = extension.here / extension.expected;
    if (extension.here != extension.expected)
        return std::fabs(slop.here / slop.expected - factor) <= kError * factor
                   ? IsAnother(
                         {"b2_lengthUnitsPerMeter", factor * b2_lengthUnitsPerMeter, b2_lengthUnitsPerMeter})
                   : IsAnother(extension);
    // Measured to a few units in the last place of a metre, the distance over which the point flies.
    return std::fabs(slop.here - slop.expected) <= 4.0f * FLT_EPSILON * kTrialMetre ? nullptr
                                                                                    : IsAnother(slop);
}

const char *WhyContentsAreUnknown(b2World &world, b2PolygonShape *box) {
    auto &manager = const_cast<b2ContactManager &>(world.GetContactManager());
    const char *why = WhyVerticesAreOthers(box);
    if (why == nullptr)
        why = WhyRecordsAreOthers(&world, *box);
    if (why == nullptr && !JointsAreRight(&world))
        why = "b2JointUserData has not the size that it has in 2.4.1";
    if (why == nullptr)
        why = WhyConstantsAreOthers(&manager.m_broadPhase);
    if (why == nullptr)
        why = WhyContactsAreOthers(&world, *box);
    if (why == nullptr)
        StepWatched(&world);
    return why;
}

/// The constructor of b2World ends with its last member, a b2Profile of zeros.
const char *WhyWorldIsUnknown(const unsigned char *room, b2World &world, b2PolygonShape *box) {
    for (size_t i = sizeof(b2World); i < sizeof(b2World) + kMargin; ++i)
        if (room[i] != kUntouched)
            return "b2World has not the size that it has in 2.4.1";
    const b2Profile &profile = world.GetProfile();
    if (profile.step != 0.0f || profile.broadphase != 0.0f || profile.solveTOI != 0.0f)
        return "b2World has not the size that it has in 2.4.1";
    return WhyContentsAreUnknown(world, box);
}

/// Room for one world and one polygon of another size than expected.
struct Trial {
    alignas(std::max_align_t) unsigned char room[sizeof(b2World) + kMargin];
    alignas(std::max_align_t) unsigned char polygon[sizeof(b2PolygonShape) + kMargin];
};

} // namespace

void SetLibraryCheck(const char *(*check)()) {
    libraryCheck = check;
}

bool IsBox2D242() {
    static const bool is = [] {
        // Two disks of radius 1 whose middles are 1 apart: 2.4.1 puts both points between them, 2.4.2 on the
        // far sides.
        const b2Vec2 origin(0.0f, 0.0f);
        b2DistanceInput input;
        input.proxyA.m_vertices = input.proxyB.m_vertices = &origin;
        input.proxyA.m_count = input.proxyB.m_count = 1;
        input.proxyA.m_radius = input.proxyB.m_radius = 1.0f;
        input.transformA.SetIdentity();
        input.transformB.SetIdentity();
        input.transformB.p.Set(1.0f, 0.0f);
        input.useRadii = true;
        b2SimplexCache cache;
        cache.count = 0;
        b2DistanceOutput output;
        b2Distance(&output, &cache, &input);
        return output.pointA.x > 0.75f;
    }();
    return is;
}

const b2ContactListener *ListenerOfNewWorlds() {
    return listenerOfNewWorlds;
}

const b2ContactFilter *FilterOfNewWorlds() {
    return filterOfNewWorlds;
}

const char *WhyBox2DIsUnknown() {
    if (libraryCheck != nullptr)
        if (const char *why = libraryCheck())
            return why;
    static Trial trial;
    // All that a world keeps except the middle of its stack, which this code does not use: a hundred
    // kilobytes that stay untouched.
    constexpr size_t kBefore = 1024;
    static_assert(kBefore < b2_stackSize && b2_stackSize < sizeof(b2World));
    std::memset(trial.room, kUntouched, kBefore);
    std::memset(trial.room + b2_stackSize, kUntouched, sizeof trial.room - b2_stackSize);
    std::memset(trial.polygon, kUntouched, sizeof trial.polygon);
    b2World *world = new (trial.room) b2World(b2Vec2(0.0f, -10.0f));
    const char *why = WhyWorldIsUnknown(trial.room, *world, new (trial.polygon) b2PolygonShape());
    if (why != nullptr) // a world of another kind is not to be trusted with its own end: it stays
        return why;
    listenerOfNewWorlds = world->GetContactManager().m_contactListener;
    filterOfNewWorlds = world->GetContactManager().m_contactFilter;
    world->~b2World();
    return nullptr;
}

// Does its arithmetic round as ours?

namespace {

/// Two polygons that overlap, or are apart by little, in the i-th of many ways.
struct TwoPolygons {
    b2PolygonShape a, b;
    b2Transform xfA, xfB;

    explicit TwoPolygons(int i) {
        const float x = static_cast<float>(i), around = 0.61f * x,
                    away = 1.0f + 0.1f * static_cast<float>(i % 4);
        b2Vec2 corners[b2_maxPolygonVertices];
        const int32 count = 3 + i % (b2_maxPolygonVertices - 2);
        for (int32 k = 0; k < count; ++k) {
            const float angle =
                (static_cast<float>(k) + 0.013f * x) * 2.0f * b2_pi / static_cast<float>(count);
            corners[k] = kSize * b2Vec2(0.83f * std::cos(angle), 0.59f * std::sin(angle));
        }
        a.SetAsBox(2.3f * kSize, 0.77f * kSize);
        b.Set(corners, count);
        xfA.Set(kSize * b2Vec2(1.3f + 0.7f * x, -0.7f), 0.37f * x);
        xfB.Set(xfA.p + b2Mul(xfA.q, away * kSize * b2Vec2(2.6f * std::cos(around), 1.1f * std::sin(around))),
                0.37f * x + 0.41f * std::sin(1.7f * x));
    }

    static constexpr float kSize = b2_lengthUnitsPerMeter;
};

/// Two manifolds, one of Box2D's and one of ours: nothing in them yet.
struct TwoManifolds {
    TwoManifolds() { std::memset(static_cast<void *>(this), 0, sizeof *this); }
    bool AreTheSame() const {
        // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bits, and all of them were written
        return std::memcmp(&box2d, &ours, sizeof ours) == 0;
    }
    b2Manifold box2d, ours;
};

/// How many of the probes gave so many points.
struct Probed {
    int points[3] = {};
    /// Were there enough of each kind among so many?
    bool IsEnough(int probes) const {
        return points[0] >= probes / 16 && points[1] >= probes / 16 && points[2] >= probes / 16;
    }
};

bool PolygonsAgree(int i, Probed *probed) {
    const TwoPolygons two(i);
    TwoManifolds made;
    const bmr_polygon32 a = Polygon32(two.a), b = Polygon32(two.b);
    b2CollidePolygons(&made.box2d, &two.a, two.xfA, &two.b, two.xfB);
    bmr_exact32_collide(Manifold32(&made.ours), &a, Transform32(two.xfA), &b, Transform32(two.xfB),
                        two.a.m_radius + two.b.m_radius, 0.1f * b2_linearSlop);
    ++probed->points[made.box2d.pointCount];
    return made.AreTheSame();
}

/// The i-th of many links with a polygon about one of its ends.
bool EdgeAgrees(int i, Probed *probed) {
    const float x = static_cast<float>(i), at = 0.1f * static_cast<float>(i % 12) - 0.05f;
    const TwoPolygons shapes(i);
    const b2Vec2 bend(0.0f, 0.4f * std::sin(2.3f * x)), first(-0.9f, 0.1f), second(0.8f, 0.13f * std::cos(x));
    b2EdgeShape edge;
    edge.m_vertex0 = TwoPolygons::kSize * (first + bend - b2Vec2(1.1f, 0.0f));
    edge.m_vertex1 = TwoPolygons::kSize * first;
    edge.m_vertex2 = TwoPolygons::kSize * second;
    edge.m_vertex3 = TwoPolygons::kSize * (second - bend + b2Vec2(1.3f, 0.0f));
    edge.m_oneSided = i % 4 != 0;
    const b2PolygonShape &polygon = i % 2 == 0 ? shapes.a : shapes.b;
    b2Transform xfB = shapes.xfB;
    const b2Vec2 place = edge.m_vertex1 + at * (edge.m_vertex2 - edge.m_vertex1);
    xfB.p = b2Mul(shapes.xfA, place - b2Vec2(0.0f, 0.004f * std::sin(3.1f * x) * TwoPolygons::kSize)) -
            b2Mul(xfB.q, polygon.m_vertices[i % polygon.m_count]);
    TwoManifolds made;
    b2CollideEdgeAndPolygon(&made.box2d, &edge, shapes.xfA, &polygon, xfB);
    ++probed->points[made.box2d.pointCount];
    const bmr_polygon32 other = Polygon32(polygon);
    const bmr_edge32 link = Edge32(edge);
    return bmr_exact32_collide_edge(Manifold32(&made.ours), &link, Transform32(shapes.xfA), &other,
                                    *Vectors32(&polygon.m_centroid), Transform32(xfB),
                                    polygon.m_radius + edge.m_radius) &&
           made.AreTheSame();
}

/// True if all probes agree, and enough of them gave no point, one and two.
bool AllAgree(bool (*agrees)(int, Probed *)) {
    constexpr int kProbes = 96;
    Probed probed;
    for (int i = 0; i < kProbes; ++i)
        if (!agrees(i, &probed))
            return false;
    return probed.IsEnough(kProbes);
}

} // namespace

bool Box2DRoundsAsExact32() {
    return AllAgree(PolygonsAgree);
}

bool Box2DCollidesEdgesAsExact32() {
    return AllAgree(EdgeAgrees);
}

// Does it call our hooks?

void internal::NoteReached(HookOf hook) {
    if (inTrialStep)
        noted.fetch_or(1u << static_cast<uint32_t>(hook), std::memory_order_relaxed);
}

bool IsInTrialStep() {
    return inTrialStep;
}

const char *WhichHookIsNotCalled() {
    uint32_t hook = 0;
    for (const HookInTrial &listed : kHooks) {
        if (listed.isHeard && (noted.load(std::memory_order_relaxed) >> hook & 1) == 0) {
            std::snprintf(sentence, sizeof sentence,
                          "Box2D does not call Boomerang's %s. Link boomerang::box2d ahead of it, or use "
                          "boomerang_accelerate()",
                          listed.name);
            return sentence;
        }
        ++hook;
    }
    return nullptr;
}

} // namespace bmr
