// SPDX-License-Identifier: MIT
#include "glue/proofs/hull.h"

#include <algorithm>
#include <functional>

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>

#include "shapes/convex_geometry.h"
#include "shapes/digest.h"
#include "shapes/side_normals.h"
#include "start/current_step.h"
#include "start/settings.h"

namespace bmr {

namespace {

const b2PolygonShape *PolygonOf(const b2Fixture &fixture) {
    return fixture.GetType() == b2Shape::e_polygon ? static_cast<const b2PolygonShape *>(fixture.GetShape())
                                                   : nullptr;
}

void AddVertices(const b2PolygonShape &polygon, std::vector<bmr_vec2> *points) {
    if (const bmr_convex32_block *big = BigPolygonOf(polygon)) {
        for (uint32_t i = 0; i < big->polygon.count; ++i)
            points->push_back({static_cast<double>(big->polygon.vertices[i].x),
                               static_cast<double>(big->polygon.vertices[i].y)});
        return;
    }
    for (int32 i = 0; i < polygon.m_count; ++i)
        points->push_back(
            {static_cast<double>(polygon.m_vertices[i].x), static_cast<double>(polygon.m_vertices[i].y)});
}

/// nullptr where the structure needs none, or where the hull has too many vertices for the compass.
bmr_hierarchy *BuildHierarchy(const bmr_polygon *polygon) {
    const Settings &settings = GetSettings();
    bmr_hierarchy *hierarchy = nullptr;
    switch (settings.pairDef.structure) {
    case BMR_LAZY_COMPASS:
        (void)bmr_hierarchy_build_compass(polygon, settings.compass, nullptr, &hierarchy);
        break;
    case BMR_LAZY_DUDLEY:
        (void)bmr_hierarchy_build_dudley(polygon, nullptr, &hierarchy);
        break;
    default:
        break;
    }
    return hierarchy;
}

bool ComesBefore(const b2Fixture *a, const b2Fixture *b) {
    return std::less<const b2Fixture *>()(a, b);
}

} // namespace

/// Takes in the fixtures that the hull is to hold, and their vertices. False where one of them makes a hull
/// worthless: Box2D sees more of it than its vertices.
bool Hull::Gather(std::vector<bmr_vec2> *points) {
    for (const b2Fixture *f = m_body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
        const b2PolygonShape *polygon = PolygonOf(*f);
        if (polygon == nullptr || f->IsSensor() || (m_fixture != nullptr && f != m_fixture))
            continue;
        if (BigPolygonOf(*polygon) == nullptr && !VerticesTellAll(*polygon))
            return false;
        m_members.push_back({f, DigestOf(*polygon)});
        m_radius = std::max(m_radius, polygon->m_radius);
        AddVertices(*polygon, points);
    }
    std::sort(m_members.begin(), m_members.end(),
              [](const Member &a, const Member &b) { return ComesBefore(a.fixture, b.fixture); });
    return true;
}

void Hull::Build() {
    Forget();
    std::vector<bmr_vec2> points;
    bmr_polygon *polygon = nullptr;
    if (!Gather(&points) || bmr_polygon_create(points.data(), points.size(), nullptr, &polygon) != BMR_OK)
        return;
    m_shape.polygon = polygon;
    if (bmr_hierarchy *hierarchy = BuildHierarchy(polygon))
        m_shape.hierarchies[bmr_hierarchy_get_kind(hierarchy)] = hierarchy;
    m_reach = 2.0 * polygon->extent; // no vertex is farther than sqrt(2) of it
    Count(&Counts::hulls);
}

void Hull::Forget() {
    for (const bmr_hierarchy *hierarchy : m_shape.hierarchies)
        bmr_hierarchy_destroy(const_cast<bmr_hierarchy *>(hierarchy), nullptr);
    bmr_polygon_destroy(const_cast<bmr_polygon *>(m_shape.polygon), nullptr);
    m_shape = {};
    m_members.clear();
    m_reach = 0.0;
    m_radius = 0.0f;
    m_held = nullptr;
    ++m_version;
}

const bmr_hierarchy *Hull::Hierarchy() const {
    for (const bmr_hierarchy *hierarchy : m_shape.hierarchies)
        if (hierarchy != nullptr)
            return hierarchy;
    return nullptr;
}

bool Hull::Holds(const b2Fixture &fixture) const {
    const auto member =
        std::lower_bound(m_members.begin(), m_members.end(), &fixture,
                         [](const Member &a, const b2Fixture *f) { return ComesBefore(a.fixture, f); });
    return member != m_members.end() && member->fixture == &fixture &&
           member->digest == DigestOf(*PolygonOf(fixture));
}

bool Hull::MakeHold(const b2Fixture &fixture) {
    const uint64_t step = CurrentStep();
    if (m_held == &fixture && m_heldIn == step && step != 0 && !GameRan())
        return true;
    // (Where none could be built, trying again for every contact would cost more than it could save.)
    if (m_shape.polygon == nullptr)
        return false;
    if (!Holds(fixture))
        Build();
    if (m_shape.polygon == nullptr || !Holds(fixture))
        return false;
    m_held = &fixture;
    m_heldIn = step;
    return true;
}

} // namespace bmr
