// SPDX-License-Identifier: MIT
// Re-proving a pair's state from nothing but the polygons (and, for the lazy structures, the hierarchies).
#include <math.h>

#include "certificate/walk.h"
#include "pair/step.h"

/// Two computations of one float, from doubles that agree up to rounding.
#define FLOAT_ROUNDING 2.384185791015625e-7 /* 2^-22 */

static bool near(const float rounded[2], bmr_vec2 exact, double scale) {
    return fabs((double)rounded[0] - exact.x) <= FLOAT_ROUNDING * scale &&
           fabs((double)rounded[1] - exact.y) <= FLOAT_ROUNDING * scale;
}

/// Is no corner of the level farther in `direction` than this one? Once around the level.
static bool is_extreme(const bmr_hierarchy *h, bmr_vec2 point, bmr_vec2 direction, uint32_t level,
                       double tolerance) {
    bmr_edge edge = 0;
    for (uint32_t i = 0; i < bmr_hierarchy_edge_count(h); ++i) {
        const bmr_corner corner = bmr_hierarchy_corner_after(h, edge, level);
        const bmr_vec2 rival = bmr_hierarchy_corner_point(h, corner);
        if (!(bmr_dot(bmr_sub(rival, point), direction) <= tolerance))
            return false;
        edge = corner.after;
        if (edge == 0)
            return true;
    }
    return false; // the level does not close
}

/// The state of a lazy pair names an edge and a corner of its level, the certificate is made of these, and
/// the corner is the one nearest to the edge's line.
static bool is_lazy(const bmr_pair *pair, const bmr_shape *owner, const bmr_shape *other,
                    const bmr_pose *other_in_owner) {
    const bmr_hierarchy *own = owner->hierarchies[pair->structure],
                        *facing = other->hierarchies[pair->structure];
    const bmr_hierarchy *const hierarchies[2] = {own, facing};
    const bmr_lazy_place at = {{pair->other, pair->other_after, BMR_NO_EDGE}, pair->edge, pair->level, 0};
    if (!bmr_lazy_is_place(hierarchies, &at))
        return false;
    const uint32_t level = bmr_walk_side_level(facing, pair->level);
    const bmr_corner corner = bmr_hierarchy_corner_after(facing, pair->other, level);
    const bmr_certificate *k = &pair->certificate;
    const bmr_line line = bmr_hierarchy_line(own, pair->edge);
    const bmr_vec2 point = bmr_hierarchy_corner_point(facing, corner);
    const bmr_vec2 direction = bmr_neg(bmr_unrotate(other_in_owner, line.normal));
    const double extent = other->polygon->extent;
    return near(k->normal, line.normal, 1.0) && (double)k->offset >= line.offset &&
           near(k->window[0], point, extent) && near(k->window[1], point, extent) &&
           near(k->low, bmr_hierarchy_line(facing, corner.before).normal, 1.0) &&
           near(k->high, bmr_hierarchy_line(facing, corner.after).normal, 1.0) &&
           is_extreme(facing, point, direction, level, BMR_PAIR_SLOP * extent);
}

/// A free direction's line touches its owner at the vertex that the pair remembers.
static bool is_free(const bmr_pair *pair, const bmr_shape *owner, const bmr_shape *other) {
    const bmr_polygon *own = owner->polygon;
    if (pair->edge >= own->count || pair->other >= other->polygon->count)
        return false;
    const bmr_vec2 normal =
        bmr_vec2_make((double)pair->certificate.normal[0], (double)pair->certificate.normal[1]);
    const double touch = bmr_dot(normal, own->vertices[pair->edge]);
    for (uint32_t i = 0; i < own->count; ++i)
        if (!(bmr_dot(normal, own->vertices[i]) <= touch + FLOAT_ROUNDING * own->extent))
            return false;
    return true;
}

/// The coarse line of two-lines is an edge's, or an axis's, and of the body that the pair says.
static bool is_coarse(const bmr_pair *pair, const bmr_polygon *a, const bmr_polygon *b) {
    bmr_coarse spare;
    return bmr_spare_line(pair, a, b, &spare) && spare.owner == pair->owner &&
           near(pair->certificate.normal, spare.normal, 1.0);
}

bmr_error bmr_pair_audit(const bmr_pair *pair, const bmr_pair_def *def, const bmr_shape *a,
                         const bmr_shape *b, const bmr_pose *b_in_a) {
    if (!pair || !def || !a || !b || !b_in_a)
        return BMR_ERROR_NULL_ARGUMENT;
    if (pair->state == BMR_PAIR_NEW || pair->state == BMR_PAIR_CONTACT)
        return BMR_OK;
    if (pair->stamp != bmr_pair_stamp(a->polygon, b->polygon))
        return BMR_ERROR_FALSE_CERTIFICATE;
    if (pair->state != BMR_PAIR_APART || pair->owner > 1 || pair->level < BMR_LEVEL_DISKS)
        return BMR_ERROR_INVALID_STRUCTURE;
    if (pair->level == BMR_LEVEL_DISKS)
        return bmr_disks_audit(&pair->certificate, a->polygon, b->polygon, b_in_a);
    const bmr_pose a_in_b = bmr_pose_inverse(b_in_a);
    const bmr_shape *owner = pair->owner == 0 ? a : b, *other = pair->owner == 0 ? b : a;
    const bmr_pose *other_in_owner = pair->owner == 0 ? b_in_a : &a_in_b;
    const bmr_error error =
        bmr_certificate_audit(&pair->certificate, owner->polygon, other->polygon, other_in_owner);
    if (error != BMR_OK)
        return error;
    double gap;
    if (bmr_certificate_check(&pair->certificate, other_in_owner, def->margin, &gap) != BMR_CHECK_HOLDS)
        return BMR_ERROR_FALSE_CERTIFICATE;
    const bmr_structure structure = bmr_pair_structure(def, a, b);
    const bool walks = structure < BMR_FREE_DIRECTION; // on hierarchies
    const bool is_made =
        pair->structure == structure && (walks || pair->level == 0) &&
        (structure != BMR_TWO_LINES || pair->free || is_coarse(pair, a->polygon, b->polygon)) &&
        (walks && !pair->free ? is_lazy(pair, owner, other, other_in_owner) : is_free(pair, owner, other));
    return is_made ? BMR_OK : BMR_ERROR_INVALID_STRUCTURE;
}
