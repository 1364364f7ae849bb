// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_APART_LINE_H
#define BOOMERANG_GLUE_APART_LINE_H

#include <cstdint>

#include "boomerang/vector.h"

class b2Fixture;

namespace bmr {

class PairTable;
class SolidContact;

/// A contact of ours was updated, and its two polygons do not touch: gives its pair in the table the
/// budget that their distance allows, along the direction that is known already (the remembered edge's, that
/// of a big polygon's memory, that of the bodies' structure), or along one that is found from there in a
/// step. Leaves the pair due where that is no more than the margins.
///
/// What is proved is a distance of the vertices as they are, computed in double, so that it does not matter
/// where the direction came from.
void ProveApart(PairTable *table, uint32_t pair, SolidContact *contact);

/// The same for a sensor's contact whose two polygons overlap: the budget that the depth of a vertex in the
/// other polygon allows. There is no line to renew it.
void ProveOverlap(PairTable *table, uint32_t pair);

/// How far apart two polygons must be for b2CollidePolygons to give no points, b2TestOverlap to say no, and
/// (where their sides are long enough) b2TimeOfImpact to find them apart.
double ApartThreshold(const PairTable &table, uint32_t pair);

/// Is polygon b beyond polygon a along this direction, of any length, where their bodies are?
bool SeparatesAlong(const b2Fixture &a, const b2Fixture &b, bmr_vec2 d);

} // namespace bmr

#endif
