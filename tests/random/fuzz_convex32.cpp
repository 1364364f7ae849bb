// SPDX-License-Identifier: MIT
// Pairs of the plugin's polygons in float: manifolds and separations have the bits of plain loops over all
// vertices (convex32_reference.h), distances, casts and times of impact are true in rational
// arithmetic.
#include <algorithm>
#include <cmath>
#include <vector>

#include "convex32/convex32_collide.h"
#include "convex32/convex32_distance.h"
#include "convex32_poses.h"
#include "convex32_reference.h"
#include "exact.h"
#include "exact_distance.h"
#include "harness.h"
#include "points.h"

namespace {

constexpr float kSlop = 0.005f;
constexpr size_t kMost = 40;

using exact::Distance;
using exact::Posed;

/// A polygon, or one or two points, with a skin.
struct Shape {
    bmr_convex32_block *block = nullptr;
    std::vector<bmr_vec32> vertices;
    std::vector<bmr_vec2> hull; ///< of the vertices: some are convex but for rounding
    float radius = 0.0f;

    Shape() = default;
    Shape(const Shape &) = delete;
    Shape &operator=(const Shape &) = delete;
    ~Shape() { bmr_convex32_destroy(block, nullptr); }

    const bmr_convex32 *Polygon() const { return &block->polygon; }
    bmr_proxy32 Proxy() const {
        return block != nullptr
                   ? bmr_proxy32_polygon(block, radius)
                   : bmr_proxy32_points(vertices.data(), static_cast<uint32_t>(vertices.size()), radius);
    }
    double Reach() const { return double{Proxy().reach}; }
};

/// Of a size from 1/16 to 64 about an origin not far away: what the bounds below are relative to.
void ReadPolygon(fuzz_bytes *bytes, Shape *shape) {
    const uint8_t how = fuzz_u8(bytes);
    if (how % 2 == 0) {
        test_random d = {1u + fuzz_u16(bytes)};
        const uint32_t count = how % 64 == 2 ? 8 + fuzz_u16(bytes) % 500 : 3 + fuzz_below(bytes, 40);
        shape->block = random_convex32(&d, static_cast<convex32_kind>(how / 2 % KINDS), count);
    } else {
        bmr_vec2 wide[kMost + 12];
        const int exponent = static_cast<int>(fuzz_below(bytes, 8)) - 2;
        const size_t count = fuzz_points(bytes, wide, kMost);
        bmr_vec2 low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
        for (size_t i = 0; i < count; ++i) {
            low = {std::fmin(low.x, wide[i].x), std::fmin(low.y, wide[i].y)};
            high = {std::fmax(high.x, wide[i].x), std::fmax(high.y, wide[i].y)};
        }
        const double side = std::fmax(high.x - low.x, high.y - low.y);
        std::vector<bmr_vec32> points;
        for (size_t i = 0; i < count && side > 0.0 && side < 1e300; ++i)
            points.push_back({static_cast<float>(std::ldexp((wide[i].x - low.x) / side - 0.5, exponent)),
                              static_cast<float>(std::ldexp((wide[i].y - low.y) / side - 0.5, exponent))});
        if (bmr_convex32_create(points.data(), points.size(), nullptr, &shape->block) != BMR_OK)
            shape->block = nullptr;
    }
    shape->radius = how >= 192 ? static_cast<float>(fuzz_in(bytes, 0.0, 0.5)) : 2.0f * kSlop;
    if (shape->block != nullptr)
        shape->vertices.assign(shape->Polygon()->vertices,
                               shape->Polygon()->vertices + shape->Polygon()->count);
}

/// The second of a pair may be a circle or an edge.
void ReadShape(fuzz_bytes *bytes, Shape *shape) {
    const uint8_t how = fuzz_u8(bytes);
    if (how % 4 != 0) {
        ReadPolygon(bytes, shape);
        return;
    }
    for (int i = 0; i <= how / 4 % 2; ++i) {
        const float x = static_cast<float>(fuzz_in(bytes, -2.0, 2.0));
        shape->vertices.push_back({x, static_cast<float>(fuzz_in(bytes, -2.0, 2.0))});
    }
    shape->radius = static_cast<float>(fuzz_in(bytes, 0.0, 1.0));
}

bmr_transform32 PoseOf(double x, double y, double angle) {
    return {{static_cast<float>(x), static_cast<float>(y)},
            static_cast<float>(std::sin(angle)),
            static_cast<float>(std::cos(angle))};
}

bmr_transform32 ReadPose(fuzz_bytes *bytes, double range) {
    const double x = fuzz_in(bytes, -range, range), y = fuzz_in(bytes, -range, range);
    const uint8_t how = fuzz_u8(bytes);
    return PoseOf(x, y,
                  how < 64   ? 0.0
                  : how < 96 ? 1.5707963267948966 * (how % 4)
                             : fuzz_in(bytes, -3.2, 3.2));
}

bmr_convex32_memory ReadMemory(fuzz_bytes *bytes) {
    bmr_convex32_memory memory = {0, 0, 0, 0};
    if (fuzz_u8(bytes) % 2 != 0) {
        memory.support_a = fuzz_u16(bytes);
        memory.support_b = fuzz_u16(bytes);
        memory.axis_x = static_cast<int16_t>(fuzz_u16(bytes));
        memory.axis_y = static_cast<int16_t>(fuzz_u16(bytes));
    }
    return memory;
}

std::vector<bmr_vec2> Widened(const std::vector<bmr_vec32> &vertices) {
    std::vector<bmr_vec2> points;
    for (const bmr_vec32 v : vertices)
        points.push_back({v.x, v.y});
    return points;
}

Posed Placed(const Shape &shape, const bmr_pose &pose) {
    return {shape.hull, pose};
}

Posed Placed(const Shape &shape, const bmr_transform32 &pose) {
    return Placed(shape, bmr_pose{{pose.p.x, pose.p.y}, pose.c, pose.s});
}

struct Pair {
    Shape a, b;
    bmr_transform32 poseA, poseB;
    double size; ///< what float's rounding is relative to
};

void CheckManifold(const char *what, const bmr_manifold32 &expected, bmr_manifold32 got) {
    if (fuzz_control("manifold")) {
        got.normal.x += 1e-6f;
        got.count ^= 1;
    }
    FUZZ_CHECK(reference_same_manifold(&expected, &got),
               "%s: %d points of type %d, expected %d of type %d; normals (%a, %a), (%a, %a)", what,
               got.count, got.type, expected.count, expected.type, double{got.normal.x}, double{got.normal.y},
               double{expected.normal.x}, double{expected.normal.y});
}

void CheckCollide(const Pair &p, fuzz_bytes *bytes) {
    bmr_convex32_memory memory = ReadMemory(bytes);
    bmr_manifold32 expected = {}, got = {};
    const float skins = p.a.radius + p.b.radius;
    reference_collide(&expected, p.a.Polygon(), &p.poseA, p.b.Polygon(), &p.poseB, skins, 0.1f * kSlop);
    for (int i = 0; i < 2; ++i) { // the second time remembering the first
        got = {};
        bmr_convex32_collide(&got, p.a.Polygon(), &p.poseA, p.b.Polygon(), &p.poseB, skins, 0.1f * kSlop,
                             &memory);
        CheckManifold("polygons", expected, got);
    }
    // Features that last: all different, and the old ones where the points are the old ones.
    bmr_manifold32 kept = got;
    bmr_convex32_keep_features(&kept, &got, 0.01f);
    for (int i = 0; i < got.count; ++i)
        FUZZ_CHECK(memcmp(&kept.points[i].feature, &got.points[i].feature, sizeof(bmr_feature32)) == 0 ||
                       memcmp(&got.points[0].feature, &got.points[1].feature, sizeof(bmr_feature32)) == 0,
                   "the features of the same manifold change");
    FUZZ_CHECK(kept.count < 2 ||
                   memcmp(&kept.points[0].feature, &kept.points[1].feature, sizeof(bmr_feature32)) != 0,
               "two points of one feature");
}

void CheckCircle(const Pair &p, fuzz_bytes *bytes) {
    bmr_convex32_memory memory = ReadMemory(bytes);
    bmr_manifold32 expected = {}, got = {};
    const bmr_vec32 centre = p.b.vertices[0];
    const float skins = p.a.radius + p.b.radius;
    reference_collide_circle(&expected, p.a.Polygon(), &p.poseA, centre, &p.poseB, skins);
    bmr_convex32_collide_circle(&got, p.a.Polygon(), &p.poseA, centre, &p.poseB, skins, &memory);
    CheckManifold("circle", expected, got);
}

void CheckEdge(const Pair &p, fuzz_bytes *bytes) {
    bmr_convex32_memory memory = ReadMemory(bytes);
    bmr_manifold32 expected = {}, got = {};
    bmr_edge32 edge;
    for (bmr_vec32 *v : {&edge.before, &edge.first, &edge.second, &edge.after}) {
        v->x = static_cast<float>(fuzz_in(bytes, -4.0, 4.0));
        v->y = static_cast<float>(fuzz_in(bytes, -4.0, 4.0));
    }
    edge.one_sided = fuzz_u8(bytes) % 2 != 0;
    if (std::hypot(edge.second.x - edge.first.x, edge.second.y - edge.first.y) < kSlop)
        return; // none of Box2D's
    const float skins = p.a.radius + 2.0f * kSlop;
    reference_collide_edge(&expected, &edge, &p.poseB, p.a.Polygon(), p.a.block->mass.centroid, &p.poseA,
                           skins);
    bmr_convex32_collide_edge(&got, &edge, &p.poseB, p.a.Polygon(), p.a.block->mass.centroid, &p.poseA, skins,
                              &memory);
    CheckManifold("edge", expected, got);
}

void CheckSeparation(const Pair &p, fuzz_bytes *bytes) {
    uint32_t first, edge, vertex;
    const bmr_transform32 frame = bmr_exact32_relative(&p.poseB, &p.poseA);
    const float expected = reference_max_separation(p.a.Polygon(), &p.poseA, p.b.Polygon(), &p.poseB, &first);
    float got =
        bmr_convex32_max_separation(p.a.Polygon(), p.b.Polygon(), &frame, fuzz_u16(bytes), &edge, &vertex);
    if (fuzz_control("separation"))
        got = std::nextafter(got, INFINITY);
    FUZZ_CHECK(got == expected && edge == first && vertex < p.b.Polygon()->count,
               "separation %a of edge %u, expected %a of %u", double{got}, edge, double{expected}, first);
}

void CheckApart(const Pair &p, fuzz_bytes *bytes) {
    bmr_convex32_memory memory = ReadMemory(bytes);
    const float reach = static_cast<float>(fuzz_u8(bytes) % 2 == 0 ? 0.0 : p.size * fuzz_in(bytes, 0.0, 1.0));
    const double truth = Distance(Placed(p.a, p.poseA), Placed(p.b, p.poseB));
    bool apart = false;
    for (int i = 0; i < 3; ++i)
        apart = bmr_convex32_apart(p.a.Polygon(), &p.poseA, p.b.Polygon(), &p.poseB, reach, &memory) || apart;
    FUZZ_CHECK(!(apart || fuzz_control("apart")) || truth > double{reach},
               "said to be farther apart than %g, at %g", double{reach}, truth);
}

void CheckDistance(const Pair &p, fuzz_bytes *bytes) {
    const bmr_proxy32 a = p.a.Proxy(), b = p.b.Proxy();
    bmr_closest32 closest = {0, 0};
    if (fuzz_u8(bytes) % 2 != 0)
        closest = {fuzz_u16(bytes), fuzz_u16(bytes)};
    const double truth = Distance(Placed(p.a, p.poseA), Placed(p.b, p.poseB));
    const bmr_distance32 found = bmr_convex32_distance(&a, &p.poseA, &b, &p.poseB, &closest);
    const double scale = std::max(truth, std::max(p.a.Reach(), p.b.Reach()));
    const double said = double{found.distance} + (fuzz_control("distance") ? 1e-3 * scale : 0.0);
    FUZZ_CHECK(std::fabs(said - truth) <= 1e-6 * scale, "distance %g, really %g", said, truth);
    const double dx = double{found.point_b.x} - double{found.point_a.x};
    const double dy = double{found.point_b.y} - double{found.point_a.y};
    FUZZ_CHECK(std::fabs(std::hypot(dx, dy) - said) <= 1e-6 * (scale + p.size + 20.0),
               "points %g apart, distance %g", std::hypot(dx, dy), said);
    FUZZ_CHECK(found.count >= 1 && found.count <= 3, "a simplex of %d", found.count);
    for (int i = 0; i < found.count; ++i)
        FUZZ_CHECK(found.vertex_a[i] < p.a.vertices.size() && found.vertex_b[i] < p.b.vertices.size(),
                   "vertices %u and %u", found.vertex_a[i], found.vertex_b[i]);
}

/// b on its way to a, and what a cast looks for.
struct Way {
    const Pair &p;
    bmr_vec32 translation;
    Posed still;
    double skinA, sigma;
    double tolerance; ///< this much more than sigma counts as reached
    double slack;     ///< of float answers

    Way(const Pair &pair, bmr_vec32 way, double length)
        : p(pair), translation(way), still(Placed(pair.a, pair.poseA)) {
        const double slop = double{kSlop};
        const double skinB = std::max(double{p.b.radius}, 2.0 * slop);
        skinA = std::max(double{p.a.radius}, 2.0 * slop);
        sigma = std::max(2.0 * slop, skinA + skinB - 2.0 * slop);
        tolerance = 0.5 * slop;
        slack = 1e-5 * (10.0 + length + p.size);
    }
    Posed Moved(double lambda) const {
        Posed moved = Placed(p.b, p.poseB);
        moved.pose.position.x += lambda * translation.x;
        moved.pose.position.y += lambda * translation.y;
        return moved;
    }
    double At(double lambda) const { return Distance(still, Moved(lambda)); }
    bool FirstTwoWithin(double most) const;
};

/// May the first two vertices that a cast looks at, the farthest of a against the way and of b along it, be
/// so near? Supports are chosen in float: any that is the farthest to rounding may be one.
bool Way::FirstTwoWithin(double most) const {
    // A direction, two products and a sum are rounded, of the farthest and of the one chosen.
    const long double rounding =
        0x1p-21L * std::hypot(translation.x, translation.y) * (p.a.Reach() + p.b.Reach()) + 1e-40L;
    const std::vector<bmr_vec2> a = Widened(p.a.vertices), b = Widened(p.b.vertices);
    const bmr_pose poseB = Moved(0.0).pose;
    const auto along = [&](const bmr_pose &pose, bmr_vec2 v) {
        const bmr_vec2 at = bmr_transform(&pose, v);
        return at.x * translation.x + at.y * translation.y;
    };
    long double leastA = INFINITY, mostB = -INFINITY;
    for (const bmr_vec2 &v : a)
        leastA = std::min<long double>(leastA, along(still.pose, v));
    for (const bmr_vec2 &w : b)
        mostB = std::max<long double>(mostB, along(poseB, w));
    for (const bmr_vec2 &v : a)
        for (const bmr_vec2 &w : b)
            if (along(still.pose, v) <= leastA + rounding && along(poseB, w) >= mostB - rounding &&
                Distance({{v}, still.pose}, {{w}, poseB}) <= most)
                return true;
    return false;
}

void CheckHit(const Way &way, const bmr_cast32 &cast, double lambda) {
    const double there = way.At(lambda);
    FUZZ_CHECK(there <= way.sigma + way.tolerance + way.slack, "a hit at %g, %g apart", lambda, there);
    const double nx = double{fuzz_control("cast-normal") ? -cast.normal.x : cast.normal.x};
    const double ny = double{cast.normal.y};
    const double along = static_cast<double>(exact::SeparationAlong({nx, ny}, way.still, way.Moved(lambda)));
    FUZZ_CHECK(std::fabs(std::hypot(nx, ny) - 1.0) <= 1e-6 && std::fabs(along - there) <= way.slack,
               "a normal of length %g along which they are %g apart, really %g", std::hypot(nx, ny), along,
               there);
    const double skin = Distance(way.still, exact::PosedOf(bmr_vec2{cast.point.x, cast.point.y}));
    FUZZ_CHECK(std::fabs(skin - way.skinA) <= way.slack, "a point %g from a, its skin is %g", skin,
               way.skinA);
}

/// False where there is one whatever comes later: as the two begin.
bool CheckMiss(const Way &way, const bmr_cast32 &cast) {
    FUZZ_CHECK(cast.lambda == 1.0f && cast.normal.x == 0.0f && cast.normal.y == 0.0f &&
                   cast.point.x == 0.0f && cast.point.y == 0.0f,
               "a miss wrote its outputs");
    const double reached = way.sigma + way.tolerance, rounding = 0x1p-40 * way.p.size; // both are double's
    if (way.At(0.0) <= rounding || way.FirstTwoWithin(reached + rounding))
        return false;
    FUZZ_CHECK(way.At(0.0) >= reached - way.slack, "a miss, but %g apart at the beginning, sigma %g",
               way.At(0.0), way.sigma);
    return true;
}

void CheckCast(const Pair &p, fuzz_bytes *bytes) {
    const bmr_proxy32 a = p.a.Proxy(), b = p.b.Proxy();
    const double length = 3.0 * (p.a.Reach() + p.b.Reach());
    const bmr_vec32 translation = {static_cast<float>(fuzz_in(bytes, -length, length)),
                                   static_cast<float>(fuzz_in(bytes, -length, length))};
    bmr_cast32 cast;
    bool hit = bmr_convex32_cast(&a, &p.poseA, &b, &p.poseB, translation, kSlop, &cast);
    if (fuzz_control("cast-miss")) {
        hit = false;
        cast = {{0.0f, 0.0f}, {0.0f, 0.0f}, 1.0f, 0};
    }
    const Way way(p, translation, length);
    const double lambda = double{cast.lambda} + (fuzz_control("cast") && hit ? 0.3 : 0.0);
    if (hit)
        CheckHit(way, cast, lambda);
    else if (!CheckMiss(way, cast))
        return;
    for (int i = 0; i <= 20 && lambda > 0.0; ++i)
        FUZZ_CHECK(way.At(lambda * i / 20) >= way.sigma - way.slack,
                   "a %s at %g, but %g apart at %g, sigma %g", hit ? "hit" : "miss", lambda,
                   way.At(lambda * i / 20), lambda * i / 20, way.sigma);
}

bmr_sweep32 ReadSweep(fuzz_bytes *bytes, double range, bool turns) {
    const auto in = [bytes](double most) { return static_cast<float>(fuzz_in(bytes, -most, most)); };
    bmr_sweep32 sweep;
    sweep.local_center = {in(1.0), in(1.0)};
    sweep.c0 = {in(range), in(range)};
    sweep.c = {sweep.c0.x + in(range), sweep.c0.y + in(range)};
    sweep.a0 = in(10.0);
    sweep.a = sweep.a0 + (turns ? in(6.0) : 0.0f);
    sweep.alpha0 = 0.0f;
    return sweep;
}

Posed At(const Shape &shape, const bmr_sweep32 &sweep, double t) {
    const double angle = (1.0 - t) * sweep.a0 + t * sweep.a, s = std::sin(angle), c = std::cos(angle);
    const double lx = sweep.local_center.x, ly = sweep.local_center.y;
    return Placed(shape, bmr_pose{{(1.0 - t) * sweep.c0.x + t * sweep.c.x - (c * lx - s * ly),
                                   (1.0 - t) * sweep.c0.y + t * sweep.c.y - (s * lx + c * ly)},
                                  c,
                                  s});
}

void CheckImpact(const Pair &p, fuzz_bytes *bytes) {
    constexpr int kSamples = 40;
    const bmr_proxy32 a = p.a.Proxy(), b = p.b.Proxy();
    const double range = p.a.Reach() + p.b.Reach();
    const uint8_t how = fuzz_u8(bytes);
    const bmr_sweep32 sweepA = ReadSweep(bytes, range, how % 2 != 0),
                      sweepB = ReadSweep(bytes, 1.5 * range, how % 4 >= 2);
    const float most = how % 8 >= 4 ? 1.0f : static_cast<float>(fuzz_in(bytes, 0.1, 1.0));
    const double angle = fuzz_in(bytes, -3.2, 3.2);
    bmr_vec32 direction = {0.0f, 0.0f};
    if (how >= 128)
        direction = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
    float time = -1.0f;
    const bmr_impact32 state = bmr_convex32_impact(&a, &sweepA, &b, &sweepB, most, kSlop, &direction, &time);
    bmr_vec32 other = {direction.y, -direction.x}; // what is remembered, good or not, changes nothing
    float again = -1.0f;
    const bmr_impact32 same = bmr_convex32_impact(&a, &sweepA, &b, &sweepB, most, kSlop, &other, &again);
    FUZZ_CHECK(same == state && again == time, "state %d at %g, from another direction %d at %g", state,
               double{time}, same, double{again});
    const double t = double{time} + (fuzz_control("impact") && state == BMR_IMPACT_TOUCHING ? 0.2 : 0.0);
    const double target = std::max(double{kSlop}, double{p.a.radius + p.b.radius - 3.0f * kSlop});
    const double slack = 4e-6 * (range + 2.0);
    const auto gap = [&](double at) { return Distance(At(p.a, sweepA, at), At(p.b, sweepB, at)); };
    const double there = gap(t);
    // Sweeps turn by up to 6 radians: the header knows of none that is given up, and asks to be shown one.
    FUZZ_CHECK(state != BMR_IMPACT_FAILED, "given up at %g", t);
    FUZZ_CHECK(state != BMR_IMPACT_OVERLAPPED || (time == 0.0f && there <= slack),
               "overlapping at %g, %g apart", t, there);
    FUZZ_CHECK(state != BMR_IMPACT_SEPARATED || time == most, "separated until %g", t);
    if (state == BMR_IMPACT_TOUCHING)
        FUZZ_CHECK(there <= target + 0.25 * double{kSlop} + slack && (t == 0.0 || there >= target - slack),
                   "touching at %g, %g apart, target %g", t, there, target);
    for (int i = 0; i <= kSamples && t > 0.0; ++i)
        FUZZ_CHECK(gap(t * i / kSamples) >= target - slack, "state %d at %g, but %g apart at %g, target %g",
                   state, t, gap(t * i / kSamples), t * i / kSamples, target);
}

void Ask(const Pair &p, fuzz_bytes *bytes) {
    const bool polygons = p.b.block != nullptr;
    switch (fuzz_below(bytes, 9)) {
    case 0:
        return polygons ? CheckCollide(p, bytes) : CheckCircle(p, bytes);
    case 1:
        return CheckCircle(p, bytes);
    case 2:
        return CheckEdge(p, bytes);
    case 3:
        return polygons ? CheckSeparation(p, bytes) : CheckDistance(p, bytes);
    case 4:
        return polygons ? CheckApart(p, bytes) : CheckDistance(p, bytes);
    case 5:
        return CheckDistance(p, bytes);
    case 6:
        return CheckCast(p, bytes);
    default:
        return CheckImpact(p, bytes);
    }
}

} // namespace

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_bytes bytes = fuzz_bytes_make(data, size);
    Pair p;
    ReadPolygon(&bytes, &p.a);
    ReadShape(&bytes, &p.b);
    if (p.a.block == nullptr || p.b.vertices.empty())
        return 0;
    for (Shape *shape : {&p.a, &p.b})
        shape->hull = exact::HullOf(Widened(shape->vertices));
    for (uint32_t questions = 1 + fuzz_below(&bytes, 6); questions > 0; --questions) {
        const uint8_t how = fuzz_u8(&bytes);
        const double range = p.a.Reach() + p.b.Reach();
        p.poseA = how % 2 == 0 ? PoseOf(0.0, 0.0, 0.0) : ReadPose(&bytes, 20.0);
        if (p.b.block != nullptr && how % 4 < 2) { // against each other, or nearly
            test_random d = {1u + fuzz_u16(&bytes)};
            p.poseB =
                pose_against(&d, p.a.Polygon(), &p.poseA, p.b.Polygon(), double{p.a.radius + p.b.radius});
        } else {
            p.poseB = ReadPose(&bytes, range);
            p.poseB.p.x += p.poseA.p.x;
            p.poseB.p.y += p.poseA.p.y;
        }
        p.size = range + std::fabs(double{p.poseA.p.x}) + std::fabs(double{p.poseA.p.y});
        Ask(p, &bytes);
    }
    return 0;
}
