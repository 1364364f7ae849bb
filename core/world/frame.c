// SPDX-License-Identifier: MIT
// Where a pair looks at its motions from.
//
// Rounding is a part of coordinates, and structures' proofs are good to a part of the polygons' extents
// (kds.h). So coordinates and extents are to be those of the two bodies, not those of the world around them:
//   - The origin of a pair's frame is where the first one's piece begins. Far from the world's origin only
//     what lies between the two is computed with.
//   - A wall is a line, and a line that moves along itself is the same line. The pair's frame goes along
//     the wall with the body, so that what is seen of the wall is a segment beside the body, a few times as
//     long as the body. In this frame the body only comes and goes, and turns.
#include <math.h>
#include <string.h>

#include "boomerang/distance.h"
#include "world/parts.h"

bmr_vec2 bmr_path_begins(const bmr_motion_piece *piece) {
    return piece->kind == BMR_PIECE_SCREW ? piece->as.screw.start.position
                                          : bmr_vec2_make(piece->as.algebraic.x[0], piece->as.algebraic.y[0]);
}

void bmr_path_begin_at(bmr_motion_piece *piece, bmr_vec2 position) {
    if (piece->kind == BMR_PIECE_SCREW) {
        piece->as.screw.start.position = position;
    } else {
        piece->as.algebraic.x[0] = position.x;
        piece->as.algebraic.y[0] = position.y;
    }
}

// ---- walls: four lines, and the segments that pairs see of them ----

bmr_line bmr_wall_line(const bmr_world *w, const bmr_world_body *wall) {
    static const bmr_vec2 inwards[BMR_WALLS] = {{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}};
    const size_t side = (size_t)(wall->id - BMR_WALL(0));
    const bmr_vec2 corner = side % 2 == 0 ? w->def.low : w->def.high;
    const bmr_line line = {inwards[side], bmr_dot(inwards[side], corner)};
    return line;
}

void bmr_walls_make(bmr_world *w) {
    for (int side = 0; side < BMR_WALLS; side++) {
        bmr_world_body *const wall = &w->walls[side];
        wall->head.item.place = BMR_NOT_QUEUED;
        wall->id = BMR_WALL(side);
        const bmr_line line = bmr_wall_line(w, wall);
        bmr_pose pose = bmr_pose_identity();
        pose.position = bmr_scale(line.offset, line.normal);
        const bmr_motion_piece rest = bmr_piece_rest(pose);
        bmr_timed_piece_set(&wall->now, -INFINITY, &rest);
        wall->birth = UINT64_MAX - BMR_WALLS + (uint64_t)side;
        wall->mass = wall->inertia = INFINITY;
        wall->since = -INFINITY;
        wall->until = INFINITY;
    }
}

static bmr_error build_hierarchy(bmr_world *w, const bmr_polygon *polygon, bmr_hierarchy **hierarchy) {
    if (w->def.structure->hierarchy < 0)
        return BMR_OK;
    const bmr_hierarchy_kind kind = (bmr_hierarchy_kind)w->def.structure->hierarchy;
    const bool makes = bmr_hierarchy_uses_compass(kind) && !w->compass;
    const bmr_error error = makes ? bmr_compass_create(2, &w->counted, &w->compass) : BMR_OK;
    return error == BMR_OK ? bmr_hierarchy_build(kind, polygon, w->compass, &w->counted, hierarchy) : error;
}

static void destroy(bmr_world *w, bmr_wall_segments *segments) {
    for (int upright = 0; upright < 2; upright++) {
        bmr_hierarchy_destroy(segments->hierarchies[upright], &w->counted);
        bmr_polygon_destroy(segments->polygons[upright], &w->counted);
    }
    bmr_world_give(w, segments, sizeof *segments);
}

static bmr_error make_segment(bmr_world *w, bmr_wall_segments *segments, int upright) {
    const double half = ldexp(1.0, segments->size);
    const bmr_vec2 end = upright ? bmr_vec2_make(0.0, half) : bmr_vec2_make(half, 0.0);
    const bmr_vec2 ends[2] = {bmr_neg(end), end};
    bmr_error error = bmr_polygon_create(ends, 2, &w->counted, &segments->polygons[upright]);
    if (error == BMR_OK)
        error = build_hierarchy(w, segments->polygons[upright], &segments->hierarchies[upright]);
    segments->shapes[upright].polygon = segments->polygons[upright];
    if (w->def.structure->hierarchy >= 0)
        segments->shapes[upright].hierarchies[w->def.structure->hierarchy] = segments->hierarchies[upright];
    return error;
}

bmr_error bmr_wall_segments_of(bmr_world *w, double radius, const bmr_wall_segments **found) {
    int size;
    // Longer than the disk and the margin: its ends are never what is nearest.
    frexp(fmax(bmr_grid_need(w, radius), BMR_MIN_SIDE), &size);
    for (const bmr_wall_segments *b = w->segments; b; b = b->next)
        if (b->size == size) {
            *found = b;
            return BMR_OK;
        }
    bmr_wall_segments *const segments = bmr_world_take(w, sizeof *segments);
    if (!segments)
        return BMR_ERROR_NO_MEMORY;
    memset(segments, 0, sizeof *segments);
    segments->size = size;
    for (int upright = 0; upright < 2; upright++) {
        const bmr_error error = make_segment(w, segments, upright);
        if (error != BMR_OK) {
            destroy(w, segments);
            return error;
        }
    }
    segments->next = w->segments;
    w->segments = segments;
    *found = segments;
    return BMR_OK;
}

void bmr_walls_destroy(bmr_world *w) {
    while (w->segments) {
        bmr_wall_segments *const next = w->segments->next;
        destroy(w, w->segments);
        w->segments = next;
    }
    bmr_compass_destroy(w->compass, &w->counted);
}

// ---- motions ----

bmr_vec2 bmr_body_pair_shift(const bmr_world *w, const bmr_body_pair *c) {
    return bmr_vec2_make(c->image[0] ? c->image[0] * (w->def.high.x - w->def.low.x) : 0.0,
                         c->image[1] ? c->image[1] * (w->def.high.y - w->def.low.y) : 0.0);
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

const bmr_shape *bmr_body_pair_shape(const bmr_body_pair *c, int side) {
    const bmr_world_body *r = c->side[side];
    return bmr_body_is_wall(r) ? &c->side[0]->segments->shapes[bmr_wall_is_upright(r)] : &r->shape;
}

bmr_pair_motion bmr_body_pair_motion(const bmr_world *w, const bmr_body_pair *c, bmr_pair_view *view) {
    const bmr_timed_piece *first = &c->side[0]->now, *second = &c->side[1]->now;
    const bmr_vec2 begins = bmr_path_begins(&first->piece), other = bmr_path_begins(&second->piece);
    const bmr_vec2 way = bmr_add(bmr_sub(other, begins), bmr_body_pair_shift(w, c));
    const bmr_vec2 origin = bmr_vec2_make(0.0, 0.0);
    const bool wall = bmr_body_is_wall(c->side[1]);
    view->pieces[0] = *first;
    view->pieces[1] = *second;
    bmr_path_begin_at(&view->pieces[0].piece, wall ? bmr_neg(way) : origin);
    bmr_path_begin_at(&view->pieces[1].piece, wall ? origin : way);
    if (wall)
        stay_beside(&view->pieces[0].piece, bmr_wall_is_upright(c->side[1]));
    for (int i = 0; i < 2; i++)
        view->motions[i] = bmr_motion_of_piece(&view->pieces[i]);
    const bmr_pair_motion motion = {&view->motions[0], &view->motions[1], bmr_body_pair_shape(c, 0)->polygon,
                                    bmr_body_pair_shape(c, 1)->polygon};
    return motion;
}

// ---- contacts: where two polygons touch, along which normal, and how they move there ----

/// Two sides face each other when their far ends are not farther apart than the near ones by more than this
/// part of the margin.
#define FACING_PART 0.125

/// The two ends of the side that is extreme in a direction; both the same where it is a vertex.
typedef struct side {
    bmr_vec2 ends[2];
} side;

static side extreme_side(const bmr_polygon *polygon, bmr_vec2 direction, double tolerance) {
    const uint32_t n = polygon->count, i = bmr_polygon_support(polygon, direction);
    const bmr_vec2 v = polygon->vertices[i];
    const uint32_t neighbours[2] = {(i + 1) % n, (i + n - 1) % n};
    side found = {{v, v}};
    for (int k = 0; k < 2; k++) {
        const bmr_vec2 u = polygon->vertices[neighbours[k]];
        if (neighbours[k] != i && bmr_dot(direction, bmr_sub(v, u)) <= tolerance)
            found.ends[1] = u;
    }
    return found;
}

/// Where two sides that face each other overlap, along the tangent: A's frame, beside A. False: in no more
/// than a point.
static bool facing(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a, bmr_vec2 normal,
                   double tolerance, bmr_vec2 points[2]) {
    const bmr_vec2 tangent = bmr_left(normal);
    const side own = extreme_side(a, normal, tolerance);
    const side other = extreme_side(b, bmr_neg(bmr_unrotate(b_in_a, normal)), tolerance);
    double low[2], high[2];
    for (int k = 0; k < 2; k++) {
        const bmr_vec2 p = k == 0 ? own.ends[0] : bmr_transform(b_in_a, other.ends[0]);
        const bmr_vec2 q = k == 0 ? own.ends[1] : bmr_transform(b_in_a, other.ends[1]);
        low[k] = fmin(bmr_dot(tangent, p), bmr_dot(tangent, q));
        high[k] = fmax(bmr_dot(tangent, p), bmr_dot(tangent, q));
    }
    const double from = fmax(low[0], low[1]), to = fmin(high[0], high[1]);
    if (!(to > from))
        return false;
    const double level = bmr_dot(normal, own.ends[0]);
    points[0] = bmr_add(bmr_scale(level, normal), bmr_scale(from, tangent));
    points[1] = bmr_add(bmr_scale(level, normal), bmr_scale(to, tangent));
    return true;
}

void bmr_touch_move(bmr_touch *touch, const bmr_instant now[2]) {
    bmr_contact *const contact = &touch->contact;
    for (size_t k = 0; k < contact->count; k++) {
        const bmr_vec2 a = bmr_add(now[0].velocity, bmr_scale(now[0].spin, bmr_left(touch->arm[0][k])));
        const bmr_vec2 b = bmr_add(now[1].velocity, bmr_scale(now[1].spin, bmr_left(touch->arm[1][k])));
        contact->velocity[k] = bmr_sub(b, a);
        contact->approach[k] = bmr_dot(contact->normal, contact->velocity[k]);
    }
}

void bmr_body_pair_now(const bmr_world *w, const bmr_body_pair *c, bmr_instant now[2]) {
    for (int i = 0; i < 2; i++)
        now[i] = bmr_piece_instant(&c->side[i]->now.piece, w->time);
}

void bmr_touch_describe(const bmr_world *w, const bmr_body_pair *c, bmr_touch *touch) {
    memset(touch, 0, sizeof *touch);
    bmr_contact *const contact = &touch->contact;
    contact->time = w->time;
    contact->a = c->side[0]->id;
    contact->b = c->side[1]->id;
    contact->image = bmr_body_pair_shift(w, c);
    contact->placed = c->event == BMR_DUE_MEET;
    contact->again = c->near->again;
    contact->count = 1;
    bmr_pair_view view;
    const bmr_pair_motion motion = bmr_body_pair_motion(w, c, &view);
    const bmr_pose seen_a = bmr_motion_pose(motion.a, w->time, NULL, NULL),
                   seen_b = bmr_motion_pose(motion.b, w->time, NULL, NULL);
    const bmr_pose b_in_a = bmr_pose_relative(&seen_a, &seen_b);
    bmr_instant now[2];
    bmr_body_pair_now(w, c, now);

    bmr_closest_points closest;
    bmr_overlap overlap;
    bmr_vec2 normal = {0.0, 0.0}, points[2] = {{0.0, 0.0}, {0.0, 0.0}};
    if (bmr_distance(motion.shape_a, NULL, motion.shape_b, &b_in_a, &closest) == BMR_OK &&
        closest.distance > 0.0) {
        normal = closest.normal;
        points[0] = closest.point_a;
        contact->distance = closest.distance;
    } else if (bmr_penetration(motion.shape_a, NULL, motion.shape_b, &b_in_a, &overlap) == BMR_OK) {
        normal = overlap.normal;
        points[0] = overlap.point_a;
    }
    const double tolerance = FACING_PART * w->def.kds.margin;
    if (contact->distance > 0.0 && facing(motion.shape_a, motion.shape_b, &b_in_a, normal, tolerance, points))
        contact->count = 2;
    contact->normal = bmr_rotate(&now[0].pose, normal);
    // Arms from what lies between the two: bodies far from the origin keep their digits. (A wall's arm is
    // that of the segment beside the body; a wall does not turn.)
    const bmr_vec2 way = bmr_sub(seen_b.position, seen_a.position);
    for (size_t k = 0; k < contact->count; k++) {
        touch->arm[0][k] = bmr_rotate(&now[0].pose, points[k]);
        touch->arm[1][k] = bmr_sub(touch->arm[0][k], way);
        contact->points[k] = bmr_add(now[0].pose.position, touch->arm[0][k]);
    }
    bmr_touch_move(touch, now);
}
