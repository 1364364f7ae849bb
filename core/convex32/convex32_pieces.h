// SPDX-License-Identifier: MIT
#ifndef BMR_CONVEX32_CONVEX32_PIECES_H
#define BMR_CONVEX32_CONVEX32_PIECES_H

#include "convex32/convex32_collide.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Convex pieces of an outline, which know their seams. An edge between two pieces is an inner one: nothing
/// is ever pushed along its normal. At an end of an inner edge the outline goes on along another piece, and
/// the corner there turns as the outline does, not as the piece. (Box2D's one-sided edges know their
/// neighbours by ghost vertices; this is the same of convex polygons.)
///
/// All functions of convex32_collide.h answer for pieces too, each as follows. Let a *face* be an edge that
/// is not inner. A piece *admits* a direction at a vertex where the outline's outward normals turn past it
/// there: between the normals of the outline's two edges, where the outline is convex and one of the two is
/// the piece's; in no direction, where the outline is straight or a notch. Then
///
/// - only faces are references, and only faces are clipped against them;
/// - a face is a reference only where the other polygon admits its direction, at its least separated vertex;
///   what is left out has an answer by a face of the same two bodies that is nearer;
/// - a circle touches a vertex in directions alone that the piece admits there;
/// - where the least overlap of two polygons is along an axis that may not answer, but the other polygon's
///   vertex that is deepest below a face lies in the piece of that face, beyond none of its inner edges, the
///   face is the reference, if ten skins deeper at most: one of two pieces pushes out a tip between them;
/// - else, where it is no more than half of the skins, there are no points: the piece behind that edge, or
///   beside that corner, has them;
/// - where it is more, a face is the reference that is not deeper than that by more than the skins (by a
///   circle's radii); where there is none, the answer is the plain polygon's.
///
/// So what overlaps a piece is not pushed out of it by a far side: by none that is deeper by more than ten
/// skins. Pieces without any face touch nothing.
///
/// Every face belongs to one piece, and every direction of a convex corner is admitted by a piece that has
/// one of its two edges. That does not say that the piece that has the answer gives it: each of two pieces
/// may leave a point to the other. Who has an outline asks all of its pieces (outline_answer.cpp of the
/// glue).

/// A corner of a piece as it is cut out of its outline.
typedef struct bmr_piece_corner32 {
    bmr_vec32 vertex;
    /// Of a corner between a face and an inner edge: the other end of the outline's edge that meets the face
    /// here. Not read elsewhere.
    bmr_vec32 neighbour;
    bool inner; ///< the edge that begins here
} bmr_piece_corner32;

/// A piece of these corners, counter-clockwise. Those that turn by no more than rounding are left out
/// (bmr_convex32_create says how much that is). An edge that is then made of several is inner if all are. One
/// that is made of both kinds is *mixed*: a face for all that touches, and seams.parts says where another
/// piece goes on behind it. Without inner edges the polygon is one as any other: polygon.seams is NULL
/// (block.seams is not). Errors as bmr_convex32_create_raw; a sliver without area as far as floats can tell
/// is BMR_ERROR_TOO_FEW_POINTS. O(n).
bmr_error bmr_convex32_create_piece(const bmr_piece_corner32 *corners, size_t count,
                                    const bmr_allocator *allocator, bmr_convex32_block **block);

/// Does the polygon admit this direction (outward, of unit length, in its own frame) at a vertex, to a turn
/// whose sine is `tolerance`? True of polygons that are no pieces.
bool bmr_convex32_admits(const bmr_convex32 *polygon, uint32_t vertex, bmr_vec32 direction, float tolerance);

/// A ray from p1 towards p2 in the frame of an outline, no vertex of which is farther from the origin than
/// `reach`. At a corner of the outline where several pieces meet, each of those that have a face there may
/// say, by rounding, that the ray passes it by. Two facts find such a ray: it passes the corner within
/// `noise`, and it then enters a piece behind the corner by an inner edge that ends there. (Lost is one that
/// passes by that piece, too: along a seam, to rounding. So is it between plain polygons.)
typedef struct bmr_piece_ray32 {
    double x, y, dx, dy; ///< p1, and from there to p2
    double length;
    double noise; ///< bmr_convex32_ray decides rightly of what is farther from the ray than this
} bmr_piece_ray32;
bmr_piece_ray32 bmr_convex32_piece_ray(bmr_vec32 p1, bmr_vec32 p2, float reach);

typedef enum bmr_entry32 {
    BMR_ENTRY_FACE,  ///< from outside
    BMR_ENTRY_INNER, ///< from another piece
    BMR_ENTRY_CORNER ///< by an inner edge, beside an end of it: the outline's pieces have to be asked
} bmr_entry32;

/// How does the ray come into the piece that it hits at `*fraction` by this edge (bmr_convex32_ray)? Where it
/// is BMR_ENTRY_CORNER writes the end of the inner edge, and the fraction at which the ray comes to it, if
/// that is less. O(1), but for the parts of this edge.
bmr_entry32 bmr_convex32_entry(const bmr_convex32_block *piece, const bmr_piece_ray32 *ray, uint32_t edge,
                               double *fraction, bmr_vec32 *corner);

/// Does the ray come through this piece to a corner that it passes at `fraction`? Said of the place on the
/// ray that is a little before it. What is outside of an inner edge by no more than the noise is inside; what
/// is inside of a face by no more is not: along a face the ray comes from outside. O(n), and the parts.
bool bmr_convex32_comes_through(const bmr_convex32_block *piece, const bmr_piece_ray32 *ray, double fraction);

/// Of the piece's faces that meet the corner, and in front of which the ray begins, the one that it runs
/// against most: where `*against`, the product of its normal with the ray's direction, is more, writes both.
/// O(n), and the parts.
void bmr_convex32_face_against(const bmr_convex32_block *piece, const bmr_piece_ray32 *ray, bmr_vec32 corner,
                               double *against, bmr_vec32 *normal);

#ifdef __cplusplus
}
#endif
#endif
