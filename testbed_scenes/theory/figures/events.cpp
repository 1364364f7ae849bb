// SPDX-License-Identifier: MIT
// Section 5: what happens at an event, drawn from runs of the structures themselves.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "theory/course.h"
#include "theory/figure.h"

namespace testbed {
namespace {

/// A screw motion of B from one place to another in the time 0 to 1, A at rest.
TwoMotions Pass(bmr_vec2 from, bmr_vec2 to, double angle, double spin) {
    TwoMotions two;
    const bmr_motion_piece rest = bmr_piece_rest(bmr_pose_identity());
    const bmr_motion_piece pass =
        bmr_piece_screw(0.0, bmr_pose_from_angle(from, angle), bmr_sub(to, from), spin);
    const bmr_motion_piece *const pieces[2] = {&rest, &pass};
    for (size_t i = 0; i < 2; ++i) {
        bmr_motion *made = nullptr;
        Require(bmr_motion_create(pieces[i], nullptr, &made), "a motion");
        two[i].reset(made);
    }
    return two;
}

/// Where a point's structure says the point is: the conditions that it waits for, as a region of A's frame.
std::vector<bmr_vec2> RegionOf(const bmr_kds *kds, const Rectangle &world) {
    std::vector<bmr_vec2> region = {{world.left, world.bottom},
                                    {world.right, world.bottom},
                                    {world.right, world.top},
                                    {world.left, world.top}};
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const size_t count = bmr_kds_conditions(kds, conditions);
    for (size_t i = 0; i < count; ++i)
        if (conditions[i].kind == BMR_CONDITION_BEYOND && conditions[i].owner == 0)
            region = Clipped(region, conditions[i].normal, conditions[i].offset);
    return region;
}

const Colour &ColourOf(bmr_kds_event_kind kind) {
    switch (kind) {
    case BMR_KDS_STAB:
        return ink::kRed;
    case BMR_KDS_ROLL:
        return ink::kPurple;
    case BMR_KDS_CROSS:
        return ink::kGreen;
    default:
        return ink::kBlue;
    }
}

/// One run of a point past the polygon: its regions, its lines, its events.
void DrawPointRun(Canvas &canvas, const Rectangle &page, const char *structure, const std::string &title,
                  bool regions) {
    const auto polygon = std::make_shared<const Body>(EllipsePoints(24, 1.6, 1.0, 0.13));
    const auto point = std::make_shared<const Body>(std::vector<bmr_vec2>{{0.0, 0.0}});
    const bmr_vec2 from = {-3.3, 1.75}, to = {3.3, 0.55};
    const Course course(polygon, point, Pass(from, to, 0.0, 0.0));
    const Rectangle world = {-3.4, -1.25, 3.4, 2.35};
    canvas.SetPanel(page, world);
    struct Event {
        bmr_vec2 at;
        bmr_kds_event_kind kind;
        bmr_kds_proof after;
    };
    std::vector<Event> events;
    size_t index = 0;
    Follow(
        course, *StructureNamed(structure), bmr_default_kds_def(), true,
        [&](const bmr_simulation_event &event) {
            if (regions)
                canvas.Polygon(RegionOf(event.kds, world), {ink::Series(index), 0.16},
                               {ink::Series(index), 0.8});
            else if (event.report.apart)
                canvas.Line(event.after.line.normal, event.after.line.offset, {ink::Series(index), 0.9, 0.8});
            events.push_back({event.pose.position, event.report.kind, event.after});
            ++index;
        });
    canvas.Polygon(polygon->Vertices(), {ink::kGrey, 0.35}, {ink::kBlack, 1.6});
    canvas.Text({0.0, 0.0}, 0.0, -5.0, "Q", 13.0, Align::Centre, ink::kBlack, true);
    canvas.Arrow(from, to, {ink::kBlack, 1.3});
    for (size_t i = 1; i < events.size(); ++i) {
        canvas.Dot(events[i].at, 3.2, ColourOf(events[i].kind));
        // Every second label above the path, so that neighbours do not collide.
        canvas.Text(events[i].at, -4.0, i % 2 ? 8.0 : -16.0, bmr_kds_event_name(events[i].kind), 10.0,
                    Align::Centre, ColourOf(events[i].kind));
    }
    canvas.ClearPanel();
    canvas.Text({0.5 * (page.left + page.right), page.top + 6.0}, 0.0, 0.0, title, 12.0, Align::Centre,
                ink::kBlack, true);
}

/// The first event of a kind, as it was seen.
struct Seen {
    bmr_kds_proof before, after;
    bmr_pose pose;
    int level;
};

void DrawPairEvent(Canvas &canvas, const Rectangle &page, const Course &course, const Seen &seen,
                   bmr_kds_event_kind kind) {
    const bmr_hierarchy *a = course.BodyOf(0).Hierarchy(BMR_HIERARCHY_COMPASS),
                        *b = course.BodyOf(1).Hierarchy(BMR_HIERARCHY_COMPASS);
    const auto level = [](const bmr_hierarchy *hierarchy, int wanted) {
        return std::min<uint32_t>(static_cast<uint32_t>(std::max(wanted, 0)), bmr_hierarchy_depth(hierarchy));
    };
    std::vector<bmr_vec2> all = Envelope(a, 0);
    for (const bmr_vec2 &corner : Placed(Envelope(b, 0), seen.pose))
        all.push_back(corner);
    canvas.Box(page, {}, {ink::kFaint, 1.0});
    canvas.SetPanel(page, Around(all, 0.04));
    canvas.Polygon(course.BodyOf(0).Vertices(), {ink::kGrey, 0.25}, {ink::kBlack, 1.2});
    canvas.Polygon(Placed(course.BodyOf(1).Vertices(), seen.pose), {ink::kGrey, 0.25}, {ink::kBlack, 1.2});
    const int shown = std::max(seen.level, seen.after.level);
    canvas.Polygon(Envelope(a, level(a, shown)), {}, {ink::kBlue, 1.1});
    canvas.Polygon(Placed(Envelope(b, level(b, shown)), seen.pose), {}, {ink::kBlue, 1.1});
    DrawLine(canvas, seen.before, seen.pose, {ink::kGrey, 1.4, 1.0, {5.0, 3.0}});
    DrawLine(canvas, seen.after, seen.pose, {ink::kRed, 1.6});
    const auto corner = [&](const bmr_kds_proof &proof, const Colour &colour) {
        const bmr_pose other = proof.owner == 0 ? seen.pose : bmr_pose_identity();
        canvas.Dot(bmr_transform(&other, proof.nearest), 3.4, colour);
    };
    corner(seen.before, ink::kGrey);
    corner(seen.after, ink::kRed);
    canvas.ClearPanel();
    canvas.Text({0.5 * (page.left + page.right), page.top + 8.0}, 0.0, 0.0,
                std::string(bmr_kds_event_name(kind)) + ": level " + std::to_string(seen.level) + " to " +
                    std::to_string(seen.after.level),
                12.0, Align::Centre, ink::kBlack, true);
}

} // namespace

void DrawPointEvents(Canvas &canvas) {
    const double half = 0.5 * canvas.Width();
    DrawPointRun(canvas, {8.0, 12.0, half - 6.0, canvas.Height() - 28.0}, "triangle-levels-compass",
                 "(a) the active triangle", true);
    DrawPointRun(canvas, {half + 6.0, 12.0, canvas.Width() - 8.0, canvas.Height() - 28.0},
                 "point-lazy-dudley", "(b) a separating edge, lazily", false);
}

void DrawPairEvents(Canvas &canvas) {
    const auto a = std::make_shared<const Body>(EllipsePoints(20, 1.3, 0.8, 0.2));
    const auto b = std::make_shared<const Body>(EllipsePoints(14, 0.9, 0.7, 0.4));
    std::map<bmr_kds_event_kind, Seen> seen;

    const Course course(a, b, Pass({-3.0, 2.2}, {2.6, 1.6}, 0.3, 2.2));
    Follow(course, *StructureNamed("lazy-compass"), bmr_default_kds_def(), true,
           [&seen](const bmr_simulation_event &event) {
               // A push must change the line to show anything, and a roll shows most where the line stays.
               if ((event.report.kind == BMR_KDS_PUSH && !event.report.line_changed) ||
                   (event.report.kind == BMR_KDS_ROLL && event.report.line_changed))
                   return;
               if (event.report.apart)
                   seen.insert({event.report.kind,
                                {event.before, event.after, event.pose, event.report.level_before}});
           });
    const double third = canvas.Width() / 3.0;
    int column = 0;
    for (const bmr_kds_event_kind kind : {BMR_KDS_STAB, BMR_KDS_PUSH, BMR_KDS_ROLL}) {
        const Rectangle page = {column * third + 6.0, 36.0, (column + 1) * third - 6.0,
                                canvas.Height() - 26.0};
        if (const auto found = seen.find(kind); found != seen.end())
            DrawPairEvent(canvas, page, course, found->second, kind);
        else
            throw std::runtime_error(std::string("the course of this figure has no ") +
                                     bmr_kds_event_name(kind));
        ++column;
    }
    canvas.ClearPanel();
    DrawKey(canvas, {20.0, 18.0}, {ink::kGrey, 1.4, 1.0, {5.0, 3.0}}, "line and corner that failed");
    DrawKey(canvas, {230.0, 18.0}, {ink::kRed, 1.6}, "line and corner after the repair");
    DrawKey(canvas, {470.0, 18.0}, {ink::kBlue, 1.1}, "envelopes of the finer of the two levels");
}

} // namespace testbed
