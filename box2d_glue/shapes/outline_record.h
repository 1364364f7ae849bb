// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_OUTLINE_RECORD_H
#define BOOMERANG_GLUE_OUTLINE_RECORD_H

#include "boomerang/outline.h"
#include "shapes/convex_registry.h"

class b2Shape;

namespace bmr {

/// Shared by the copies of an OutlineShape and their fixtures: its pieces, which are big polygons of the
/// registry, also if they have few vertices. One block of memory, besides those of the pieces.
struct OutlineRecord : registry::Group {
    double area;
    bmr_vec2 centroid;
    double inertia; ///< about the centroid
    double ownPart; ///< of the inertias that its pieces have of their own: the rest is for floats to hold
    float reach;    ///< no vertex of a piece is farther from the origin
    uint32_t pieceCount;
    uint32_t balance;           ///< which of the pieces makes up for the rounding of all (outline_mass.h)
    registry::Handle pieces[1]; ///< as many as there are pieces
};

/// The record of an outline that was cut into these pieces, with one reference. `mass` is the outline's; the
/// pieces are given masses whose sum it is. BMR_ERROR_TOO_FEW_POINTS where no piece has an area as far as
/// floats can tell, BMR_ERROR_OUT_OF_RANGE, BMR_ERROR_NO_MEMORY; then `*record` is untouched.
bmr_error MakeOutlineRecord(const bmr_outline_pieces &pieces, const bmr_mass &mass, OutlineRecord **record);

/// The record that a shape is a piece of, also where it was changed in place; nullptr where it is none. A few
/// loads.
OutlineRecord *OutlineRecordOf(const b2Shape &shape);

} // namespace bmr

#endif
