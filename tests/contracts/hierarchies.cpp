// SPDX-License-Identifier: MIT
// Polygons, their sums and their hierarchies. (Bad vertex arrays: bad_vertex_arrays.h.)
#include "boomerang/inflated.h"
#include "boomerang/kds.h"
#include "boomerang/minkowski.h"
#include "hierarchy/mixed_cells.h"
#include "stage.h"

using namespace contracts;

namespace {

const Table kTheRules("rules", [] {});

const Table kPolygons("boomerang/polygon.h", [] {
    static const std::vector<bmr_vec2> points = Ellipse(60, 3.0);
    Makes("bmr_polygon_create", {{"points", kNotNull}, {"result", kNotNull}}, [](const Given &g) {
        bmr_polygon *made = Untouched<bmr_polygon>();
        const bmr_error error =
            bmr_polygon_create(g.Or(0, points.data()), points.size(), g.allocator, g.Or(1, &made));
        return MadePolygon(g, error, made);
    });
    Makes("bmr_polygon_create_raw", {{"vertices", kNotNull}, {"result", kNotNull}}, [](const Given &g) {
        bmr_polygon *made = Untouched<bmr_polygon>();
        const bmr_error error =
            bmr_polygon_create_raw(g.Or(0, points.data()), points.size(), g.allocator, g.Or(1, &made));
        return MadePolygon(g, error, made);
    });
    Makes("bmr_polygon_copy", {{"polygon", kNotNull}, {"result", kNotNull}}, [](const Given &g) {
        bmr_polygon *made = Untouched<bmr_polygon>();
        const bmr_error error = bmr_polygon_copy(g.Or(0, Round().polygon), g.allocator, g.Or(1, &made));
        return MadePolygon(g, error, made);
    });
    Refuses("bmr_polygon_destroy", {{"polygon", kMayBeNull}}, [](const Given &g) {
        bmr_polygon_destroy(g.Or(0, Polygon(points)), nullptr);
        return "OK";
    });
    Refuses("bmr_polygon_audit", {{"polygon", kNotNull}},
            [](const Given &g) { return Said(bmr_polygon_audit(g.Or(0, Round().polygon))); });
    Answers("bmr_polygon_support", "1", {{"direction", Says("some vertex", {kNaN, kInfinity})}},
            [](const Given &g) {
                const uint32_t vertex = bmr_polygon_support(Square().polygon, {g[0], -g[0]});
                return g[0] == 1.0 ? std::to_string(vertex) : vertex < 4 ? "some vertex" : "no vertex";
            });
    Answers("bmr_polygon_support_from", "1",
            {{"direction", Says("2", {kNaN}) + Says("3", {{"0, hint `UINT32_MAX`", 0.0}})},
             {"hint", 2, Says("1", {4, UINT32_MAX})}},
            [](const Given &g) {
                const auto hint = static_cast<uint32_t>(g[0] == 0.0 ? UINT32_MAX : g[1]);
                return std::to_string(bmr_polygon_support_from(Square().polygon, {g[0], -g[0]}, hint));
            });
    Answers("bmr_polygon_contains", "true",
            {{"x", 0, Says("false", {kNaN, kInfinity, -kInfinity})},
             {"tolerance", 0, Says("false", {kNaN})},
             {"x, tolerance 1", 0, Says("false", {kNaN})}},
            [](const Given &g) {
                const double tolerance = g[2] == 0.0 ? g[1] : 1.0;
                return Said(bmr_polygon_contains(Square().polygon, {g[0] + g[2], 0.0}, tolerance));
            });
});

const Table kSums("boomerang/minkowski.h", [] {
    Makes("bmr_minkowski_difference",
          {{"a", kNotNull},
           {"b", kNotNull},
           {"result", kNotNull},
           {"rotation", 0.8, kFinite},
           {"vertices of each", 60, Says("TOO_MANY_POINTS", {40000})},
           {"size of each", 1, Says("OUT_OF_RANGE", {9e8})}},
          [](const Given &g) {
              bmr_polygon *p = Polygon(Ellipse(g.Count(4), g[5], g[5])), *made = Untouched<bmr_polygon>();
              const bmr_error error =
                  bmr_minkowski_difference(g.Or(0, p), g.Or(1, p), {g[3], 0.6}, g.allocator, g.Or(2, &made));
              bmr_polygon_destroy(p, nullptr);
              return MadePolygon(g, error, made);
          });
});

/// What a call says that makes a hierarchy.
template <typename Build> std::string Built(const Given &g, const Build &build) {
    bmr_hierarchy *made = nullptr;
    const bmr_error error = build(&made);
    return MadeHierarchy(g, error, made);
}

const Table kHierarchies("boomerang/hierarchy.h", [] {
    Makes("bmr_compass_create",
          {{"most vertices", 60, Says("NO_POINTS", {0}) + Says("TOO_MANY_POINTS", {65536, kSizeMax})},
           {"result", kNotNull}},
          [](const Given &g) {
              bmr_compass *compass = nullptr;
              const bmr_error error = bmr_compass_create(g.Count(0), g.allocator, g.Or(1, &compass));
              if (error != BMR_OK)
                  return Said(error, compass != nullptr);
              Given freely = g;
              freely.allocator = nullptr;
              const std::string built = Built(freely, [&](bmr_hierarchy **made) {
                  return bmr_hierarchy_build_compass(Round().polygon, compass, nullptr, made);
              });
              bmr_compass_destroy(compass, g.allocator);
              return built;
          });
    Makes("bmr_hierarchy_build_compass",
          {{"polygon", kNotNull + Says("TABLE_TOO_SMALL", {{"of 128 vertices, for 64", 128}})},
           {"compass", kNotNull},
           {"result", kNotNull}},
          [](const Given &g) {
              static const Body large(Ellipse(128));
              return Built(g, [&](bmr_hierarchy **made) {
                  return bmr_hierarchy_build_compass(g.Or(0, g[0] == 128.0 ? large.polygon : Round().polygon),
                                                     g.Or(1, Round().compass), g.allocator, g.Or(2, made));
              });
          });
    Makes("bmr_hierarchy_build_compass_with_corners",
          {{"polygon", kNotNull},
           {"compass", kNotNull},
           {"result", kNotNull},
           {"levels", 2, Says("TABLE_TOO_SMALL", {7, UINT32_MAX})}},
          [](const Given &g) {
              return Built(g, [&](bmr_hierarchy **made) {
                  return bmr_hierarchy_build_compass_with_corners(
                      g.Or(0, Round().polygon), g.Or(1, Round().compass), static_cast<uint32_t>(g[3]),
                      g.allocator, g.Or(2, made));
              });
          });
    using Build = bmr_error (*)(const bmr_polygon *, const bmr_allocator *, bmr_hierarchy **);
    const std::pair<const char *, Build> builds[] = {
        {"bmr_hierarchy_build_dudley", bmr_hierarchy_build_dudley},
        {"bmr_hierarchy_build_dobkin_kirkpatrick", bmr_hierarchy_build_dobkin_kirkpatrick}};
    for (const auto &[name, build] : builds)
        Makes(name, {{"polygon", kNotNull}, {"result", kNotNull}}, [build = build](const Given &g) {
            return Built(g, [&](bmr_hierarchy **made) {
                return build(g.Or(0, Round().polygon), g.allocator, g.Or(1, made));
            });
        });
    Makes("bmr_hierarchy_copy",
          {{"hierarchy", kNotNull},
           {"polygon", kNotNull + Says("WRONG_HIERARCHY", {{"another", 2}})},
           {"result", kNotNull}},
          [](const Given &g) {
              return Built(g, [&](bmr_hierarchy **made) {
                  return bmr_hierarchy_copy(g.Or(0, Round().hierarchies[BMR_HIERARCHY_DUDLEY]),
                                            g.Or(1, g[1] == 2.0 ? Square().polygon : Round().polygon),
                                            g.allocator, g.Or(2, made));
              });
          });
    Refuses("bmr_hierarchy_audit", {{"hierarchy", kNotNull}},
            [](const Given &g) { return Said(bmr_hierarchy_audit(g.Or(0, Round().hierarchies[0]))); });
    Answers("bmr_hierarchy_extreme", "some corner",
            {{"direction", Says("some corner", {0.0, {"NaN, level `UINT32_MAX`", kNaN}})},
             {"level", 1, Says("some corner", {UINT32_MAX})}},
            [](const Given &g) {
                const bmr_hierarchy *hierarchy = Square().hierarchies[0];
                const bmr_corner corner =
                    bmr_hierarchy_extreme(hierarchy, {g[0], g[0]}, static_cast<uint32_t>(g[1]));
                return corner.before < bmr_hierarchy_edge_count(hierarchy) ? "some corner" : "no corner";
            });
    Makes("bmr_chains_create", {{"hierarchy", kNotNull}, {"result", kNotNull}}, [](const Given &g) {
        bmr_chains *made = nullptr;
        const bmr_error error = bmr_chains_create(g.Or(0, Round().hierarchies[BMR_HIERARCHY_DUDLEY]),
                                                  g.allocator, g.Or(1, &made));
        if (error != BMR_OK)
            return Said(error, made != nullptr);
        const size_t bytes = bmr_chains_bytes(made);
        g.Made(&bytes, sizeof bytes);
        bmr_chains_destroy(made, g.allocator);
        return Said(error);
    });
    Answers("bmr_inflation_level", "another level", {{"root level", Says("the deepest", {UINT32_MAX})}},
            [](const Given &g) {
                const bmr_hierarchy *hierarchy = Round().hierarchies[0];
                const bmr_inflation inflation =
                    bmr_inflation_make(1.0, 0.5, 0.5, static_cast<uint32_t>(g[0]));
                const uint32_t level = bmr_inflation_level(&inflation, hierarchy, 3);
                return level == bmr_hierarchy_depth(hierarchy) ? "the deepest" : "another level";
            });
    Makes("bmr_mixed_tiling_create", {{"mixed hierarchies", kNotNull}, {"result", kNotNull}},
          [](const Given &g) {
              const bmr_mixed mixed =
                  bmr_mixed_make(Round().hierarchies[0], Round().hierarchies[0], 0.8, 0.6, 0.0);
              bmr_mixed_tiling *made = nullptr;
              const bmr_error error = bmr_mixed_tiling_create(g.Or(0, &mixed), g.allocator, g.Or(1, &made));
              if (error != BMR_OK)
                  return Said(error, made != nullptr);
              for (uint32_t tile = 0; tile < bmr_mixed_tiling_count(made); ++tile)
                  g.Made(bmr_mixed_tiling_cell(made, tile), sizeof(bmr_mixed_cell));
              bmr_mixed_tiling_destroy(made, g.allocator);
              return Said(error);
          });
});

} // namespace
