// SPDX-License-Identifier: MIT
#include "motions.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "hierarchies.h"

#define TWO_PI 6.283185307179586

bmr_pose test_pose_at(const bmr_polygon *a, const bmr_polygon *b, double direction, double angle,
                      double gap) {
    bmr_pose q = {{0.0, 0.0}, cos(angle), sin(angle)};
    const bmr_vec2 u = {cos(direction), sin(direction)}, v = bmr_unrotate(&q, bmr_neg(u));
    const bmr_vec2 on_a = a->vertices[bmr_polygon_support(a, u)];
    const bmr_vec2 on_b = bmr_rotate(&q, b->vertices[bmr_polygon_support(b, v)]);
    q.position = bmr_add(bmr_sub(on_a, on_b), bmr_scale(gap, u));
    return q;
}

test_motion test_motion_make(test_motion_kind kind, const bmr_polygon *a, const bmr_polygon *b,
                             test_random *random) {
    test_motion m = {kind, a, b, 0, 0, 0, 0, 0, 0, 0, {0, 0}, {0, 0}};
    m.unit = fmax(fmin(a->radius, b->radius), 0.1 * fmax(a->radius, b->radius));
    if (!(m.unit > 0.0))
        m.unit = 1.0;
    m.direction = test_random_uniform(random, 0.0, TWO_PI);
    m.angle = test_random_uniform(random, 0.0, TWO_PI);
    // Gaps of all sizes matter, so that they are uniform in their logarithm; some overlap.
    m.gap = m.unit * exp(test_random_uniform(random, log(1e-6), log(2.0)));
    if (test_random_below(random, 8) == 0)
        m.gap = -0.2 * m.gap;
    const double speed = exp(test_random_uniform(random, log(1e-4), log(0.5)));
    m.direction_speed = speed * test_random_uniform(random, -1.0, 1.0);
    m.spin = speed * test_random_uniform(random, -1.0, 1.0);
    m.rush = speed * m.unit * test_random_uniform(random, -1.0, 1.0);
    const bmr_pose q = test_pose_at(a, b, m.direction, m.angle, m.gap);
    const bmr_vec2 across = {-sin(m.direction), cos(m.direction)};
    m.velocity = bmr_scale(speed * (a->radius + b->radius + m.unit), across);
    m.position = bmr_sub(q.position, bmr_scale(20.0, m.velocity));
    if (kind == TEST_MOTION_SPIN)
        m.position = q.position;
    return m;
}

static bmr_pose at_position(const test_motion *m) {
    const bmr_pose q = {m->position, cos(m->angle), sin(m->angle)};
    return q;
}

bmr_pose test_motion_next(test_motion *m, test_random *random) {
    switch (m->kind) {
    case TEST_MOTION_LINE:
        m->position = bmr_add(m->position, m->velocity);
        return at_position(m);
    case TEST_MOTION_TUMBLE:
        m->position = bmr_add(m->position, m->velocity);
        m->angle += m->spin;
        return at_position(m);
    case TEST_MOTION_SPIN:
        m->angle += m->spin;
        return at_position(m);
    case TEST_MOTION_ORBIT:
        m->direction += m->direction_speed;
        break;
    case TEST_MOTION_ROLLING:
        m->direction += m->direction_speed;
        m->angle += m->spin;
        m->gap += m->rush;
        if (m->gap > 2.0 * m->unit || m->gap < -0.1 * m->unit)
            m->rush = m->gap > 0.0 ? -fabs(m->rush) : fabs(m->rush);
        break;
    case TEST_MOTION_WANDER:
        m->direction += m->direction_speed * test_random_uniform(random, -2.0, 2.0);
        m->angle += m->spin * test_random_uniform(random, -2.0, 2.0);
        m->gap = fabs(m->gap + m->rush * test_random_uniform(random, -1.0, 1.0));
        break;
    case TEST_MOTION_TREMBLE:
        return test_pose_at(m->a, m->b, m->direction + test_random_uniform(random, -2e-7, 2e-7),
                            m->angle + test_random_uniform(random, -2e-7, 2e-7),
                            fabs(m->gap) * 1e-3 * test_random_uniform(random, -0.1, 1.0));
    case TEST_MOTION_JUMP:
    default:
        m->direction = test_random_uniform(random, 0.0, TWO_PI);
        m->angle = test_random_uniform(random, 0.0, TWO_PI);
        m->gap = m->unit * test_random_uniform(random, -0.2, 1.0);
        break;
    }
    return test_pose_at(m->a, m->b, m->direction, m->angle, m->gap);
}

test_pair test_pair_make(bmr_structure structure, bmr_polygon *a, bmr_polygon *b) {
    test_pair pair = {.shape = {{.polygon = a}, {.polygon = b}}, .def = bmr_default_pair_def()};
    pair.def.structure = structure;
    for (int side = 0; side < 2 && structure < BMR_FREE_DIRECTION; ++side)
        pair.shape[side].hierarchies[structure] =
            test_hierarchy((bmr_hierarchy_kind)structure, pair.shape[side].polygon);
    bmr_pair_init(&pair.pair);
    return pair;
}

void test_pair_destroy(test_pair *pair) {
    for (int side = 0; side < 2; ++side) {
        for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind)
            bmr_hierarchy_destroy((bmr_hierarchy *)(uintptr_t)pair->shape[side].hierarchies[kind], NULL);
        bmr_polygon_destroy((bmr_polygon *)(uintptr_t)pair->shape[side].polygon, NULL);
    }
}

bmr_answer test_pair_advance(test_pair *c, const bmr_pose *pose, double *gap) {
    const bmr_observer observer = {&c->counters, NULL, NULL};
    return bmr_pair_advance(&c->pair, &c->def, &c->shape[0], &c->shape[1], pose, &observer, gap);
}

bmr_error test_pair_audit(const test_pair *c, const bmr_pose *q) {
    const bmr_pair *const p = &c->pair;
    const bmr_certificate *const k = &p->certificate;
    const bmr_error error = bmr_pair_audit(p, &c->def, &c->shape[0], &c->shape[1], q);
    if (error != BMR_OK)
        fprintf(stderr,
                "%s, %u and %u vertices, at (%.17g, %.17g; %.17g, %.17g), level %d: the line (%.9g, %.9g; "
                "%.9g) of %c's edge %u faces %u|%u%s: the audit: %s\n",
                bmr_structure_name(c->def.structure), c->shape[0].polygon->count, c->shape[1].polygon->count,
                q->position.x, q->position.y, q->c, q->s, p->level, (double)k->normal[0],
                (double)k->normal[1], (double)k->offset, p->owner == 0 ? 'A' : 'B', p->edge, p->other,
                p->other_after, p->free ? ", free" : "", bmr_error_describe(error));
    return error;
}
