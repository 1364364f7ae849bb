// SPDX-License-Identifier: MIT
// What all structures share: checks of arguments, memory, contact and the exact distance.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "certificate/coarse.h"
#include "geometry/distance.h"
#include "geometry/memory.h"
#include "hierarchy/tree.h"
#include "kds/registry.h"
#include "kds/structure.h"

/// How far (c, s) of a pose may be off unit length before it is no motion.
#define POSE_TOLERANCE 1e-3
/// Of the extents: a pair farther apart than its reach and this (and BMR_DISTANCE_TOLERANCE of the reach) is
/// not in contact (kds.h).
#define CONTACT_ROUNDING 1e-9

bmr_kds_def bmr_default_kds_def(void) {
    bmr_kds_def def = {1e-6, 0.0, 0.5, 0.5, 0};
    return def;
}

const char *bmr_kds_event_name(bmr_kds_event_kind kind) {
    static const char *const names[BMR_KDS_EVENT_KIND_COUNT] = {
        "start",    "push",    "stab",     "roll",    "cross", "page-turn",
        "collapse", "feature", "handover", "contact", "leave", "none"};
    return (unsigned)kind < BMR_KDS_EVENT_KIND_COUNT ? names[kind] : NULL;
}

static const bmr_kds_class *class_of(const bmr_kds_info *info) {
    return info->implementation;
}

static bool def_makes_sense(const bmr_kds_def *def) {
    return def->margin > 0.0 && isfinite(def->margin) && def->hysteresis >= 0.0 &&
           isfinite(def->hysteresis) && def->alpha > 0.0 && isfinite(def->alpha) && def->offset_ratio > 0.0 &&
           def->offset_ratio < 1.0;
}

/// Is the hierarchy that stands in this place of this kind, and built over this polygon?
static bool is_of(const bmr_shape *shape, int kind) {
    return bmr_tree_is_of(shape->hierarchies[kind], kind, shape->polygon);
}

bmr_error bmr_kds_create(const bmr_kds_info *info, const bmr_kds_def *def, const bmr_shape *a,
                         const bmr_shape *b, const bmr_allocator *allocator, bmr_kds **kds) {
    if (!info || !def || !a || !b || !kds || !a->polygon || !b->polygon)
        return BMR_ERROR_NULL_ARGUMENT;
    if (info->hierarchy >= 0 && (!a->hierarchies[info->hierarchy] || !b->hierarchies[info->hierarchy]))
        return BMR_ERROR_NULL_ARGUMENT;
    if (info->hierarchy >= 0 && !(is_of(a, info->hierarchy) && is_of(b, info->hierarchy)))
        return BMR_ERROR_WRONG_HIERARCHY;
    if (!def_makes_sense(def) || (info->domain == BMR_KDS_POINT && b->polygon->count != 1))
        return BMR_ERROR_OUT_OF_RANGE;
    const bmr_kds_class *class = class_of(info);
    const size_t extra = class->extra_bytes ? class->extra_bytes(a, b, def) : 0;
    const size_t bytes = sizeof(bmr_kds) + class->state_bytes + extra;
    bmr_kds *made = bmr_allocate(allocator, bytes);
    if (!made)
        return BMR_ERROR_NO_MEMORY;
    memset(made, 0, bytes);
    made->info = info;
    made->def = *def;
    made->shapes[0] = *a;
    made->shapes[1] = *b;
    made->bytes = bytes;
    const bmr_error error = class->prepare ? class->prepare(made) : BMR_OK;
    if (error != BMR_OK)
        bmr_release(allocator, made, bytes);
    else
        *kds = made;
    return error;
}

void bmr_kds_destroy(bmr_kds *kds, const bmr_allocator *allocator) {
    if (kds)
        bmr_release(allocator, kds, kds->bytes);
}

size_t bmr_kds_bytes(const bmr_kds *kds) {
    return kds->bytes;
}

bool bmr_kds_in_contact(const bmr_kds *kds) {
    return kds->contact;
}

static bool is_motion(const bmr_pose *q) {
    const double off = q->c * q->c + q->s * q->s - 1.0;
    return isfinite(q->position.x) && isfinite(q->position.y) && fabs(off) <= 2.0 * POSE_TOLERANCE;
}

void bmr_kds_start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    memset(report, 0, sizeof *report);
    const bool leaves = kds->started && kds->contact;
    kds->started = true;
    kds->steps = &report->touched;
    report->touched = 1;
    report->apart = is_motion(&now->pose) && class_of(kds->info)->start(kds, now, report);
    kds->steps = NULL;
    kds->contact = !report->apart;
    report->line_changed = report->apart;
    report->kind = !report->apart ? BMR_KDS_CONTACT : leaves ? BMR_KDS_LEAVE : BMR_KDS_START;
}

size_t bmr_kds_conditions(const bmr_kds *kds, bmr_condition conditions[BMR_KDS_MAX_CONDITIONS]) {
    return kds->contact || !kds->started ? 0 : class_of(kds->info)->conditions(kds, conditions);
}

void bmr_kds_repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    memset(report, 0, sizeof *report);
    report->kind = BMR_KDS_NONE;
    if (kds->contact || !kds->started)
        return;
    kds->steps = &report->touched;
    report->touched = 1;
    report->apart = is_motion(&now->pose) && class_of(kds->info)->repair(kds, now, failed, report);
    kds->steps = NULL;
    kds->contact = !report->apart;
    if (!report->apart)
        report->kind = BMR_KDS_CONTACT;
}

bool bmr_kds_get_proof(const bmr_kds *kds, bmr_kds_proof *proof) {
    if (kds->contact || !kds->started)
        return false;
    class_of(kds->info)->proof(kds, proof);
    return true;
}

double bmr_kds_separation(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_vec2 direction) {
    const bmr_polygon *a = kds->shapes[0].polygon, *b = kds->shapes[1].polygon;
    const bmr_vec2 against = bmr_neg(bmr_unrotate(b_in_a, direction));
    unsigned steps = 0;
    const bmr_vec2 p = a->vertices[bmr_support_counted(a, direction, &steps)];
    const bmr_vec2 q = b->vertices[bmr_support_counted(b, against, &steps)];
    bmr_kds_tally(kds, steps);
    return bmr_dot(direction, bmr_sub(bmr_transform(b_in_a, q), p));
}

bool bmr_kds_closest(const bmr_kds *kds, const bmr_pose *b_in_a, uint32_t *a, uint32_t *b,
                     bmr_vec2 *direction, double *distance) {
    const bmr_polygon *p = kds->shapes[0].polygon, *q = kds->shapes[1].polygon;
    const bmr_simplex near = bmr_simplex_make(*a % p->count, *b % q->count);
    bmr_simplex simplex;
    bmr_closest closest;
    bmr_closest_start(p, q, b_in_a, &near, &simplex);
    const bool apart = bmr_closest_direction(p, q, b_in_a, bmr_kds_reach(kds), 0.0, &simplex, &closest);
    bmr_kds_tally(kds, simplex.steps);
    if (!apart)
        return false;
    *a = closest.a;
    *b = closest.b;
    *direction = closest.direction;
    *distance = closest.separation;
    return true;
}

bmr_vec2 bmr_kds_cone_end(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_vec2 inside, double least, int side,
                          const uint32_t support[2]) {
    unsigned steps = 0;
    const bmr_vec2 end = bmr_cone_end(kds->shapes[0].polygon, kds->shapes[1].polygon, b_in_a, inside, least,
                                      side, support, &steps);
    bmr_kds_tally(kds, steps);
    return end;
}

void bmr_kds_extremes(const bmr_kds *kds, int owner, const bmr_pose *b_in_a, bmr_vec2 normal,
                      double *own_most, double *other_least) {
    const bmr_polygon *own = kds->shapes[owner].polygon, *other = kds->shapes[1 - owner].polygon;
    const bmr_pose other_in_own = owner == 0 ? *b_in_a : bmr_pose_inverse(b_in_a);
    *own_most = -INFINITY;
    *other_least = INFINITY;
    for (uint32_t i = 0; i < own->count; i++)
        *own_most = fmax(*own_most, bmr_dot(normal, own->vertices[i]));
    for (uint32_t i = 0; i < other->count; i++)
        *other_least = fmin(*other_least, bmr_dot(normal, bmr_transform(&other_in_own, other->vertices[i])));
}

/// Brute force over every vertex: does the proof's line separate by more than the margin, up to the rounding
/// of this very computation?
static bmr_error audit_line(const bmr_kds *kds, const bmr_pose *b_in_a, const bmr_kds_proof *proof) {
    const bmr_polygon *own = kds->shapes[proof->owner].polygon,
                      *other = kds->shapes[1 - proof->owner].polygon;
    const double slop =
        1e-12 * (own->extent + other->extent + fabs(b_in_a->position.x) + fabs(b_in_a->position.y));
    const bmr_vec2 n = proof->line.normal;
    if (!(fabs(hypot(n.x, n.y) - 1.0) < 1e-9))
        return BMR_ERROR_FALSE_CERTIFICATE;
    double own_most, other_least;
    bmr_kds_extremes(kds, proof->owner, b_in_a, n, &own_most, &other_least);
    if (own_most > proof->line.offset + slop || !(other_least - proof->line.offset > kds->def.margin - slop))
        return BMR_ERROR_FALSE_CERTIFICATE;
    return BMR_OK;
}

bmr_error bmr_kds_audit(const bmr_kds *kds, const bmr_pose *b_in_a) {
    if (!kds || !b_in_a)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!kds->started || !is_motion(b_in_a))
        return BMR_OK;
    if (kds->contact) {
        uint32_t a = 0, b = 0;
        bmr_vec2 direction;
        double distance;
        const double reach = bmr_kds_reach(kds);
        const double slop =
            CONTACT_ROUNDING * (kds->shapes[0].polygon->extent + kds->shapes[1].polygon->extent) +
            BMR_DISTANCE_TOLERANCE * reach;
        const bool apart =
            bmr_kds_closest(kds, b_in_a, &a, &b, &direction, &distance) && distance > reach + slop;
        return apart ? BMR_ERROR_INVALID_STRUCTURE : BMR_OK;
    }
    bmr_kds_proof proof;
    const bmr_kds_class *class = class_of(kds->info);
    if (kds->proof_at)
        kds->proof_at(kds, b_in_a, &proof);
    else
        class->proof(kds, &proof);
    const bmr_error error = audit_line(kds, b_in_a, &proof);
    if (error != BMR_OK)
        return error;
    return class->audit ? class->audit(kds, b_in_a) : BMR_OK;
}

double bmr_condition_rate(const bmr_condition *condition, const bmr_instant *now) {
    const bmr_pose *q = &now->pose;
    const bool of_a = condition->owner == 0;
    if (condition->kind == BMR_CONDITION_TURN) {
        // cross(n, R x), and cross(R n, x) for B: what turns is at a right angle to what it turns into.
        const bmr_vec2 turning = bmr_rotate(q, of_a ? condition->point : condition->normal);
        const bmr_vec2 still = of_a ? condition->normal : condition->point;
        return (of_a ? now->spin : -now->spin) * bmr_dot(turning, still);
    }
    if (condition->kind == BMR_CONDITION_BEYOND && !of_a) {
        // <R n, x - p> - h, x fixed in A
        const bmr_vec2 n = bmr_rotate(q, condition->normal), d = bmr_sub(condition->point, q->position);
        return now->spin * bmr_dot(bmr_left(n), d) - bmr_dot(n, now->velocity);
    }
    const bmr_vec2 arm = bmr_rotate(q, condition->point);
    const bmr_vec2 velocity = bmr_add(now->velocity, bmr_scale(now->spin, bmr_left(arm)));
    if (condition->kind == BMR_CONDITION_BEYOND)
        return bmr_dot(condition->normal, velocity);
    const bmr_vec2 d = bmr_sub(bmr_add(arm, q->position), condition->normal);
    const double length = hypot(d.x, d.y);
    return length > 0.0 ? bmr_dot(d, velocity) / length : 0.0;
}

bool bmr_condition_fails(const bmr_condition *condition, const bmr_instant *now, double tolerance) {
    const double value = bmr_condition_value(condition, &now->pose);
    if (!(value > 0.0)) // a NaN has failed
        return true;
    return value <= tolerance && bmr_condition_rate(condition, now) < 0.0;
}

/// The table of all structures, in the order of the paper.
static const bmr_kds_info *const structures[] = {
    // One point, one polygon (section 5)
    &bmr_kds_triangle_levels_compass, &bmr_kds_triangle_levels_dudley, &bmr_kds_triangle_binary_dudley,
    &bmr_kds_point_lazy_dudley,
    // Two polygons, translating or rigid (section 5)
    &bmr_kds_active_cell_compass, &bmr_kds_active_cell_dudley, &bmr_kds_tiling_dudley,
    &bmr_kds_sum_triangle_dudley, &bmr_kds_lazy_compass, &bmr_kds_lazy_dudley,
    // Inflation and hysteresis (section 6)
    &bmr_kds_point_inflated_compass, &bmr_kds_point_inflated_dudley, &bmr_kds_point_complex,
    &bmr_kds_inflated_translation, &bmr_kds_inflated_window,
    // The open question (section 7), and beyond
    &bmr_kds_hybrid, &bmr_kds_two_lines, &bmr_kds_coarse, &bmr_kds_free_fd2, &bmr_kds_predict_adaptive,
    // Rivals (the introduction of section 5)
    &bmr_kds_closest_features, &bmr_kds_inner_tangent, &bmr_kds_separating_edge_walk, NULL};

size_t bmr_kds_count(void) {
    return sizeof structures / sizeof structures[0] - 1;
}

const bmr_kds_info *bmr_kds_at(size_t index) {
    return index < bmr_kds_count() ? structures[index] : NULL;
}

bmr_error bmr_kds_find(const char *name, const bmr_kds_info **info) {
    if (!name || !info)
        return BMR_ERROR_NULL_ARGUMENT;
    for (size_t i = 0; i < bmr_kds_count(); i++)
        if (strcmp(structures[i]->name, name) == 0) {
            *info = structures[i];
            return BMR_OK;
        }
    return BMR_ERROR_UNKNOWN_NAME;
}

/// Appends to a text that is `length` bytes long; returns how long it would be with that. A text that is too
/// long for `size` is cut, and what comes behind is counted all the same.
static size_t append(char *text, size_t size, size_t length, const char *format, const char *word) {
    const size_t left = length < size ? size - length : 0;
    const int written = snprintf(left > 0 ? text + length : NULL, left, format, word);
    return length + (written > 0 ? (size_t)written : 0);
}

size_t bmr_kds_describe_unknown(const char *name, char *text, size_t size) {
    if (!text)
        size = 0;
    size_t length = append(text, size, 0, "there is no structure \"%.64s\"; there are ", name ? name : "");
    for (size_t i = 0; i < bmr_kds_count(); ++i)
        length = append(text, size, length, i + 1 < bmr_kds_count() ? "%s, " : "%s", structures[i]->name);
    return length;
}
