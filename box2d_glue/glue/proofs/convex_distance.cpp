// SPDX-License-Identifier: MIT
#include "glue/proofs/convex_distance.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include <box2d/b2_time_of_impact.h>

#include "convex32/convex32_distance.h"
#include "shapes/shapes32.h"
#include "start/install.h"

namespace bmr {

namespace {

static_assert(sizeof(b2Sweep) == sizeof(bmr_sweep32) && offsetof(b2Sweep, c0) == offsetof(bmr_sweep32, c0) &&
              offsetof(b2Sweep, c) == offsetof(bmr_sweep32, c) &&
              offsetof(b2Sweep, a0) == offsetof(bmr_sweep32, a0) &&
              offsetof(b2Sweep, a) == offsetof(bmr_sweep32, a));

const bmr_sweep32 *Sweep32(const b2Sweep &sweep) {
    return reinterpret_cast<const bmr_sweep32 *>(&sweep);
}

/// The buffer of a proxy of ours.
struct Mark {
    uint64_t polygon; ///< its number
    uint32_t shape;   ///< the low half of its address
    uint32_t magic;
};
static_assert(sizeof(Mark) == sizeof(b2DistanceProxy::m_buffer));
constexpr uint32_t kMagic = 0xb00343a6u;

Mark MarkOf(const b2DistanceProxy &proxy) {
    Mark mark;
    std::memcpy(&mark, proxy.m_buffer, sizeof mark);
    return mark;
}

/// Has the polygon of this block these vertices? Found out without reading the block, which another thread
/// may be freeing if it has not: a block's vertices are right behind it.
bool VerticesAreOf(const bmr_convex32_block *block, const b2Vec2 *vertices) {
    return reinterpret_cast<const bmr_vec32 *>(block + 1) == Vectors32(vertices);
}

/// The polygon that a proxy is marked with; nullptr where there is none. For small ones the buffer is not
/// read. It may be uninitialised, or have the mark of a polygon that has nothing to do with the proxy.
const bmr_convex32_block *BigOf(const b2DistanceProxy &proxy) {
    if (proxy.m_count <= b2_maxPolygonVertices)
        return nullptr;
    const Mark mark = MarkOf(proxy);
    if (mark.magic != kMagic)
        return nullptr;
    const bmr_convex32_block *block = BigPolygonOfNumber(mark.polygon);
    return block != nullptr && VerticesAreOf(block, proxy.m_vertices) &&
                   block->polygon.count == static_cast<uint32_t>(proxy.m_count)
               ? block
               : nullptr;
}

/// Two proxies, of which at least one is big.
struct Two {
    bmr_proxy32 a, b;
};

bmr_proxy32 Proxy32(const b2DistanceProxy &proxy, const bmr_convex32_block *block) {
    return block != nullptr ? bmr_proxy32_polygon(block, proxy.m_radius)
                            : bmr_proxy32_points(Vectors32(proxy.m_vertices),
                                                 static_cast<uint32_t>(proxy.m_count), proxy.m_radius);
}

/// False where none is.
bool Find(const b2DistanceProxy &a, const b2DistanceProxy &b, Two *two) {
    const bmr_convex32_block *bigA = BigOf(a), *bigB = BigOf(b);
    if (bigA == nullptr && bigB == nullptr)
        return false;
    two->a = Proxy32(a, bigA);
    two->b = Proxy32(b, bigB);
    return true;
}

/// A cache holds 8 bits of a vertex' number.
constexpr uint32_t kCachedVertices = 256;

bmr_closest32 ReadCache(const b2SimplexCache &cache, const Two &two) {
    if (cache.count == 0 || cache.count > 3)
        return {0, 0};
    return {two.a.polygon.count <= kCachedVertices ? cache.indexA[0] : 0u,
            two.b.polygon.count <= kCachedVertices ? cache.indexB[0] : 0u};
}

/// As Box2D leaves it; of numbers above 255 what is left are numbers of other vertices.
void WriteCache(b2SimplexCache *cache, const Two &two, const b2DistanceInput &input,
                const bmr_distance32 &found) {
    cache->count = static_cast<uint16>(found.count);
    b2Vec2 w[3];
    for (int32_t i = 0; i < found.count; ++i) {
        cache->indexA[i] = static_cast<uint8>(found.vertex_a[i]);
        cache->indexB[i] = static_cast<uint8>(found.vertex_b[i]);
        w[i] = b2Mul(input.transformB, *Vectors(&two.b.polygon.vertices[found.vertex_b[i]])) -
               b2Mul(input.transformA, *Vectors(&two.a.polygon.vertices[found.vertex_a[i]]));
    }
    cache->metric = found.count == 1   ? 0.0f
                    : found.count == 2 ? (w[1] - w[0]).Length()
                                       : b2Cross(w[1] - w[0], w[2] - w[0]);
}

/// Takes the skins off: the points go to the surfaces, or both between them where the skins overlap. (In
/// Box2D 2.4.2 they go to the surfaces unless the polygons themselves meet.)
void TakeRadiiOff(b2DistanceOutput *output, float radiusA, float radiusB) {
    if (IsBox2D242() && !(output->distance < b2_epsilon)) {
        b2Vec2 normal = output->pointB - output->pointA;
        normal.Normalize();
        output->distance = b2Max(0.0f, output->distance - radiusA - radiusB);
        output->pointA += radiusA * normal;
        output->pointB -= radiusB * normal;
        return;
    }
    if (output->distance > radiusA + radiusB && output->distance > b2_epsilon) {
        output->distance -= radiusA + radiusB;
        b2Vec2 normal = output->pointB - output->pointA;
        normal.Normalize();
        output->pointA += radiusA * normal;
        output->pointB -= radiusB * normal;
        return;
    }
    output->pointA = output->pointB = 0.5f * (output->pointA + output->pointB);
    output->distance = 0.0f;
}

bmr_impact32 Impact(const b2TOIInput &input, const Two &two, bmr_vec32 guess, float *t) {
    return bmr_convex32_impact(&two.a, Sweep32(input.sweepA), &two.b, Sweep32(input.sweepB), input.tMax,
                               b2_linearSlop, &guess, t);
}

b2TOIOutput::State StateOf(bmr_impact32 answer) {
    switch (answer) {
    case BMR_IMPACT_FAILED:
        break;
    case BMR_IMPACT_OVERLAPPED:
        return b2TOIOutput::e_overlapped;
    case BMR_IMPACT_TOUCHING:
        return b2TOIOutput::e_touching;
    case BMR_IMPACT_SEPARATED:
        return b2TOIOutput::e_separated;
    }
    return b2TOIOutput::e_failed;
}

} // namespace

bool SetBigProxy(b2DistanceProxy *proxy, const b2Shape &shape) {
    const bmr_convex32_block *block = BigPolygonOf(shape);
    if (block == nullptr)
        return false;
    const Mark mark = {NumberOfBigPolygon(shape), static_cast<uint32_t>(reinterpret_cast<uintptr_t>(&shape)),
                       kMagic};
    std::memcpy(static_cast<void *>(proxy->m_buffer), &mark, sizeof mark);
    proxy->m_vertices = reinterpret_cast<const b2Vec2 *>(block->polygon.vertices);
    proxy->m_count = static_cast<int32>(block->polygon.count);
    proxy->m_radius = shape.m_radius;
    return true;
}

bool BigDistance(b2DistanceOutput *output, b2SimplexCache *cache, const b2DistanceInput &input) {
    Two two;
    if (!Find(input.proxyA, input.proxyB, &two))
        return false;
    bmr_closest32 closest = ReadCache(*cache, two);
    const bmr_distance32 found = bmr_convex32_distance(&two.a, Transform32(input.transformA), &two.b,
                                                       Transform32(input.transformB), &closest);
    output->pointA = *Vectors(&found.point_a);
    output->pointB = *Vectors(&found.point_b);
    output->distance = found.distance;
    output->iterations = found.iterations;
    WriteCache(cache, two, input, found);
    if (input.useRadii)
        TakeRadiiOff(output, two.a.radius, two.b.radius);
    return true;
}

bool BigCast(b2ShapeCastOutput *output, const b2ShapeCastInput &input, bool *hit) {
    Two two;
    if (!Find(input.proxyA, input.proxyB, &two))
        return false;
    bmr_cast32 cast;
    *hit = bmr_convex32_cast(&two.a, Transform32(input.transformA), &two.b, Transform32(input.transformB),
                             *Vectors32(&input.translationB), b2_linearSlop, &cast);
    output->point = *Vectors(&cast.point);
    output->normal = *Vectors(&cast.normal);
    output->lambda = cast.lambda;
    output->iterations = cast.iterations;
    return true;
}

bool BigImpact(b2TOIOutput *output, const b2TOIInput &input) {
    Two two;
    if (!Find(input.proxyA, input.proxyB, &two))
        return false;
    output->state = StateOf(Impact(input, two, {0.0f, 0.0f}, &output->t));
    return true;
}

bool BigNeverTouch(const Swept &a, const Swept &b, bmr_vec32 guess, bool *never) {
    if (BigPolygonOf(a.shape) == nullptr && BigPolygonOf(b.shape) == nullptr)
        return false;
    b2TOIInput input;
    SetProxy(&input.proxyA, a.shape, a.child);
    SetProxy(&input.proxyB, b.shape, b.child);
    input.sweepA = a.sweep;
    input.sweepB = b.sweep;
    input.tMax = 1.0f;
    Two two;
    float t;
    *never = Find(input.proxyA, input.proxyB, &two) && Impact(input, two, guess, &t) != BMR_IMPACT_TOUCHING;
    return true;
}

Overlap BigOverlap(const b2DistanceProxy &a, const b2Transform &xfA, const b2DistanceProxy &b,
                   const b2Transform &xfB) {
    Two two;
    if (!Find(a, b, &two))
        return Overlap::kUnknown;
    bmr_closest32 closest = {0, 0};
    const bmr_distance32 found =
        bmr_convex32_distance(&two.a, Transform32(xfA), &two.b, Transform32(xfB), &closest);
    const float gap = found.distance > two.a.radius + two.b.radius && found.distance > b2_epsilon
                          ? found.distance - (two.a.radius + two.b.radius)
                          : 0.0f;
    return gap < 10.0f * b2_epsilon ? Overlap::kOverlapping : Overlap::kApart;
}

} // namespace bmr
