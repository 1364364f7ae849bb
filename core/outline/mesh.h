// SPDX-License-Identifier: MIT
#ifndef BMR_OUTLINE_MESH_H
#define BMR_OUTLINE_MESH_H

#include <stdbool.h>

#include "geometry/predicates.h"
#include "outline/rings.h"

/// One side of an edge between two faces, or of an edge of the outline. The face is on its left.
typedef struct bmr_half {
    uint32_t origin;         ///< point
    uint32_t next, previous; ///< around the face, counter-clockwise
    uint32_t twin;           ///< the other side; NONE on the outline
    uint32_t source;         ///< the edge of the outline; NONE inside
    uint32_t face;
    uint32_t corner; ///< for whoever looks at a group of faces: which corner of the group its origin is
} bmr_half;

/// The solid of an outline, cut into convex faces from corner to corner. A face is known by one of its
/// halves. Halves and faces that are not used have themselves as `face`, or as the half, NONE.
typedef struct bmr_mesh {
    const bmr_vec2 *points;
    bmr_half *halves;
    uint32_t half_count;
    uint32_t *faces; ///< one half of each; NONE of a face that is no more
    uint32_t face_count;
    size_t bytes; ///< of the one block, which begins with the halves
} bmr_mesh;

/// Cuts the solid into triangles: one sweep, which finds the outline's faults on its way. Each triangle is
/// strictly counter-clockwise. O(n log n). Errors: those of bmr_sweep.
bmr_error bmr_mesh_triangulate(const bmr_ring_links *links, const bmr_allocator *allocator, bmr_mesh *mesh,
                               bmr_outline_fault *fault);
void bmr_mesh_free(bmr_mesh *mesh, const bmr_allocator *allocator);

static inline bmr_vec2 bmr_mesh_point(const bmr_mesh *mesh, uint32_t half) {
    return mesh->points[mesh->halves[half].origin];
}

/// The half that ends where this one begins, on the other side of the previous one: the next one clockwise
/// around the corner's point. NONE where the outline is in between.
static inline uint32_t bmr_mesh_turn_left(const bmr_mesh *mesh, uint32_t half) {
    return mesh->halves[mesh->halves[half].previous].twin;
}

/// Would the two faces beside an inner edge be convex as one, at the point where `half` begins?
static inline bool bmr_mesh_is_idle_at(const bmr_mesh *mesh, uint32_t half) {
    const bmr_half *h = &mesh->halves[half], *t = &mesh->halves[h->twin];
    return bmr_orientation(bmr_mesh_point(mesh, h->previous), mesh->points[h->origin],
                           bmr_mesh_point(mesh, mesh->halves[t->next].next)) >= 0;
}

/// Makes one face of the two beside an inner edge. O(edges of the smaller face); the larger one's number
/// stays.
void bmr_mesh_unite(bmr_mesh *mesh, uint32_t half);

/// Takes away every inner edge that no notch needs (Hertel and Mehlhorn, "Fast triangulation of simple
/// polygons", 1983): what is left is at most two a notch. O(n).
void bmr_mesh_unite_idle(bmr_mesh *mesh);

/// Makes the faces of a mesh fewer: groups of neighbouring ones are cut anew into the fewest, until that
/// saves none anywhere, and where the whole fits into one group, it is done with that. Faces stay convex.
/// Errors: NO_MEMORY, with the mesh still whole.
bmr_error bmr_mesh_improve(bmr_mesh *mesh, const bmr_allocator *allocator);

#endif
