// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_HIERARCHY_H
#define BOOMERANG_HIERARCHY_H

#include "boomerang/polygon.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Outer approximations of a convex polygon P (section 3 of the paper). Compass, Dudley and
/// Dobkin-Kirkpatrick hierarchies are one tree type.
///
/// The envelope P_0 is a bounding rectangle. Its edges E, N, W, S have the ids 0, 1, 2, 3 and the outer
/// normals (1,0), (0,1), (-1,0), (0,-1). Every further edge cuts one corner of the envelope before it. The
/// region between the corner's two edges and P is a boomerang; its apex is the corner. A node of the tree is
/// such an edge and the boomerang that it cuts. Every edge is a support line of P itself. (If it touches P in
/// one vertex only, it is a degenerate edge.) P_i is the polygon of all edges of level i or less. P_0
/// contains P_1 contains ... contains P_depth = P, up to edges that are merged because their directions agree
/// within 1e-11.

typedef uint32_t bmr_edge;
#define BMR_NO_EDGE UINT32_MAX

typedef enum bmr_hierarchy_kind {
    BMR_HIERARCHY_COMPASS,
    BMR_HIERARCHY_DUDLEY,
    BMR_HIERARCHY_DOBKIN_KIRKPATRICK,
    BMR_HIERARCHY_KIND_COUNT
} bmr_hierarchy_kind;

/// A corner of an envelope: the point where the lines of two adjacent edges meet. `before` and `after` are in
/// counter-clockwise order. `cut` is the node that cuts this corner, or BMR_NO_EDGE if the corner is a vertex
/// of P.
typedef struct bmr_corner {
    bmr_edge before, after, cut;
} bmr_corner;

/// The half plane <normal, x> <= offset that contains P. Its boundary is a support line of P. `normal` has
/// unit length.
typedef struct bmr_line {
    bmr_vec2 normal;
    double offset;
} bmr_line;

typedef struct bmr_hierarchy bmr_hierarchy;

/// The directions of the compass: the 4 * 2^levels multiples of 90 / 2^levels degrees. A table is constant.
/// Any number of compass hierarchies on any number of threads may share it. It must outlive them.
typedef struct bmr_compass bmr_compass;
/// Makes a table for polygons of up to `max_vertices` vertices: 64 to 128 bytes a vertex of the LARGEST
/// polygon, once. Errors: NULL_ARGUMENT, NO_POINTS (for 0 vertices), TOO_MANY_POINTS, NO_MEMORY; then
/// *compass is untouched.
bmr_error bmr_compass_create(size_t max_vertices, const bmr_allocator *allocator, bmr_compass **compass);
/// NULL is no error.
void bmr_compass_destroy(bmr_compass *compass, const bmr_allocator *allocator);

/// Builds a compass hierarchy over `polygon`, which must outlive it. Points and segments have one too. The
/// top ceil(log2 n) levels bisect the angle; below them the median edge cuts. Depth at most 2 ceil(log2 n),
/// at most 5 n edges. O(n) time, because the polygon's edges are in order already; one block, with the
/// polygon at most 160 bytes a vertex for n >= 64. Errors of all builders: NULL_ARGUMENT, NO_MEMORY; of this
/// one also TABLE_TOO_SMALL. Then *hierarchy is untouched.
bmr_error bmr_hierarchy_build_compass(const bmr_polygon *polygon, const bmr_compass *compass,
                                      const bmr_allocator *allocator, bmr_hierarchy **hierarchy);
/// The same, but the first `corner_levels` levels also cut corners that are vertices of the polygon already,
/// by edges of length zero. So no two neighbouring edges of level i <= corner_levels, or of any level below,
/// are more than 90 / 2^i degrees apart. Section 6's tuning needs these edges: without them, at a sharp
/// corner, no line of any level is as far from a point as the polygon is, and beta stays at sqrt 2. At most 4
/// * 2^corner_levels edges more; depth at least corner_levels. Also TABLE_TOO_SMALL if the table has fewer
/// levels than corner_levels (it has ceil(log2 max_vertices)).
bmr_error bmr_hierarchy_build_compass_with_corners(const bmr_polygon *polygon, const bmr_compass *compass,
                                                   uint32_t corner_levels, const bmr_allocator *allocator,
                                                   bmr_hierarchy **hierarchy);
/// Builds a Dudley hierarchy: degenerate edges and split edges from n regular points on a circle of radius 2D
/// (normals outward; core/README.md, section 3, has the erratum), each boomerang cut by its median edge,
/// split vertices counted. Depth at most ceil(log2 2n), at most 2 n + 4 edges. Cost, lifetime and errors as
/// above.
bmr_error bmr_hierarchy_build_dudley(const bmr_polygon *polygon, const bmr_allocator *allocator,
                                     bmr_hierarchy **hierarchy);
/// Builds a Dobkin-Kirkpatrick hierarchy: the polygon's own edges only, each boomerang cut by its median
/// edge. Depth at most ceil(log2 n), at most n + 4 edges. Cost, lifetime and errors as above.
bmr_error bmr_hierarchy_build_dobkin_kirkpatrick(const bmr_polygon *polygon, const bmr_allocator *allocator,
                                                 bmr_hierarchy **hierarchy);
/// Builds one of any kind, as the function of that kind does. `compass` is for kinds whose edges have the
/// directions of its table, and may be NULL for others. Errors: OUT_OF_RANGE (no such kind), and those of the
/// function.
bmr_error bmr_hierarchy_build(bmr_hierarchy_kind kind, const bmr_polygon *polygon, const bmr_compass *compass,
                              const bmr_allocator *allocator, bmr_hierarchy **hierarchy);
/// "compass", "dudley", "dobkin-kirkpatrick"; NULL for anything else.
const char *bmr_hierarchy_name(bmr_hierarchy_kind kind);
/// Does bmr_hierarchy_build need a compass for it?
bool bmr_hierarchy_uses_compass(bmr_hierarchy_kind kind);
/// NULL is no error.
void bmr_hierarchy_destroy(bmr_hierarchy *hierarchy, const bmr_allocator *allocator);

/// Bytes of the hierarchy's block, without the polygon and the compass table.
size_t bmr_hierarchy_bytes(const bmr_hierarchy *hierarchy);
bmr_hierarchy_kind bmr_hierarchy_get_kind(const bmr_hierarchy *hierarchy);
const bmr_polygon *bmr_hierarchy_polygon(const bmr_hierarchy *hierarchy);
/// Number of edges, the four roots among them: valid ids are 0 .. count-1.
uint32_t bmr_hierarchy_edge_count(const bmr_hierarchy *hierarchy);
/// The deepest level; P_depth = P.
uint32_t bmr_hierarchy_depth(const bmr_hierarchy *hierarchy);

/// The level at which the edge first appears: 0 for the roots.
uint32_t bmr_hierarchy_level(const bmr_hierarchy *hierarchy, bmr_edge edge);
bmr_line bmr_hierarchy_line(const bmr_hierarchy *hierarchy, bmr_edge edge);
/// A vertex of P on the edge's line.
uint32_t bmr_hierarchy_touch(const bmr_hierarchy *hierarchy, bmr_edge edge);

/// The two edges between which an edge's boomerang lies, and the nodes that cut its two halves. For a root:
/// its neighbours on level 0, and the top boomerangs on either side.
typedef struct bmr_boomerang {
    bmr_edge outer_before, outer_after; ///< the lines that meet in the apex, counter-clockwise order
    bmr_edge child_before, child_after; ///< BMR_NO_EDGE if the half is empty
    uint32_t level;
} bmr_boomerang;
bmr_boomerang bmr_hierarchy_boomerang(const bmr_hierarchy *hierarchy, bmr_edge edge);
/// The apex of the boomerang that `edge` cuts (for a root: undefined, (0,0)).
bmr_vec2 bmr_hierarchy_apex(const bmr_hierarchy *hierarchy, bmr_edge edge);
/// Distance from the apex to P's chain inside the boomerang; 0 for a root. O(log n).
double bmr_hierarchy_height(const bmr_hierarchy *hierarchy, bmr_edge edge);

/// The corner of P_level at the counter-clockwise (clockwise) end of `edge`, which must be on that level
/// (level(edge) <= level). O(level - level(edge)).
bmr_corner bmr_hierarchy_corner_after(const bmr_hierarchy *hierarchy, bmr_edge edge, uint32_t level);
bmr_corner bmr_hierarchy_corner_before(const bmr_hierarchy *hierarchy, bmr_edge edge, uint32_t level);
/// The corner of two edges that are adjacent on some level; this finds its `cut`. O(1).
bmr_corner bmr_hierarchy_corner(const bmr_hierarchy *hierarchy, bmr_edge before, bmr_edge after);
/// The corner of P_level that is farthest in `direction` (not zero): its cone [normal(before), normal(after)]
/// contains the direction. At an exact tie it is the corner whose `before` is the tied edge. O(level).
bmr_corner bmr_hierarchy_extreme(const bmr_hierarchy *hierarchy, bmr_vec2 direction, uint32_t level);
/// The point of a corner: the meeting point of its two lines, or the vertex of P that both touch.
bmr_vec2 bmr_hierarchy_corner_point(const bmr_hierarchy *hierarchy, bmr_corner corner);

/// The extreme corner of P_to_level in `direction`, from the extreme corner of a level that is not deeper.
/// O(levels between).
bmr_corner bmr_hierarchy_refine(const bmr_hierarchy *hierarchy, bmr_corner corner, bmr_vec2 direction,
                                uint32_t to_level);
/// The corner of P_(level-1) from which this corner of P_level comes: the one that was cut there, or the same
/// corner if none was (level >= 1). O(1).
bmr_corner bmr_hierarchy_coarsen(const bmr_hierarchy *hierarchy, bmr_corner corner, uint32_t level);

/// A hierarchy's chains as arrays: bmr_chains_create in kds.h makes them.
typedef struct bmr_chains bmr_chains;

/// One body of a pair: the objects that are made once for a polygon and shared by all its pairs. Plain data;
/// the polygon and the hierarchies belong to the caller.
typedef struct bmr_shape {
    const bmr_polygon *polygon; ///< never NULL
    /// Built over `polygon` itself, each at the index of its bmr_hierarchy_kind. NULL if no structure in use
    /// needs it.
    const bmr_hierarchy *hierarchies[BMR_HIERARCHY_KIND_COUNT];
    /// The chains of those hierarchies (kds.h), for the structures that search chains ("triangle-binary-..").
    /// NULL: a pair that needs them makes its own, in its own block.
    const bmr_chains *chains[BMR_HIERARCHY_KIND_COUNT];
} bmr_shape;

/// Checks every promise of this header against the polygon by brute force, O(n * depth). For tests and
/// audits.
bmr_error bmr_hierarchy_audit(const bmr_hierarchy *hierarchy);

#ifdef __cplusplus
}
#endif
#endif
