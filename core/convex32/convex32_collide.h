// SPDX-License-Identifier: MIT
#ifndef BMR_CONVEX32_CONVEX32_COLLIDE_H
#define BMR_CONVEX32_CONVEX32_COLLIDE_H

#include "convex32/convex32.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// How convex polygons of any size touch each other, circles and edges: the manifolds of Box2D's own
/// algorithms run on all vertices, found without looking at all of them.
///
/// Where the work begins is the caller's to keep from one pose to the next: a bmr_convex32_memory. It decides
/// how fast the answer is found, never what it is.

/// Where the search ended last: 8 bytes. All zero at first. Vertices serve polygons that turn little from one
/// pose to the next; the direction, which is the world's, those that spin by many of their edges.
typedef struct bmr_convex32_memory {
    uint16_t support_a, support_b; ///< the pair of vertices that was closest
    int16_t axis_x, axis_y;        ///< from a to b, of length 32767; zero, or longer than 32768: none yet
} bmr_convex32_memory;

/// The largest edge separation over all edges of `reference` and the first edge that has it: the bits of a
/// loop over all. `frame` as in exact32.h. Global, also where the polygons overlap deeply: directions are
/// searched by branch and bound. `edge_hint` is any number; `*other_vertex` gets a vertex of `other` that is
/// least separated. O(log n); besides, it looks at all edges that separate too nearly as much to tell apart.
float bmr_convex32_max_separation(const bmr_convex32 *reference, const bmr_convex32 *other,
                                  const bmr_transform32 *frame, uint32_t edge_hint, uint32_t *edge,
                                  uint32_t *other_vertex);

/// Are the two polygons certainly farther apart than `reach` (>= 0, length units)? The function projects both
/// on the remembered direction, and on at most two more if the first does not show it. True is a proof of the
/// poses as they stand in floats, for polygons that are exactly convex: it allows for rounding, and does not
/// rely on the memory. False says nothing. The memory keeps the direction and the vertices for the next call.
bool bmr_convex32_apart(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                        const bmr_transform32 *pose_b, float reach, bmr_convex32_memory *memory);

/// The manifold of two polygons of any size: as bmr_exact32_collide, on real edges, and writes only what that
/// does. The bits are those of Box2D's loops over all vertices, whatever the memory holds, with one
/// difference where either has more than 8 of them. Box2D prefers A's face to one of B's that separates by up
/// to `tolerance` more, and clips the edge of B that faces it; where B has many short edges, that one may lie
/// beyond the face, which leaves no point though the two touch. Then B's face is taken after all. Features
/// are numbered modulo 256; bmr_convex32_keep_features makes them last.
void bmr_convex32_collide(bmr_manifold32 *manifold, const bmr_convex32 *a, const bmr_transform32 *pose_a,
                          const bmr_convex32 *b, const bmr_transform32 *pose_b, float radius_sum,
                          float tolerance, bmr_convex32_memory *memory);

/// A polygon and a circle (`centre` in its own body's frame): Box2D's b2CollidePolygonAndCircle. Writes
/// `count`, and where it is 1 all but the impulses: type BMR_MANIFOLD_FACE_A, feature zero.
void bmr_convex32_collide_circle(bmr_manifold32 *manifold, const bmr_convex32 *polygon,
                                 const bmr_transform32 *pose_polygon, bmr_vec32 centre,
                                 const bmr_transform32 *pose_circle, float radius_sum,
                                 bmr_convex32_memory *memory);

/// An edge (A) and a polygon (B): Box2D's b2CollideEdgeAndPolygon, with four differences past 8 vertices,
/// where its rules are only good for few and long faces:
/// - A one-sided edge leaves what lies beyond its neighbours' normals to them. Box2D does so from a sine of
///   0.1 on, which is many faces of a polygon that is nearly round; a wheel would stumble over each joint of
///   a flat chain. Here it is the larger turn at the ends of the polygon's face, at most 0.1.
/// - Where that leaves it nothing and the neighbour's normal is within Box2D's 0.1 of its own, its own normal
///   is taken: of a sharp vertex on a flat joint each edge would say that it is the other's.
///   (Where the chain bends more, such a vertex may still be left to neither, as in Box2D.)
/// - Where the polygon's face is the reference and no point of the edge that is near enough lies straight
///   above it, Box2D finds none. Here the one nearest to the face, at most `radius_sum` beside it, is taken.
/// - Where the edge is the reference and the polygon touches it around one of its ends, so that no point is
///   left, the polygon's face is taken.
///
/// `centroid` is B's, in its own frame: a one-sided edge does not push what is behind it.
/// Box2D's two tolerances here are absolute, so no slop is asked for.
void bmr_convex32_collide_edge(bmr_manifold32 *manifold, const bmr_edge32 *edge,
                               const bmr_transform32 *pose_edge, const bmr_convex32 *polygon,
                               bmr_vec32 centroid, const bmr_transform32 *pose_polygon, float radius_sum,
                               bmr_convex32_memory *memory);

/// A solver starts from the impulses of points with the same features, so features must follow the points
/// while the polygons roll: each point of `manifold` keeps its own features if `old` has them, else takes
/// those of the nearest unused point of `old` within `distance`; no two are alike afterwards. Points are
/// compared in the frame that they are given in; where the reference changed sides, by features alone.
void bmr_convex32_keep_features(bmr_manifold32 *manifold, const bmr_manifold32 *old, float distance);

#ifdef __cplusplus
}
#endif
#endif
