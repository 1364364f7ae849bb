// SPDX-License-Identifier: MIT
// Section 7, the open question: the two lines of core/kds/two_lines.c, drawn from the structures themselves.
#include <algorithm>
#include <cmath>

#include "boomerang/distance.h"
#include "theory/course.h"
#include "theory/figure.h"

namespace testbed {
namespace {

/// What a structure chooses at a pose.
struct Choice {
    bmr_kds_proof proof;
    std::vector<bmr_condition> conditions;
};

Choice Chosen(const char *structure, const Body &a, const Body &b, const bmr_instant &now) {
    const bmr_kds_def def = bmr_default_kds_def();
    const bmr_shape shapes[2] = {a.Shape(), b.Shape()};
    bmr_kds *kds = nullptr;
    Require(bmr_kds_create(StructureNamed(structure), &def, &shapes[0], &shapes[1], nullptr, &kds),
            "a structure");
    bmr_kds_report report;
    bmr_kds_start(kds, &now, &report);
    Choice choice;
    choice.conditions.resize(BMR_KDS_MAX_CONDITIONS);
    choice.conditions.resize(bmr_kds_conditions(kds, choice.conditions.data()));
    const bool apart = bmr_kds_get_proof(kds, &choice.proof);
    bmr_kds_destroy(kds, nullptr);
    if (!apart)
        throw std::runtime_error("the bodies of this figure touch");
    return choice;
}

/// The ranks of a body's edges in its tree: in each quadrant the middle edge, then those of both halves.
std::vector<int> Depths(const std::vector<bmr_vec2> &vertices) {
    const size_t n = vertices.size();
    std::vector<int> depths(n, 0);
    const auto quadrant = [&](size_t i) {
        const bmr_vec2 along = bmr_sub(vertices[(i + 1) % n], vertices[i]);
        // The normal is (y, -x).
        return static_cast<int>(std::floor((std::atan2(-along.x, along.y) + 2.0 * M_PI) / (0.5 * M_PI))) & 3;
    };
    size_t start = 0;
    while (start + 1 < n && quadrant(start) == quadrant((start + n - 1) % n))
        ++start;
    for (size_t from = 0; from < n;) {
        size_t until = from + 1;
        while (until < n && quadrant((start + until) % n) == quadrant((start + from) % n))
            ++until;
        for (size_t i = from; i < until; ++i)
            for (size_t low = from, high = until, depth = 1;; ++depth) {
                const size_t middle = low + (high - low) / 2;
                depths[(start + i) % n] = static_cast<int>(depth);
                if (i == middle)
                    break;
                (i > middle ? low : high) = i > middle ? middle + 1 : middle;
            }
        from = until;
    }
    return depths;
}

/// Each edge with its rank, and the axes of the body's frame.
void DrawRanks(Canvas &canvas, const Body &body, const bmr_pose &pose, const char *name,
               const Colour &colour) {
    const std::vector<bmr_vec2> vertices = body.Vertices();
    const std::vector<int> depths = Depths(vertices);
    for (size_t i = 0; i < vertices.size(); ++i) {
        const bmr_vec2 p = vertices[i], q = vertices[(i + 1) % vertices.size()], along = bmr_sub(q, p);
        const double length = std::hypot(along.x, along.y);
        const bmr_vec2 normal = bmr_rotate(&pose, {along.y / length, -along.x / length});
        const bmr_vec2 at = bmr_transform(&pose, bmr_scale(0.5, bmr_add(p, q)));
        canvas.Text(at, -11.0 * normal.x, -11.0 * normal.y - 3.5, std::to_string(depths[i]), 10.0,
                    Align::Centre, colour);
    }
    for (int k = 0; k < 4; ++k) {
        const bmr_vec2 axis = {std::cos(0.5 * M_PI * k), std::sin(0.5 * M_PI * k)};
        canvas.Arrow(pose.position, bmr_add(pose.position, bmr_scale(0.3, bmr_rotate(&pose, axis))),
                     {ink::kGrey, 1.0});
    }
    canvas.Text(pose.position, 22.0, 16.0, name, 14.0, Align::Centre, ink::kBlack, true);
}

void DrawBodies(Canvas &canvas, const Body &a, const Body &b, const bmr_pose &pose) {
    canvas.Polygon(a.Vertices(), {ink::kBlue, 0.12}, {ink::kBlue, 1.6});
    canvas.Polygon(Placed(b.Vertices(), pose), {ink::kGrey, 0.2}, {ink::kBlack, 1.6});
}

} // namespace

void DrawFreeDirection(Canvas &canvas) {
    const Body a(EllipsePoints(20, 1.9, 0.9, 0.1)), b(EllipsePoints(22, 1.5, 0.85, 0.1));
    const bmr_instant now = {bmr_pose_from_angle({0.35, 2.45}, 0.25), bmr_vec2_make(0.0, 0.0), 0.0};
    const Choice choice = Chosen("free-fd2", a, b, now);
    const bmr_pose home = bmr_pose_identity();
    bmr_closest_points closest;
    Require(bmr_distance(a.Polygon(), &home, b.Polygon(), &now.pose, &closest), "the closest points");

    const Rectangle page = {10.0, 46.0, canvas.Width() - 10.0, canvas.Height() - 10.0};
    canvas.SetPanel(page, {-2.3, 0.1, 2.9, 2.75});
    DrawBodies(canvas, a, b, now.pose);
    DrawLine(canvas, choice.proof, now.pose, {ink::kRed, 1.6});
    canvas.Arrow(closest.point_a, closest.point_b, {ink::kBlack, 1.3});
    canvas.Text(bmr_scale(0.5, bmr_add(closest.point_a, closest.point_b)), -8.0, -3.0, "u", 13.0,
                Align::Right);
    const bmr_pose other = choice.proof.owner == 0 ? now.pose : home;
    for (const bmr_condition &condition : choice.conditions) {
        if (condition.kind == BMR_CONDITION_BEYOND) {
            canvas.Dot(bmr_transform(&other, condition.point), 4.0, ink::kPurple);
        } else {
            const bmr_vec2 end = bmr_rotate(condition.owner == 0 ? &home : &now.pose, condition.normal),
                           point = bmr_rotate(condition.owner == 0 ? &now.pose : &home, condition.point),
                           bracket = condition.owner == choice.proof.owner ? point : end,
                           from = choice.proof.owner == 0 ? closest.point_b : closest.point_a;
            canvas.Arrow(from, bmr_add(from, bmr_scale(0.9, bracket)), {ink::kOrange, 1.4});
        }
    }
    canvas.Text({0.0, 0.4}, 0.0, -5.0, "P", 14.0, Align::Centre, ink::kBlack, true);
    canvas.Text(now.pose.position, 0.0, -5.0, "Q", 14.0, Align::Centre, ink::kBlack, true);
    canvas.ClearPanel();
    DrawKey(canvas, {20.0, 26.0}, {ink::kRed, 1.6}, "the line, fixed in one body");
    canvas.Dot({224.0, 26.0}, 4.0, ink::kPurple);
    canvas.Text({234.0, 22.0}, 0.0, 0.0, "the window: corners of the other body's tangents", 10.5);
    DrawKey(canvas, {500.0, 26.0}, {ink::kOrange, 1.4}, "ends of the bracket");
}

void DrawCoarseLine(Canvas &canvas) {
    const Body a(EllipsePoints(18, 1.7, 0.9, 0.1)), b(EllipsePoints(12, 1.5, 0.85, 0.1));
    const bmr_instant now = {bmr_pose_from_angle({1.3, 2.15}, 0.5), bmr_vec2_make(1.0, 0.0), 1.0};
    const Choice coarse = Chosen("coarse", a, b, now), nearest = Chosen("free-fd2", a, b, now);
    const Rectangle page = {10.0, 46.0, canvas.Width() - 10.0, canvas.Height() - 10.0};
    canvas.SetPanel(page, {-2.4, -1.0, 3.3, 3.2});
    DrawBodies(canvas, a, b, now.pose);
    DrawLine(canvas, nearest.proof, now.pose, {ink::kGrey, 1.2, 1.0, {5.0, 3.0}});
    DrawLine(canvas, coarse.proof, now.pose, {ink::kRed, 1.6});
    DrawRanks(canvas, a, bmr_pose_identity(), "P", ink::kBlue);
    DrawRanks(canvas, b, now.pose, "Q", ink::kBlack);
    const bmr_pose other = coarse.proof.owner == 0 ? now.pose : bmr_pose_identity();
    canvas.Dot(bmr_transform(&other, coarse.proof.nearest), 4.0, ink::kPurple);
    canvas.ClearPanel();
    DrawKey(canvas, {20.0, 26.0}, {ink::kRed, 1.6}, "the coarse line");
    DrawKey(canvas, {150.0, 26.0}, {ink::kGrey, 1.2, 1.0, {5.0, 3.0}}, "the free direction");
    canvas.Text({300.0, 22.0}, 0.0, 0.0, "1 2 3 ..: depth of an edge in its tree (the arrows, axes: 0)",
                10.5);
}

} // namespace testbed
