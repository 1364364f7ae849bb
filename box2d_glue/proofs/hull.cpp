// SPDX-License-Identifier: MIT
#include "proofs/hull.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <new>
#include <vector>

#include <box2d/b2_block_allocator.h>
#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>

#include "convex32/convex32_envelope.h"
#include "shapes/convex_geometry.h"
#include "shapes/side_normals.h"
#include "start/current_step.h"
#include "start/settings.h"

namespace bmr {

/// A fixture's content when a hull was built from it. A fixture with the same content has not changed, and
/// the hull holds it.
struct HullMember {
    const b2Fixture *fixture;
    float radius;
    int32 count;
    b2Vec2 vertices[b2_maxPolygonVertices];
    uint64_t bigPolygon; ///< its number; then there are no vertices here. Else 0
};

namespace {

const b2PolygonShape *PolygonOf(const b2Fixture &fixture) {
    return fixture.GetType() == b2Shape::e_polygon ? static_cast<const b2PolygonShape *>(fixture.GetShape())
                                                   : nullptr;
}

HullMember MemberOf(const b2Fixture &fixture, const b2PolygonShape &polygon) {
    HullMember member;
    member.fixture = &fixture;
    member.radius = polygon.m_radius;
    member.bigPolygon = NumberOfBigPolygon(polygon);
    member.count = member.bigPolygon != 0 ? 0 : polygon.m_count;
    std::copy_n(polygon.m_vertices, member.count, member.vertices);
    return member;
}

constexpr size_t kSlabSlack = 64; // alignment of the pieces

/// The fixtures that the hull is to hold. A hull of one fixture takes it as it is; that of a body leaves
/// sensors out: their contacts ask nothing of it. None at all where one of them makes a hull worthless.
std::vector<HullMember> GatherMembers(const Hull &hull) {
    std::vector<HullMember> members;
    members.reserve(hull.fixture != nullptr ? 1 : 16);
    for (const b2Fixture *f = hull.body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
        const b2PolygonShape *polygon = PolygonOf(*f);
        if (polygon == nullptr || !(hull.fixture != nullptr ? f == hull.fixture : !f->IsSensor()))
            continue;
        if (BigPolygonOf(*polygon) == nullptr && !VerticesTellAll(*polygon))
            return {};
        members.push_back(MemberOf(*f, *polygon));
    }
    return members;
}

/// All vertices of a big polygon, or the corners of an envelope of it.
void AddBigPolygon(const bmr_convex32 &polygon, std::vector<bmr_vec2> *points) {
    if (polygon.count <= kMostHullVertices) {
        for (uint32_t i = 0; i < polygon.count; ++i)
            points->push_back(
                {static_cast<double>(polygon.vertices[i].x), static_cast<double>(polygon.vertices[i].y)});
        return;
    }
    points->resize(points->size() + kMostHullVertices);
    bmr_convex32_envelope(&polygon, kMostHullVertices, points->data() + points->size() - kMostHullVertices);
}

/// The members' vertices. Bodies of many fixtures are cut from one outline, so that neighbours share most of
/// theirs: what the member before has too is left out, which spares the hull two thirds of its sorting.
std::vector<bmr_vec2> PointsOf(const std::vector<HullMember> &members) {
    std::vector<bmr_vec2> points;
    points.reserve(members.size() * b2_maxPolygonVertices);
    const b2Vec2 *before = nullptr, *beforeEnd = nullptr;
    for (const HullMember &member : members) {
        if (member.bigPolygon != 0)
            AddBigPolygon(BigPolygonOf(*member.fixture->GetShape())->polygon, &points);
        const b2Vec2 *const end = member.vertices + member.count;
        for (const b2Vec2 *v = member.vertices; v != end; ++v) {
            if (std::find(before, beforeEnd, *v) == beforeEnd)
                points.push_back({static_cast<double>(v->x), static_cast<double>(v->y)});
        }
        before = member.vertices;
        beforeEnd = end;
    }
    return points;
}

bool ComesBefore(const HullMember &member, const b2Fixture *fixture) {
    return std::less<const b2Fixture *>()(member.fixture, fixture);
}

/// To the bit. (Compilers make two words of it; the last vertex of an odd number is compared with the one
/// before, once more.)
bool SameTwo(const b2Vec2 *a, const b2Vec2 *b) {
    return std::memcmp(a, b, 2 * sizeof(b2Vec2)) == 0; // NOLINT(bugprone-suspicious-memory-comparison)
}

bool LooksLike(const HullMember &member, const b2PolygonShape &polygon) {
    const uint64_t number = AnyBigPolygon() ? NumberOfBigPolygon(polygon) : 0;
    if (member.bigPolygon != number || number != 0)
        return member.bigPolygon == number && member.radius == polygon.m_radius;
    const int32 count = member.count;
    if (count != polygon.m_count || member.radius != polygon.m_radius || count < 2)
        return false;
    for (int32 i = 0; i < count - 2; i += 2)
        if (!SameTwo(member.vertices + i, polygon.m_vertices + i))
            return false;
    return SameTwo(member.vertices + count - 2, polygon.m_vertices + count - 2);
}

/// The member that was built from the fixture of this address; the end of the members if there is none. They
/// are sorted by address.
const HullMember *FindMember(const Hull &hull, const b2Fixture &fixture) {
    const HullMember *const begin = hull.members, *const end = begin + hull.memberCount;
    const HullMember *const member = std::lower_bound(begin, end, &fixture, ComesBefore);
    return member != end && member->fixture == &fixture ? member : end;
}

/// Was the hull built from this fixture as it is now?
bool IsMember(const Hull &hull, const b2Fixture &fixture, const b2PolygonShape &polygon) {
    const HullMember *const member = FindMember(hull, fixture);
    return member != hull.members + hull.memberCount && LooksLike(*member, polygon);
}

/// Replaces `points` by the corners of a compass envelope of at most kMostHullVertices edges.
bool Coarsen(const bmr_polygon &hull, std::vector<bmr_vec2> *points) {
    // 4 * 2^level edges at most.
    uint32_t level = 0;
    while ((8u << level) <= kMostHullVertices)
        ++level;
    bmr_hierarchy *hierarchy = nullptr;
    bmr_compass *compass = nullptr;
    bool done = false;
    if (bmr_compass_create(hull.count, nullptr, &compass) == BMR_OK &&
        bmr_hierarchy_build_compass(&hull, compass, nullptr, &hierarchy) == BMR_OK) {
        points->clear();
        bmr_edge edge = 0;
        do {
            const bmr_corner corner = bmr_hierarchy_corner_after(hierarchy, edge, level);
            points->push_back(bmr_hierarchy_corner_point(hierarchy, corner));
            edge = corner.after;
        } while (edge != 0 && points->size() <= kMostHullVertices);
        done = edge == 0;
    }
    bmr_hierarchy_destroy(hierarchy, nullptr);
    bmr_compass_destroy(compass, nullptr);
    return done;
}

bool ReduceToEnvelope(std::vector<bmr_vec2> *points) {
    bmr_polygon *whole = nullptr;
    if (bmr_polygon_create(points->data(), points->size(), nullptr, &whole) != BMR_OK)
        return false;
    const bool done = whole->count <= kMostHullVertices || Coarsen(*whole, points);
    bmr_polygon_destroy(whole, nullptr);
    return done;
}

/// The hierarchy of the chosen structure; nullptr if it needs none.
bmr_error BuildHierarchy(const bmr_polygon *polygon, bmr_hierarchy **hierarchy) {
    const Settings &settings = GetSettings();
    switch (settings.pairDef.structure) {
    case BMR_LAZY_COMPASS:
        return bmr_hierarchy_build_compass(polygon, settings.compass, nullptr, hierarchy);
    case BMR_LAZY_DUDLEY:
        return bmr_hierarchy_build_dudley(polygon, nullptr, hierarchy);
    default:
        return BMR_OK; // the free direction needs none
    }
}

void Forget(Hull *hull) {
    FreeSlab(hull->allocator, &hull->slab);
    hull->shape = {};
    hull->members = nullptr;
    hull->memberCount = 0;
    hull->radius = 0.0f;
    hull->reach = 0.0;
}

/// Puts copies of all that a hull is made of into one slab; false if they do not fit.
bool KeepInSlab(Hull *hull, const std::vector<HullMember> &members, const bmr_polygon &whole,
                const bmr_hierarchy *built) {
    hull->slab =
        AllocateSlab(hull->allocator, members.size() * sizeof(HullMember) + bmr_polygon_bytes(whole.count) +
                                          (built != nullptr ? bmr_hierarchy_bytes(built) : 0) + kSlabSlack);
    const bmr_allocator memory = SlabAllocator(&hull->slab);
    bmr_polygon *polygon = nullptr;
    bmr_hierarchy *hierarchy = nullptr;
    void *kept = TakeFromSlab(&hull->slab, members.size() * sizeof(HullMember));
    if (kept == nullptr || bmr_polygon_copy(&whole, &memory, &polygon) != BMR_OK ||
        (built != nullptr && bmr_hierarchy_copy(built, polygon, &memory, &hierarchy) != BMR_OK)) {
        Forget(hull);
        return false;
    }
    hull->shape = {polygon, {}, {}};
    if (hierarchy != nullptr)
        hull->shape.hierarchies[bmr_hierarchy_get_kind(hierarchy)] = hierarchy;
    hull->members = static_cast<HullMember *>(kept);
    hull->memberCount = static_cast<int32_t>(members.size());
    std::uninitialized_copy(members.begin(), members.end(), hull->members);
    std::sort(hull->members, hull->members + hull->memberCount,
              [](const HullMember &a, const HullMember &b) { return ComesBefore(a, b.fixture); });
    return true;
}

/// May throw std::bad_alloc, before anything is built.
void BuildShape(Hull *hull) {
    const std::vector<HullMember> members = GatherMembers(*hull);
    std::vector<bmr_vec2> points = PointsOf(members);
    if (points.size() > kMostHullVertices && !ReduceToEnvelope(&points))
        return;
    bmr_polygon *whole = nullptr;
    if (bmr_polygon_create(points.data(), points.size(), nullptr, &whole) != BMR_OK)
        return;
    bmr_hierarchy *hierarchy = nullptr;
    const bool built =
        BuildHierarchy(whole, &hierarchy) == BMR_OK && KeepInSlab(hull, members, *whole, hierarchy);
    bmr_hierarchy_destroy(hierarchy, nullptr);
    bmr_polygon_destroy(whole, nullptr);
    if (!built)
        return;
    hull->reach = 2.0 * hull->shape.polygon->extent; // no vertex is farther than sqrt(2) of it
    for (const HullMember &member : members)
        hull->radius = std::max(hull->radius, member.radius);
    Count(&Counts::hulls);
}

void BuildShapeOrNone(Hull *hull) {
    try {
        BuildShape(hull);
    } catch (const std::bad_alloc &) {
        // Its pairs go to Box2D.
    }
}

} // namespace

Hull *CreateHull(const b2Body *body, const b2Fixture *fixture, b2BlockAllocator *allocator) {
    Hull *hull = new (allocator->Allocate(sizeof(Hull))) Hull();
    hull->body = body;
    hull->fixture = fixture;
    hull->references = 1;
    hull->allocator = allocator;
    BuildShapeOrNone(hull);
    hull->lookedAt = CurrentStep();
    return hull;
}

void ReleaseHull(Hull *hull) {
    if (--hull->references > 0)
        return;
    Forget(hull);
    hull->allocator->Free(hull, sizeof(Hull));
}

void RebuildHull(Hull *hull) {
    Forget(hull);
    BuildShapeOrNone(hull);
    hull->lookedAt = CurrentStep();
}

bool HullIsUpToDate(const Hull &hull) {
    if (hull.shape.polygon == nullptr)
        return true;
    if (hull.fixture != nullptr)
        return HullHolds(hull, *hull.fixture);
    const HullMember *const begin = hull.members, *const end = begin + hull.memberCount;
    // Fixtures that were made one after another mostly lie so, and the list begins with the last.
    const HullMember *member = end;
    for (const b2Fixture *f = hull.body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
        const b2PolygonShape *polygon = PolygonOf(*f);
        if (polygon == nullptr || f->IsSensor())
            continue;
        const bool follows = member != begin && (member - 1)->fixture == f;
        member = follows ? member - 1 : FindMember(hull, *f);
        if ((member == end || !LooksLike(*member, *polygon)) && !HullHolds(hull, *f))
            return false;
    }
    return true;
}

bool HullHolds(const Hull &hull, const b2Fixture &fixture) {
    const b2PolygonShape *polygon = PolygonOf(fixture);
    if (hull.shape.polygon == nullptr || polygon == nullptr || !(polygon->m_radius <= hull.radius))
        return false;
    if (IsMember(hull, fixture, *polygon))
        return true;
    if (const bmr_convex32_block *big = BigPolygonOf(*polygon))
        return bmr_convex32_held(&big->polygon, hull.shape.polygon,
                                 kHullTolerance * hull.shape.polygon->extent);
    if (!VerticesTellAll(*polygon))
        return false;
    for (int32 i = 0; i < polygon->m_count; ++i) {
        const bmr_vec2 point = {static_cast<double>(polygon->m_vertices[i].x),
                                static_cast<double>(polygon->m_vertices[i].y)};
        // Exactly inside in nearly every case, which is found in O(log n); an envelope's corners are rounded.
        if (!bmr_polygon_contains(hull.shape.polygon, point, 0.0) &&
            !bmr_polygon_contains(hull.shape.polygon, point, kHullTolerance * hull.shape.polygon->extent))
            return false;
    }
    return true;
}

} // namespace bmr
