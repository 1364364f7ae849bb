// SPDX-License-Identifier: MIT
#include "start/recognise.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <new>

#include <box2d/b2_block_allocator.h>
#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_friction_joint.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_world.h>

#include "base/compiler.h"
#include "start/recognise_constants.h"
#include "world/ledger.h"

namespace bmr {

namespace {

const char *(*libraryCheck)() = nullptr;
const b2ContactListener *listenerOfNewWorlds = nullptr;
const b2ContactFilter *filterOfNewWorlds = nullptr;

constexpr char kOtherBodySize[] = "b2Body has not the size that it has in 2.4.1";
constexpr char kOtherFixtureSize[] = "b2Fixture has not the size that it has in 2.4.1";

constexpr unsigned char kUntouched = 0xa5;
/// Room behind an object for a Box2D whose own is larger.
constexpr size_t kMargin = 4096;

/// The sizes that Box2D's block allocator rounds up to.
constexpr size_t BlockSize(size_t size) {
    for (const size_t block :
         {16u, 32u, 64u, 96u, 128u, 160u, 192u, 224u, 256u, 320u, 384u, 448u, 512u, 640u})
        if (size <= block)
            return block;
    return size;
}

/// Two objects that were allocated one after the other lie one block apart.
template <typename T> bool IsOneBlock(const T *first, const T *second) {
    const auto distance = reinterpret_cast<uintptr_t>(second) - reinterpret_cast<uintptr_t>(first);
    return distance == BlockSize(sizeof(T)) || ~distance + 1 == BlockSize(sizeof(T));
}

bool Is(const b2Vec2 &v, float x, float y) {
    return v.x == x && v.y == y;
}

// Numbers that a float holds exactly, each for one field: no two fields can be taken for each other.
constexpr float kDensity = 0.625f, kFriction = 0.375f, kRestitution = 0.0625f, kGravityScale = 0.5f;
constexpr float kLinearDamping = 0.125f, kAngularDamping = 0.25f, kSpeed = 3.0f, kSpin = 0.75f;

b2Body *MakeBody(b2World &world, float x, float y) {
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position.Set(x, y);
    def.linearVelocity.Set(kSpeed, -kSpeed);
    def.angularVelocity = kSpin;
    def.linearDamping = kLinearDamping;
    def.angularDamping = kAngularDamping;
    def.gravityScale = kGravityScale;
    return world.CreateBody(&def);
}

b2Fixture *MakeFixture(b2Body *body, const b2PolygonShape &shape) {
    b2FixtureDef def;
    def.shape = &shape;
    def.density = kDensity;
    def.friction = kFriction;
    def.restitution = kRestitution;
    return body->CreateFixture(&def);
}

bool BodyIsAsMade(const b2Body *body, const b2World *world, float x, float y) {
    return body->GetType() == b2_dynamicBody && Is(body->GetPosition(), x, y) && body->GetAngle() == 0.0f &&
           Is(body->GetLinearVelocity(), kSpeed, -kSpeed) && body->GetAngularVelocity() == kSpin &&
           body->GetLinearDamping() == kLinearDamping && body->GetAngularDamping() == kAngularDamping &&
           body->GetGravityScale() == kGravityScale && body->GetWorld() == world && body->IsAwake() &&
           body->IsEnabled() && body->GetFixtureList() == nullptr && body->GetContactList() == nullptr;
}

bool FixtureIsAsMade(const b2Fixture *fixture, const b2Body *body, const b2PolygonShape &shape) {
    if (fixture->GetBody() != body || body->GetFixtureList() != fixture || fixture->IsSensor() ||
        fixture->GetDensity() != kDensity || fixture->GetFriction() != kFriction ||
        fixture->GetRestitution() != kRestitution || fixture->GetType() != b2Shape::e_polygon)
        return false;
    const auto *copy = static_cast<const b2PolygonShape *>(fixture->GetShape());
    return copy != nullptr && copy->m_count == shape.m_count && copy->m_radius == shape.m_radius &&
           Is(copy->m_vertices[2], shape.m_vertices[2].x, shape.m_vertices[2].y) &&
           Is(copy->m_normals[3], shape.m_normals[3].x, shape.m_normals[3].y);
}

/// The manifold of boxes of half-width 1 at (0, 0) and (1.5, 0.25), in metres, in which nothing is rounded.
bool ManifoldIsRight(b2Contact *contact) {
    struct {
        b2Manifold manifold;
        unsigned char behind[64];
    } room;
    std::memset(static_cast<void *>(&room), kUntouched, sizeof room);
    const b2Body *a = contact->GetFixtureA()->GetBody(), *b = contact->GetFixtureB()->GetBody();
    contact->Evaluate(&room.manifold, a->GetTransform(), b->GetTransform());
    for (const unsigned char byte : room.behind)
        if (byte != kUntouched)
            return false;
    const b2Manifold &m = room.manifold;
    return m.type == b2Manifold::e_faceA && m.pointCount == 2 && Is(m.localNormal, 1.0f, 0.0f) &&
           Is(m.localPoint, kTrialMetre, 0.0f) && m.points[0].localPoint.x == -kTrialMetre &&
           m.points[1].localPoint.x == -kTrialMetre && m.points[0].id.key != m.points[1].id.key;
}

/// Does Box2D leave the bits of a contact's flags alone that hold the ledger's numbers? Of a new contact
/// whose boxes overlap, which has no listener.
bool LeavesNumbersAlone(b2Contact *contact) {
    struct Open : b2Contact {
        static void CallUpdate(b2Contact *of) { (of->*(&Open::Update))(nullptr); }
    };
    constexpr uint32 kNew = 0x0004, kTouching = 0x0006;
    if (ContactAccess::Flags(contact) != kNew)
        return false;
    Open::CallUpdate(contact);
    if (ContactAccess::Flags(contact) != kTouching)
        return false;
    ContactNumber::Write(contact, ContactNumber::kMost - 1);
    Open::CallUpdate(contact);
    return ContactAccess::Flags(contact) == (kTouching | ~ContactNumber::kBox2DsFlags);
}

/// A box that flies 10 m at one 8 m away in front of it: they meet a good half of the way along.
bool ImpactIsRight(const b2PolygonShape &shape) {
    b2DistanceProxy box;
    box.Set(&shape, 0);
    const float time =
        TrialImpact(box, kTrialMetre * b2Vec2(10.0f, 0.0f), box, kTrialMetre * b2Vec2(8.0f, 0.0f));
    return time > 0.59f && time < 0.61f;
}

/// A definition with zeros behind it: a Box2D whose own is larger reads zeros there. All others of its fields
/// are zero, too.
template <typename Def> struct ZeroDef {
    ZeroDef() { std::memset(static_cast<void *>(this), 0, sizeof *this); }
    Def *Get() { return reinterpret_cast<Def *>(room); }
    const Def *Get() const { return reinterpret_cast<const Def *>(room); }
    alignas(Def) unsigned char room[sizeof(Def) + 256];
};

/// The block that Box2D's allocator hands out next to an object of class T, each of its bytes known.
template <typename T> class NextBlock {
public:
    explicit NextBlock(b2BlockAllocator *allocator) {
        constexpr auto kBytes = static_cast<int32>(BlockSize(sizeof(T)));
        m_block = allocator->Allocate(kBytes);
        std::memset(m_block, kUntouched, static_cast<size_t>(kBytes));
        allocator->Free(m_block, kBytes);
    }

    /// Did `object` get the block, and is the part behind a T unwritten? (Reads to the end of the block; the
    /// address sanitizer would allow no more than the bytes of a T.)
    BMR_NOT_FOR_ADDRESS_SANITIZER bool HoldsNoMoreThan(const T *object) const {
        constexpr unsigned char kFreedForDebugging = 0xfd; // what Free writes with _DEBUG
        if (object != m_block)
            return false;
        const auto *bytes = static_cast<const volatile unsigned char *>(m_block);
        for (size_t i = sizeof(T); i < BlockSize(sizeof(T)); ++i)
            if (bytes[i] != kUntouched && bytes[i] != kFreedForDebugging)
                return false;
        return true;
    }

private:
    void *m_block;
};

/// Bodies and fixtures end with what a game's own settings may make of their user data. Ask before bodies and
/// fixtures are made from definitions with more than zeros behind the user data.
const char *WhyUserDataIsUnknown(b2World *world, const b2PolygonShape &shape) {
    b2BlockAllocator *allocator = world->GetContactManager().m_allocator;
    const NextBlock<b2Body> blockOfBody(allocator);
    const ZeroDef<b2BodyDef> bodyDef;
    b2Body *body = world->CreateBody(bodyDef.Get());
    if (!blockOfBody.HoldsNoMoreThan(body))
        return kOtherBodySize;
    if (body->GetUserData().pointer != 0)
        return "b2BodyUserData has not the size that it has in 2.4.1";
    const NextBlock<b2Fixture> blockOfFixture(allocator);
    ZeroDef<b2FixtureDef> fixtureDef;
    fixtureDef.Get()->shape = &shape;
    b2Fixture *fixture = body->CreateFixture(fixtureDef.Get());
    if (!blockOfFixture.HoldsNoMoreThan(fixture))
        return kOtherFixtureSize;
    if (fixture->GetUserData().pointer != 0)
        return "b2FixtureUserData has not the size that it has in 2.4.1";
    world->DestroyBody(body);
    return nullptr;
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

const char *WhyContentsAreUnknown(b2World &world, b2PolygonShape *box) {
    if (const char *why = WhyVerticesAreOthers(box, kMargin))
        return why;
    const b2PolygonShape &shape = *box;
    if (const char *why = WhyUserDataIsUnknown(&world, shape))
        return why;
    if (!JointsAreRight(&world))
        return "b2JointUserData has not the size that it has in 2.4.1";
    constexpr float kX[] = {0.0f, 1.5f * kTrialMetre, 0.0f};
    constexpr float kY[] = {0.0f, 0.25f * kTrialMetre, 8.0f * kTrialMetre};
    b2Body *bodies[3];
    for (int i = 0; i < 3; ++i) {
        bodies[i] = MakeBody(world, kX[i], kY[i]);
        if (!BodyIsAsMade(bodies[i], &world, kX[i], kY[i]))
            return "the fields of b2Body lie elsewhere than in 2.4.1";
    }
    if (!IsOneBlock(bodies[0], bodies[1]) || world.GetBodyCount() != 3 || world.GetBodyList() != bodies[2] ||
        bodies[2]->GetNext() != bodies[1])
        return kOtherBodySize;
    const b2Fixture *fixtures[4];
    for (int i = 0; i < 3; ++i) {
        fixtures[i] = MakeFixture(bodies[i], shape);
        if (!FixtureIsAsMade(fixtures[i], bodies[i], shape))
            return "the fields of b2Fixture or b2PolygonShape lie elsewhere than in 2.4.1";
    }
    if (!IsOneBlock(fixtures[0], fixtures[1]))
        return kOtherFixtureSize;
    if (!IsOneBlock(static_cast<const b2PolygonShape *>(fixtures[0]->GetShape()),
                    static_cast<const b2PolygonShape *>(fixtures[1]->GetShape())))
        return "b2PolygonShape has not the size that it has in 2.4.1";
    if (!ImpactIsRight(shape))
        return "b2TimeOfImpact gives other times than in 2.4.1";
    if (const char *why = WhyConstantsAreOthers(&world))
        return why;
    // A second box in the place of the first gives the two contacts whose distance is looked at.
    fixtures[3] = MakeFixture(bodies[0], shape);
    const_cast<b2ContactManager &>(world.GetContactManager()).FindNewContacts();
    b2Contact *newest = world.GetContactList();
    if (world.GetContactCount() != 2 || newest == nullptr || newest->GetNext() == nullptr ||
        newest->GetNext()->GetNext() != nullptr)
        return "contacts are found or listed otherwise than in 2.4.1";
    b2Contact *oldest = newest->GetNext();
    if (!IsOneBlock(oldest, newest))
        return "b2Contact has not the size that it has in 2.4.1";
    for (b2Contact *contact : {oldest, newest}) {
        const b2Fixture *a = contact->GetFixtureA(), *b = contact->GetFixtureB();
        if (b != fixtures[1] && a != fixtures[1])
            return "the fields of b2Contact lie elsewhere than in 2.4.1";
        if (contact->GetChildIndexA() != 0 || contact->GetChildIndexB() != 0 || !contact->IsEnabled() ||
            contact->IsTouching() || contact->GetManifold()->pointCount != 0 ||
            contact->GetRestitution() != kRestitution)
            return "the fields of b2Contact lie elsewhere than in 2.4.1";
    }
    if (oldest->GetFixtureA() == fixtures[0] && !ManifoldIsRight(oldest))
        return "b2CollidePolygons gives other manifolds than in 2.4.1";
    if (!LeavesNumbersAlone(oldest) || !LeavesNumbersAlone(newest))
        return "b2Contact has flags that it has not in 2.4.1";
    return nullptr;
}

/// The constructor of b2World ends with its last member, a b2Profile of zeros.
const char *WhyWorldIsUnknown(const unsigned char *room, b2World &world, b2PolygonShape *box) {
    for (size_t i = sizeof(b2World); i < sizeof(b2World) + kMargin; ++i)
        if (room[i] != kUntouched)
            return "b2World is larger than in 2.4.1";
    const b2Profile &profile = world.GetProfile();
    if (profile.step != 0.0f || profile.broadphase != 0.0f || profile.solveTOI != 0.0f)
        return "b2World is smaller than in 2.4.1";
    if (!Is(world.GetGravity(), kSpeed, -kSpeed) || world.GetBodyList() != nullptr ||
        world.GetBodyCount() != 0 || world.GetContactList() != nullptr || world.GetContactCount() != 0 ||
        !world.GetAllowSleeping() || world.IsLocked() || !world.GetContinuousPhysics() ||
        world.GetSubStepping() || !world.GetAutoClearForces() || world.GetProxyCount() != 0)
        return "the fields of b2World lie elsewhere than in 2.4.1";
    return WhyContentsAreUnknown(world, box);
}

/// Room for one world and one polygon of another size than expected. A leak checker finds those that stay by
/// their list.
struct Trial {
    Trial *before;
    alignas(std::max_align_t) unsigned char room[sizeof(b2World) + kMargin];
    alignas(std::max_align_t) unsigned char polygon[sizeof(b2PolygonShape) + kMargin];
};
Trial *leftAlone = nullptr;

} // namespace

const char kNoMemoryToRecognise[] = "there is no memory to find out which Box2D this is";

void SetLibraryCheck(const char *(*check)()) {
    libraryCheck = check;
}

bool IsBox2D242() {
    static std::atomic<int> known{-1};
    int answer = known.load(std::memory_order_relaxed);
    if (answer < 0) {
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
        answer = output.pointA.x > 0.75f ? 1 : 0;
        known.store(answer, std::memory_order_relaxed);
    }
    return answer == 1;
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
    auto *trial = static_cast<Trial *>(std::malloc(sizeof(Trial)));
    if (trial == nullptr)
        return kNoMemoryToRecognise;
    // All that a world keeps except the middle of its stack, which this code does not use: a hundred
    // kilobytes that stay untouched.
    constexpr size_t kBefore = 1024;
    static_assert(kBefore < b2_stackSize && b2_stackSize < sizeof(b2World));
    std::memset(trial->room, kUntouched, kBefore);
    std::memset(trial->room + b2_stackSize, kUntouched, sizeof trial->room - b2_stackSize);
    std::memset(trial->polygon, kUntouched, sizeof trial->polygon);
    b2World *world = new (trial->room) b2World(b2Vec2(kSpeed, -kSpeed));
    const char *why = WhyWorldIsUnknown(trial->room, *world, new (trial->polygon) b2PolygonShape());
    if (why != nullptr) {
        // A world of another kind is not to be trusted with its own end: it stays.
        trial->before = leftAlone;
        leftAlone = trial;
        return why;
    }
    listenerOfNewWorlds = world->GetContactManager().m_contactListener;
    filterOfNewWorlds = world->GetContactManager().m_contactFilter;
    world->~b2World();
    std::free(trial);
    return nullptr;
}

} // namespace bmr
