// SPDX-License-Identifier: MIT
#ifndef BMR_EXACT32_EXACT32_H
#define BMR_EXACT32_EXACT32_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// For the Box2D plugin alone; not a public header.
///
/// Separation of two small convex polygons along one edge normal, and how they touch, in float, on plain
/// arrays. The ORDER of the float operations is the contract: it is that of Box2D 2.4.x's polygon narrow
/// phase, so the numbers have the same bits as Box2D's own when it was compiled without fused multiply-add.
/// Plain C and lanes (SSE2, NEON) give the same bits, with two exceptions. A separation of zero may have
/// another sign, which no comparison sees. A NaN in a manifold may have another payload.

typedef struct bmr_vec32 {
    float x, y;
} bmr_vec32;

/// Position, then sine, then cosine: the layout of Box2D's b2Transform.
typedef struct bmr_transform32 {
    bmr_vec32 p;
    float s, c;
} bmr_transform32;

/// A polygon by its arrays; nothing past `count` is used (it may be read, up to the 8th vertex: the arrays
/// must be 8 long).
typedef struct bmr_polygon32 {
    const bmr_vec32 *vertices;
    const bmr_vec32 *normals; ///< normals[i] belongs to the edge from vertex i to i+1
    int32_t count;            ///< 1 to 8
} bmr_polygon32;

/// The frame of `reference` as seen from `other`: other^-1 reference.
bmr_transform32 bmr_exact32_relative(const bmr_transform32 *other, const bmr_transform32 *reference);

/// Least separation of `other`'s vertices from edge `edge` of `reference`. `frame` is reference in other's
/// frame.
float bmr_exact32_edge_separation(const bmr_polygon32 *reference, int32_t edge, const bmr_polygon32 *other,
                                  const bmr_transform32 *frame);

/// bmr_exact32_relative and bmr_exact32_edge_separation in one call, with the same bits: the check that is
/// made most. `vertex` and `normal` are one edge of a polygon posed at `reference`; `points` are `count` (1
/// to 8, in an array of 8) of a polygon posed at `other`.
float bmr_exact32_posed_separation(const bmr_vec32 *vertex, const bmr_vec32 *normal,
                                   const bmr_transform32 *reference, const bmr_vec32 *points, int32_t count,
                                   const bmr_transform32 *other);

/// The largest edge separation over all edges of `reference` and the first edge that has it.
float bmr_exact32_max_separation(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                                 const bmr_transform32 *frame, int32_t *edge);

/// What a contact point was made of: the layout of Box2D's b2ContactFeature.
typedef struct bmr_feature32 {
    uint8_t index_a, index_b;
    uint8_t type_a, type_b; ///< BMR_FEATURE_VERTEX or BMR_FEATURE_FACE
} bmr_feature32;
enum { BMR_FEATURE_VERTEX = 0, BMR_FEATURE_FACE = 1 };

typedef struct bmr_manifold_point32 {
    bmr_vec32 point; ///< in the incident polygon's frame
    float normal_impulse, tangent_impulse;
    bmr_feature32 feature;
} bmr_manifold_point32;

/// Where two polygons touch: the layout of Box2D's b2Manifold.
typedef struct bmr_manifold32 {
    bmr_manifold_point32 points[2];
    bmr_vec32 normal;      ///< of the reference face, in its own polygon's frame
    bmr_vec32 plane_point; ///< the face's middle, likewise
    int32_t type;          ///< BMR_MANIFOLD_FACE_A or _B: whose face is the reference
    int32_t count;         ///< of points, 0 to 2
} bmr_manifold32;
enum { BMR_MANIFOLD_FACE_A = 1, BMR_MANIFOLD_FACE_B = 2 };

enum { BMR_NO_EDGE32 = -1, BMR_EDGES_OF_B32 = 8 };

/// How two polygons of 3 to 8 vertices touch: the manifold of Box2D's b2CollidePolygons, to the bit. It
/// writes the fields that b2CollidePolygons writes, and no others: `count` always; `type` where no face
/// separates; `normal` and `plane_point` where clipping leaves two points; the place and the feature of each
/// of the `count` points. It never writes impulses.
///
/// `radius_sum` is the sum of the skins. B's face is the reference where it separates by more than
/// `tolerance` (Box2D: a tenth of its slop) more than A's does.
///
/// Returns an edge that separates the two by more than their skins, if there is one: A's edge of largest
/// separation, or BMR_EDGES_OF_B32 plus B's where none of A's does. Remember it: for as long as this edge
/// separates them, the count is 0. BMR_NO_EDGE32 where no edge separates them, whether there are points or
/// not.
int32_t bmr_exact32_collide(bmr_manifold32 *manifold, const bmr_polygon32 *a, const bmr_transform32 *pose_a,
                            const bmr_polygon32 *b, const bmr_transform32 *pose_b, float radius_sum,
                            float tolerance);
/// An edge, one-sided or not: Box2D's b2EdgeShape.
typedef struct bmr_edge32 {
    bmr_vec32 before, first, second, after; ///< before and after: the ghosts of a one-sided one
    bool one_sided;
} bmr_edge32;

/// How an edge and a polygon of 3 to 8 vertices touch: the manifold of Box2D's b2CollideEdgeAndPolygon, to
/// the bit, written as bmr_exact32_collide writes it. False where a number is not finite, or where one is too
/// large: the manifold is Box2D's to make.
bool bmr_exact32_collide_edge(bmr_manifold32 *manifold, const bmr_edge32 *edge,
                              const bmr_transform32 *pose_edge, const bmr_polygon32 *polygon,
                              bmr_vec32 centroid, const bmr_transform32 *pose, float radius_sum);

#ifdef __cplusplus
}
#endif
#endif
