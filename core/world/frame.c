// SPDX-License-Identifier: MIT
// Where a couple looks at its motions from.
//
// Rounding is a part of coordinates, and structures' proofs are good to a part of the polygons' extents
// (kds.h). So coordinates and extents are to be those of the two bodies, not those of the world around them:
//   - The origin of a couple's frame is where the first one's piece begins. Far from the world's origin only
//     what lies between the two is computed with.
//   - A wall is a line, and a line that moves along itself is the same line. The couple's frame goes along
//     the wall with the body, so that what is seen of the wall is a segment beside the body, a few times as
//     long as the body. In this frame the body only comes and goes, and turns.
#include <math.h>
#include <string.h>

#include "world/parts.h"

bmr_vec2 bmr_couple_shift(const bmr_world *w, const bmr_couple *c) {
    return bmr_vec2_make(c->image[0] ? c->image[0] * (w->def.high.x - w->def.low.x) : 0.0,
                         c->image[1] ? c->image[1] * (w->def.high.y - w->def.low.y) : 0.0);
}

static bmr_vec2 beginning(const bmr_motion_piece *piece) {
    return piece->kind == BMR_PIECE_SCREW ? piece->as.screw.start.position
                                          : bmr_vec2_make(piece->as.algebraic.x[0], piece->as.algebraic.y[0]);
}

/// The same motion from another beginning. (Copies no more than what the piece's kind has.)
static void begin_at(bmr_timed_piece *seen, const bmr_timed_piece *timed, bmr_vec2 position) {
    seen->from = timed->from;
    seen->piece.kind = timed->piece.kind;
    seen->piece.origin = timed->piece.origin;
    if (timed->piece.kind == BMR_PIECE_SCREW) {
        seen->piece.as.screw = timed->piece.as.screw;
        seen->piece.as.screw.start.position = position;
    } else {
        seen->piece.as.algebraic = timed->piece.as.algebraic;
        seen->piece.as.algebraic.x[0] = position.x;
        seen->piece.as.algebraic.y[0] = position.y;
    }
}

/// What goes along an upright wall (y), or along a level one (x), is taken out.
static void stay_beside(bmr_motion_piece *piece, bool upright) {
    if (piece->kind == BMR_PIECE_SCREW) {
        bmr_screw_motion *const screw = &piece->as.screw;
        *(upright ? &screw->start.position.y : &screw->start.position.x) = 0.0;
        *(upright ? &screw->velocity.y : &screw->velocity.x) = 0.0;
        return;
    }
    bmr_algebraic_piece *const path = &piece->as.algebraic;
    double *const along = upright ? path->y : path->x;
    for (size_t k = 0; k <= path->degree; k++)
        along[k] = 0.0;
}

const bmr_shape *bmr_couple_shape(const bmr_couple *c, int side) {
    const bmr_resident *r = c->side[side];
    return bmr_resident_is_wall(r) ? &c->side[0]->beside->shapes[bmr_wall_is_upright(r)] : &r->shape;
}

bmr_pair_motion bmr_couple_motion(const bmr_world *w, const bmr_couple *c, bmr_couple_view *view) {
    const bmr_timed_piece *first = &c->side[0]->now, *second = &c->side[1]->now;
    const bmr_vec2 begins = beginning(&first->piece), other = beginning(&second->piece);
    const bmr_vec2 way = bmr_add(bmr_sub(other, begins), bmr_couple_shift(w, c));
    const bmr_vec2 origin = bmr_vec2_make(0.0, 0.0);
    if (bmr_resident_is_wall(c->side[1])) {
        begin_at(&view->pieces[0], first, bmr_neg(way));
        stay_beside(&view->pieces[0].piece, bmr_wall_is_upright(c->side[1]));
        begin_at(&view->pieces[1], second, origin);
    } else {
        begin_at(&view->pieces[0], first, origin);
        begin_at(&view->pieces[1], second, way);
    }
    for (int i = 0; i < 2; i++)
        view->motions[i] = bmr_motion_of_piece(&view->pieces[i]);
    const bmr_pair_motion motion = {&view->motions[0], &view->motions[1], bmr_couple_shape(c, 0)->polygon,
                                    bmr_couple_shape(c, 1)->polygon};
    return motion;
}
