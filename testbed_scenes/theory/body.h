// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_BODY_H
#define BOOMERANG_TESTBED_BODY_H

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "boomerang/kds.h"

namespace testbed {

/// Throws what an error code of core means, as a sentence about `what`.
void Require(bmr_error error, const std::string &what);

/// A convex polygon with all three hierarchies, and the chains of those two whose chains are searched: all
/// that its pairs share. Or with none of these.
class Body {
public:
    enum class Hierarchies { All, None };
    /// The hull of the points. Throws std::runtime_error.
    explicit Body(const std::vector<bmr_vec2> &points, Hierarchies hierarchies = Hierarchies::All);

    const bmr_polygon *Polygon() const { return m_polygon.get(); }
    const bmr_hierarchy *Hierarchy(bmr_hierarchy_kind kind) const { return m_hierarchies[kind].get(); }
    bmr_shape Shape() const;
    std::vector<bmr_vec2> Vertices() const;
    /// The largest distance of two vertices.
    double Diameter() const;

private:
    struct Deleter {
        void operator()(bmr_polygon *polygon) const { bmr_polygon_destroy(polygon, nullptr); }
        void operator()(bmr_compass *compass) const { bmr_compass_destroy(compass, nullptr); }
        void operator()(bmr_hierarchy *hierarchy) const { bmr_hierarchy_destroy(hierarchy, nullptr); }
        void operator()(bmr_chains *chains) const { bmr_chains_destroy(chains, nullptr); }
    };
    std::unique_ptr<bmr_polygon, Deleter> m_polygon;
    std::unique_ptr<bmr_compass, Deleter> m_compass;
    std::unique_ptr<bmr_hierarchy, Deleter> m_hierarchies[BMR_HIERARCHY_KIND_COUNT];
    std::unique_ptr<bmr_chains, Deleter> m_chains[BMR_HIERARCHY_KIND_COUNT];
};

} // namespace testbed

#endif
