// SPDX-License-Identifier: MIT
#include "hull.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <vector>

#include <box2d/b2_block_allocator.h>
#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>

#include "run_allocator.h"
#include "settings.h"

namespace bmr {

namespace {

const b2PolygonShape *PolygonOf(const b2Fixture &fixture) {
    return fixture.GetType() == b2Shape::e_polygon ? static_cast<const b2PolygonShape *>(fixture.GetShape())
                                                   : nullptr;
}

void AddPoints(const b2Fixture &fixture, std::vector<bmr_vec2> *points, float *radius) {
    const b2PolygonShape *polygon = PolygonOf(fixture);
    if (polygon == nullptr)
        return;
    for (int32 i = 0; i < polygon->m_count; ++i)
        points->push_back(
            {static_cast<double>(polygon->m_vertices[i].x), static_cast<double>(polygon->m_vertices[i].y)});
    *radius = std::max(*radius, polygon->m_radius);
}

void GatherPoints(const Hull &hull, std::vector<bmr_vec2> *points, float *radius) {
    for (const b2Fixture *f = hull.body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
        // A hull of one fixture takes it as it is; that of a body leaves sensors out: their contacts ask
        // nothing of it.
        if (hull.fixture != nullptr ? f == hull.fixture : !f->IsSensor())
            AddPoints(*f, points, radius);
    }
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

bmr_error BuildHierarchy(const bmr_polygon *polygon, const bmr_allocator *allocator,
                         bmr_hierarchy **hierarchy) {
    const Settings &settings = GetSettings();
    switch (settings.pairDef.structure) {
    case BMR_LAZY_COMPASS:
        return bmr_hierarchy_build_compass(polygon, settings.compass, allocator, hierarchy);
    case BMR_LAZY_DUDLEY:
        return bmr_hierarchy_build_dudley(polygon, allocator, hierarchy);
    case BMR_LAZY_DOBKIN_KIRKPATRICK:
        return bmr_hierarchy_build_dobkin_kirkpatrick(polygon, allocator, hierarchy);
    default:
        return BMR_OK; // the free direction needs none
    }
}

void DestroyShape(Hull *hull) {
    const bmr_allocator memory = RunAllocator(hull->allocator);
    bmr_hierarchy_destroy(const_cast<bmr_hierarchy *>(hull->shape.hierarchy), &memory);
    bmr_polygon_destroy(const_cast<bmr_polygon *>(hull->shape.polygon), &memory);
    hull->shape = {nullptr, nullptr};
}

/// May throw std::bad_alloc, before anything is built.
void BuildShape(Hull *hull) {
    std::vector<bmr_vec2> points;
    GatherPoints(*hull, &points, &hull->radius);
    if (points.size() > kMostHullVertices && !ReduceToEnvelope(&points))
        return;
    const bmr_allocator memory = RunAllocator(hull->allocator);
    bmr_polygon *polygon = nullptr;
    bmr_hierarchy *hierarchy = nullptr;
    if (bmr_polygon_create(points.data(), points.size(), &memory, &polygon) != BMR_OK)
        return;
    if (BuildHierarchy(polygon, &memory, &hierarchy) != BMR_OK) {
        bmr_polygon_destroy(polygon, &memory);
        return;
    }
    hull->shape = {polygon, hierarchy};
    for (uint32_t i = 0; i < polygon->count; ++i)
        hull->reach = std::max(hull->reach, std::hypot(polygon->vertices[i].x, polygon->vertices[i].y));
    Count(&Counts::hulls);
}

void BuildShapeOrNone(Hull *hull) {
    hull->shape = {nullptr, nullptr};
    hull->radius = 0.0f;
    hull->reach = 0.0;
    try {
        BuildShape(hull);
    } catch (const std::bad_alloc &) {
        hull->shape = {nullptr, nullptr}; // its pairs go to Box2D
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
    return hull;
}

void ReleaseHull(Hull *hull) {
    if (--hull->references > 0)
        return;
    DestroyShape(hull);
    hull->allocator->Free(hull, sizeof(Hull));
}

void RebuildHull(Hull *hull) {
    DestroyShape(hull);
    BuildShapeOrNone(hull);
}

bool HullHolds(const Hull &hull, const b2Fixture &fixture) {
    const b2PolygonShape *polygon = PolygonOf(fixture);
    if (hull.shape.polygon == nullptr || polygon == nullptr || !(polygon->m_radius <= hull.radius))
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
