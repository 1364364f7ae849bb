// SPDX-License-Identifier: MIT
#include "kds/held_cell.h"

#include <math.h>

#include "hierarchy/mixed.h"

/// B's displacement: an angle in radians, which is also its way as a part of the extents. Well above the
/// angle within which directions are merged (1e-11) and above rounding, well below any sensible margin.
#define DISPLACEMENT 0x1p-33
/// Its direction: no multiple of any compass angle.
#define DISPLACEMENT_X 0.8191
#define DISPLACEMENT_Y 0.5737

bmr_held_cell bmr_held_make(const bmr_kds *kds) {
    bmr_held_cell held = {.displacement = {.c = cos(DISPLACEMENT), .s = sin(DISPLACEMENT)}};
    const double extent_b = kds->shapes[1].polygon->extent;
    held.scale = fmax(kds->shapes[0].polygon->extent + extent_b, kds->def.margin);
    const double way = DISPLACEMENT * held.scale;
    held.displacement.position = bmr_vec2_make(way * DISPLACEMENT_X, way * DISPLACEMENT_Y);
    held.room = way + DISPLACEMENT * 1.5 * extent_b; // a corner of the square is sqrt(2) extents away
    const double apart = kds->def.margin + 2.0 * held.room + 2.0 * BMR_HELD_SLACK * held.scale;
    held.mixed = bmr_mixed_make(bmr_kds_hierarchy(kds, 0), bmr_kds_hierarchy(kds, 1), 1.0, 0.0, 0.5 * apart);
    return held;
}

bmr_pose bmr_held_displaced(const bmr_held_cell *held, const bmr_pose *pose) {
    const bmr_pose *d = &held->displacement;
    const bmr_pose q = {bmr_transform(pose, d->position), pose->c * d->c - pose->s * d->s,
                        pose->s * d->c + pose->c * d->s};
    return q;
}

int bmr_held_level(const bmr_held_cell *held) {
    const int32_t stage = bmr_mixed_stage(&held->mixed, &held->cell);
    return stage < 0 ? BMR_HELD_OUTSIDE_LEVEL : stage / 2 + 1;
}

bmr_edge bmr_held_edge(const bmr_held_cell *held, int *owner) {
    const bool own = held->cell.kind == BMR_MIXED_TRIANGLE || held->cell.kind == BMR_MIXED_OUTSIDE;
    *owner = own ? held->cell.owner : 1 - held->cell.owner;
    return own ? held->cell.edge : held->cell.other[0];
}

static bmr_condition condition_of_side(const bmr_held_cell *held, const bmr_mixed_figure *f, size_t i) {
    const bmr_mixed_part *part = &f->parts[i];
    const bmr_line *line = &f->lines[part->of][part->line];
    const bmr_vec2 p = f->corners[1 - part->of][part->corner];
    const int owner = part->of ? 1 - f->owner : f->owner, label = BMR_HELD_SIDE + part->role;
    const double sign = (double)part->beyond;
    if (owner == 0)
        return bmr_condition_beyond(0, bmr_scale(sign, line->normal), sign * line->offset,
                                    bmr_transform(&held->displacement, p), label);
    const bmr_vec2 n = bmr_rotate(&held->displacement, line->normal);
    const double offset = line->offset + bmr_dot(n, held->displacement.position);
    return bmr_condition_beyond(1, bmr_scale(sign, n), sign * offset, p, label);
}

static bmr_vec2 normal_in(const bmr_mixed_figure *f, int body, bmr_edge edge) {
    const int of = body == f->owner ? 0 : 1;
    int i = 0;
    while (i < 2 && f->edges[of][i] != edge)
        ++i;
    return f->lines[of][i].normal;
}

/// Lemma 4.2: a full turn of Q turns O(mn log m) pages.
/// -B's normals are those of B turned round.
static bmr_condition condition_of_order(const bmr_held_cell *held, const bmr_mixed_figure *f,
                                        const bmr_mixed_order *order) {
    const bmr_vec2 first = normal_in(f, order->owner, order->first);
    const bmr_vec2 second = normal_in(f, 1 - order->owner, order->second);
    const int label = order->page_turn ? BMR_HELD_PAGE : BMR_HELD_COLLAPSE;
    return order->owner == 0
               ? bmr_condition_turn(0, first, bmr_neg(bmr_rotate(&held->displacement, second)), label)
               : bmr_condition_turn(1, bmr_neg(bmr_rotate(&held->displacement, first)), second, label);
}

size_t bmr_held_conditions(const bmr_held_cell *held, bool turns, bmr_condition *out) {
    bmr_mixed_figure figure;
    bmr_mixed_order orders[2];
    bmr_mixed_draw(&held->mixed, &held->cell, &figure);
    const size_t count = figure.sides;
    for (size_t i = 0; i < count; ++i)
        out[i] = condition_of_side(held, &figure, i);
    if (!turns)
        return count;
    bmr_mixed_orders(&held->mixed, &held->cell, orders);
    out[count] = condition_of_order(held, &figure, &orders[0]);
    out[count + 1] = condition_of_order(held, &figure, &orders[1]);
    return count + 2;
}

void bmr_held_proof(const bmr_held_cell *held, bmr_kds_proof *out) {
    bmr_mixed_side sides[BMR_MIXED_MAX_SIDES];
    const size_t count = bmr_mixed_sides(&held->mixed, &held->cell, sides);
    size_t i = 0;
    while (i + 1 < count && sides[i].role != BMR_MIXED_INNER)
        ++i;
    const int owner = sides[i].owner, other = 1 - owner;
    out->owner = owner;
    out->line = bmr_hierarchy_line(held->mixed.hierarchies[owner], sides[i].edge);
    out->nearest = bmr_hierarchy_corner_point(
        held->mixed.hierarchies[other],
        bmr_hierarchy_corner(held->mixed.hierarchies[other], sides[i].corner[0], sides[i].corner[1]));
    if (owner == 1) { // the line has B's displacement: out until all of B itself is behind it
        out->line.normal = bmr_rotate(&held->displacement, out->line.normal);
        out->line.offset += bmr_dot(out->line.normal, held->displacement.position) + held->room;
    }
    out->level = bmr_held_level(held);
}

/// The other body's edges of a cell: there when e was inserted, and a triangle's two adjacent.
static bool is_of_its_stage(const bmr_held_cell *held) {
    const int other = 1 - held->cell.owner;
    const bmr_hierarchy *h = held->mixed.hierarchies[other];
    const uint32_t level = (uint32_t)(bmr_mixed_stage(&held->mixed, &held->cell) + 1 - other) / 2u;
    if (bmr_hierarchy_level(h, held->cell.other[0]) > level)
        return false;
    return held->cell.kind != BMR_MIXED_TRIANGLE ||
           bmr_hierarchy_corner_after(h, held->cell.other[0], level).after == held->cell.other[1];
}

bmr_error bmr_held_audit(const bmr_held_cell *held, const bmr_pose *b_in_a) {
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const size_t count = bmr_held_conditions(held, true, conditions);
    for (size_t i = 0; i < count; ++i) {
        const double unit = conditions[i].kind == BMR_CONDITION_TURN ? 1.0 : held->scale;
        if (!(bmr_condition_value(&conditions[i], b_in_a) > -2.0 * BMR_HELD_SLACK * unit))
            return BMR_ERROR_INVALID_STRUCTURE;
    }
    return bmr_held_is_cell(held) && !is_of_its_stage(held) ? BMR_ERROR_INVALID_STRUCTURE : BMR_OK;
}
