// SPDX-License-Identifier: MIT
#include "theory/body.h"

#include <algorithm>
#include <cmath>

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
    bmr_hierarchy *hierarchy = nullptr;
    Require(bmr_hierarchy_build_compass(polygon, compass, nullptr, &hierarchy), "the compass hierarchy");
    m_hierarchies[BMR_HIERARCHY_COMPASS].reset(hierarchy);
    Require(bmr_hierarchy_build_dudley(polygon, nullptr, &hierarchy), "the Dudley hierarchy");
    m_hierarchies[BMR_HIERARCHY_DUDLEY].reset(hierarchy);
    Require(bmr_hierarchy_build_dobkin_kirkpatrick(polygon, nullptr, &hierarchy),
            "the Dobkin-Kirkpatrick hierarchy");
    m_hierarchies[BMR_HIERARCHY_DOBKIN_KIRKPATRICK].reset(hierarchy);
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

double Body::Diameter() const {
    double most = 0.0;
    for (const bmr_vec2 &a : Vertices())
        for (const bmr_vec2 &b : Vertices())
            most = std::max(most, std::hypot(a.x - b.x, a.y - b.y));
    return most;
}

} // namespace testbed
