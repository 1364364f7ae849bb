// SPDX-License-Identifier: MIT
// Bad arguments of core's functions in double, and poses that are none. Those in float: bad_core32.cpp.
#include <cstring>

#include "arguments.h"
#include "bad_poses.h"
#include "boomerang/distance.h"
#include "boomerang/inflated.h"
#include "boomerang/kds.h"
#include "boomerang/minkowski.h"
#include "boomerang/pair.h"
#include "hierarchy/mixed_cells.h"
#include "points.h"
#include "structure_named.h"

using namespace bad_input;

namespace {

bmr_polygon *Polygon(const std::vector<double> &xy) {
    bmr_polygon *polygon = nullptr;
    bmr_polygon_create(reinterpret_cast<const bmr_vec2 *>(xy.data()), xy.size() / 2, nullptr, &polygon);
    return polygon;
}

/// A square of half width 1 and what can be made of it; every cell has a process of its own, which frees it.
struct World {
    bmr_polygon *square = Polygon(Square(1.0));
    bmr_polygon *round = Polygon(Circle(40, 1.0));
    bmr_compass *compass = nullptr;
    bmr_hierarchy *hierarchies[BMR_HIERARCHY_KIND_COUNT] = {};

    World() {
        bmr_compass_create(64, nullptr, &compass);
        bmr_hierarchy_build_compass(square, compass, nullptr, &hierarchies[BMR_HIERARCHY_COMPASS]);
        bmr_hierarchy_build_dudley(square, nullptr, &hierarchies[BMR_HIERARCHY_DUDLEY]);
        bmr_hierarchy_build_dobkin_kirkpatrick(square, nullptr,
                                               &hierarchies[BMR_HIERARCHY_DOBKIN_KIRKPATRICK]);
    }
    World(const World &) = delete;
    World &operator=(const World &) = delete;
    ~World() {
        for (bmr_hierarchy *hierarchy : hierarchies)
            bmr_hierarchy_destroy(hierarchy, nullptr);
        bmr_compass_destroy(compass, nullptr);
        bmr_polygon_destroy(square, nullptr);
        bmr_polygon_destroy(round, nullptr);
    }
    bmr_shape Shape() const { return {square, {hierarchies[0], hierarchies[1], hierarchies[2]}, {}}; }
};

std::string CreateKds(const char *name, void (*spoil)(bmr_kds_def *, bmr_shape *)) {
    const World world;
    bmr_kds_def def = bmr_default_kds_def();
    bmr_shape shape = world.Shape();
    if (spoil != nullptr)
        spoil(&def, &shape);
    const bmr_kds_info *info = nullptr;
    bmr_kds_find(name, &info);
    bmr_kds *kds = nullptr;
    const bmr_error error = bmr_kds_create(info, &def, &shape, &shape, nullptr, &kds);
    bmr_kds_destroy(kds, nullptr);
    return Said(error);
}

/// Both queries of two squares, one of them at this pose: each must refuse it the same way, and write
/// nothing.
std::string Asked(const bmr_pose &pose) {
    const World world;
    std::string answers[4];
    for (int i = 0; i < 4; ++i) {
        const bmr_pose *a = i % 2 == 0 ? &pose : nullptr, *b = i % 2 == 0 ? nullptr : &pose;
        bmr_closest_points closest = {-77.0, {}, {}, {}};
        bmr_overlap overlap = {-77.0, {}, {}, {}};
        const bmr_error error = i < 2 ? bmr_distance(world.square, a, world.square, b, &closest)
                                      : bmr_penetration(world.square, a, world.square, b, &overlap);
        const bool written = closest.distance != -77.0 || overlap.depth != -77.0;
        answers[i] = Said(error) + (written ? ", and the answer is written" : "");
        if (answers[i] != answers[0])
            return answers[0] + " and " + answers[i];
    }
    return answers[0];
}

std::string PairsCheck(uint32_t body, double margin) {
    bmr_pair pair;
    bmr_pair_init(&pair);
    const bmr_pair_bodies bodies = {0, body};
    const bmr_pose poses[2] = {bmr_pose_identity(), bmr_pose_identity()};
    size_t failed = 0, count = 77;
    const bmr_error error = bmr_pairs_check(&pair, &bodies, 1, poses, 2, margin, &failed, &count);
    return Said(error) + (error != BMR_OK && count != 77 ? ", and the count is written" : "");
}

std::string Minkowski(bmr_vec2 rotation, size_t a, size_t b, double size) {
    bmr_polygon *p = Polygon(Circle(a, size)), *q = Polygon(Circle(b, size)), *sum = nullptr;
    const bmr_error error = bmr_minkowski_difference(p, q, rotation, nullptr, &sum);
    for (bmr_polygon *polygon : {p, q, sum})
        bmr_polygon_destroy(polygon, nullptr);
    return Said(error);
}

std::string Compass(size_t most) {
    bmr_compass *compass = nullptr;
    const bmr_error error = bmr_compass_create(most, nullptr, &compass);
    bmr_compass_destroy(compass, nullptr);
    return Said(error);
}

std::vector<Argument> Arguments() {
    return {
        {"`bmr_polygon_create`: no place for the result",
         [] {
             const bmr_vec2 point = {0, 0};
             return Said(bmr_polygon_create(&point, 1, nullptr, nullptr));
         }},
        {"`bmr_polygon_copy`: `NULL`",
         [] {
             bmr_polygon *copy = nullptr;
             return Said(bmr_polygon_copy(nullptr, nullptr, &copy));
         }},
        {"`bmr_polygon_destroy`: `NULL`",
         [] {
             bmr_polygon_destroy(nullptr, nullptr);
             return std::string("nothing happens");
         }},
        {"`bmr_polygon_audit`: `NULL`", [] { return Said(bmr_polygon_audit(nullptr)); }},
        {"`bmr_polygon_support_from`: direction of NaN, hint 2",
         [] {
             const World world;
             return std::to_string(bmr_polygon_support_from(world.square, {kNone, 1.0}, 2));
         }},
        {"`bmr_polygon_support_from`: direction of zero, hint `UINT32_MAX`",
         [] {
             const World world;
             return std::to_string(bmr_polygon_support_from(world.square, {0.0, 0.0}, UINT32_MAX));
         }},
        {"`bmr_polygon_support`: direction of NaN",
         [] {
             const World world;
             return bmr_polygon_support(world.round, {kNone, kNone}) < 40 ? "some vertex" : "no vertex";
         }},
        {"`bmr_polygon_support`: direction of infinity",
         [] {
             const World world;
             return bmr_polygon_support(world.round, {kInfinite, 0.0}) < 40 ? "some vertex" : "no vertex";
         }},
        {"`bmr_polygon_contains`: a point of NaN, tolerance 0",
         [] {
             const World world;
             return Said(bmr_polygon_contains(world.square, {kNone, 0.0}, 0.0));
         }},
        {"`bmr_polygon_contains`: a point of NaN, tolerance 1",
         [] {
             const World world;
             return Said(bmr_polygon_contains(world.square, {kNone, 0.0}, 1.0));
         }},
        {"`bmr_polygon_contains`: the middle, tolerance of NaN",
         [] {
             const World world;
             return Said(bmr_polygon_contains(world.square, {0.0, 0.0}, kNone));
         }},
        {"`bmr_polygon_contains`: a point at infinity, tolerance 0",
         [] {
             const World world;
             return Said(bmr_polygon_contains(world.square, {kInfinite, 0.0}, 0.0));
         }},
        {"`bmr_minkowski_difference`: `NULL`",
         [] {
             const World world;
             bmr_polygon *sum = nullptr;
             return Said(bmr_minkowski_difference(world.square, nullptr, {1, 0}, nullptr, &sum));
         }},
        {"`bmr_minkowski_difference`: rotation of NaN",
         [] {
             return Minkowski({kNone, 0}, 8, 8, 1.0);
         }},
        {"`bmr_minkowski_difference`: rotation of infinity",
         [] {
             return Minkowski({kInfinite, 0}, 8, 8, 1.0);
         }},
        {"`bmr_minkowski_difference`: 40,000 and 40,000 vertices",
         [] {
             return Minkowski({1, 0}, 40000, 40000, 1.0);
         }},
        {"`bmr_minkowski_difference`: a sum beyond 1e9",
         [] {
             return Minkowski({1, 0}, 8, 8, 9e8);
         }},
        {"`bmr_compass_create`: for 0 vertices", [] { return Compass(0); }},
        {"`bmr_compass_create`: for 65,536 vertices", [] { return Compass(65536); }},
        {"`bmr_compass_create`: for `SIZE_MAX` vertices", [] { return Compass(SIZE_MAX); }},
        {"`bmr_compass_create`: no place for the result",
         [] { return Said(bmr_compass_create(8, nullptr, nullptr)); }},
        {"`bmr_hierarchy_build_compass`: no polygon",
         [] {
             const World world;
             bmr_hierarchy *made = nullptr;
             return Said(bmr_hierarchy_build_compass(nullptr, world.compass, nullptr, &made));
         }},
        {"`bmr_hierarchy_build_compass`: no compass",
         [] {
             const World world;
             bmr_hierarchy *made = nullptr;
             return Said(bmr_hierarchy_build_compass(world.square, nullptr, nullptr, &made));
         }},
        {"`bmr_hierarchy_build_compass`: a compass for half of the vertices",
         [] {
             const World world;
             bmr_polygon *large = Polygon(Circle(128, 1.0));
             bmr_hierarchy *made = nullptr;
             const bmr_error error = bmr_hierarchy_build_compass(large, world.compass, nullptr, &made);
             bmr_polygon_destroy(large, nullptr);
             return Said(error);
         }},
        {"`bmr_hierarchy_build_dudley`: no polygon",
         [] {
             bmr_hierarchy *made = nullptr;
             return Said(bmr_hierarchy_build_dudley(nullptr, nullptr, &made));
         }},
        {"`bmr_hierarchy_build_dobkin_kirkpatrick`: no place for the result",
         [] {
             const World world;
             return Said(bmr_hierarchy_build_dobkin_kirkpatrick(world.square, nullptr, nullptr));
         }},
        {"`bmr_hierarchy_build_compass_with_corners`: a compass of 6 levels for 7",
         [] {
             const World world;
             bmr_hierarchy *made = nullptr;
             return Said(
                 bmr_hierarchy_build_compass_with_corners(world.square, world.compass, 7, nullptr, &made));
         }},
        {"`bmr_hierarchy_build_compass_with_corners`: for `UINT32_MAX` levels",
         [] {
             const World world;
             bmr_hierarchy *made = nullptr;
             return Said(bmr_hierarchy_build_compass_with_corners(world.square, world.compass, UINT32_MAX,
                                                                  nullptr, &made));
         }},
        {"`bmr_chains_create`: no hierarchy",
         [] {
             bmr_chains *made = nullptr;
             return Said(bmr_chains_create(nullptr, nullptr, &made));
         }},
        {"`bmr_hierarchy_copy`: no polygon",
         [] {
             const World world;
             bmr_hierarchy *made = nullptr;
             return Said(bmr_hierarchy_copy(world.hierarchies[0], nullptr, nullptr, &made));
         }},
        {"`bmr_hierarchy_copy`: over another polygon",
         [] {
             const World world;
             bmr_polygon *other = Polygon(Circle(5, 1.0));
             bmr_hierarchy *made = nullptr;
             const bmr_error error = bmr_hierarchy_copy(world.hierarchies[0], other, nullptr, &made);
             bmr_polygon_destroy(other, nullptr);
             return Said(error);
         }},
        {"`bmr_hierarchy_audit`: `NULL`", [] { return Said(bmr_hierarchy_audit(nullptr)); }},
        {"`bmr_hierarchy_extreme`: direction of NaN, level `UINT32_MAX`",
         [] {
             const World world;
             const bmr_corner corner =
                 bmr_hierarchy_extreme(world.hierarchies[0], {kNone, kNone}, UINT32_MAX);
             return corner.before < bmr_hierarchy_edge_count(world.hierarchies[0]) ? "some corner"
                                                                                   : "no corner";
         }},
        {"`bmr_inflation_level`: a root level of `UINT32_MAX`",
         [] {
             const World world;
             const bmr_inflation inflation = bmr_inflation_make(1.0, 0.5, 0.5, UINT32_MAX);
             return bmr_inflation_level(&inflation, world.hierarchies[0], 3) ==
                            bmr_hierarchy_depth(world.hierarchies[0])
                        ? "the deepest"
                        : "another level";
         }},
        {"`bmr_mixed_tiling_create`: `NULL`",
         [] {
             bmr_mixed_tiling *tiling = nullptr;
             return Said(bmr_mixed_tiling_create(nullptr, nullptr, &tiling));
         }},
        {"`bmr_structure_name`: no structure",
         [] { return bmr_structure_name(BMR_STRUCTURE_COUNT) == nullptr ? "`NULL`" : "a name"; }},
        {"`bmr_event_name`, `bmr_kds_event_name`: no event",
         [] {
             return bmr_event_name(BMR_EVENT_KIND_COUNT) == nullptr &&
                            bmr_kds_event_name(BMR_KDS_EVENT_KIND_COUNT) == nullptr
                        ? "`NULL`"
                        : "a name";
         }},
        {"`bmr_distance`, `bmr_penetration`: `NULL`",
         [] {
             const World world;
             bmr_closest_points closest;
             bmr_overlap overlap;
             const bmr_error errors[] = {
                 bmr_distance(nullptr, nullptr, world.square, nullptr, &closest),
                 bmr_distance(world.square, nullptr, nullptr, nullptr, &closest),
                 bmr_distance(world.square, nullptr, world.square, nullptr, nullptr),
                 bmr_penetration(nullptr, nullptr, world.square, nullptr, &overlap),
                 bmr_penetration(world.square, nullptr, nullptr, nullptr, &overlap),
                 bmr_penetration(world.square, nullptr, world.square, nullptr, nullptr)};
             for (const bmr_error error : errors)
                 if (error != errors[0])
                     return std::string("two answers");
             return Said(errors[0]);
         }},
        {"`bmr_distance`, `bmr_penetration`: a pose at NaN",
         [] {
             return Asked({{kNone, 0}, 1, 0});
         }},
        {"`bmr_distance`, `bmr_penetration`: a pose at infinity",
         [] {
             return Asked({{0, -kInfinite}, 1, 0});
         }},
        {"`bmr_distance`, `bmr_penetration`: a pose turned by NaN",
         [] {
             return Asked(bmr_pose_from_angle({0, 0}, kNone));
         }},
        {"`bmr_distance`, `bmr_penetration`: a pose turned by infinity",
         [] {
             return Asked(bmr_pose_from_angle({0, 0}, kInfinite));
         }},
        {"`bmr_distance`, `bmr_penetration`: a pose at 2e9",
         [] {
             return Asked({{2e9, 0}, 1, 0});
         }},
        {"`bmr_distance`, `bmr_penetration`: a pose that doubles",
         [] {
             return Asked({{0, 0}, 2, 0});
         }},
        {"`bmr_distance`, `bmr_penetration`: a pose of zeros",
         [] {
             return Asked({{0, 0}, 0, 0});
         }},
        {"`bmr_pairs_check`: a body that is not there", [] { return PairsCheck(2, 0.0); }},
        {"`bmr_pairs_check`: a margin of NaN", [] { return PairsCheck(1, kNone); }},
        {"`bmr_pairs_check`: a margin below 0", [] { return PairsCheck(1, -1.0); }},
        {"`bmr_kds_find`: no such name",
         [] {
             const bmr_kds_info *info = nullptr;
             return Said(bmr_kds_find("", &info));
         }},
        {"`bmr_kds_find`: a `NULL` name, or none for the answer",
         [] {
             const bmr_kds_info *info = nullptr;
             const bmr_error name = bmr_kds_find(nullptr, &info), answer = bmr_kds_find("predict", nullptr);
             return name == answer ? Said(name) : "two answers";
         }},
        {"`bmr_kds_create`: no structure", [] { return CreateKds("none of that name", nullptr); }},
        {"`bmr_kds_create`: no polygon",
         [] { return CreateKds("lazy-compass", [](bmr_kds_def *, bmr_shape *s) { s->polygon = nullptr; }); }},
        {"`bmr_kds_create`: not the hierarchy that it needs",
         [] {
             return CreateKds("lazy-dudley", [](bmr_kds_def *, bmr_shape *s) {
                 s->hierarchies[BMR_HIERARCHY_DUDLEY] = nullptr;
             });
         }},
        {"`bmr_kds_create`: a hierarchy of another polygon",
         [] {
             static const World other; // its square has the same vertices, and other owners
             return CreateKds("lazy-dudley", [](bmr_kds_def *, bmr_shape *s) { s->polygon = other.square; });
         }},
        {"`bmr_kds_create`: a hierarchy of another kind",
         [] {
             return CreateKds("lazy-dudley", [](bmr_kds_def *, bmr_shape *s) {
                 s->hierarchies[BMR_HIERARCHY_DUDLEY] = s->hierarchies[BMR_HIERARCHY_COMPASS];
             });
         }},
        {"`bmr_kds_create`: a margin of 0",
         [] { return CreateKds("lazy-compass", [](bmr_kds_def *d, bmr_shape *) { d->margin = 0.0; }); }},
        {"`bmr_kds_create`: a margin of NaN",
         [] { return CreateKds("lazy-compass", [](bmr_kds_def *d, bmr_shape *) { d->margin = kNone; }); }},
        {"`bmr_kds_create`: an infinite margin",
         [] {
             return CreateKds("lazy-compass", [](bmr_kds_def *d, bmr_shape *) { d->margin = kInfinite; });
         }},
        {"`bmr_kds_create`: a hysteresis below 0",
         [] {
             return CreateKds("lazy-compass", [](bmr_kds_def *d, bmr_shape *) { d->hysteresis = -1e-38; });
         }},
        {"`bmr_kds_create`: a hysteresis of NaN",
         [] {
             return CreateKds("lazy-compass", [](bmr_kds_def *d, bmr_shape *) { d->hysteresis = kNone; });
         }},
        {"`bmr_kds_create`: an alpha of NaN",
         [] { return CreateKds("lazy-compass", [](bmr_kds_def *d, bmr_shape *) { d->alpha = kNone; }); }},
        {"`bmr_kds_create`: an offset ratio of 1",
         [] {
             return CreateKds("lazy-compass", [](bmr_kds_def *d, bmr_shape *) { d->offset_ratio = 1.0; });
         }},
        {"`bmr_kds_create`: a window part of 1",
         [] { return CreateKds("lazy-compass", [](bmr_kds_def *d, bmr_shape *) { d->window_part = 1.0; }); }},
        {"`bmr_kds_create`: a window part of NaN",
         [] {
             return CreateKds("lazy-compass", [](bmr_kds_def *d, bmr_shape *) { d->window_part = kNone; });
         }},
        {"`bmr_kds_create`: a point's structure for two squares",
         [] { return CreateKds("point-lazy-compass", nullptr); }},
        {"`bmr_kds_audit`: `NULL`", [] { return Said(bmr_kds_audit(nullptr, nullptr)); }},
    };
}

// --- poses ---

std::string AdvancePair(const bmr_pose &pose, bmr_structure structure, bool check) {
    const World world;
    bmr_pair_def def = bmr_default_pair_def();
    def.structure = structure;
    const bmr_shape shape = world.Shape();
    bmr_pair pair;
    bmr_pair_init(&pair);
    if (check) {                                  // the certificate of a good pose, looked at
        const bmr_pose good = {{2.5, 0.5}, 1, 0}; // near enough for a line
        double gap = 0.0;
        if (bmr_pair_advance(&pair, &def, &shape, &shape, &good, nullptr, nullptr) != BMR_APART)
            return "not apart at a good pose";
        return bmr_pair_check(&pair, &pose, 0.0, &gap) ? "holds" : "no answer";
    }
    double gap = 0.0;
    const bool apart = bmr_pair_advance(&pair, &def, &shape, &shape, &pose, nullptr, &gap) == BMR_APART;
    return apart ? gap > 0.0 ? "apart" : "apart without a gap" : "ask an exact test";
}

std::string StartKds(const bmr_pose &pose, const char *name) {
    const World world;
    const bmr_kds_def def = bmr_default_kds_def();
    const bmr_shape shape = world.Shape();
    bmr_kds *kds = nullptr;
    if (bmr_kds_create(test_structure(name), &def, &shape, &shape, nullptr, &kds) != BMR_OK)
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

std::string PoseAnswer(size_t row, size_t column) {
    const bmr_pose &pose = kPoses[row].pose;
    switch (column) {
    case 0:
        return AdvancePair(pose, BMR_FREE_DIRECTION, true);
    case 1:
        return AdvancePair(pose, BMR_LAZY_COMPASS, false);
    case 2:
        return AdvancePair(pose, BMR_LAZY_DUDLEY, false);
    case 3:
        return AdvancePair(pose, BMR_FREE_DIRECTION, false);
    default:
        return "";
    }
}

/// Of two polygons.
std::vector<std::string> KdsNames() {
    std::vector<std::string> names;
    for (size_t i = 0; i < bmr_kds_count(); ++i)
        if (bmr_kds_at(i)->domain != BMR_KDS_POINT)
            names.emplace_back(bmr_kds_at(i)->name);
    return names;
}

/// All structures agree, or the first that does not is named.
std::string EveryKds(size_t row) {
    std::string first;
    for (const std::string &name : KdsNames()) {
        const std::string answer = StartKds(kPoses[row].pose, name.c_str());
        if (first.empty())
            first = answer;
        else if (answer != first)
            return first + ", but " + name + ": " + answer;
    }
    return first;
}

} // namespace

int main(int argc, char **argv) {
    return Main(
        argc, argv,
        {ArgumentTable("arguments of core", Arguments()),
         {"poses of a pair",
          {"`bmr_pair_check`", "`bmr_pair_advance`, lazy-compass", "`bmr_pair_advance`, lazy-dudley",
           "`bmr_pair_advance`, free-direction", "`bmr_kds_start`, every structure"},
          PoseNames(),
          [](size_t row, size_t column) { return column == 4 ? EveryKds(row) : PoseAnswer(row, column); }}});
}
