// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_EXACT32_H
#define BOOMERANG_EXACT32_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Separation of two small convex polygons along one edge normal, in float, on plain arrays. The ORDER of the
/// float operations is the contract: it is that of Box2D 2.4.x's polygon narrow phase, so the numbers have
/// the same bits as Box2D's own when it was compiled without fused multiply-add. The scalar and the SSE2 form
/// give the same bits, the sign of a zero aside (which no comparison sees).

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
/// The same in plain C, on every machine: what the SSE2 form is tested against.
float bmr_exact32_edge_separation_scalar(const bmr_polygon32 *reference, int32_t edge,
                                         const bmr_polygon32 *other, const bmr_transform32 *frame);

/// The same in one go, for the check that is made most: `vertex` and `normal` of one edge of a polygon posed
/// at `reference`, against the `count` (1 to 8, in an array of 8) `points` of a polygon posed at `other`. The
/// bits of bmr_exact32_relative followed by bmr_exact32_edge_separation.
float bmr_exact32_posed_separation(const bmr_vec32 *vertex, const bmr_vec32 *normal,
                                   const bmr_transform32 *reference, const bmr_vec32 *points, int32_t count,
                                   const bmr_transform32 *other);

/// The largest edge separation over all edges of `reference` and the first edge that has it.
float bmr_exact32_max_separation(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                                 const bmr_transform32 *frame, int32_t *edge);
/// The same in plain C.
float bmr_exact32_max_separation_scalar(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                                        const bmr_transform32 *frame, int32_t *edge);

#ifdef __cplusplus
}
#endif
#endif
