// SPDX-License-Identifier: MIT
#include "boomerang/convex_shape.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <box2d/b2_block_allocator.h>
#include <box2d/b2_body.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_draw.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_world.h>

#include "shapes/big_polygons.h"
#include "shapes/outline_record.h"
#include "shapes/shapes32.h"

namespace bmr {

static_assert(sizeof(ConvexShape) == sizeof(b2PolygonShape), "Box2D frees sizeof(b2PolygonShape) bytes");
static_assert(ConvexShape::kMostVertices == BMR_CONVEX32_MOST);

#if defined(BMR_CONVEX_HANDLE_IN_PADDING)
uint32_t ConvexShape::GetKeptHandle() const {
    return m_handle;
}

void ConvexShape::SetHandle(uint32_t handle) {
    m_handle = handle;
}
#else
uint32_t ConvexShape::GetKeptHandle() const {
    if (m_count > registry::kMostShown)
        return 0;
    uint32_t handle;
    std::memcpy(&handle, &m_normals[registry::kMostShown], sizeof handle);
    return handle;
}

void ConvexShape::SetHandle(uint32_t handle) {
    if (m_count <= registry::kMostShown) // a stock octagon has a normal there
        std::memcpy(static_cast<void *>(&m_normals[registry::kMostShown]), &handle, sizeof handle);
}
#endif

uint32_t ConvexShape::GetHandle() const {
    const uint32_t handle = GetKeptHandle();
    return handle != 0 && registry::Find(handle).shown.IsOf(*this) ? handle : 0;
}

ConvexShape::ConvexShape() noexcept {
    SetHandle(0);
    if (internal::convexShapeTable.load(std::memory_order_relaxed) == nullptr)
        internal::convexShapeTable.store(internal::TableOf(*this), std::memory_order_relaxed);
}

ConvexShape::ConvexShape(const ConvexShape &other) noexcept : b2PolygonShape(other) {
    SetHandle(other.GetKeptHandle());
    registry::AddReference(GetKeptHandle());
}

ConvexShape &ConvexShape::operator=(const ConvexShape &other) noexcept {
    const uint32_t old = GetKeptHandle(), handle = other.GetKeptHandle();
    registry::AddReference(handle); // first: it may be the same
    b2PolygonShape::operator=(other);
    SetHandle(handle);
    registry::Release(old);
    return *this;
}

ConvexShape::~ConvexShape() {
    registry::Release(GetKeptHandle());
}

void ConvexShape::Adopt(uint32_t handle) {
    const uint32_t old = GetKeptHandle();
    const bmr_convex32_block &block = registry::BlockOf(handle);
    const registry::Shown &shown = registry::Find(handle).shown;
    const uint32_t count = shown.count;
    std::copy_n(Vectors(shown.vertices), count, m_vertices);
    for (uint32_t i = 0; i < count; ++i) {
        const b2Vec2 &from = m_vertices[i], &to = m_vertices[(i + 1) % count];
        const double x = static_cast<double>(to.x) - static_cast<double>(from.x),
                     y = static_cast<double>(to.y) - static_cast<double>(from.y),
                     length = std::sqrt(x * x + y * y);
        m_normals[i].Set(static_cast<float>(y / length), static_cast<float>(-x / length));
    }
    m_count = static_cast<int32>(count);
    m_centroid.Set(block.mass.centroid.x, block.mass.centroid.y);
    SetHandle(handle);
    registry::Release(old);
}

int32 ConvexShape::GetVertexCount() const {
    const uint32_t handle = GetHandle();
    return handle != 0 ? static_cast<int32>(registry::BlockOf(handle).polygon.count) : m_count;
}

const b2Vec2 *ConvexShape::GetVertices() const {
    const uint32_t handle = GetHandle();
    return handle != 0 ? Vectors(registry::BlockOf(handle).polygon.vertices) : m_vertices;
}

const b2Vec2 &ConvexShape::GetVertex(int32 index) const {
    return GetVertices()[index];
}

const b2Vec2 &ConvexShape::GetNormal(int32 index) const {
    const uint32_t handle = GetHandle();
    return (handle != 0 ? Vectors(registry::BlockOf(handle).polygon.normals) : m_normals)[index];
}

const ConvexShape *ConvexShape::From(const b2Shape *shape) {
    return shape != nullptr && internal::IsConvexShape(*shape) ? static_cast<const ConvexShape *>(shape)
                                                               : nullptr;
}

b2Shape *ConvexShape::Clone(b2BlockAllocator *allocator) const {
    return new (allocator->Allocate(sizeof(ConvexShape))) ConvexShape(*this);
}

bool ConvexShape::TestPoint(const b2Transform &xf, const b2Vec2 &p) const {
    const uint32_t handle = GetHandle();
    if (handle == 0)
        return b2PolygonShape::TestPoint(xf, p);
    const b2Vec2 local = b2MulT(xf.q, p - xf.p);
    return bmr_convex32_contains(&registry::BlockOf(handle).polygon, *Vectors32(&local));
}

bool ConvexShape::RayCast(b2RayCastOutput *output, const b2RayCastInput &input, const b2Transform &xf,
                          int32 childIndex) const {
    const uint32_t handle = GetHandle();
    if (handle == 0)
        return b2PolygonShape::RayCast(output, input, xf, childIndex);
    const b2Vec2 p1 = b2MulT(xf.q, input.p1 - xf.p), p2 = b2MulT(xf.q, input.p2 - xf.p);
    const bmr_convex32_block &block = registry::BlockOf(handle);
    float fraction;
    uint32_t edge;
    if (!bmr_convex32_ray(&block.polygon, *Vectors32(&p1), *Vectors32(&p2), input.maxFraction, &fraction,
                          &edge))
        return false;
    bmr_vec32 normal = block.polygon.normals[edge];
    if (block.seams.inner != nullptr &&
        !EntersOutline(handle, *Vectors32(&p1), *Vectors32(&p2), edge, &fraction, &normal))
        return false;
    output->fraction = fraction;
    output->normal = b2Mul(xf.q, *Vectors(&normal));
    return true;
}

void ConvexShape::ComputeAABB(b2AABB *aabb, const b2Transform &xf, int32 childIndex) const {
    const uint32_t handle = GetHandle();
    if (handle == 0)
        return b2PolygonShape::ComputeAABB(aabb, xf, childIndex);
    bmr_vec32 lower, upper;
    bmr_convex32_box(&registry::BlockOf(handle).polygon, Transform32(xf), &lower, &upper);
    const b2Vec2 skin(m_radius, m_radius);
    aabb->lowerBound = b2Vec2(lower.x, lower.y) - skin;
    aabb->upperBound = b2Vec2(upper.x, upper.y) + skin;
}

void ConvexShape::ComputeMass(b2MassData *massData, float density) const {
    const uint32_t handle = GetHandle();
    if (handle == 0)
        return b2PolygonShape::ComputeMass(massData, density);
    if (registry::Find(handle).group.load(std::memory_order_relaxed) != nullptr)
        return WeighPiece(handle, density, massData);
    const bmr_mass32 &mass = registry::BlockOf(handle).mass;
    massData->mass = density * mass.area;
    massData->center.Set(mass.centroid.x, mass.centroid.y);
    massData->I = 0.0f;
    Weighing alone;
    alone.Add(*massData);
    massData->I = InertiaAboutOrigin(alone.OfCentre(),
                                     static_cast<double>(density) * static_cast<double>(mass.inertia));
}

// What games see of them.

namespace {

/// The last drawing of b2World::DebugDraw on this thread.
struct Drawn {
    const b2World *world;
    const b2Draw *draw;
};
thread_local Drawn drawnByBox2D = {nullptr, nullptr};

/// The colour by which b2World::DebugDraw shows the state of a body.
b2Color ColorOf(const b2Body &body) {
    if (body.GetType() == b2_dynamicBody && body.GetMass() == 0.0f)
        return b2Color(1.0f, 0.0f, 0.0f);
    if (!body.IsEnabled())
        return b2Color(0.5f, 0.5f, 0.3f);
    if (body.GetType() == b2_staticBody)
        return b2Color(0.5f, 0.9f, 0.5f);
    if (body.GetType() == b2_kinematicBody)
        return b2Color(0.5f, 0.5f, 0.9f);
    return body.IsAwake() ? b2Color(0.9f, 0.7f, 0.7f) : b2Color(0.6f, 0.6f, 0.6f);
}

b2Vec2 Posed(bmr_vec32 vertex, const b2Transform &xf) {
    return b2Mul(xf, b2Vec2(vertex.x, vertex.y));
}

/// A fan: each piece begins with vertex 0, and goes on from where the one before ended.
void DrawPieces(const bmr_convex32 &polygon, const b2Transform &xf, const b2Color &color, b2Draw &draw) {
    b2Vec2 piece[b2_maxPolygonVertices];
    piece[0] = Posed(polygon.vertices[0], xf);
    for (uint32_t i = 1; i + 1 < polygon.count;) {
        int32 count = 1;
        piece[count++] = Posed(polygon.vertices[i], xf);
        while (count < b2_maxPolygonVertices && i + 1 < polygon.count)
            piece[count++] = Posed(polygon.vertices[++i], xf);
        draw.DrawSolidPolygon(piece, count, color);
    }
}

/// Of a piece: those of its edges, and parts of edges, that are the outline's.
void DrawFaces(const bmr_convex32_block &block, const b2Transform &xf, const b2Color &color, b2Draw &draw) {
    const bmr_convex32 &polygon = block.polygon;
    const bmr_seams32 &seams = block.seams;
    uint32_t part = 0;
    for (uint32_t i = 0; i < polygon.count; ++i) {
        const bmr_vec32 end = polygon.vertices[i + 1 < polygon.count ? i + 1 : 0];
        const bool mixed = part < seams.part_count && seams.parts[part].edge == i;
        if (!mixed && seams.inner[i] == 0)
            draw.DrawSegment(Posed(polygon.vertices[i], xf), Posed(end, xf), color);
        for (; part < seams.part_count && seams.parts[part].edge == i; ++part) {
            const bool last = part + 1 == seams.part_count || seams.parts[part + 1].edge != i;
            if (!seams.parts[part].inner)
                draw.DrawSegment(Posed(seams.parts[part].from, xf),
                                 Posed(last ? end : seams.parts[part + 1].from, xf), color);
        }
    }
}

bool DrawWhole(const bmr_convex32 &polygon, const b2Transform &xf, const b2Color &color, b2Draw &draw) {
    auto *vertices = static_cast<b2Vec2 *>(std::malloc(polygon.count * sizeof(b2Vec2)));
    if (vertices == nullptr)
        return false;
    for (uint32_t i = 0; i < polygon.count; ++i)
        vertices[i] = Posed(polygon.vertices[i], xf);
    draw.DrawSolidPolygon(vertices, static_cast<int32>(polygon.count), color);
    std::free(vertices);
    return true;
}

} // namespace

void DrawBigPolygon(const bmr_convex32_block &block, const b2Transform &xf, const b2Color &color,
                    DrawAs drawAs, b2Draw &draw) {
    if (drawAs != DrawAs::Whole || !DrawWhole(block.polygon, xf, color, draw))
        DrawPieces(block.polygon, xf, color, draw);
    if (block.polygon.seams != nullptr || block.seams.part_count > 0)
        DrawFaces(block, xf, color, draw);
}

void NoteDrawnByBox2D(const b2World *world, const b2Draw *draw) {
    drawnByBox2D = {world, draw};
}

void DrawConvexShapes(const b2World &world, b2Draw &draw, DrawAs drawAs) {
    const Drawn drawn = std::exchange(drawnByBox2D, {nullptr, nullptr});
    if (drawn.world == &world && drawn.draw == &draw)
        return;
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        for (const b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
            if (const bmr_convex32_block *block = BigPolygonOf(*f->GetShape()))
                DrawBigPolygon(*block, body->GetTransform(), ColorOf(*body), drawAs, draw);
}

} // namespace bmr
