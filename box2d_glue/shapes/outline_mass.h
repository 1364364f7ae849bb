// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_OUTLINE_MASS_H
#define BOOMERANG_GLUE_OUTLINE_MASS_H

#include <box2d/b2_shape.h>

#include "boomerang/error.h"
#include "shapes/convex_registry.h"

class b2Body;

namespace bmr {

struct OutlineRecord;

/// The mass of a fixture of a piece: its share of the outline's mass. The inertias of all shares of one
/// density add up, in a body that has nothing else and in Box2D's rounding, to the float that is nearest to
/// the outline's, or to one beside it: midway between two, a sum goes to the even one. One of the pieces
/// makes up for the rounding of the others: of that one O(pieces), else O(1).
void WeighPiece(registry::Handle piece, float density, b2MassData *massData);

/// Will Box2D hold the inertia of a body to kInertiaTolerance when all pieces are on it, too? Else
/// BMR_ERROR_FAR_FROM_ORIGIN. Bodies that do not turn have none to be held. O(pieces and fixtures).
bmr_error CheckInertia(const b2Body &body, const OutlineRecord &record, float density);

} // namespace bmr

#endif
