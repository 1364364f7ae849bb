// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_EXACT_POLYGONS_H
#define BOOMERANG_TEST_EXACT_POLYGONS_H

#include "boomerang/polygon.h"
#include "exact_motion.h"

/// @file
/// Convex polygons in rational arithmetic, and how far apart they are. No filter, no floating point at all.

namespace exact {

using Number = mpq_class;

inline Places PlacesOf(const bmr_polygon *polygon) {
    Places places;
    for (uint32_t i = 0; i < polygon->count; ++i)
        places.push_back(PlaceOf(polygon->vertices[i]));
    return places;
}

inline Places PlacesAt(const bmr_polygon *polygon, const bmr_pose &pose) {
    return At(pose, {polygon->vertices, polygon->vertices + polygon->count});
}

/// Do the normals of some edge separate the two, closed as they are? (For points and segments, only where
/// they are not in line.)
inline bool SomeEdgeSeparates(const Places &a, const Places &b) {
    for (int turn = 0; turn < 2; ++turn) {
        const Places &own = turn ? b : a;
        for (size_t i = 0; i < own.size(); ++i) {
            const Place e = Way(own[i], own[(i + 1) % own.size()]);
            if (LeastAlong(turn ? Place{-e.y, e.x} : Place{e.y, -e.x}, a, b) > 0)
                return true;
        }
    }
    return false;
}

inline Number Cross(const Place &a, const Place &b) {
    return a.x * b.y - a.y * b.x;
}

/// Of a point and a segment, which may be a point.
inline Number SquareToSegment(const Place &p, const Place &from, const Place &to) {
    const Place e = Way(from, to), w = Way(from, p);
    const Number along = Product(e, w), length = Square(e), across = Cross(e, w);
    if (along <= 0)
        return Square(w);
    return along >= length ? Square(Way(to, p)) : Number(across * across / length);
}

/// The squared distance of two convex polygons in order, or of points and segments; 0 where they touch or
/// overlap.
inline Number SquaredDistance(const Places &a, const Places &b) {
    const bool separated = SomeEdgeSeparates(a, b);
    if ((a.size() > 2 || b.size() > 2) && !separated)
        return 0;
    Number best(-1);
    for (size_t i = 0; i < a.size(); ++i)
        for (size_t j = 0; j < b.size(); ++j) {
            const Place &a_next = a[(i + 1) % a.size()], &b_next = b[(j + 1) % b.size()];
            for (const Number &d : {SquareToSegment(a[i], b[j], b_next), SquareToSegment(b[j], a[i], a_next)})
                if (best < 0 || d < best)
                    best = d;
            // Two segments that are not in line, and neither of whose lines separates them, cross.
            if (!separated && Cross(Way(a[i], a_next), Way(b[j], b_next)) != 0)
                return 0;
        }
    return best;
}

} // namespace exact

#endif
