// SPDX-License-Identifier: MIT
// What is asked once, in double: distance and closest points, penetration, a check of many pairs, and the
// time of contact, of fuzzed polygons at poses of any numbers and along fuzzed motions. Answers are those of
// rational arithmetic, and arguments are refused exactly where the headers say so.
#include <cmath>
#include <memory>

#include "boomerang/kinetic.h"
#include "harness.h"
#include "paths.h"
#include "points.h"
#include "query_oracle.h"

namespace {

constexpr size_t kMost = 24;

struct Destroyer {
    void operator()(bmr_polygon *polygon) const { bmr_polygon_destroy(polygon, nullptr); }
    void operator()(bmr_motion *motion) const { bmr_motion_destroy(motion); }
};
using Polygon = std::unique_ptr<bmr_polygon, Destroyer>;
using Motion = std::unique_ptr<bmr_motion, Destroyer>;

/// Mostly near the origin; else of any numbers.
bmr_pose ReadPose(fuzz_bytes *bytes, double reach) {
    const uint8_t how = fuzz_u8(bytes);
    bmr_pose pose = bmr_pose_from_angle({0.0, 0.0}, how % 4 == 0 ? 0.0 : fuzz_in(bytes, -3.2, 3.2));
    pose.position.x = how < 192 ? fuzz_in(bytes, -reach, reach) : fuzz_number(bytes);
    pose.position.y = how < 192 ? fuzz_in(bytes, -reach, reach) : fuzz_number(bytes);
    if (how >= 240) {
        pose.c = fuzz_number(bytes);
        pose.s = fuzz_number(bytes);
    }
    return pose;
}

/// What the header says of a pose, in long double.
bmr_error ErrorOf(const bmr_pose &pose) {
    const long double c = pose.c, s = pose.s, off = c * c + s * s - 1.0L;
    if (!std::isfinite(pose.position.x) || !std::isfinite(pose.position.y) || !std::isfinite(pose.c) ||
        !std::isfinite(pose.s))
        return BMR_ERROR_NOT_FINITE;
    const bool far = std::fmax(std::fabs(pose.position.x), std::fabs(pose.position.y)) > BMR_MAX_COORDINATE;
    return far || std::fabs(off) > static_cast<long double>(BMR_DISTANCE_UNIT) ? BMR_ERROR_OUT_OF_RANGE
                                                                               : BMR_OK;
}

/// Is the length of (c, s) so near to what is just allowed that rounding decides?
bool IsOnTheBorder(const bmr_pose &pose) {
    const long double c = pose.c, s = pose.s, off = std::fabs(c * c + s * s - 1.0L);
    return std::fabs(off - static_cast<long double>(BMR_DISTANCE_UNIT)) < 1e-15L;
}

void AskDistance(const bmr_polygon *a, const bmr_polygon *b, fuzz_bytes *bytes) {
    const double reach = 3.0 * (a->extent + b->extent);
    const bmr_pose pose_a = ReadPose(bytes, reach), pose_b = ReadPose(bytes, reach);
    if (IsOnTheBorder(pose_a) || IsOnTheBorder(pose_b))
        return;
    bmr_error expected = ErrorOf(pose_a);
    if (expected == BMR_OK)
        expected = ErrorOf(pose_b);
    if (fuzz_control("refusal"))
        expected = expected == BMR_OK ? BMR_ERROR_OUT_OF_RANGE : BMR_OK;
    bmr_closest_points closest = {-77.0, {}, {}, {}};
    bmr_overlap overlap = {-77.0, {}, {}, {}};
    const bmr_error distance_error = bmr_distance(a, &pose_a, b, &pose_b, &closest),
                    depth_error = bmr_penetration(a, &pose_a, b, &pose_b, &overlap);
    FUZZ_CHECK(distance_error == expected && depth_error == expected, "errors %d and %d, not %d",
               distance_error, depth_error, expected);
    if (expected != BMR_OK) {
        FUZZ_CHECK(closest.distance == -77.0 && overlap.depth == -77.0, "an error wrote an answer");
        return;
    }
    const query::Scene scene = query::SceneOf(a, pose_a, b, pose_b);
    const bool points = a->count == 1 && b->count == 1;
    const long double truth = exact::SignedDistance(scene.at_a, scene.at_b);
    if (fuzz_control("distance"))
        closest.distance = closest.distance * (1.0 + 1e-9) + 3.0 * scene.tolerance;
    FUZZ_CHECK(std::fabs(closest.distance - std::fmax(0.0L, truth)) <= scene.tolerance,
               "distance %.17g, which is %.17Lg", closest.distance, truth);
    if (fuzz_control("points"))
        closest.point_a = bmr_add(closest.point_a, bmr_scale(3.0 * scene.tolerance, closest.normal));
    FUZZ_CHECK(closest.distance == 0.0 || query::ProvesItself(scene, closest),
               "closest points at %.17g do not prove it", closest.distance);
    FUZZ_CHECK((closest.distance > 0.0) == (overlap.normal.x == 0.0 && overlap.normal.y == 0.0) || points,
               "distance %.17g, depth %.17g: which?", closest.distance, overlap.depth);
    if (fuzz_control("depth"))
        overlap.depth = overlap.depth * (1.0 + 1e-9) + 3.0 * scene.tolerance;
    FUZZ_CHECK(closest.distance > 0.0 ? overlap.depth == 0.0
                                      : points || query::Agrees(scene, overlap, std::fmax(0.0L, -truth)),
               "depth %.17g, which is %.17Lg", overlap.depth, -truth);
}

/// Some bodies of two shapes, a pair of every two neighbours: advanced, moved, and checked.
void AskManyPairs(const bmr_polygon *a, const bmr_polygon *b, fuzz_bytes *bytes) {
    constexpr uint32_t kBodies = 6;
    const bmr_shape shapes[2] = {{a, {}, {}}, {b, {}, {}}};
    const double extent = a->extent + b->extent, reach = 3.0 * extent;
    const double margin = std::ldexp(extent, -4 - static_cast<int>(fuzz_below(bytes, 20)));
    bmr_pair_def def = bmr_default_pair_def();
    def.structure = BMR_FREE_DIRECTION;
    def.margin = margin;
    bmr_pose poses[kBodies];
    bmr_pair pairs[kBodies - 1];
    for (bmr_pose &pose : poses)
        pose = ReadPose(bytes, reach);
    for (uint32_t i = 0; i + 1 < kBodies; ++i) {
        bmr_pair_init(&pairs[i]);
        const bmr_pose relative = bmr_pose_relative(&poses[i], &poses[i + 1]);
        if (fuzz_u8(bytes) % 8 != 0) // else it knows nothing yet
            bmr_pair_advance(&pairs[i], &def, &shapes[i % 2], &shapes[1 - i % 2], &relative, nullptr,
                             nullptr);
    }
    for (bmr_pose &pose : poses)
        if (fuzz_u8(bytes) % 2 == 0)
            pose = ReadPose(bytes, fuzz_u8(bytes) % 2 == 0 ? reach : 1e-3 * reach);
    const double need = fuzz_u8(bytes) % 16 == 0 ? fuzz_number(bytes) : margin;
    for (uint32_t i = 0; i + 1 < kBodies; ++i) {
        const bmr_pose relative = bmr_pose_relative(&poses[i], &poses[i + 1]);
        double checked;
        bool holds =
            bmr_pair_takes(&relative) && need >= 0.0 && bmr_pair_check(&pairs[i], &relative, need, &checked);
        if (fuzz_control("held"))
            holds = bmr_pair_takes(&relative);
        // Between bodies far from the origin, their relative pose is known to rounding, and one whose (c, s)
        // is off unit length scales the other body.
        const double off = std::fabs(relative.c * relative.c + relative.s * relative.s - 1.0);
        if (!holds || off > 1e-14)
            continue;
        const long double gap = exact::SignedDistance(exact::PosedOf(shapes[i % 2].polygon),
                                                      exact::PosedOf(shapes[1 - i % 2].polygon, relative));
        const long double places = std::hypot(static_cast<long double>(relative.position.x),
                                              static_cast<long double>(relative.position.y));
        FUZZ_CHECK(gap > need - 1e-14L * (extent + places), "pair %u holds at %.17Lg, margin %.17g", i, gap,
                   need);
    }
}

void AskTimeOfContact(const bmr_polygon *a, const bmr_polygon *b, fuzz_bytes *bytes) {
    constexpr double kEnd = 2.0;
    constexpr long double kSlop = 1e-8L; // 1e-9 of the extents, and 1e-12 of the time at these speeds
    const fuzz_motion_range ranges[2] = {{0.5, 3.0, 12.0, 0.0, kEnd, false, false},
                                         {6.0, 8.0, 12.0, 0.0, kEnd, false, false}};
    const Motion motion_a(fuzz_motion(bytes, &ranges[0])), motion_b(fuzz_motion(bytes, &ranges[1]));
    if (!motion_a || !motion_b)
        return;
    const double margin = std::pow(10.0, -2.0 - fuzz_below(bytes, 5));
    const double from = fuzz_in(bytes, 0.0, 0.5 * kEnd), until = fuzz_in(bytes, from, kEnd);
    const bmr_shape shape_a = {a, {}, {}}, shape_b = {b, {}, {}};
    double time = -77.0;
    const bmr_error error = bmr_time_of_contact(&shape_a, motion_a.get(), &shape_b, motion_b.get(), from,
                                                until, margin, nullptr, &time);
    FUZZ_CHECK(error == BMR_OK, "time of contact: %s", bmr_error_describe(error));
    if (fuzz_control("late-contact"))
        time = INFINITY;
    if (fuzz_control("early-contact"))
        time = from;
    const auto gap = [&](double at) {
        return exact::SignedDistance(
            exact::PosedOf(a, bmr_motion_pose(motion_a.get(), at, nullptr, nullptr)),
            exact::PosedOf(b, bmr_motion_pose(motion_b.get(), at, nullptr, nullptr)));
    };
    const bool meets = time <= until;
    FUZZ_CHECK(meets ? time >= from : time == INFINITY, "contact at %.17g, from %.17g to %.17g", time, from,
               until);
    FUZZ_CHECK(!meets || gap(time) <= margin + kSlop, "contact at %.17g, but the distance is %.17Lg", time,
               gap(time));
    const double end = meets ? time : until;
    for (int sample = 0; sample < 40; ++sample) {
        const double at = from + (end - from) * sample / 40.0;
        FUZZ_CHECK(at >= time || gap(at) >= margin - kSlop, "not before %.17g, but at %.17g it is %.17Lg",
                   time, at, gap(at));
    }
}

} // namespace

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_bytes bytes = fuzz_bytes_make(data, size);
    const uint8_t what = fuzz_u8(&bytes);
    const bool moves = what % 4 == 3;
    const auto read = [&]() {
        return Polygon(moves ? fuzz_polygon_of_size(&bytes, kMost, 2) : fuzz_polygon(&bytes, kMost));
    };
    const Polygon a = read(), b = a ? read() : nullptr;
    if (!b)
        return 0;
    if (moves)
        AskTimeOfContact(a.get(), b.get(), &bytes);
    else if (what % 4 == 2)
        AskManyPairs(a.get(), b.get(), &bytes);
    else
        AskDistance(a.get(), b.get(), &bytes);
    return 0;
}
