// SPDX-License-Identifier: MIT
#ifndef BMR_OUTLINE_IMPROVE_H
#define BMR_OUTLINE_IMPROVE_H

#include "outline/mesh.h"

/// Makes the faces of a mesh fewer: groups of neighbouring ones are cut anew into the fewest, until that
/// saves none anywhere, and where the whole fits into one group, it is done with that. Faces stay convex.
/// Errors: NO_MEMORY, with the mesh still whole.
bmr_error bmr_mesh_improve(bmr_mesh *mesh, const bmr_allocator *allocator);

#endif
