// SPDX-License-Identifier: MIT
#include "theory/course.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace testbed {

void Require(bmr_error error, const std::string &what) {
    if (error != BMR_OK)
        throw std::runtime_error(what + ": " + bmr_error_describe(error));
}

Body::Body(const std::vector<bmr_vec2> &points, Hierarchies hierarchies) {
    bmr_polygon *polygon = nullptr;
    Require(bmr_polygon_create(points.data(), points.size(), nullptr, &polygon), "the polygon");
    m_polygon.reset(polygon);
    if (hierarchies == Hierarchies::None)
        return;
    bmr_compass *compass = nullptr;
    Require(bmr_compass_create(polygon->count, nullptr, &compass), "the compass");
    m_compass.reset(compass);
    for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
        bmr_hierarchy *hierarchy = nullptr;
        Require(
            bmr_hierarchy_build(static_cast<bmr_hierarchy_kind>(kind), polygon, compass, nullptr, &hierarchy),
            "the hierarchy");
        m_hierarchies[kind].reset(hierarchy);
    }
    for (const bmr_hierarchy_kind kind : {BMR_HIERARCHY_COMPASS, BMR_HIERARCHY_DUDLEY}) {
        bmr_chains *chains = nullptr;
        Require(bmr_chains_create(m_hierarchies[kind].get(), nullptr, &chains), "the chains");
        m_chains[kind].reset(chains);
    }
}

bmr_shape Body::Shape() const {
    bmr_shape shape = {m_polygon.get(), {}, {}};
    for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
        shape.hierarchies[kind] = m_hierarchies[kind].get();
        shape.chains[kind] = m_chains[kind].get();
    }
    return shape;
}

std::vector<bmr_vec2> Body::Vertices() const {
    return {m_polygon->vertices, m_polygon->vertices + m_polygon->count};
}

namespace {

void OnEvent(void *context, const bmr_simulation_event *event) {
    (*static_cast<EventObserver *>(context))(*event);
}

} // namespace

Course::Course(std::shared_ptr<const Body> a, std::shared_ptr<const Body> b, const bmr_family_def &family)
    : m_bodies{std::move(a), std::move(b)}, m_rigid(bmr_family_is_rigid(family.family)),
      m_convex(bmr_family_is_convex(family.family)) {
    bmr_family_motion made = {};
    Require(bmr_family_create(&family, m_bodies[0]->Polygon(), m_bodies[1]->Polygon(), nullptr, &made),
            std::string("the motion ") + bmr_family_name(family.family));
    for (size_t i = 0; i < 2; ++i)
        m_motions[i].reset(made.motions[i]);
    m_diameter = made.diameter;
    m_separation = made.separation;
}

Course::Course(std::shared_ptr<const Body> a, std::shared_ptr<const Body> b, TwoMotions motions)
    : m_bodies{std::move(a), std::move(b)}, m_motions(std::move(motions)),
      m_diameter(std::max(bmr_polygon_diameter(m_bodies[0]->Polygon()),
                          bmr_polygon_diameter(m_bodies[1]->Polygon()))) {}

bmr_course Course::AsCourse() const {
    return {
        {m_bodies[0]->Polygon(), m_bodies[1]->Polygon()}, {m_motions[0].get(), m_motions[1].get()}, 0.0, 1.0};
}

bmr_kds_def DefFor(const Course &course) {
    bmr_kds_def def = bmr_default_kds_def();
    constexpr double kPartOfSeparation = 1e-3;
    def.margin = std::min(def.margin, kPartOfSeparation * course.Separation());
    return def;
}

bool Takes(const bmr_kds_info &structure, const Course &course) {
    switch (structure.domain) {
    case BMR_KDS_POINT:
        return course.BodyOf(1).Polygon()->count == 1;
    case BMR_KDS_TRANSLATION:
        return !course.IsRigid();
    case BMR_KDS_RIGID:
        break;
    }
    return true;
}

bmr_run Follow(const Course &course, const bmr_kds_info &structure, const bmr_kds_def &def, bool audit,
               EventObserver observer) {
    bmr_run_def run = {};
    run.structure = &structure;
    run.shapes[0] = course.BodyOf(0).Shape();
    run.shapes[1] = course.BodyOf(1).Shape();
    run.simulation = bmr_default_simulation_def();
    run.simulation.kds = def;
    run.audit = audit;
    run.observer = observer ? OnEvent : nullptr;
    run.context = &observer;
    const bmr_course followed = course.AsCourse();
    bmr_run outcome = {};
    Require(bmr_run_course(&run, &followed, course.Diameter(), nullptr, &outcome), structure.name);
    if (outcome.audit != BMR_OK)
        throw std::runtime_error(std::string(structure.name) + ": an audit found that " +
                                 bmr_error_describe(outcome.audit));
    return outcome;
}

const bmr_kds_info *StructureNamed(const char *name) {
    const bmr_kds_info *info = nullptr;
    Require(bmr_kds_find(name, &info), name);
    return info;
}

} // namespace testbed
