// SPDX-License-Identifier: MIT
// The manifold of core/exact32 against b2CollidePolygons itself, byte by byte, what is not written included.
#include <cfenv>

#include "box2d_shapes.h"
#include "cases.h"
#include "shapes/shapes32.h"

namespace {

using bmr::Polygon32;
using bmr::Transform32;
using namespace shapes;

constexpr float kTolerance = 0.1f * b2_linearSlop;
constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();

struct Scene {
    b2PolygonShape a, b;
    b2Transform xfA, xfB;
};

using Collide = std::function<decltype(bmr_exact32_collide)>;

/// All of a manifold; a NaN is a NaN, whatever its sign and payload: they hang on the order in which a
/// compiler puts the factors of a product.
struct Words {
    uint32_t word[sizeof(b2Manifold) / 4];
};

Words WordsOf(const void *manifold) {
    Words w;
    std::memcpy(&w, manifold, sizeof w);
    for (const size_t i : {0u, 1u, 5u, 6u, 10u, 11u, 12u, 13u}) { // the places and the normal
        float f;
        std::memcpy(&f, &w.word[i], sizeof f);
        if (std::isnan(f))
            w.word[i] = 0x7fc00000u;
    }
    return w;
}

// A pattern that neither side writes by accident.
constexpr int kUnwritten = 0x5a;

Words OfBox2D(const Scene &s, b2Manifold *manifold) {
    std::memset(static_cast<void *>(manifold), kUnwritten, sizeof *manifold);
    b2CollidePolygons(manifold, &s.a, s.xfA, &s.b, s.xfB);
    return WordsOf(manifold);
}

Words Ours(const Scene &s, const Collide &collide, int32_t *edge) {
    bmr_manifold32 manifold;
    std::memset(&manifold, kUnwritten, sizeof manifold);
    const bmr_polygon32 a = Polygon32(s.a), b = Polygon32(s.b);
    *edge = collide(&manifold, &a, Transform32(s.xfA), &b, Transform32(s.xfB), s.a.m_radius + s.b.m_radius,
                    kTolerance);
    return WordsOf(&manifold);
}

/// What came up, and what was not the same.
struct Tally {
    size_t scenes = 0, different = 0, points[3] = {}, faceB = 0, cut = 0, leftEarly = 0, wrongEdges = 0;
};

/// An edge that is given back separates by more than the skins, and is the largest of its polygon.
bool EdgeIsRight(const Scene &s, int32_t edge, bool leftEarly) {
    if (edge == BMR_NO_EDGE32)
        return !leftEarly;
    const bool ofB = edge >= BMR_EDGES_OF_B32;
    const bmr_polygon32 owner = Polygon32(ofB ? s.b : s.a), other = Polygon32(ofB ? s.a : s.b);
    const bmr_transform32 frame =
        bmr_exact32_relative(Transform32(ofB ? s.xfA : s.xfB), Transform32(ofB ? s.xfB : s.xfA));
    int32_t largest = 0;
    const float separation = bmr_exact32_max_separation(&owner, &other, &frame, &largest);
    return leftEarly && edge - (ofB ? BMR_EDGES_OF_B32 : 0) == largest &&
           separation > s.a.m_radius + s.b.m_radius;
}

void Compare(const Scene &s, const Collide &collide, Tally *t) {
    b2Manifold manifold;
    const Words expected = OfBox2D(s, &manifold);
    int32_t edge = 0;
    const Words found = Ours(s, collide, &edge);
    uint32_t pattern;
    std::memset(&pattern, kUnwritten, sizeof pattern);
    const bool leftEarly = expected.word[offsetof(b2Manifold, type) / 4] == pattern;
    ++t->scenes;
    ++t->points[manifold.pointCount];
    t->leftEarly += leftEarly;
    t->faceB += !leftEarly && manifold.type == b2Manifold::e_faceB;
    for (int i = 0; i < manifold.pointCount; ++i)
        t->cut += manifold.points[i].id.cf.typeA == manifold.points[i].id.cf.typeB ? 0 : 1;
    t->different += std::memcmp(&expected, &found, sizeof found) != 0;
    t->wrongEdges += !EdgeIsRight(s, edge, leftEarly);
}

/// What lies past the count is whatever was there.
void SpoilTheRest(b2PolygonShape *shape) {
    for (int i = shape->m_count; i < b2_maxPolygonVertices; ++i)
        shape->m_vertices[i] = shape->m_normals[i] = {-1e30f, kNotANumber};
}

/// With as many vertices as wished, unless Set weld some together.
b2PolygonShape Polygon(Engine &engine, int count) {
    b2PolygonShape shape;
    if (Below(engine, 3) == 0) {
        const double radius = Uniform(engine, 0.1, 2.0);
        shape.Set(Circle(count, radius, 0.0, 0.0, Uniform(engine, 0.0, 6.3)).data(), count);
        return shape;
    }
    if (count == 4 && Below(engine, 2) == 0) {
        shape.SetAsBox(UniformF(engine, 0.02, 2.0), UniformF(engine, 0.02, 2.0));
        return shape;
    }
    do
        shape = shapes::RandomPolygon(engine, 3.0);
    while (shape.m_count != count);
    return shape;
}

void Radii(Engine &engine, Scene *s) {
    if (Below(engine, 4) == 0)
        s->a.m_radius = UniformF(engine, 0.0, 3.0) * b2_polygonRadius;
    if (Below(engine, 4) == 0)
        s->b.m_radius = Below(engine, 2) == 0 ? 0.0f : UniformF(engine, -1.0, 20.0) * b2_polygonRadius;
}

/// Moved together or apart until they nearly touch, then a little more or less.
void Approach(Engine &engine, Scene *s) {
    const bmr_polygon32 a = Polygon32(s->a), b = Polygon32(s->b);
    b2Vec2 way = s->xfB.p - s->xfA.p;
    way.Normalize();
    for (int i = 0; i < 3; ++i) {
        int32_t edge;
        const bmr_transform32 aInB = bmr_exact32_relative(Transform32(s->xfB), Transform32(s->xfA)),
                              bInA = bmr_exact32_relative(Transform32(s->xfA), Transform32(s->xfB));
        const float separation = std::fmax(bmr_exact32_max_separation(&a, &b, &aInB, &edge),
                                           bmr_exact32_max_separation(&b, &a, &bInA, &edge));
        s->xfB.p -= separation * way;
    }
    s->xfB.p += UniformF(engine, -0.03, 0.03) * way;
}

using Maker = std::function<Scene(Engine &, int, int)>;

Scene Anywhere(Engine &engine, int countA, int countB) {
    Scene s = {Polygon(engine, countA), Polygon(engine, countB), {}, {}};
    s.xfA = shapes::RandomPose(engine, 3.0);
    s.xfB = shapes::RandomPose(engine, 3.0);
    Radii(engine, &s);
    return s;
}

Scene Touching(Engine &engine, int countA, int countB) {
    Scene s = Anywhere(engine, countA, countB);
    Approach(engine, &s);
    return s;
}

/// Resting face to face or nearly so, as in piles.
Scene FaceToFace(Engine &engine, int countA, int countB) {
    Scene s = Anywhere(engine, countA, countB);
    const int i = Below(engine, s.a.m_count), j = Below(engine, s.b.m_count);
    const b2Vec2 n = b2Mul(s.xfA.q, s.a.m_normals[i]), m = s.b.m_normals[j];
    const float tilt = Below(engine, 2) == 0 ? 0.0f : UniformF(engine, -1e-3, 1e-3);
    s.xfB.q.Set(std::atan2(-n.y, -n.x) - std::atan2(m.y, m.x) + tilt);
    const b2Vec2 along = b2Cross(n, 1.0f);
    const b2Vec2 place = b2Mul(s.xfA, s.a.m_vertices[i]) + UniformF(engine, -0.01, 0.03) * n +
                         UniformF(engine, -1.0, 1.0) * along;
    s.xfB.p = place - b2Mul(s.xfB.q, s.b.m_vertices[j]);
    return s;
}

/// Equal edges, exact zeros of both signs, corners on corners: all on a grid.
Scene OnAGrid(Engine &engine, int countA, int countB) {
    const auto shape = [&engine](int count) {
        b2PolygonShape made = Polygon(engine, count);
        if (count == 4)
            made.SetAsBox(0.5f * static_cast<float>(1 + Below(engine, 3)), 0.5f);
        return made;
    };
    Scene s = {shape(countA), Below(engine, 2) == 0 ? shape(countA) : shape(countB), {}, {}};
    for (b2Transform *xf : {&s.xfA, &s.xfB}) {
        constexpr float kSines[] = {0.0f, 1.0f, -0.0f, -1.0f};
        const int quarter = Below(engine, 4);
        xf->p.Set(0.5f * static_cast<float>(Below(engine, 5) - 2),
                  0.5f * static_cast<float>(Below(engine, 5) - 2));
        xf->q.s = kSines[quarter];
        xf->q.c = kSines[(quarter + 1) % 4];
    }
    if (Below(engine, 2) == 0)
        s.a.m_radius = s.b.m_radius = 0.0f;
    return s;
}

Scene FarOut(Engine &engine, int countA, int countB) {
    Scene s = Touching(engine, countA, countB);
    const float range = std::pow(10.0f, UniformF(engine, 1.0, 7.0));
    const b2Vec2 away(UniformF(engine, -1.0, 1.0) * range, UniformF(engine, -1.0, 1.0) * range);
    s.xfA.p += away;
    s.xfB.p += away;
    return s;
}

/// No polygon that Set would make: vertices and normals that have nothing to do with each other, edges
/// without length, numbers without bounds.
Scene Senseless(Engine &engine, int countA, int countB) {
    const auto number = [&engine] {
        constexpr float kSpecial[] = {0.0f,
                                      -0.0f,
                                      FLT_MIN,
                                      -FLT_MAX,
                                      FLT_MAX,
                                      std::numeric_limits<float>::infinity(),
                                      -std::numeric_limits<float>::infinity(),
                                      kNotANumber,
                                      std::numeric_limits<float>::denorm_min()};
        switch (Below(engine, 12)) {
        case 0:
            return kSpecial[Below(engine, 9)];
        case 1:
            return UniformF(engine, -1.0, 1.0) * std::pow(10.0f, UniformF(engine, -38.0, 38.0));
        case 2:
            return 0.5f * static_cast<float>(Below(engine, 5) - 2);
        default:
            return UniformF(engine, -1.0, 1.0);
        }
    };
    Scene s = Below(engine, 2) == 0 ? Touching(engine, countA, countB) : OnAGrid(engine, countA, countB);
    for (int changes = 1 + Below(engine, 6); changes > 0; --changes) {
        b2PolygonShape &shape = Below(engine, 2) == 0 ? s.a : s.b;
        b2Transform &xf = Below(engine, 2) == 0 ? s.xfA : s.xfB;
        const int i = Below(engine, shape.m_count);
        float *const places[] = {&shape.m_vertices[i].x,
                                 &shape.m_vertices[i].y,
                                 &shape.m_normals[i].x,
                                 &shape.m_normals[i].y,
                                 &xf.p.x,
                                 &xf.p.y,
                                 &xf.q.s,
                                 &xf.q.c,
                                 &shape.m_radius};
        if (Below(engine, 4) == 0)
            shape.m_vertices[i] = shape.m_vertices[(i + 1) % shape.m_count];
        else
            *places[Below(engine, 9)] = number();
    }
    return s;
}

Tally CompareAll(const Maker &make, const Collide &collide, uint64_t seed, size_t rounds) {
    Engine engine(seed);
    Tally t;
    for (size_t i = 0; i < rounds; ++i) {
        Scene s = make(engine, 3 + static_cast<int>(i % 6), 3 + static_cast<int>(i / 6 % 6));
        SpoilTheRest(&s.a);
        SpoilTheRest(&s.b);
        Compare(s, collide, &t);
    }
    return t;
}

} // namespace

TEST_CASE("manifolds have the bits of b2CollidePolygons' own, whatever the poses") {
    const struct {
        const char *name;
        Maker make;
        bool points; // does it come to all kinds of manifolds?
    } makers[] = {{"anywhere", Anywhere, true},       {"touching", Touching, true},
                  {"face to face", FaceToFace, true}, {"on a grid", OnAGrid, true},
                  {"far out", FarOut, true},          {"senseless", Senseless, true}};
    for (const auto &maker : makers) {
        INFO(std::string(maker.name));
        const Tally t = CompareAll(maker.make, bmr_exact32_collide, 11, test_scaled(80000));
        CHECK(t.different == 0);
        CHECK(t.wrongEdges == 0);
        // Everything came up that can.
        const size_t few = t.scenes / 500;
        CHECK(t.points[1] + t.points[2] > few);
        CHECK(t.points[2] > few / 4);
        CHECK(t.points[1] > 0);
        CHECK(t.faceB > few / 4);
        CHECK(t.cut > few / 4);
        CHECK(t.leftEarly > few / 4);
    }
}

TEST_CASE("nothing past the count is computed with") {
    Engine engine(12);
    // Signalling: any arithmetic with it raises FE_INVALID.
    const uint32_t trapBits = 0x7fa00000u;
    float trap;
    const auto raises = [](const Scene &s) {
        int32_t edge;
        std::feclearexcept(FE_ALL_EXCEPT);
        (void)Ours(s, bmr_exact32_collide, &edge);
        return std::fetestexcept(FE_INVALID) != 0;
    };
    size_t raised = 0, raisedByOneMore = 0;
    for (size_t i = 0; i < test_scaled(20000); ++i) {
        Scene s = FaceToFace(engine, 3 + Below(engine, 5), 3 + Below(engine, 5));
        for (b2PolygonShape *shape : {&s.a, &s.b})
            for (int j = shape->m_count; j < b2_maxPolygonVertices; ++j) {
                std::memcpy(&trap, &trapBits, sizeof trap);
                std::memcpy(&shape->m_vertices[j].x, &trapBits, sizeof trap);
                std::memcpy(&shape->m_vertices[j].y, &trapBits, sizeof trap);
                std::memcpy(&shape->m_normals[j], &shape->m_vertices[j], sizeof(b2Vec2));
            }
        raised += raises(s);
        ++s.a.m_count;
        raisedByOneMore += raises(s);
    }
    CHECK(raised == 0);
    CHECK(raisedByOneMore == test_scaled(20000)); // the control
}

TEST_CASE("control: manifolds that differ in one rounding, one tie or one feature are told apart") {
    struct Mutant {
        float radius, tolerance; ///< times what they are
        void (*spoil)(bmr_manifold32 &);
    };
    const auto nothing = [](bmr_manifold32 &) {};
    const Mutant mutants[] = {
        {1.0f, 0.9f, nothing},
        {1.0f + FLT_EPSILON, 1.0f, nothing},
        {1.0f, 1.0f,
         [](bmr_manifold32 &m) {
             if (m.count == 2 && m.points[1].feature.type_a != m.points[0].feature.type_a)
                 m.points[1].feature.index_a ^= 1;
         }},
        {1.0f, 1.0f,
         [](bmr_manifold32 &m) {
             if (m.count > 0)
                 m.points[0].point.x = std::nextafterf(m.points[0].point.x, 9.0f);
         }},
        {1.0f, 1.0f,
         [](bmr_manifold32 &m) {
             if (m.count > 0)
                 m.points[0].normal_impulse = 0.0f;
         }},
    };
    for (const Mutant &mutant : mutants) {
        const Collide collide = [&mutant](bmr_manifold32 *m, const bmr_polygon32 *a,
                                          const bmr_transform32 *ta, const bmr_polygon32 *b,
                                          const bmr_transform32 *tb, float radius, float tolerance) {
            const int32_t edge =
                bmr_exact32_collide(m, a, ta, b, tb, radius * mutant.radius, tolerance * mutant.tolerance);
            mutant.spoil(*m);
            return edge;
        };
        CHECK(CompareAll(FaceToFace, collide, 13, test_scaled(50000)).different > 0);
    }
}
