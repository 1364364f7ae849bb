// SPDX-License-Identifier: MIT
// Core's functions: polygons, hierarchies, distances, pairs, structures, outlines; and poses that are none.
#include <algorithm>

#include "boomerang/distance.h"
#include "boomerang/inflated.h"
#include "boomerang/kds.h"
#include "boomerang/minkowski.h"
#include "boomerang/outline.h"
#include "contracts.h"
#include "hierarchy/mixed_cells.h"
#include "kds_driver.h"

using namespace contracts;

namespace {

/// The end of a call that makes a polygon.
std::string MadePolygon(Asked &ask, bmr_error error, bmr_polygon *made) {
    if (error == BMR_OK) {
        ask.Made(made->vertices, made->count * sizeof *made->vertices);
        ask.Made(&made->center, sizeof made->center);
        bmr_polygon_destroy(made, ask.Allocator());
    }
    return ask.Says(error);
}

/// The end of a call that makes a hierarchy.
std::string MadeHierarchy(Asked &ask, bmr_error error, bmr_hierarchy *made, const bmr_allocator *allocator) {
    if (error == BMR_OK) {
        for (bmr_edge edge = 0; edge < bmr_hierarchy_edge_count(made); ++edge) {
            const bmr_line line = bmr_hierarchy_line(made, edge);
            const bmr_boomerang boomerang = bmr_hierarchy_boomerang(made, edge);
            ask.Made(&line, sizeof line);
            ask.Made(&boomerang, sizeof boomerang);
        }
        bmr_hierarchy_destroy(made, allocator);
    }
    return ask.Says(error);
}

} // namespace

TEST_CASE("boomerang/polygon.h, boomerang/minkowski.h") {
    static const std::vector<bmr_vec2> points = Ellipse(60, 3.0);
    using Make = bmr_error (*)(const bmr_vec2 *, size_t, const bmr_allocator *, bmr_polygon **);
    const std::pair<const char *, Make> makes[] = {{"bmr_polygon_create", bmr_polygon_create},
                                                   {"bmr_polygon_create_raw", bmr_polygon_create_raw}};
    for (const auto &[name, make] : makes) {
        Row(name, [make = make](Asked &ask) {
            bmr_polygon *made = Untouched<bmr_polygon>();
            const double count = ask.Number("count", 60,
                                            Gives(BMR_ERROR_NO_POINTS, {0}) +
                                                Gives(BMR_ERROR_TOO_MANY_POINTS, {65536, kSizeMax}));
            const bmr_error error = make(ask.NotNull("points", points.data()), Count(count), ask.Allocator(),
                                         ask.Result("result", &made));
            return MadePolygon(ask, error, made);
        });
    }
    Row("bmr_polygon_audit", [](Asked &ask) {
        bmr_polygon_destroy(nullptr, nullptr);
        return ask.Says(bmr_polygon_audit(ask.NotNull("polygon", Round().polygon)));
    });
    Row(
        "bmr_polygon_support",
        [](Asked &ask) {
            const double x = ask.Number("direction", 1, Gives("some vertex", {kNaN, kInfinity}));
            const uint32_t vertex = bmr_polygon_support(Square().polygon, {x, -x});
            return x == 1.0 ? std::to_string(vertex) : vertex < 4 ? "some vertex" : "no vertex";
        },
        "1");
    Row(
        "bmr_polygon_support_from",
        [](Asked &ask) {
            const double hint = ask.Number("hint", 2, Gives("1", {4, UINT32_MAX})),
                         x = ask.Number("direction", 1, Gives("2", {kNaN}) + Gives("2", {0}));
            return std::to_string(
                bmr_polygon_support_from(Square().polygon, {x, -x}, static_cast<uint32_t>(hint)));
        },
        "1");
    Row(
        "bmr_polygon_contains",
        [](Asked &ask) {
            const double x = ask.Number("x", 0, Gives("outside", {kNaN, kInfinity, -kInfinity})),
                         tolerance = ask.Number("tolerance", 0, Gives("outside", {kNaN}));
            return bmr_polygon_contains(Square().polygon, {x, 0.0}, tolerance) ? "inside" : "outside";
        },
        "inside");
    Row("bmr_minkowski_difference", [](Asked &ask) {
        const size_t count = Count(ask.Number("vertices", 60, Gives(BMR_ERROR_TOO_MANY_POINTS, {40000})));
        const double size = ask.Number("size", 1, OutOfRange({9e8}));
        bmr_polygon *p = Polygon(Ellipse(count, size, size)), *made = Untouched<bmr_polygon>();
        const bmr_error error = bmr_minkowski_difference(ask.NotNull("a", p), ask.NotNull("b", p),
                                                         {ask.Number("rotation", 0.8, kFinite), 0.6},
                                                         ask.Allocator(), ask.Result("result", &made));
        bmr_polygon_destroy(p, nullptr);
        return MadePolygon(ask, error, made);
    });
}

TEST_CASE("boomerang/hierarchy.h, boomerang/inflated.h") {
    static const Body large(Ellipse(128));
    Row("bmr_compass_create", [](Asked &ask) {
        bmr_compass *compass = nullptr;
        const double most =
            ask.Number("most vertices", 60,
                       Gives(BMR_ERROR_NO_POINTS, {0}) + Gives(BMR_ERROR_TOO_MANY_POINTS, {65536, kSizeMax}));
        const bmr_error error =
            bmr_compass_create(Count(most), ask.Allocator(), ask.Result("result", &compass));
        if (error != BMR_OK)
            return ask.Says(error);
        bmr_hierarchy *built = nullptr;
        const bmr_error then = bmr_hierarchy_build_compass(Round().polygon, compass, nullptr, &built);
        const std::string said = MadeHierarchy(ask, then, built, nullptr);
        bmr_compass_destroy(compass, ask.Allocator());
        return said;
    });
    Row("bmr_hierarchy_build_compass", [](Asked &ask) {
        bmr_hierarchy *made = nullptr;
        bmr_polygon *p =
            ask.Or("polygon of more vertices", Round().polygon, {{large.polygon, BMR_ERROR_TABLE_TOO_SMALL}});
        const bmr_error error =
            bmr_hierarchy_build_compass(ask.NotNull("polygon", p), ask.NotNull("compass", Round().compass),
                                        ask.Allocator(), ask.Result("result", &made));
        return MadeHierarchy(ask, error, made, ask.Allocator());
    });
    Row("bmr_hierarchy_build_compass_with_corners", [](Asked &ask) {
        bmr_hierarchy *made = nullptr;
        const double levels = ask.Number("levels", 2, Gives(BMR_ERROR_TABLE_TOO_SMALL, {7, UINT32_MAX}));
        const bmr_error error = bmr_hierarchy_build_compass_with_corners(
            ask.NotNull("polygon", Round().polygon), ask.NotNull("compass", Round().compass),
            static_cast<uint32_t>(levels), ask.Allocator(), ask.Result("result", &made));
        return MadeHierarchy(ask, error, made, ask.Allocator());
    });
    Row("bmr_hierarchy_build", [](Asked &ask) {
        bmr_hierarchy *made = nullptr;
        const double kind = ask.Number("kind", BMR_HIERARCHY_COMPASS,
                                       Gives(BMR_ERROR_OUT_OF_RANGE, {-1, BMR_HIERARCHY_KIND_COUNT}));
        const bmr_error error = bmr_hierarchy_build(
            static_cast<bmr_hierarchy_kind>(static_cast<int>(kind)), ask.NotNull("polygon", Round().polygon),
            ask.NotNull("compass", Round().compass), ask.Allocator(), ask.Result("result", &made));
        return MadeHierarchy(ask, error, made, ask.Allocator());
    });
    for (int other = BMR_HIERARCHY_COMPASS + 1; other < BMR_HIERARCHY_KIND_COUNT; ++other) {
        const auto kind = static_cast<bmr_hierarchy_kind>(other);
        std::string name = bmr_hierarchy_name(kind);
        std::replace(name.begin(), name.end(), '-', '_');
        Row(("bmr_hierarchy_build_" + name).c_str(), [kind](Asked &ask) {
            bmr_hierarchy *made = nullptr;
            const bmr_error error =
                bmr_hierarchy_build(kind, ask.NotNull("polygon", Round().polygon), Round().compass,
                                    ask.Allocator(), ask.Result("result", &made));
            return MadeHierarchy(ask, error, made, ask.Allocator());
        });
    }
    Row("bmr_hierarchy_audit", [](Asked &ask) {
        return ask.Says(bmr_hierarchy_audit(ask.NotNull("hierarchy", Round().hierarchies[0])));
    });
    Row(
        "bmr_hierarchy_extreme",
        [](Asked &ask) {
            const bmr_hierarchy *hierarchy = Square().hierarchies[0];
            const double x = ask.Number("direction", 1, Gives("some corner", {0.0, kNaN})),
                         level = ask.Number("level", 1, Gives("some corner", {UINT32_MAX}));
            const bmr_corner corner = bmr_hierarchy_extreme(hierarchy, {x, x}, static_cast<uint32_t>(level));
            return corner.before < bmr_hierarchy_edge_count(hierarchy) ? "some corner" : "no corner";
        },
        "some corner");
    Row("bmr_chains_create", [](Asked &ask) {
        bmr_chains *made = nullptr;
        const bmr_error error =
            bmr_chains_create(ask.NotNull("hierarchy", Round().hierarchies[BMR_HIERARCHY_DUDLEY]),
                              ask.Allocator(), ask.Result("result", &made));
        if (error == BMR_OK) {
            const size_t bytes = bmr_chains_bytes(made);
            ask.Made(&bytes, sizeof bytes);
            bmr_chains_destroy(made, ask.Allocator());
        }
        return ask.Says(error);
    });
    Row(
        "bmr_inflation_level",
        [](Asked &ask) {
            const bmr_hierarchy *hierarchy = Round().hierarchies[0];
            const double root = ask.Number("root level", 1, Gives("the deepest", {UINT32_MAX}));
            const bmr_inflation inflation = bmr_inflation_make(1.0, 0.5, 0.5, static_cast<uint32_t>(root));
            const uint32_t level = bmr_inflation_level(&inflation, hierarchy, 3);
            return level == bmr_hierarchy_depth(hierarchy) ? "the deepest" : "another level";
        },
        "another level");
    Row("bmr_mixed_tiling_create", [](Asked &ask) {
        const bmr_mixed mixed = bmr_mixed_make(Round().hierarchies[0], Round().hierarchies[0], 0.8, 0.6, 0.0);
        bmr_mixed_tiling *made = nullptr;
        const bmr_error error = bmr_mixed_tiling_create(ask.NotNull("mixed hierarchies", &mixed),
                                                        ask.Allocator(), ask.Result("result", &made));
        if (error == BMR_OK) {
            for (uint32_t tile = 0; tile < bmr_mixed_tiling_count(made); ++tile)
                ask.Made(bmr_mixed_tiling_cell(made, tile), sizeof(bmr_mixed_cell));
            bmr_mixed_tiling_destroy(made, ask.Allocator());
        }
        return ask.Says(error);
    });
}

TEST_CASE("boomerang/distance.h, with the pose on either side") {
    const bmr_pose *sides[2] = {};
    bmr_pose pose;
    for (const int side : {0, 1})
        for (const bool depth : {false, true})
            Row(depth ? "bmr_penetration" : "bmr_distance", [&](Asked &ask) {
                pose = bmr_pose_from_angle({ask.Number("x", 0.5, kFinite + OutOfRange({2e9})),
                                            ask.Number("y", 0, kFinite + OutOfRange({-2e9}))},
                                           ask.Number("angle", 0, kFinite));
                const double length = ask.Number("length of the rotation", 1, kFinite + OutOfRange({0, 2}));
                pose.c *= length;
                pose.s *= length;
                sides[side] = &pose;
                sides[1 - side] = nullptr;
                const bmr_polygon *a = ask.NotNull("a", Square().polygon),
                                  *b = ask.NotNull("b", Square().polygon);
                bmr_closest_points closest = {-77.0, {}, {}, {}};
                bmr_overlap overlap = {-77.0, {}, {}, {}};
                return ask.Says(
                    depth ? bmr_penetration(a, sides[0], b, sides[1], ask.Result("result", &overlap))
                          : bmr_distance(a, sides[0], b, sides[1], ask.Result("result", &closest)));
            });
}

TEST_CASE("boomerang/pair.h, boomerang/kds.h") {
    CHECK(bmr_structure_name(BMR_STRUCTURE_COUNT) == nullptr);
    CHECK(bmr_event_name(BMR_EVENT_KIND_COUNT) == nullptr);
    CHECK(bmr_kds_event_name(BMR_KDS_EVENT_KIND_COUNT) == nullptr);
    CHECK(bmr_hierarchy_name(BMR_HIERARCHY_KIND_COUNT) == nullptr);
    Row("bmr_kds_find", [](Asked &ask) {
        const bmr_kds_info *info = nullptr;
        const char *name = ask.Or("an unknown name", "hybrid", {{"", BMR_ERROR_UNKNOWN_NAME}});
        return ask.Says(bmr_kds_find(ask.NotNull("name", name), ask.Result("result", &info)));
    });
    static const Body other({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}); // the same vertices, and other owners
    Row("bmr_kds_create of lazy-dudley", [](Asked &ask) {
        const bmr_kds_info *info =
            ask.Or("a point's structure for two squares", test_structure("lazy-dudley"),
                   {{test_structure("point-lazy-dudley"), BMR_ERROR_OUT_OF_RANGE}});
        bmr_shape shape = Square().Shape();
        shape.polygon = ask.NotNull("polygon", ask.Or("another polygon", Square().polygon,
                                                      {{other.polygon, BMR_ERROR_WRONG_HIERARCHY}}));
        shape.hierarchies[BMR_HIERARCHY_DUDLEY] = ask.NotNull(
            "hierarchy", ask.Or("a hierarchy of another kind", Square().hierarchies[BMR_HIERARCHY_DUDLEY],
                                {{Square().hierarchies[BMR_HIERARCHY_COMPASS], BMR_ERROR_WRONG_HIERARCHY}}));
        bmr_kds_def def = bmr_default_kds_def();
        def.margin = ask.Number("margin", def.margin, kNumber + kAboveZero);
        def.hysteresis = ask.Number("hysteresis", def.hysteresis, kNumber + kNotBelowZero);
        def.alpha = ask.Number("alpha", def.alpha, kNumber + kAboveZero);
        def.offset_ratio =
            ask.Number("offset ratio", def.offset_ratio, kNumber + kAboveZero + OutOfRange({1}));
        bmr_kds *made = nullptr;
        const std::string said = ask.Says(bmr_kds_create(ask.NotNull("structure", info), &def, &shape, &shape,
                                                         nullptr, ask.Result("result", &made)));
        bmr_kds_destroy(made, nullptr);
        return said;
    });
    // One after another: those on an explicit sum or tiling allocate for it.
    Row("bmr_kds_create", [](Asked &ask) {
        static const Body point({{3, 0}});
        const bmr_kds_def def = bmr_default_kds_def();
        const bmr_instant now = {{{9.0, 2.0}, 0.8, 0.6}, {0.0, 0.0}, 0.0};
        for (size_t i = 0; i < bmr_kds_count(); ++i) {
            const bmr_kds_info *info = bmr_kds_at(i);
            const bmr_shape a = Round().Shape(), b = info->domain == BMR_KDS_POINT ? point.Shape() : a;
            bmr_kds *made = nullptr;
            const bmr_error error = bmr_kds_create(info, &def, &a, &b, ask.Allocator(), &made);
            if (error != BMR_OK)
                return made == nullptr ? ask.Says(error) : "something is written";
            bmr_kds_report report;
            bmr_kds_start(made, &now, &report);
            bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
            const size_t count = bmr_kds_conditions(made, conditions);
            ask.Made(&count, sizeof count);
            for (size_t k = 0; k < count; ++k) {
                ask.Made(&conditions[k].normal, sizeof conditions[k].normal);
                ask.Made(&conditions[k].offset, sizeof conditions[k].offset);
            }
            bmr_kds_destroy(made, ask.Allocator());
        }
        return kOk.text;
    });
    Row("bmr_kds_audit", [](Asked &ask) {
        const bmr_kds_def def = bmr_default_kds_def();
        const bmr_shape shape = Square().Shape();
        bmr_kds *kds = nullptr;
        bmr_kds_create(test_structure("lazy-dudley"), &def, &shape, &shape, nullptr, &kds);
        const bmr_instant now = {{{9, 2}, 1, 0}, {0, 0}, 0};
        bmr_kds_report report;
        bmr_kds_start(kds, &now, &report);
        const bmr_error error = bmr_kds_audit(ask.NotNull("structure", kds), ask.NotNull("pose", &now.pose));
        bmr_kds_destroy(kds, nullptr);
        return ask.Says(error);
    });
}

// --- poses that are none ---

namespace {

std::string StartKds(const bmr_pose &pose, const bmr_kds_info *info) {
    const bmr_kds_def def = bmr_default_kds_def();
    const bmr_shape shape = Square().Shape();
    bmr_kds *kds = nullptr;
    if (bmr_kds_create(info, &def, &shape, &shape, nullptr, &kds) != BMR_OK)
        return "not made";
    const bmr_instant now = {pose, {0, 0}, 0};
    bmr_kds_report report;
    bmr_kds_start(kds, &now, &report);
    const bool apart = report.apart;
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const bool waits = bmr_kds_conditions(kds, conditions) > 0;
    bmr_kds_destroy(kds, nullptr);
    return waits != apart ? "conditions do not fit" : apart ? "apart" : "contact";
}

} // namespace

TEST_CASE("a pose that is none proves nothing of two squares, which a good one has 3 apart") {
    const struct {
        const char *name;
        bmr_pose pose;
        const char *start;
    } rows[] = {
        {"5 to the right", {{5, 0}, 1, 0}, "apart"},
        {"x is NaN", {{kNaN, 0}, 1, 0}, "contact"},
        {"y is NaN", {{5, kNaN}, 1, 0}, "contact"},
        {"x is infinite", {{kInfinity, 0}, 1, 0}, "contact"},
        {"y is minus infinity", {{5, -kInfinity}, 1, 0}, "contact"},
        {"x is 1e38", {{1e38, 0}, 1, 0}, "apart"},
        {"x is 1e308", {{1e308, 0}, 1, 0}, "contact"},
        {"x is 5 and y 1e-38", {{5, 1e-38}, 1, 0}, "apart"},
        {"the cosine is NaN", {{5, 0}, kNaN, 0}, "contact"},
        {"the sine is infinite", {{5, 0}, 1, kInfinity}, "contact"},
        {"the rotation is 0", {{5, 0}, 0, 0}, "contact"},
        {"the rotation is 1 % too long", {{5, 0}, 1.01, 0}, "contact"},
        {"the rotation is twice too long", {{5, 0}, 2, 0}, "contact"},
        {"the rotation is 1e38", {{5, 0}, 1e38, 0}, "contact"},
    };
    for (const auto &row : rows) {
        CAPTURE(std::string(row.name));
        for (size_t i = 0; i < bmr_kds_count(); ++i) {
            const bmr_kds_info *info = bmr_kds_at(i);
            CAPTURE(std::string(info->name));
            if (info->domain != BMR_KDS_POINT)
                CHECK(StartKds(row.pose, info) == row.start);
        }
    }
}

// --- outlines ---

namespace {

/// A star of many notches, with a square hole.
struct Star {
    std::vector<bmr_vec2> points;
    std::vector<uint32_t> counts = {BMR_OUTLINE_OPTIMAL_POINTS, 4};

    Star() {
        points = Ellipse(counts[0]);
        for (uint32_t i = 0; i < counts[0]; ++i) {
            const double radius = 1.0 + 0.5 * ((i * 7919 + 3) % 101) / 100.0;
            points[i] = {points[i].x * radius, points[i].y * radius};
        }
        for (const bmr_vec2 &p : Ellipse(4, 0.5, -0.5))
            points.push_back(p);
    }
    bmr_rings Rings(uint32_t count = 2) const { return {points.data(), counts.data(), count}; }
};

const Star &TheStar() {
    static const Star star;
    return star;
}

const bmr_outline_fault kNoFault = {BMR_ERROR_COUNT, {0, 0}, {0, 0}, {0.0, 0.0}};

} // namespace

TEST_CASE("boomerang/outline.h") {
    static const Rules tolerances = kNotNegative + Gives(BMR_ERROR_NOT_FINITE, {kNaN, kInfinity});
    Row("bmr_outline_check", [](Asked &ask) {
        bmr_rings rings = TheStar().Rings();
        rings.points = ask.NotNull("points", rings.points);
        rings.counts = ask.NotNull("counts", rings.counts);
        bmr_outline_fault fault = kNoFault;
        const bmr_error error = bmr_outline_check(ask.NotNull("rings", &rings), ask.Allocator(),
                                                  ask.MayBeNull("fault", ask.Watched(&fault)));
        ask.Made(&fault.error, sizeof fault.error);
        return ask.Says(error);
    });
    Row("bmr_outline_check of many points", [](Asked &ask) {
        static const std::vector<bmr_vec2> points = Ellipse(4);
        const double count = ask.Number("points", 4, Gives(BMR_ERROR_TOO_MANY_POINTS, {65536, UINT32_MAX}));
        const uint32_t counts[] = {static_cast<uint32_t>(count), 2};
        const bmr_rings rings = {points.data(), counts, counts[0] == UINT32_MAX ? 2u : 1u};
        return ask.Says(bmr_outline_check(&rings, nullptr, nullptr));
    });
    Row("bmr_outline_simplify", [](Asked &ask) {
        const bmr_rings rings = TheStar().Rings();
        std::vector<uint32_t> kept(TheStar().points.size(), 77), counts = {77, 77};
        bmr_outline_fault fault = kNoFault;
        const bmr_error error = bmr_outline_simplify(
            ask.NotNull("rings", &rings), ask.Number("tolerance", 0.1, tolerances), ask.Allocator(),
            ask.Result("place of the points", kept.data()), ask.Result("place of the counts", counts.data()),
            ask.MayBeNull("fault", ask.Watched(&fault)));
        if (error == BMR_OK) {
            ask.Made(counts.data(), sizeof counts[0] * 2);
            ask.Made(kept.data(), (size_t{counts[0]} + counts[1]) * sizeof kept[0]);
        }
        return ask.Says(error);
    });
    // With the hole, without, and with a tolerance.
    for (const auto &[holes, tolerance] :
         std::initializer_list<std::pair<uint32_t, double>>{{1, 0}, {0, 0}, {1, 0.1}})
        Row("bmr_outline_decompose", [holes = holes, good = tolerance](Asked &ask) {
            const bmr_rings rings = TheStar().Rings(1 + holes);
            const bmr_outline_def def = {ask.Number("tolerance", good, tolerances)};
            bmr_outline_pieces *made = Untouched<bmr_outline_pieces>();
            bmr_outline_fault fault = kNoFault;
            const bmr_error error = bmr_outline_decompose(
                ask.NotNull("rings", &rings), ask.MayBeNull("def", &def), ask.Allocator(),
                ask.Result("result", &made), ask.MayBeNull("fault", ask.Watched(&fault)));
            if (error == BMR_OK) {
                ask.Made(made->edges, made->edge_count * sizeof *made->edges);
                ask.Made(made->first, (made->piece_count + 1) * sizeof *made->first);
                bmr_outline_pieces_destroy(made, ask.Allocator());
            }
            return ask.Says(error);
        });
    Row("bmr_outline_mass", [](Asked &ask) {
        const double half = ask.Number("half width of a hole in a square", 0.5, OutOfRange({1}));
        std::vector<bmr_vec2> points = Ellipse(4);
        for (const bmr_vec2 &p : Ellipse(4, half, half))
            points.push_back(p);
        const uint32_t counts[] = {4, 4};
        const bmr_rings rings = {points.data(), counts, 2};
        bmr_mass mass = {-77.0, {}, 0.0};
        return ask.Says(bmr_outline_mass(ask.NotNull("rings", &rings), ask.Result("result", &mass)));
    });
    Row("bmr_outline_pieces_audit", [](Asked &ask) {
        const bmr_rings rings = TheStar().Rings();
        bmr_outline_pieces *made = nullptr;
        bmr_outline_decompose(&rings, nullptr, nullptr, &made, nullptr);
        const bmr_error error = bmr_outline_pieces_audit(ask.NotNull("pieces", made));
        bmr_outline_pieces_destroy(made, nullptr);
        bmr_outline_pieces_destroy(nullptr, nullptr);
        return ask.Says(error);
    });
}
