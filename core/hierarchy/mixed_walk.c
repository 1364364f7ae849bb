// SPDX-License-Identifier: MIT
// Straight walks through the mixed hierarchy, and where they start.
#include <math.h>

#include "hierarchy/mixed.h"
#include "hierarchy/tree.h"

void bmr_mixed_tops(const bmr_mixed *mixed, bmr_mixed_top tops[BMR_MIXED_TOPS]) {
    for (uint32_t i = 0; i < BMR_MIXED_TOPS; ++i) {
        bmr_mixed_top *top = &tops[i];
        top->owner = i < BMR_ROOTS ? 0 : 1;
        top->edge = i % BMR_ROOTS;
        const bmr_corner w = bmr_mixed_around(mixed, 1 - top->owner, top->edge, 0);
        top->corner[0] = w.before;
        top->corner[1] = w.after;
        const bmr_edge before = (top->edge + BMR_ROOTS - 1) % BMR_ROOTS, after = (top->edge + 1) % BMR_ROOTS;
        top->start = bmr_mixed_sum(mixed, top->owner, before, top->edge, w.before, w.after);
        top->end = bmr_mixed_sum(mixed, top->owner, top->edge, after, w.before, w.after);
    }
}

bmr_mixed_cell bmr_mixed_outside(const bmr_mixed *mixed, bmr_vec2 x, double *slack) {
    bmr_mixed_cell best = {0};
    *slack = -INFINITY;
    for (uint32_t i = 0; i < BMR_MIXED_TOPS; ++i) {
        const int owner = i < BMR_ROOTS ? 0 : 1;
        const bmr_corner w = bmr_mixed_around(mixed, 1 - owner, i % BMR_ROOTS, 0);
        const bmr_mixed_cell cell =
            bmr_mixed_cell_make(BMR_MIXED_OUTSIDE, owner, i % BMR_ROOTS, w.before, w.after);
        bmr_mixed_figure figure;
        bmr_mixed_draw(mixed, &cell, &figure);
        const double value = bmr_mixed_figure_value(mixed, &figure, 0, x);
        if (value > *slack) {
            *slack = value;
            best = cell;
        }
    }
    return best;
}

bmr_mixed_cell bmr_mixed_enter(const bmr_mixed *mixed, const bmr_mixed_ray *ray, unsigned *touched) {
    bmr_mixed_top tops[BMR_MIXED_TOPS];
    bmr_mixed_tops(mixed, tops);
    for (uint32_t i = 0; i < BMR_MIXED_TOPS; ++i)
        if (bmr_mixed_left(ray, tops[i].start) && !bmr_mixed_left(ray, tops[i].end))
            return bmr_mixed_down(mixed, tops[i].owner, tops[i].edge, tops[i].corner, 0, ray, touched);
    return bmr_mixed_cell_make(BMR_MIXED_OUTSIDE, 0, 0, BMR_NO_EDGE, BMR_NO_EDGE);
}

size_t bmr_mixed_exit(const bmr_mixed *mixed, const bmr_mixed_cell *cell, const bmr_mixed_figure *figure,
                      const bmr_mixed_ray *ray) {
    bmr_vec2 corners[BMR_MIXED_MAX_SIDES];
    const size_t count = figure->sides;
    bmr_mixed_figure_polygon(mixed, cell, figure, corners);
    size_t exit = 0;
    while (exit < count && !(!bmr_mixed_left(ray, corners[exit]) &&
                             bmr_mixed_left(ray, corners[exit + 1 < count ? exit + 1 : 0])))
        ++exit;
    return exit;
}

/// The rest of a walk whose ray is known: from a cell that the ray meets.
static bool follow(const bmr_mixed *mixed, bmr_mixed_cell *cell, const bmr_mixed_ray *ray, bmr_vec2 to,
                   unsigned *touched) {
    for (uint32_t step = bmr_mixed_most_steps(mixed); step > 0; --step) {
        if (cell->kind == BMR_MIXED_OUTSIDE || cell->kind == BMR_MIXED_INSIDE)
            return true;
        bmr_mixed_figure figure;
        bmr_mixed_draw(mixed, cell, &figure);
        const size_t exit = bmr_mixed_exit(mixed, cell, &figure, ray);
        if (exit == figure.sides)
            return false;
        if (bmr_mixed_figure_value(mixed, &figure, exit, to) >= 0.0)
            return true;
        *cell = bmr_mixed_next(mixed, cell, (bmr_mixed_role)figure.parts[exit].role, ray, touched);
    }
    return false;
}

/// Lemma 4.4(b): a convex curve meets O(log(D/s)) and O(sqrt(D/s)) mixed triangles.
bool bmr_mixed_walk(const bmr_mixed *mixed, bmr_mixed_cell *cell, bmr_vec2 from, bmr_vec2 to,
                    unsigned *touched) {
    const bmr_mixed_ray ray = {from, bmr_sub(to, from)};
    if (ray.direction.x == 0.0 && ray.direction.y == 0.0)
        return true;
    return follow(mixed, cell, &ray, to, touched);
}

bool bmr_mixed_locate(const bmr_mixed *mixed, bmr_vec2 x, bmr_vec2 direction, bmr_mixed_cell *cell,
                      unsigned *touched) {
    double slack;
    *cell = bmr_mixed_outside(mixed, x, &slack);
    if (slack > 0.0)
        return true;
    const bmr_mixed_ray ray = {x, bmr_neg(direction)};
    *cell = bmr_mixed_enter(mixed, &ray, touched);
    return cell->kind != BMR_MIXED_OUTSIDE && follow(mixed, cell, &ray, x, touched);
}
