// SPDX-License-Identifier: MIT
// Distances, pairs and structures; and poses that are none.
#include "bad_poses.h"
#include "boomerang/distance.h"
#include "boomerang/kds.h"
#include "stage.h"
#include "structure_named.h"

using namespace contracts;

namespace {

/// bmr_distance and bmr_penetration, with the pose on either side: all must say the same.
std::string Asked(const Given &g) {
    const bmr_polygon *a = g.Or(0, Square().polygon), *b = g.Or(1, Square().polygon);
    bmr_pose pose = bmr_pose_from_angle({g[3], g[4]}, g[5]);
    pose.c *= g[6];
    pose.s *= g[6];
    std::string answers[4];
    for (int i = 0; i < 4; ++i) {
        const bmr_pose *of_a = i % 2 == 0 ? &pose : nullptr, *of_b = i % 2 == 0 ? nullptr : &pose;
        bmr_closest_points closest = {-77.0, {}, {}, {}};
        bmr_overlap overlap = {-77.0, {}, {}, {}};
        const bmr_error error = i < 2 ? bmr_distance(a, of_a, b, of_b, g.Or(2, &closest))
                                      : bmr_penetration(a, of_a, b, of_b, g.Or(2, &overlap));
        answers[i] = Said(error, closest.distance != -77.0 || overlap.depth != -77.0);
        if (answers[i] != answers[0])
            return answers[0] + " and " + answers[i];
    }
    return answers[0];
}

const Table kDistances("boomerang/distance.h", [] {
    Refuses("bmr_distance, bmr_penetration",
            {{"a", kNotNull},
             {"b", kNotNull},
             {"result", kNotNull},
             {"x of a pose", 0.5, kFinite + Says("OUT_OF_RANGE", {2e9})},
             {"y", 0, kFinite + Says("OUT_OF_RANGE", {-2e9})},
             {"angle", 0, kFinite},
             {"length of the rotation", 1, kFinite + Says("OUT_OF_RANGE", {0, 2})}},
            Asked);
});

const Table kPairs("boomerang/pair.h", [] {
    Refuses("bmr_pairs_check",
            {{"body of a pair", 1, Says("OUT_OF_RANGE", {2, UINT32_MAX})},
             {"margin", 0, kNotBelowZero + Says("OUT_OF_RANGE", {kNaN}) + Says("OK", {kInfinity})}},
            [](const Given &g) {
                bmr_pair pair;
                bmr_pair_init(&pair);
                const bmr_pair_bodies bodies = {0, static_cast<uint32_t>(g[0])};
                const bmr_pose poses[2] = {bmr_pose_identity(), bmr_pose_identity()};
                size_t failed = 0, count = 77;
                const bmr_error error = bmr_pairs_check(&pair, &bodies, 1, poses, 2, g[1], &failed, &count);
                return Said(error, count != 77);
            });
    const auto name = [](const char *text) { return std::string(text != nullptr ? text : "`NULL`"); };
    Answers("bmr_structure_name", "lazy-compass",
            {{"structure", BMR_LAZY_COMPASS, Says("`NULL`", {{"none", BMR_STRUCTURE_COUNT}})}},
            [name](const Given &g) { return name(bmr_structure_name(static_cast<bmr_structure>(g[0]))); });
    Answers("bmr_event_name", "start", {{"event", 0, Says("`NULL`", {{"none", BMR_EVENT_KIND_COUNT}})}},
            [name](const Given &g) { return name(bmr_event_name(static_cast<bmr_event_kind>(g[0]))); });
    Answers(
        "bmr_kds_event_name", "start", {{"event", 0, Says("`NULL`", {{"none", BMR_KDS_EVENT_KIND_COUNT}})}},
        [name](const Given &g) { return name(bmr_kds_event_name(static_cast<bmr_kds_event_kind>(g[0]))); });
});

/// Of lazy-dudley, which needs a hierarchy.
std::string CreateKds(const Given &g) {
    static const Body other({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}); // the same vertices, and other owners
    bmr_shape shape = Square().Shape();
    shape.polygon = g.Or(1, g[1] == 2.0 ? other.polygon : Square().polygon);
    shape.hierarchies[BMR_HIERARCHY_DUDLEY] =
        g.Or(2, Square().hierarchies[g[2] == 2.0 ? BMR_HIERARCHY_COMPASS : BMR_HIERARCHY_DUDLEY]);
    bmr_kds_def def = bmr_default_kds_def();
    def.margin = g[3];
    def.hysteresis = g[4];
    def.alpha = g[5];
    def.offset_ratio = g[6];
    def.window_part = g[7];
    const char *name = g[0] == 2.0 ? "point-lazy-dudley" : "lazy-dudley";
    bmr_kds *made = nullptr;
    const bmr_error error =
        bmr_kds_create(g.Or(0, test_structure(name)), &def, &shape, &shape, nullptr, g.Or(8, &made));
    bmr_kds_destroy(made, nullptr);
    return Said(error, made != nullptr);
}

/// All structures, one after another: those on an explicit sum or tiling allocate for it.
std::string CreateEveryKds(const Given &g) {
    static const Body point({{3, 0}});
    const bmr_kds_def def = bmr_default_kds_def();
    const bmr_instant now = {{{9.0, 2.0}, 0.8, 0.6}, {0.0, 0.0}, 0.0};
    for (size_t i = 0; i < bmr_kds_count(); ++i) {
        const bmr_kds_info *info = bmr_kds_at(i);
        const bmr_shape a = Round().Shape(), b = info->domain == BMR_KDS_POINT ? point.Shape() : a;
        bmr_kds *made = nullptr;
        const bmr_error error = bmr_kds_create(info, &def, &a, &b, g.allocator, &made);
        if (error != BMR_OK)
            return Said(error, made != nullptr);
        bmr_kds_report report;
        bmr_kds_start(made, &now, &report);
        bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
        const size_t count = bmr_kds_conditions(made, conditions);
        g.Made(&count, sizeof count);
        for (size_t k = 0; k < count; ++k) {
            g.Made(&conditions[k].normal, sizeof conditions[k].normal);
            g.Made(&conditions[k].offset, sizeof conditions[k].offset);
        }
        bmr_kds_destroy(made, g.allocator);
    }
    return "OK";
}

const Table kStructures("boomerang/kds.h", [] {
    const bmr_kds_def good = bmr_default_kds_def();
    Refuses("bmr_kds_find", {{"name", kNotNull + Says("UNKNOWN_NAME", {{"none", 2}})}, {"result", kNotNull}},
            [](const Given &g) {
                const bmr_kds_info *info = nullptr;
                const bmr_error error = bmr_kds_find(g.Or(0, g[0] == 2.0 ? "" : "hybrid"), g.Or(1, &info));
                return Said(error, info != nullptr);
            });
    Refuses("bmr_kds_create",
            {{"structure", kNotNull + Says("OUT_OF_RANGE", {{"a point's, for two squares", 2}})},
             {"polygon", kNotNull + Says("WRONG_HIERARCHY", {{"another than the hierarchy's", 2}})},
             {"hierarchy", kNotNull + Says("WRONG_HIERARCHY", {{"of another kind", 2}})},
             {"margin", good.margin, kNumber + kAboveZero},
             {"hysteresis", good.hysteresis, kNumber + kNotBelowZero},
             {"alpha", good.alpha, kNumber + kAboveZero},
             {"offset ratio", good.offset_ratio, kNumber + kAboveZero + Says("OUT_OF_RANGE", {1})},
             {"window part", good.window_part, kNumber + kNotBelowZero + Says("OUT_OF_RANGE", {1})},
             {"result", kNotNull}},
            CreateKds);
    Allocates("bmr_kds_create", CreateEveryKds);
    Refuses("bmr_kds_audit", {{"structure", kNotNull}, {"pose", kNotNull}}, [](const Given &g) {
        const bmr_kds_def def = bmr_default_kds_def();
        const bmr_shape shape = Square().Shape();
        bmr_kds *kds = nullptr;
        bmr_kds_create(test_structure("lazy-dudley"), &def, &shape, &shape, nullptr, &kds);
        const bmr_instant now = {{{9, 2}, 1, 0}, {0, 0}, 0};
        bmr_kds_report report;
        bmr_kds_start(kds, &now, &report);
        const bmr_error error = bmr_kds_audit(g.Or(0, kds), g.Or(1, &now.pose));
        bmr_kds_destroy(kds, nullptr);
        return Said(error);
    });
});

// --- poses ---

/// What a certificate of a good pose says at this one.
std::string CheckPair(const bmr_pose &pose) {
    const bmr_pair_def def = bmr_default_pair_def();
    const bmr_shape shape = Square().Shape();
    bmr_pair pair;
    bmr_pair_init(&pair);
    const bmr_pose good = {{2.5, 0.5}, 1, 0}; // near enough for a line
    double gap = 0.0;
    if (bmr_pair_advance(&pair, &def, &shape, &shape, &good, nullptr, nullptr) != BMR_APART)
        return "not apart at a good pose";
    return bmr_pair_check(&pair, &pose, 0.0, &gap) ? "holds" : "no answer";
}

std::string AdvancePair(const bmr_pose &pose, bmr_structure structure) {
    bmr_pair_def def = bmr_default_pair_def();
    def.structure = structure;
    const bmr_shape shape = Square().Shape();
    bmr_pair pair;
    bmr_pair_init(&pair);
    double gap = 0.0;
    if (bmr_pair_advance(&pair, &def, &shape, &shape, &pose, nullptr, &gap) != BMR_APART)
        return "ask an exact test";
    return gap > 0.0 ? "apart" : "apart without a gap";
}

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

/// All structures of two polygons agree, or the first that does not is named.
std::string StartEveryKds(const bmr_pose &pose) {
    std::string first;
    for (size_t i = 0; i < bmr_kds_count(); ++i) {
        const bmr_kds_info *info = bmr_kds_at(i);
        if (info->domain == BMR_KDS_POINT)
            continue;
        const std::string answer = StartKds(pose, info);
        if (first.empty())
            first = answer;
        else if (answer != first)
            return first + ", but " + info->name + ": " + answer;
    }
    return first;
}

const Table kPoses("poses of a pair", [] {
    return Poses({{"`bmr_pair_check`", CheckPair},
                  {"`bmr_pair_advance`, lazy-compass",
                   [](const bmr_pose &pose) { return AdvancePair(pose, BMR_LAZY_COMPASS); }},
                  {"`bmr_pair_advance`, lazy-dudley",
                   [](const bmr_pose &pose) { return AdvancePair(pose, BMR_LAZY_DUDLEY); }},
                  {"`bmr_pair_advance`, free-direction",
                   [](const bmr_pose &pose) { return AdvancePair(pose, BMR_FREE_DIRECTION); }},
                  {"`bmr_kds_start`, every structure", StartEveryKds}});
});

} // namespace
