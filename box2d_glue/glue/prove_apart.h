// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PROVE_APART_H
#define BOOMERANG_GLUE_PROVE_APART_H

#include <cstdint>

#include "glue/pairs/pair_table.h"
#include "glue/proofs/thresholds.h"

namespace bmr {

class SolidContact;

/// How far apart two polygons must be for b2CollidePolygons to give no points, b2TestOverlap to say no, and
/// (where their sides are long enough) b2TimeOfImpact to find them apart.
inline double ApartThreshold(const PairTable &table, uint32_t pair) {
    const Pair &at = table.At(pair);
    const FixtureMotions &motions = table.motions;
    return ContactMargin(static_cast<double>(motions[at.a].radius + motions[at.b].radius),
                         motions.RoundingMargin(at.a, at.b));
}

/// A contact was updated, and its two polygons do not touch: gives its pair the budget that their distance
/// allows, along the direction that is known already (the remembered edge's, that of a big polygon's memory,
/// that of the bodies' structure), or along one that is found from there in a step. False where that is no
/// more than the margins: call SetDue then.
///
/// What is proved is a distance of the vertices as they are, computed in double, so that it does not matter
/// where the direction came from.
bool ProveApart(PairTable *table, uint32_t pair, SolidContact *contact);

/// Is polygon b beyond polygon a along this direction, of any length, where their bodies are?
bool SeparatesAlong(const b2Fixture &a, const b2Fixture &b, bmr_vec2 d);

} // namespace bmr

#endif
