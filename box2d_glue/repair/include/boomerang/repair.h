// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_REPAIR_H
#define BOOMERANG_REPAIR_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "boomerang/error.h"
#include "boomerang/outline.h"

/// @file
/// Rings as people draw them become outlines that bmr_outline_decompose takes, and many outlines become one.
/// C++11, no Box2D; a library of its own, boomerang::repair, on the clipper of Debian's libpolyclipping.
///
/// Where coordinates go. Results lie on a grid whose step is a power of two, from snap / 32 to snap / 16. No
/// point of a boundary that results is farther than `snap` from the rings that were given, and no place that
/// is farther than `snap` from all of them changes sides. So the area differs by at most the sum, over all
/// edges, of 2 * snap * length + pi * snap^2. Coordinates may be up to 2^30 steps of the grid (with a snap of
/// 1 cm: 524 km). Up to 2^24 steps (8 km) results are exact as floats, too.
///
/// What is joined. A point goes to an earlier one within a fifth of snap, and an edge bends to a point within
/// a fifth of snap: near-touches become touches, cracks and shared edges between rings vanish.

namespace bmr {

/// Rings of points, those of one outline: the outer one first, then its holes. RepairOutline takes any rings.
/// Each is closed without repeating its first point (repeated points do no harm).
struct Outline {
    std::vector<bmr_vec2> points; ///< of all rings, one ring behind the other
    std::vector<uint32_t> counts; ///< how many points each ring has

    /// A ring more, of `count` points that have an x and a y.
    template <typename Point> void AddRing(const Point *ring, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            const bmr_vec2 point = {static_cast<double>(ring[i].x), static_cast<double>(ring[i].y)};
            points.push_back(point);
        }
        counts.push_back(static_cast<uint32_t>(count));
    }
    /// As core takes them; valid until the outline changes.
    bmr_rings GetRings() const {
        const bmr_rings rings = {points.data(), counts.data(), static_cast<uint32_t>(counts.size())};
        return rings;
    }
};

/// The rule that says what is solid if rings lie over each other.
enum class FillRule {
    EvenOdd, ///< places that an odd number of rings goes around
    NonZero  ///< places that rings go around more often in one direction than in the other
};

/// The outlines of what is solid. Each is one connected solid with its holes, outer ring counter-clockwise,
/// holes clockwise, no straight points; islands in holes are outlines of their own. bmr_outline_check takes
/// each as it is. At most BMR_MAX_VERTICES points. About O((n + k) log n + n m), with k crossings and at most
/// m edges across any horizontal line.
///
/// Errors leave `*repaired` as it was: BMR_ERROR_NULL_ARGUMENT, BMR_ERROR_NO_POINTS,
/// BMR_ERROR_TOO_MANY_POINTS (also in the result, and for thousands of edges on each other),
/// BMR_ERROR_NOT_FINITE (a coordinate or snap), BMR_ERROR_NEGATIVE (snap not above 0), BMR_ERROR_OUT_OF_RANGE
/// (a coordinate beyond 2^30 steps of the grid: a larger snap helps), BMR_ERROR_TOO_FEW_POINTS (nothing solid
/// is left), BMR_ERROR_CROSSING_EDGES (rounding made new crossings in each repetition; no test meets it),
/// BMR_ERROR_NO_MEMORY.
bmr_error RepairOutline(const Outline &rings, FillRule rule, double snap, std::vector<Outline> *repaired);

/// The union of many outlines: tiles of a map, neighbouring platforms. The rings of each outline are solid by
/// the rule, those of different outlines are added up. The points of all outlines together are limited; all
/// else is as in RepairOutline.
bmr_error MergeOutlines(const Outline *outlines, std::size_t count, FillRule rule, double snap,
                        std::vector<Outline> *merged);

} // namespace bmr

#endif
