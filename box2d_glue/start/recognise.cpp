// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
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
#include "start/install.h"
#include "start/settings.h"

namespace bmr {

namespace {

const char *(*libraryCheck)() = nullptr;
const b2ContactListener *listenerOfNewWorlds = nullptr;
const b2ContactFilter *filterOfNewWorlds = nullptr;

/// The answer: of a constant, or of a hook.
char sentence[160];

thread_local bool inTrialStep = false;
std::atomic<uint32_t> noted{0}; ///< a bit for each hook that was called in the trial step

constexpr unsigned char kUntouched = 0xa5;
/// Memory behind an object for a Box2D whose own is larger.
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

/// Are these bytes as they were before Box2D could write there? (The address sanitizer allows no more than
/// the bytes of an object.)
BMR_NOT_FOR_ADDRESS_SANITIZER bool AreUntouched(const void *block, size_t from, size_t to) {
    constexpr unsigned char kFreedForDebugging = 0xfd; // what b2BlockAllocator::Free writes with _DEBUG
    const auto *bytes = static_cast<const volatile unsigned char *>(block);
    for (size_t i = from; i < to; ++i)
        if (bytes[i] != kUntouched && bytes[i] != kFreedForDebugging)
            return false;
    return true;
}

/// Has Box2D an object of class T made. Returns it if it got the block that Box2D's allocator hands out next
/// for a T, and if the part of the block behind a T is unwritten; else nullptr.
template <typename T, typename Make> T *MakeInItsBlock(b2BlockAllocator *allocator, Make make) {
    constexpr size_t kBytes = BlockSize(sizeof(T));
    void *const block = allocator->Allocate(static_cast<int32>(kBytes));
    std::memset(block, kUntouched, kBytes);
    allocator->Free(block, static_cast<int32>(kBytes));
    T *const made = make();
    return made == block && AreUntouched(block, sizeof(T), kBytes) ? made : nullptr;
}

/// A definition with zeros behind it: a Box2D whose own is larger reads zeros there. All others of its fields
/// are zero, too.
template <typename Def> struct ZeroDef {
    ZeroDef() { std::memset(static_cast<void *>(this), 0, sizeof *this); }
    Def *Get() { return reinterpret_cast<Def *>(bytes); }
    alignas(Def) unsigned char bytes[sizeof(Def) + 256];
};

constexpr const char *kOtherWorld = "b2World has not the size that it has in 2.4.1",
                     *kOtherShape = "b2PolygonShape has not the size that it has in 2.4.1";

// A record that is too large writes behind ours; one that is too small leaves our last member unwritten.

/// Bodies and fixtures end with what a game's own settings may make of their user data.
const char *WhyRecordsAreOthers(b2World *world, const b2PolygonShape &box) {
    b2BlockAllocator *allocator = world->GetContactManager().m_allocator;
    b2Body *body =
        MakeInItsBlock<b2Body>(allocator, [&] { return world->CreateBody(ZeroDef<b2BodyDef>().Get()); });
    if (body == nullptr || body->GetUserData().pointer != 0)
        return "b2Body or its user data have not the size that they have in 2.4.1";
    b2Fixture *fixture = MakeInItsBlock<b2Fixture>(allocator, [&] {
        ZeroDef<b2FixtureDef> def;
        def.Get()->shape = &box;
        return body->CreateFixture(def.Get());
    });
    if (fixture == nullptr || fixture->GetUserData().pointer != 0)
        return "b2Fixture or its user data have not the size that they have in 2.4.1";
    const auto *shape = MakeInItsBlock<b2PolygonShape>(allocator, [&] { // it ends with the world
        return static_cast<b2PolygonShape *>(box.Clone(allocator));
    });
    if (shape == nullptr || shape->m_count != box.m_count)
        return kOtherShape;
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
    const b2Contact *contact = MakeInItsBlock<b2Contact>(manager.m_allocator, [&] {
        manager.FindNewContacts();
        return world->GetContactList();
    });
    return contact != nullptr && contact->GetTangentSpeed() == 0.0f
               ? nullptr
               : "b2Contact has not the size that it has in 2.4.1";
}

/// Zeros that CreateJoint takes for a static body without joints and contacts. The last byte of its address
/// is 0, which is `false`.
struct alignas(256) NoBody {
    unsigned char bytes[sizeof(b2Body) + 256];
    b2Body *Get() { return reinterpret_cast<b2Body *>(bytes); }
};

/// Does Box2D find the bodies of a joint's definition, which stand behind its user data, where we do? Where
/// it looks elsewhere, there are two others.
bool JointsAreRight(b2World *world) {
    NoBody a = {}, b = {}, elsewhere = {};
    b2Body *places[2] = {b.Get(), elsewhere.Get()};
    alignas(b2FrictionJointDef) unsigned char bytes[sizeof(b2FrictionJointDef) + 32 * sizeof places];
    for (size_t at = 0; at + sizeof places <= sizeof bytes; at += sizeof places)
        std::memcpy(bytes + at, places, sizeof places);
    auto *def = reinterpret_cast<b2JointDef *>(bytes);
    def->type = e_frictionJoint;
    def->bodyA = a.Get();
    b2Joint *joint = world->CreateJoint(def);
    if (joint->GetBodyA() != a.Get() || joint->GetBodyB() != def->bodyB ||
        joint->GetUserData().pointer != def->userData.pointer)
        return false;
    world->DestroyJoint(joint);
    return true;
}

const char *IsAnother(const char *constant, float here, float expected) {
    std::snprintf(sentence, sizeof sentence, "%s is %.5g here, %.5g in the Box2D this was built for",
                  constant, static_cast<double>(here), static_cast<double>(expected));
    return sentence;
}

/// Makes `shape`, which has memory behind it, a box whose half-width is a metre.
const char *WhyVerticesAreOthers(b2PolygonShape *shape) {
    const b2Vec2 firstNormal(0.0f, -1.0f);
    shape->SetAsBox(kTrialMetre, kTrialMetre);
    if (shape->m_count == 4 && shape->m_normals[0] == firstNormal)
        return nullptr;
    // Behind as many vertices as there are in this Box2D stand the normals.
    const auto *bytes = reinterpret_cast<const unsigned char *>(shape->m_vertices);
    for (size_t i = 4; i < kMargin / sizeof(b2Vec2); ++i) {
        b2Vec2 there;
        std::memcpy(&there, bytes + i * sizeof there, sizeof there);
        if (there == firstNormal && i != b2_maxPolygonVertices)
            return IsAnother("b2_maxPolygonVertices", static_cast<float>(i), b2_maxPolygonVertices);
    }
    return kOtherShape;
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
    const float extension = MeasureExtension(broadPhase), slop = MeasureSlop(),
                factor = extension / b2_aabbExtension;
    if (extension == b2_aabbExtension) // slop: to a few units in the last place of the way of the point
        return std::fabs(slop - b2_linearSlop) <= 4.0f * FLT_EPSILON * kTrialMetre
                   ? nullptr
                   : IsAnother("b2_linearSlop", slop, b2_linearSlop);
    constexpr float kError = 1e-3f;
    if (std::fabs(slop / b2_linearSlop - factor) <= kError * factor) // one factor makes the second of both
        return IsAnother("b2_lengthUnitsPerMeter", factor * b2_lengthUnitsPerMeter, b2_lengthUnitsPerMeter);
    return IsAnother("b2_aabbExtension", extension, b2_aabbExtension);
}

const char *WhyWorldIsUnknown(b2World *world, b2PolygonShape *box) {
    // The constructor of b2World ends with its last member, a b2Profile of zeros.
    const b2Profile &profile = world->GetProfile();
    if (!AreUntouched(world, sizeof(b2World), sizeof(b2World) + kMargin) || profile.step != 0.0f ||
        profile.broadphase != 0.0f || profile.solveTOI != 0.0f)
        return kOtherWorld;
    const char *why = WhyVerticesAreOthers(box);
    if (why == nullptr)
        why = WhyRecordsAreOthers(world, *box);
    if (why == nullptr && !JointsAreRight(world))
        why = "b2JointUserData has not the size that it has in 2.4.1";
    if (why == nullptr)
        why = WhyConstantsAreOthers(const_cast<b2BroadPhase *>(&world->GetContactManager().m_broadPhase));
    if (why == nullptr)
        why = WhyContactsAreOthers(world, *box);
    return why;
}

/// Memory for one world and one polygon of another size than expected.
struct Trial {
    alignas(std::max_align_t) unsigned char world[sizeof(b2World) + kMargin];
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
    std::memset(trial.world, kUntouched, kBefore);
    std::memset(trial.world + b2_stackSize, kUntouched, sizeof trial.world - b2_stackSize);
    std::memset(trial.polygon, kUntouched, sizeof trial.polygon);
    b2World *world = new (trial.world) b2World(b2Vec2(0.0f, -10.0f));
    if (const char *why = WhyWorldIsUnknown(world, new (trial.polygon) b2PolygonShape()))
        return why; // a world of another kind is not to be trusted with its own end: it stays
    StepWatched(world);
    listenerOfNewWorlds = world->GetContactManager().m_contactListener;
    filterOfNewWorlds = world->GetContactManager().m_contactFilter;
    world->~b2World();
    return nullptr;
}

const char *WhyThisBox2DIsUnknown() {
    const HoldsProcessLock lock;
    static const char *const why = WhyBox2DIsUnknown();
    return why;
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

/// Two manifolds, Box2D's and ours: nothing in them yet.
struct TwoManifolds {
    TwoManifolds() { std::memset(static_cast<void *>(this), 0, sizeof *this); }
    bool AreTheSame() const {
        // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bits, and all of them were written
        return std::memcmp(&box2d, &ours, sizeof ours) == 0;
    }
    b2Manifold box2d, ours;
};

/// How many probes found no point, one and two.
using Probed = int[3];

/// Does Box2D round the box of a polygon as its source says? A vectorizer may fuse these products where it
/// fuses no others (gcc 12 does, even with -ffp-contract=off).
bool BoxRoundsAsWritten(const b2PolygonShape &polygon, const b2Transform &xf) {
    volatile float rounded; // one rounding an operation, however this file is compiled
    const auto round = [&rounded](float value) {
        rounded = value;
        return static_cast<float>(rounded);
    };
    b2AABB box;
    polygon.ComputeAABB(&box, xf, 0);
    b2Vec2 lower(b2_maxFloat, b2_maxFloat), upper(-b2_maxFloat, -b2_maxFloat);
    for (int32 i = 0; i < polygon.m_count; ++i) {
        const b2Vec2 v = polygon.m_vertices[i];
        const float x = round(round(xf.q.c * v.x) - round(xf.q.s * v.y));
        const float y = round(round(xf.q.s * v.x) + round(xf.q.c * v.y));
        const b2Vec2 at(round(x + xf.p.x), round(y + xf.p.y));
        lower = b2Min(lower, at);
        upper = b2Max(upper, at);
    }
    const b2Vec2 r(polygon.m_radius, polygon.m_radius);
    return box.lowerBound == lower - r && box.upperBound == upper + r;
}

bool PolygonsAgree(int i, Probed *probed) {
    const TwoPolygons two(i);
    TwoManifolds made;
    const bmr_polygon32 a = Polygon32(two.a), b = Polygon32(two.b);
    b2CollidePolygons(&made.box2d, &two.a, two.xfA, &two.b, two.xfB);
    bmr_exact32_collide(Manifold32(&made.ours), &a, Transform32(two.xfA), &b, Transform32(two.xfB),
                        two.a.m_radius + two.b.m_radius, 0.1f * b2_linearSlop);
    ++(*probed)[made.box2d.pointCount];
    return made.AreTheSame() && BoxRoundsAsWritten(two.a, two.xfA) && BoxRoundsAsWritten(two.b, two.xfB);
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
    ++(*probed)[made.box2d.pointCount];
    const bmr_polygon32 other = Polygon32(polygon);
    const bmr_edge32 link = Edge32(edge);
    return bmr_exact32_collide_edge(Manifold32(&made.ours), &link, Transform32(shapes.xfA), &other,
                                    *Vectors32(&polygon.m_centroid), Transform32(xfB),
                                    polygon.m_radius + edge.m_radius) &&
           made.AreTheSame();
}

/// True if all probes agree, and enough of them found no point, one and two.
bool AllAgree(bool (*agrees)(int, Probed *)) {
    constexpr int kProbes = 96;
    Probed probed = {};
    for (int i = 0; i < kProbes; ++i)
        if (!agrees(i, &probed))
            return false;
    return *std::min_element(probed, probed + 3) >= kProbes / 16;
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
    constexpr bool kHeard = true, kAny = false;
    constexpr struct {
        const char *name;
        bool isHeard; ///< in the trial step; Box2D has to call these
    } kHooks[] = {
#define BMR_NAME_HOOK(name, function, symbol, heard, result, parameters, renamed) {#function, heard},
        BMR_HOOKS(BMR_NAME_HOOK)};
    const uint32_t called = noted.load(std::memory_order_relaxed);
    for (uint32_t hook = 0; hook < static_cast<uint32_t>(HookOf::Count); ++hook)
        if (kHooks[hook].isHeard && (called >> hook & 1) == 0) {
            std::snprintf(sentence, sizeof sentence,
                          "Box2D does not call Boomerang's %s. Link boomerang::box2d ahead of it, or use "
                          "boomerang_accelerate()",
                          kHooks[hook].name);
            return sentence;
        }
    return nullptr;
}

} // namespace bmr
