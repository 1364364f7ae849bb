// SPDX-License-Identifier: MIT
#include "boomerang/repair.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <new>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "clip/clip.h"

namespace bmr {

namespace {

using repair::Path;
using repair::Paths;
using repair::Solid;

/// Where paths cross the clipper rounds to the grid, and what was rounded may cross anew. Then it is clipped
/// again: one in a hundred times with random rings, and never a third time.
constexpr int kMostClips = 3;
/// Points go to others, and edges bend to points, that are not farther than this, in snaps.
constexpr double kReach = 0.2;
/// In steps: edges that pass through a place's square bend to the place. So edges that meet at a small angle,
/// where the clipper takes a crossing for an end, have that end in common.
constexpr double kSquare = 0.75;
/// A step is at most snap / 16. A point is rounded once, by sqrt(1/2) steps; and at each clipping, first of
/// its own outline and then of all, it is rounded and bent.
static_assert(2.0 * kReach + (0.7072 + 2 * kMostClips * (0.7072 + kSquare)) / 16.0 < 1.0,
              "nothing moves farther than snap");
/// Input that takes seconds, and less than a gigabyte.
constexpr size_t kMostPoints = size_t{1} << 20;

struct Grid {
    int exponent; ///< a step is 2 to this
    double reach; ///< in steps
};

bmr_error MakeGrid(double snap, Grid *grid) {
    if (!std::isfinite(snap))
        return BMR_ERROR_NOT_FINITE;
    if (!(snap > 0.0))
        return BMR_ERROR_NEGATIVE;
    if (snap < 64.0 * DBL_MIN) // a step has all bits of a double
        return BMR_ERROR_OUT_OF_RANGE;
    std::frexp(snap, &grid->exponent);
    grid->exponent -= 5;
    grid->reach = kReach * std::ldexp(snap, -grid->exponent);
    return BMR_OK;
}

/// The points of all outlines, in steps of the grid.
bmr_error ReadPoints(const Outline *outlines, size_t count, const Grid &grid, std::vector<bmr_vec2> *points) {
    for (size_t i = 0; i < count; ++i) {
        const Outline &outline = outlines[i];
        if (outline.points.size() > kMostPoints - points->size())
            return BMR_ERROR_TOO_MANY_POINTS;
        if (std::accumulate(outline.counts.begin(), outline.counts.end(), uint64_t{0}) !=
            outline.points.size())
            return BMR_ERROR_OUT_OF_RANGE;
        for (const bmr_vec2 &p : outline.points) {
            if (!std::isfinite(p.x) || !std::isfinite(p.y))
                return BMR_ERROR_NOT_FINITE;
            const bmr_vec2 steps = {std::ldexp(p.x, -grid.exponent), std::ldexp(p.y, -grid.exponent)};
            if (std::fabs(steps.x) > repair::kMostSteps || std::fabs(steps.y) > repair::kMostSteps)
                return BMR_ERROR_OUT_OF_RANGE;
            points->push_back(steps);
        }
    }
    return points->empty() ? BMR_ERROR_NO_POINTS : BMR_OK;
}

Outline OutlineOf(const Solid &solid, const Grid &grid) {
    Outline outline;
    for (const Path &ring : solid) {
        outline.counts.push_back(static_cast<uint32_t>(ring.size()));
        for (const repair::Place &place : ring)
            outline.points.push_back({std::ldexp(static_cast<double>(place.X), grid.exponent),
                                      std::ldexp(static_cast<double>(place.Y), grid.exponent)});
    }
    return outline;
}

void Transpose(Paths *paths) {
    for (Path &path : *paths)
        for (repair::Place &place : path)
            std::swap(place.X, place.Y);
}

bool AreWide(const Paths &paths) {
    ClipperLib::cInt left = INT64_MAX, right = INT64_MIN, bottom = INT64_MAX, top = INT64_MIN;
    for (const Path &path : paths)
        for (const repair::Place &place : path) {
            left = std::min(left, place.X);
            right = std::max(right, place.X);
            bottom = std::min(bottom, place.Y);
            top = std::max(top, place.Y);
        }
    return left <= right && right - left > top - bottom;
}

/// The clipper, which goes from line to line upwards: along the longer way, where a line meets fewer edges.
bool Unite(Paths *paths, ClipperLib::PolyFillType rule, bool *any) {
    const bool wide = AreWide(*paths);
    if (wide) {
        Transpose(paths); // rings run the other way then
        rule = rule == ClipperLib::pftPositive ? ClipperLib::pftNegative : rule;
    }
    ClipperLib::Clipper clipper;
    *any = clipper.AddPaths(*paths, ClipperLib::ptSubject, true);
    if (*any && !clipper.Execute(ClipperLib::ctUnion, *paths, rule, rule))
        return false;
    if (wide)
        Transpose(paths);
    return true;
}

/// The places that the paths go around by the rule, as solids.
bmr_error Clip(Paths paths, ClipperLib::PolyFillType rule, std::vector<Solid> *solids) {
    for (int i = 0; i < kMostClips; ++i) {
        bool any;
        if (!Unite(&paths, rule, &any))
            return BMR_ERROR_CROSSING_EDGES;
        if (!any) { // none goes around anything
            solids->clear();
            return BMR_OK;
        }
        if (!repair::Bend(&paths, kSquare) || !repair::Bend(&paths, 0.0))
            return BMR_ERROR_TOO_MANY_POINTS;
        if (repair::Arrange(paths, solids))
            return BMR_OK;
        rule = ClipperLib::pftEvenOdd;
    }
    return BMR_ERROR_CROSSING_EDGES;
}

bmr_error Repair(const Outline *outlines, size_t count, FillRule rule, double snap,
                 std::vector<Outline> *repaired) {
    Grid grid;
    bmr_error error = MakeGrid(snap, &grid);
    std::vector<bmr_vec2> points;
    if (error == BMR_OK)
        error = ReadPoints(outlines, count, grid, &points);
    if (error != BMR_OK)
        return error;
    const std::vector<repair::Place> places = repair::Gather(points, grid.reach);
    Paths paths;
    auto place = places.begin();
    for (size_t i = 0; i < count; ++i)
        for (const uint32_t size : outlines[i].counts) {
            paths.emplace_back(place, place + size);
            place += size;
        }
    if (!repair::Bend(&paths, grid.reach))
        return BMR_ERROR_TOO_MANY_POINTS;

    const auto fill = rule == FillRule::EvenOdd ? ClipperLib::pftEvenOdd : ClipperLib::pftNonZero;
    std::vector<Solid> solids;
    Paths all; // the rings of each outline, which run around its solid once
    auto ring = paths.begin();
    for (size_t i = 0; i < count && error == BMR_OK; ++i) {
        const auto end = ring + static_cast<std::ptrdiff_t>(outlines[i].counts.size());
        error = Clip(Paths(ring, end), fill, &solids);
        for (const Solid &solid : solids)
            all.insert(all.end(), solid.begin(), solid.end());
        ring = end;
    }
    if (error == BMR_OK && count > 1)
        error = Clip(std::move(all), ClipperLib::pftPositive, &solids);
    if (error != BMR_OK)
        return error;
    if (solids.empty())
        return BMR_ERROR_TOO_FEW_POINTS;
    std::vector<Outline> made;
    for (const Solid &solid : solids) {
        made.push_back(OutlineOf(solid, grid));
        const bmr_rings rings = made.back().GetRings();
        error = bmr_outline_check(&rings, nullptr, nullptr);
        if (error != BMR_OK)
            return error;
    }
    repaired->swap(made);
    return BMR_OK;
}

} // namespace

bmr_error MergeOutlines(const Outline *outlines, std::size_t count, FillRule rule, double snap,
                        std::vector<Outline> *merged) {
    if (merged == nullptr || (outlines == nullptr && count > 0))
        return BMR_ERROR_NULL_ARGUMENT;
    try {
        return Repair(outlines, count, rule, snap, merged);
    } catch (const std::bad_alloc &) {
        return BMR_ERROR_NO_MEMORY;
    } catch (const std::length_error &) {
        return BMR_ERROR_NO_MEMORY;
    } catch (const std::exception &) { // the clipper's
        return BMR_ERROR_CROSSING_EDGES;
    }
}

bmr_error RepairOutline(const Outline &rings, FillRule rule, double snap, std::vector<Outline> *repaired) {
    return MergeOutlines(&rings, 1, rule, snap, repaired);
}

} // namespace bmr
