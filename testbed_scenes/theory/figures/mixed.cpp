// SPDX-License-Identifier: MIT
// Section 4: mixed hierarchies.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>

#include "hierarchy/mixed_cells.h"
#include "theory/figure.h"

namespace testbed {
namespace {

// Two small polygons without symmetry. What is drawn is the sum of the first and the reflected second.
const std::vector<bmr_vec2> kP = {{-1.5, -0.5}, {0.2, -1.05}, {1.55, -0.35}, {1.2, 0.75}, {-0.35, 1.1}};
const std::vector<bmr_vec2> kQ = {{-0.75, -0.35}, {0.35, -0.7}, {0.95, 0.2}, {0.1, 0.75}};
constexpr double kTurn = 0.37;

/// A tiling and what it is made of.
class Tiling {
public:
    Tiling(const Body &p, const Body &q, double angle)
        : m_mixed(bmr_mixed_make(p.Hierarchy(BMR_HIERARCHY_DOBKIN_KIRKPATRICK),
                                 q.Hierarchy(BMR_HIERARCHY_DOBKIN_KIRKPATRICK), std::cos(angle),
                                 std::sin(angle), 0.0)),
          m_tiling(nullptr, bmr_mixed_tiling_destroyer) {
        bmr_mixed_tiling *tiling = nullptr;
        Require(bmr_mixed_tiling_create(&m_mixed, nullptr, &tiling), "the tiling");
        m_tiling.reset(tiling);
    }
    const bmr_mixed *Mixed() const { return &m_mixed; }
    size_t Count() const { return bmr_mixed_tiling_count(m_tiling.get()); }
    const bmr_mixed_cell &Cell(size_t i) const {
        return *bmr_mixed_tiling_cell(m_tiling.get(), static_cast<uint32_t>(i));
    }
    std::vector<bmr_vec2> Corners(const bmr_mixed_cell &cell) const {
        bmr_vec2 corners[BMR_MIXED_MAX_SIDES];
        const size_t count = bmr_mixed_polygon(&m_mixed, &cell, corners);
        return {corners, corners + count};
    }
    /// Of all cells: of M_0.
    Rectangle Frame(double margin) const {
        std::vector<bmr_vec2> all;
        for (size_t i = 0; i < Count(); ++i)
            for (const bmr_vec2 &corner : Corners(Cell(i)))
                all.push_back(corner);
        return Around(all, margin);
    }

private:
    static void bmr_mixed_tiling_destroyer(bmr_mixed_tiling *tiling) {
        bmr_mixed_tiling_destroy(tiling, nullptr);
    }
    bmr_mixed m_mixed;
    std::unique_ptr<bmr_mixed_tiling, void (*)(bmr_mixed_tiling *)> m_tiling;
};

double AreaOf(const std::vector<bmr_vec2> &corners) {
    double twice = 0.0;
    for (size_t i = 0; i < corners.size(); ++i)
        twice += bmr_cross(corners[i], corners[(i + 1) % corners.size()]);
    return 0.5 * twice;
}

const Colour &ColourOf(const bmr_mixed_cell &cell) {
    if (cell.kind != BMR_MIXED_TRIANGLE)
        return ink::kGreen;
    return cell.owner == 0 ? ink::kBlue : ink::kRed;
}

void DrawCells(Canvas &canvas, const Tiling &tiling, double opacity) {
    for (size_t i = 0; i < tiling.Count(); ++i) {
        const bmr_mixed_cell &cell = tiling.Cell(i);
        canvas.Polygon(tiling.Corners(cell), {ColourOf(cell), opacity}, {ColourOf(cell), 0.8});
    }
}

/// The sum of P's and the reflected Q's envelopes as they are before a stage.
std::vector<bmr_vec2> SumBefore(const Body &p, const Body &q, double angle, int stage) {
    const uint32_t levelP = static_cast<uint32_t>(stage + 1) / 2, levelQ = static_cast<uint32_t>(stage) / 2;
    const bmr_hierarchy *const hp = p.Hierarchy(BMR_HIERARCHY_DOBKIN_KIRKPATRICK);
    const bmr_hierarchy *const hq = q.Hierarchy(BMR_HIERARCHY_DOBKIN_KIRKPATRICK);
    const bmr_pose turn = bmr_pose_from_angle({0.0, 0.0}, angle);
    std::vector<bmr_vec2> sums;
    for (const bmr_vec2 &a : Envelope(hp, std::min(levelP, bmr_hierarchy_depth(hp))))
        for (const bmr_vec2 &b : Placed(Envelope(hq, std::min(levelQ, bmr_hierarchy_depth(hq))), turn))
            sums.push_back(bmr_sub(a, b));
    return Body(sums).Vertices();
}

void DrawCentre(Canvas &canvas, const std::vector<bmr_vec2> &polygon, const std::string &text) {
    canvas.Polygon(polygon, {ink::kGrey, 0.25}, {ink::kBlack, 1.8});
    bmr_vec2 centre = {0.0, 0.0};
    for (const bmr_vec2 &corner : polygon)
        centre = bmr_add(centre, bmr_scale(1.0 / static_cast<double>(polygon.size()), corner));
    canvas.Text(centre, 0.0, -4.0, text, 12.0, Align::Centre, ink::kBlack, true);
}

/// A polygon with the level at which each of its edges is inserted.
void DrawNumbered(Canvas &canvas, const Rectangle &page, const Body &body, double angle, bool reflected,
                  const std::string &name, const Colour &colour) {
    bmr_pose turn = bmr_pose_from_angle({0.0, 0.0}, angle);
    if (reflected) {
        turn.c = -turn.c;
        turn.s = -turn.s;
    }
    const bmr_hierarchy *hierarchy = body.Hierarchy(BMR_HIERARCHY_DOBKIN_KIRKPATRICK);
    const std::vector<bmr_vec2> outer = Placed(Envelope(hierarchy, 0), turn);
    canvas.SetPanel(page, Around(outer, 0.16));
    canvas.Polygon(outer, {}, {ink::kGrey, 0.8, 1.0, {3.0, 3.0}});
    canvas.Polygon(Placed(body.Vertices(), turn), {colour, 0.2}, {colour, 1.6});
    canvas.Text(turn.position, 0.0, -5.0, name, 13.0, Align::Centre, ink::kBlack, true);
    for (bmr_edge edge = 0; edge < bmr_hierarchy_edge_count(hierarchy); ++edge) {
        const uint32_t level = bmr_hierarchy_level(hierarchy, edge);
        if (level == 0)
            continue;
        const uint32_t depth = bmr_hierarchy_depth(hierarchy);
        const bmr_vec2 from =
            bmr_hierarchy_corner_point(hierarchy, bmr_hierarchy_corner_before(hierarchy, edge, depth));
        const bmr_vec2 to =
            bmr_hierarchy_corner_point(hierarchy, bmr_hierarchy_corner_after(hierarchy, edge, depth));
        const bmr_vec2 normal = bmr_rotate(&turn, bmr_hierarchy_line(hierarchy, edge).normal);
        const bmr_vec2 middle = bmr_transform(&turn, bmr_scale(0.5, bmr_add(from, to)));
        canvas.Text(middle, 9.0 * normal.x, 9.0 * normal.y - 4.0, std::to_string(level), 10.0, Align::Centre,
                    colour);
    }
}

void DrawKey(Canvas &canvas, double x, double y, const Colour &colour, const std::string &text) {
    canvas.Box({x, y, x + 12.0, y + 12.0}, {colour, 0.35}, {colour, 1.0});
    canvas.Text({x + 18.0, y + 2.0}, 0.0, 0.0, text, 11.0);
}

using CellKey = std::tuple<int, int, bmr_edge, bmr_edge>;
CellKey KeyOf(const bmr_mixed_cell &cell) {
    return {cell.kind, cell.owner, cell.edge, cell.kind == BMR_MIXED_TRIANGLE ? BMR_NO_EDGE : cell.other[0]};
}
std::map<CellKey, bmr_mixed_cell> CellsOf(const Tiling &tiling) {
    std::map<CellKey, bmr_mixed_cell> cells;
    for (size_t i = 0; i < tiling.Count(); ++i)
        cells[KeyOf(tiling.Cell(i))] = tiling.Cell(i);
    return cells;
}

/// An event of the rotation: the angle after it, and the parallelogram that changes.
struct Change {
    double angle;
    bmr_mixed_cell before, after; ///< kind INSIDE: there is none
};

/// The first events of the three kinds, met by turning in small steps.
struct Changes {
    std::optional<Change> pageTurn, collapse, expansion;
};

constexpr double kStep = 0.004;

Changes FindChanges(const Body &p, const Body &q) {
    bmr_mixed_cell none = {};
    none.kind = BMR_MIXED_INSIDE;
    Changes changes;
    std::map<CellKey, bmr_mixed_cell> last = CellsOf(Tiling(p, q, kTurn));
    for (double angle = kTurn + kStep; angle < kTurn + 2.0 * M_PI; angle += kStep) {
        const std::map<CellKey, bmr_mixed_cell> now = CellsOf(Tiling(p, q, angle));
        auto mirrored = [](CellKey key) {
            std::get<0>(key) = std::get<0>(key) == BMR_MIXED_BEFORE ? BMR_MIXED_AFTER : BMR_MIXED_BEFORE;
            return key;
        };
        for (const auto &[key, cell] : last) {
            if (now.count(key) || cell.kind == BMR_MIXED_TRIANGLE)
                continue;
            const auto moved = now.find(mirrored(key));
            if (moved != now.end() && !last.count(mirrored(key)) && !changes.pageTurn)
                changes.pageTurn = Change{angle, cell, moved->second};
            else if (moved == now.end() && !changes.collapse)
                changes.collapse = Change{angle, cell, none};
        }
        for (const auto &[key, cell] : now)
            if (!last.count(key) && cell.kind != BMR_MIXED_TRIANGLE && !last.count(mirrored(key)) &&
                !changes.expansion)
                changes.expansion = Change{angle, none, cell};
        last = now;
    }
    return changes;
}

/// Two pictures of one change, before and after, around the cell that changes.
void DrawChange(Canvas &canvas, double left, double bottom, double size, const Body &p, const Body &q,
                const Change &change, const std::string &title) {
    constexpr double kApart = 0.09; // of an angle, to either side of the event
    const double at = change.angle - 0.5 * kStep;
    const bmr_mixed_cell &shown = change.before.kind != BMR_MIXED_INSIDE ? change.before : change.after;
    // Around the triangle of the edge that the parallelogram belongs to.
    const Tiling middle(p, q, at);
    const bmr_mixed_cell triangle = bmr_mixed_triangle(middle.Mixed(), shown.owner, shown.edge);
    const Rectangle world = Around(middle.Corners(triangle), 0.55);
    canvas.ClearPanel();
    canvas.Text({left + size + 6.0, bottom + size + 8.0}, 0.0, 0.0, title, 12.0, Align::Centre, ink::kBlack,
                true);
    for (int side = 0; side < 2; ++side) {
        const Tiling tiling(p, q, at + (side == 0 ? -kApart : kApart));
        const double x = left + side * (size + 12.0);
        canvas.ClearPanel();
        const Rectangle page = {x, bottom, x + size, bottom + size};
        canvas.Box(page, {}, {ink::kFaint, 1.0});
        canvas.SetPanel(page, world);
        DrawCells(canvas, tiling, 0.10);
        const bmr_mixed_cell now = bmr_mixed_triangle(tiling.Mixed(), shown.owner, shown.edge);
        canvas.Polygon(tiling.Corners(now), {ColourOf(now), 0.45}, {ColourOf(now), 1.6});
        const bmr_mixed_cell &cell = side == 0 ? change.before : change.after;
        if (cell.kind != BMR_MIXED_INSIDE && bmr_mixed_exists(tiling.Mixed(), &cell))
            canvas.Polygon(tiling.Corners(cell), {ColourOf(cell), 0.55}, {ColourOf(cell), 1.8});
        bmr_vec2 x0 = {0.0, 0.0};
        for (const bmr_vec2 &corner : middle.Corners(triangle))
            x0 = bmr_add(x0, bmr_scale(1.0 / 3.0, corner));
        canvas.Dot(x0, 3.0, ink::kBlack);
        canvas.Text(x0, 6.0, 2.0, "x", 11.0);
    }
}

} // namespace

void DrawMixedInsertion(Canvas &canvas) {
    // Rounder ones, so that there are chains to push.
    const Body p(EllipsePoints(6, 1.5, 1.0, 0.5)), q(EllipsePoints(7, 1.0, 0.8, 0.1));
    const Tiling tiling(p, q, kTurn);
    // The edge that cuts away most, of those that push a chain on both sides.
    std::map<std::pair<int, bmr_edge>, std::set<int>> sides;
    std::map<std::pair<int, bmr_edge>, double> areas;
    for (size_t i = 0; i < tiling.Count(); ++i) {
        const bmr_mixed_cell &cell = tiling.Cell(i);
        sides[{cell.owner, cell.edge}].insert(cell.kind);
        areas[{cell.owner, cell.edge}] += AreaOf(tiling.Corners(cell));
    }
    std::pair<int, bmr_edge> shown = areas.begin()->first;
    for (const auto &[key, area] : areas)
        if (std::make_pair(sides[key].size(), area) > std::make_pair(sides[shown].size(), areas[shown]))
            shown = key;
    const bmr_mixed_cell triangle = bmr_mixed_triangle(tiling.Mixed(), shown.first, shown.second);
    const int stage = bmr_mixed_stage(tiling.Mixed(), &triangle);
    const Rectangle world = tiling.Frame(0.05);
    const double half = 0.5 * canvas.Width();
    for (int side = 0; side < 2; ++side) {
        canvas.SetPanel({10.0 + side * half, 40.0, half - 10.0 + side * half, canvas.Height() - 26.0}, world);
        const std::vector<bmr_vec2> before = SumBefore(p, q, kTurn, stage);
        if (side == 1)
            for (size_t i = 0; i < tiling.Count(); ++i)
                if (const bmr_mixed_cell &cell = tiling.Cell(i);
                    cell.owner == shown.first && cell.edge == shown.second)
                    canvas.Polygon(tiling.Corners(cell), {ColourOf(cell), 0.4}, {ColourOf(cell), 1.4});
        canvas.Polygon(before, {}, {ink::kBlack, 1.6});
        DrawCentre(canvas, SumBefore(p, q, kTurn, 1000), "");
    }
    canvas.ClearPanel();
    canvas.Text({0.5 * half, canvas.Height() - 16.0}, 0.0, 0.0, "before the edge e", 12.0, Align::Centre,
                ink::kBlack, true);
    canvas.Text({1.5 * half, canvas.Height() - 16.0}, 0.0, 0.0, "what e cuts away", 12.0, Align::Centre,
                ink::kBlack, true);
    DrawKey(canvas, 60.0, 16.0, ColourOf(triangle), "the triangle that e cuts off its own polygon");
    DrawKey(canvas, 370.0, 16.0, ink::kGreen, "parallelograms left by the other's chain");
}

void DrawMixedFull(Canvas &canvas) {
    const Body p(kP), q(kQ);
    const Tiling tiling(p, q, kTurn);
    const double split = 190.0;
    DrawNumbered(canvas, {10.0, 235.0, split - 10.0, canvas.Height() - 10.0}, p, 0.0, false, "P", ink::kBlue);
    DrawNumbered(canvas, {10.0, 50.0, split - 10.0, 225.0}, q, kTurn, true, "-Q", ink::kRed);
    canvas.SetPanel({split, 44.0, canvas.Width() - 10.0, canvas.Height() - 10.0}, tiling.Frame(0.02));
    DrawCells(canvas, tiling, 0.28);
    DrawCentre(canvas, SumBefore(p, q, kTurn, 1000), "P + (-Q)");
    // A configuration point and its cell: in the middle of a parallelogram that is large enough to see.
    const bmr_mixed_cell *best = nullptr;
    double most = 0.0;
    for (size_t i = 0; i < tiling.Count(); ++i) {
        const bmr_mixed_cell &cell = tiling.Cell(i);
        if (cell.kind == BMR_MIXED_TRIANGLE)
            continue;
        const double area = AreaOf(tiling.Corners(cell));
        if (area > most) {
            most = area;
            best = &cell;
        }
    }
    if (best) {
        const std::vector<bmr_vec2> c = tiling.Corners(*best);
        canvas.Polygon(c, {ColourOf(*best), 0.45}, {ink::kBlack, 1.6});
        const bmr_vec2 x = bmr_scale(0.5, bmr_add(c[0], c[2]));
        canvas.Dot(x, 3.0, ink::kBlack);
        canvas.Text(x, 6.0, 3.0, "x", 12.0, Align::Left, ink::kBlack, true);
    }
    canvas.ClearPanel();
    DrawKey(canvas, 30.0, 16.0, ink::kBlue, "P's triangles");
    DrawKey(canvas, 160.0, 16.0, ink::kRed, "Q's triangles");
    DrawKey(canvas, 290.0, 16.0, ink::kGreen, "mixed parallelograms");
    canvas.Text({470.0, 18.0}, 0.0, 0.0, "numbers: level of the cut", 11.0);
}

void DrawMixedEvents(Canvas &canvas) {
    const Body p(kP), q(kQ);
    const Changes changes = FindChanges(p, q);
    const double size = 0.5 * (canvas.Width() - 32.0);
    double bottom = canvas.Height();
    for (const auto &[change, title] :
         {std::make_pair(changes.pageTurn, "page turn"), std::make_pair(changes.collapse, "collapse"),
          std::make_pair(changes.expansion, "expansion")}) {
        if (!change)
            throw std::runtime_error(std::string("no ") + title + " in a full turn");
        bottom -= size + 34.0;
        DrawChange(canvas, 10.0, bottom, size, p, q, *change, title);
    }
}

} // namespace testbed
