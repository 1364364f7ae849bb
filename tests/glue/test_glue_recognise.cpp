// SPDX-License-Identifier: MIT
// A Box2D that is not the one the glue was built for is left alone. This program stands in front of some
// functions of Box2D's (ELF lets it) and lets each do what another version, or one with other constants,
// could do.
#include <box2d/b2_time_of_impact.h>
#include <box2d/box2d.h>
#include <dlfcn.h>

#include "as_stock.h"
#include "cases.h"
#if defined(IN_CHILD_ASAN)
#    include <sanitizer/lsan_interface.h>
#endif
#include "start/install.h"

namespace {

enum class Oddity {
    kNone,
    kLargerWorld,
    kSmallerWorld,
    kLargerBody,
    kLargerFixture,
    kLargerShape,
    kLargerContact,
    kSmallerContact,
    kHastyManifold,
    kSlowManifold,
    kFusedBox,
    kLargerUserDataOfBody,
    kSmallerUserDataOfBody,
    kLargerUserDataOfFixture,
    kSmallerUserDataOfFixture,
    kLargerUserDataOfJoint,
    kSmallerUserDataOfJoint,
    kUserDataOfJointElsewhere,
    kMoreVertices,
    kFewerVertices,
    kNoNormals,
    kOtherExtension,
    kOtherSlop,
    kOtherUnits
};
Oddity oddity = Oddity::kNone;

template <typename Function> Function *Real(const char *name) {
    return reinterpret_cast<Function *>(dlsym(RTLD_NEXT, name));
}

/// A process asks once. Here the next world lies where one that is not to be trusted with its own end stays.
std::string Why(Oddity odd) {
    oddity = odd;
#if defined(IN_CHILD_ASAN)
    const __lsan::ScopedDisabler notLost;
#endif
    const char *why = bmr::WhyBox2DIsUnknown();
    oddity = Oddity::kNone;
    return why != nullptr ? why : "";
}

} // namespace

void MakeWorld(b2World *world, const b2Vec2 &gravity) __asm__("_ZN7b2WorldC1ERK6b2Vec2");
void MakeWorld(b2World *world, const b2Vec2 &gravity) {
    auto *bytes = reinterpret_cast<unsigned char *>(world);
    unsigned char end[sizeof(b2Profile)];
    std::memcpy(end, bytes + sizeof(b2World) - sizeof end, sizeof end);
    Real<void(b2World *, const b2Vec2 &)>("_ZN7b2WorldC1ERK6b2Vec2")(world, gravity);
    if (oddity == Oddity::kLargerWorld)
        bytes[sizeof(b2World) + 5] = 0;
    if (oddity == Oddity::kSmallerWorld)
        std::memcpy(bytes + sizeof(b2World) - sizeof end, end, sizeof end);
}

b2Body *MakeBody(b2World *world, const b2BodyDef *def) __asm__("_ZN7b2World10CreateBodyEPK9b2BodyDef");
b2Body *MakeBody(b2World *world, const b2BodyDef *def) {
    const auto real = Real<b2Body *(b2World *, const b2BodyDef *)>("_ZN7b2World10CreateBodyEPK9b2BodyDef");
    if (oddity == Oddity::kLargerBody)
        world->GetContactManager().m_allocator->Allocate(sizeof(b2Body)); // as what is in another block
    b2Body *body = real(world, def);
    if (oddity == Oddity::kLargerUserDataOfBody)
        std::memset(static_cast<void *>(body + 1), 0, sizeof(void *));
    if (oddity == Oddity::kSmallerUserDataOfBody)
        body->GetUserData().pointer = ~uintptr_t{0} << 32;
    return body;
}

b2Fixture *MakeFixture(b2Body *body,
                       const b2FixtureDef *def) __asm__("_ZN6b2Body13CreateFixtureEPK12b2FixtureDef");
b2Fixture *MakeFixture(b2Body *body, const b2FixtureDef *def) {
    const auto real =
        Real<b2Fixture *(b2Body *, const b2FixtureDef *)>("_ZN6b2Body13CreateFixtureEPK12b2FixtureDef");
    if (oddity == Oddity::kLargerFixture)
        body->GetWorld()->GetContactManager().m_allocator->Allocate(sizeof(b2Fixture));
    b2Fixture *fixture = real(body, def);
    if (oddity == Oddity::kLargerUserDataOfFixture)
        std::memset(static_cast<void *>(fixture + 1), 0, sizeof(void *));
    if (oddity == Oddity::kSmallerUserDataOfFixture)
        fixture->GetUserData().pointer = ~uintptr_t{0} << 32;
    return fixture;
}

b2Shape *CloneShape(const b2PolygonShape *shape,
                    b2BlockAllocator *allocator) __asm__("_ZNK14b2PolygonShape5CloneEP16b2BlockAllocator");
b2Shape *CloneShape(const b2PolygonShape *shape, b2BlockAllocator *allocator) {
    if (oddity == Oddity::kLargerShape)
        allocator->Allocate(sizeof(b2PolygonShape)); // its block goes with the allocator
    return Real<b2Shape *(const b2PolygonShape *, b2BlockAllocator *)>(
        "_ZNK14b2PolygonShape5CloneEP16b2BlockAllocator")(shape, allocator);
}

b2Contact *
MakeContact(b2Fixture *a, int32 indexA, b2Fixture *b, int32 indexB,
            b2BlockAllocator *allocator) __asm__("_ZN9b2Contact6CreateEP9b2FixtureiS1_iP16b2BlockAllocator");
b2Contact *MakeContact(b2Fixture *a, int32 indexA, b2Fixture *b, int32 indexB, b2BlockAllocator *allocator) {
    if (oddity == Oddity::kLargerContact)
        allocator->Allocate(sizeof(b2Contact));
    b2Contact *contact = Real<b2Contact *(b2Fixture *, int32, b2Fixture *, int32, b2BlockAllocator *)>(
        "_ZN9b2Contact6CreateEP9b2FixtureiS1_iP16b2BlockAllocator")(a, indexA, b, indexB, allocator);
    if (oddity == Oddity::kSmallerContact)
        contact->SetTangentSpeed(1.0f); // what was there before
    return contact;
}

void Collide(b2Manifold *manifold, const b2PolygonShape *a, const b2Transform &xfA, const b2PolygonShape *b,
             const b2Transform
                 &xfB) __asm__("_Z17b2CollidePolygonsP10b2ManifoldPK14b2PolygonShapeRK11b2TransformS3_S6_");
void Collide(b2Manifold *manifold, const b2PolygonShape *a, const b2Transform &xfA, const b2PolygonShape *b,
             const b2Transform &xfB) {
    const b2Vec2 before = manifold->localNormal;
    Real<void(b2Manifold *, const b2PolygonShape *, const b2Transform &, const b2PolygonShape *,
              const b2Transform &)>(
        "_Z17b2CollidePolygonsP10b2ManifoldPK14b2PolygonShapeRK11b2TransformS3_S6_")(manifold, a, xfA, b,
                                                                                     xfB);
    if (oddity == Oddity::kHastyManifold)
        manifold->localNormal = before;
    if (oddity == Oddity::kSlowManifold)
        manifold->localNormal.SetZero();
}

constexpr char kBoxOfPolygon[] = "_ZNK14b2PolygonShape11ComputeAABBEP6b2AABBRK11b2Transformi";
void BoxOfPolygon(const b2PolygonShape *shape, b2AABB *box, const b2Transform &xf,
                  int32 child) __asm__("_ZNK14b2PolygonShape11ComputeAABBEP6b2AABBRK11b2Transformi");
void BoxOfPolygon(const b2PolygonShape *shape, b2AABB *box, const b2Transform &xf, int32 child) {
    Real<void(const b2PolygonShape *, b2AABB *, const b2Transform &, int32)>(kBoxOfPolygon)(shape, box, xf,
                                                                                            child);
    if (oddity != Oddity::kFusedBox)
        return;
    const b2Vec2 r(shape->m_radius, shape->m_radius);
    box->lowerBound.Set(b2_maxFloat, b2_maxFloat);
    box->upperBound = -box->lowerBound;
    for (int32 i = 0; i < shape->m_count; ++i) {
        const b2Vec2 v = shape->m_vertices[i];
        const b2Vec2 at(std::fma(xf.q.c, v.x, -(xf.q.s * v.y)) + xf.p.x,
                        std::fma(xf.q.s, v.x, xf.q.c * v.y) + xf.p.y);
        box->lowerBound = b2Min(box->lowerBound, at);
        box->upperBound = b2Max(box->upperBound, at);
    }
    box->lowerBound -= r;
    box->upperBound += r;
}

void Impact(b2TOIOutput *output,
            const b2TOIInput *input) __asm__("_Z14b2TimeOfImpactP11b2TOIOutputPK10b2TOIInput");
void Impact(b2TOIOutput *output, const b2TOIInput *input) {
    Real<void(b2TOIOutput *, const b2TOIInput *)>("_Z14b2TimeOfImpactP11b2TOIOutputPK10b2TOIInput")(output,
                                                                                                    input);
    const bool points = input->proxyA.m_count == 1;
    if (points && oddity == Oddity::kOtherSlop)
        output->t = 0.9925f;
    if (points && oddity == Oddity::kOtherUnits)
        output->t = 0.95f;
}

/// The box of a tree whose extension is larger by so much.
b2AABB Larger(b2AABB box, float x, float y) {
    box.lowerBound -= b2Vec2(x, y);
    box.upperBound += b2Vec2(x, y);
    return box;
}
b2AABB OddBox(const b2AABB &box) {
    switch (oddity) {
    case Oddity::kOtherExtension:
        return Larger(box, b2_aabbExtension, b2_aabbExtension);
    case Oddity::kOtherUnits:
        return Larger(box, 9.0f * b2_aabbExtension, 9.0f * b2_aabbExtension);
    default:
        return box;
    }
}

int32 MakeProxy(b2DynamicTree *tree, const b2AABB &box,
                void *userData) __asm__("_ZN13b2DynamicTree11CreateProxyERK6b2AABBPv");
int32 MakeProxy(b2DynamicTree *tree, const b2AABB &box, void *userData) {
    return Real<int32(b2DynamicTree *, const b2AABB &, void *)>(
        "_ZN13b2DynamicTree11CreateProxyERK6b2AABBPv")(tree, OddBox(box), userData);
}

b2Joint *MakeJoint(b2World *world, const b2JointDef *def) __asm__("_ZN7b2World11CreateJointEPK10b2JointDef");
b2Joint *MakeJoint(b2World *world, const b2JointDef *def) {
    b2FrictionJointDef read;
    std::memcpy(static_cast<void *>(&read), static_cast<const void *>(def), sizeof read);
    // The bodies are where a user datum of two pointers, or of half a one, has them.
    const auto *const *bodies = reinterpret_cast<b2Body *const *>(&def->bodyA);
    if (oddity == Oddity::kLargerUserDataOfJoint)
        std::memcpy(static_cast<void *>(&read.bodyA), bodies + 1, 2 * sizeof *bodies);
    if (oddity == Oddity::kSmallerUserDataOfJoint)
        std::memcpy(static_cast<void *>(&read.bodyA), bodies - 1, 2 * sizeof *bodies);
    b2Joint *joint = Real<b2Joint *(b2World *, const b2JointDef *)>(
        "_ZN7b2World11CreateJointEPK10b2JointDef")(world, &read);
    if (oddity == Oddity::kUserDataOfJointElsewhere)
        joint->GetUserData().pointer >>= 32;
    return joint;
}

/// As where b2_maxPolygonVertices is another.
void LayOut(b2PolygonShape *shape, size_t vertices) {
    auto *bytes = reinterpret_cast<unsigned char *>(shape->m_vertices);
    b2Vec2 normals[4];
    std::memcpy(normals, shape->m_normals, sizeof normals);
    std::memset(bytes + sizeof normals, 0, sizeof shape->m_vertices);
    std::memcpy(bytes + vertices * sizeof *normals, normals, sizeof normals);
    shape->m_count = 0;
}

void MakeBox(b2PolygonShape *shape, float hx, float hy) __asm__("_ZN14b2PolygonShape8SetAsBoxEff");
void MakeBox(b2PolygonShape *shape, float hx, float hy) {
    Real<void(b2PolygonShape *, float, float)>("_ZN14b2PolygonShape8SetAsBoxEff")(shape, hx, hy);
    if (oddity == Oddity::kMoreVertices)
        LayOut(shape, 32);
    if (oddity == Oddity::kFewerVertices)
        LayOut(shape, 7);
    if (oddity == Oddity::kNoNormals)
        LayOut(shape, 0);
}

TEST_CASE("the Box2D of this process is known, as often as it is asked") {
    CHECK(Why(Oddity::kNone) == "");
    CHECK(Why(Oddity::kNone) == "");
}

TEST_CASE("another size is noticed, also of user data") {
    const struct {
        Oddity oddity;
        const char *record;
    } kRows[] = {
        {Oddity::kLargerWorld, "b2World has"},
        {Oddity::kSmallerWorld, "b2World has"},
        {Oddity::kLargerBody, "b2Body or its user data have"},
        {Oddity::kLargerUserDataOfBody, "b2Body or its user data have"},
        {Oddity::kSmallerUserDataOfBody, "b2Body or its user data have"},
        {Oddity::kLargerFixture, "b2Fixture or its user data have"},
        {Oddity::kLargerUserDataOfFixture, "b2Fixture or its user data have"},
        {Oddity::kSmallerUserDataOfFixture, "b2Fixture or its user data have"},
        {Oddity::kLargerShape, "b2PolygonShape has"},
        {Oddity::kNoNormals, "b2PolygonShape has"},
        {Oddity::kLargerContact, "b2Contact has"},
        {Oddity::kSmallerContact, "b2Contact has"},
        {Oddity::kLargerUserDataOfJoint, "b2JointUserData has"},
        {Oddity::kSmallerUserDataOfJoint, "b2JointUserData has"},
        {Oddity::kUserDataOfJointElsewhere, "b2JointUserData has"},
    };
    for (const auto &row : kRows) {
        CAPTURE(row.record);
        CHECK(Why(row.oddity).rfind(row.record + std::string(" not the size that "), 0) == 0);
    }
}

TEST_CASE("another constant is noticed, and named") {
    CHECK(Why(Oddity::kMoreVertices) ==
          "b2_maxPolygonVertices is 32 here, 8 in the Box2D this was built for");
    CHECK(Why(Oddity::kFewerVertices) ==
          "b2_maxPolygonVertices is 7 here, 8 in the Box2D this was built for");
    CHECK(Why(Oddity::kOtherExtension) ==
          "b2_aabbExtension is 0.2 here, 0.1 in the Box2D this was built for");
    CHECK(Why(Oddity::kOtherSlop) == "b2_linearSlop is 0.0075 here, 0.005 in the Box2D this was built for");
    CHECK(Why(Oddity::kOtherUnits) == "b2_lengthUnitsPerMeter is 10 here, 1 in the Box2D this was built for");
}

TEST_CASE("the library's own check is asked first") {
    bmr::SetLibraryCheck([] { return "no symbols"; });
    CHECK(Why(Oddity::kLargerWorld) == "no symbols");
    bmr::SetLibraryCheck(nullptr);
}

TEST_CASE("a Box2D whose polygons have manifolds or boxes of other bits is noticed") {
    const bool stock = bmr::Box2DRoundsAsExact32();
    for (const Oddity odd : {Oddity::kHastyManifold, Oddity::kSlowManifold, Oddity::kFusedBox}) {
        oddity = odd;
        CHECK(!bmr::Box2DRoundsAsExact32());
    }
    oddity = Oddity::kNone;
    CHECK(bmr::Box2DRoundsAsExact32() == stock);
}

TEST_CASE("a Box2D that rounds otherwise is refused, with a sentence") {
    const std::string said = as_stock::InChild([](as_stock::Run &run) {
        oddity = Oddity::kSlowManifold;
        run.Print("%s", StderrOf([] { bmr::Install(); }).c_str());
    });
    CHECK(said ==
          "boomerang: not at work, Box2D runs as it is: this Box2D fuses products (as compilers do for "
          "ARM64, and with -march=haswell), or has fast-math. Compile it with -ffp-contract=off -mno-fma and "
          "without, or use boomerang_accelerate()\n\n");
}
