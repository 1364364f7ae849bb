// SPDX-License-Identifier: MIT
// A small engine of one's own: convex polygons drift, spin and bounce in a box. Two worlds are stepped side
// by side: one tests every pair in every step (disks first), the other asks a budget of motion
// (boomerang/budget.h). Their bodies must stay the same to the bit. Links boomerang::core alone.
//
//   example_budget [BODIES [STEPS]]    with arguments it prints times, too
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "boomerang/budget.h"
#include "boomerang/distance.h"
#include "boomerang/polygon.h"

#define UNITS 65536.0 // of motion, a length: sums count in 1/65536
#define MARGIN 0.02   // two bodies touch at this distance
#define SLOP 1e-9     // more than what measure() may be off by
#define CORNERS 6
#define DENSITY 0.16 // bodies for each unit of the box's area

typedef struct body {
    bmr_polygon *shape;
    bmr_pose pose;
    bmr_vec2 velocity;
    double spin;
    bmr_vec2 center; // in the world, of this step
} body;

typedef struct pair {
    uint32_t a, b;
    uint32_t deadline;
    bmr_budget_line line;
} pair;

typedef struct world {
    uint32_t bodies, pairs;
    double side;
    body *body;
    bmr_mover *mover; // apart from the bodies: a scan of pairs reads nothing else
    pair *pair;
    unsigned long tests, renewals, contacts;
} world;

// The engine's test: the distance of two bodies, 0 if they overlap, and the direction from a's nearest point
// to b's. (Not the largest separation along an edge: that may fall by more than the bodies move.)
static double measure(const body *a, const body *b, bmr_vec2 *direction) {
    bmr_closest_points closest;
    if (bmr_distance(a->shape, &a->pose, b->shape, &b->pose, &closest) != BMR_OK)
        exit(2);
    *direction = closest.normal;
    return closest.distance;
}

// By how much the bounding disks are farther apart than the bodies must be: what is asked before a test.
static double slack_of_disks(const body *a, const body *b) {
    const bmr_vec2 way = bmr_sub(b->center, a->center);
    return sqrt(bmr_dot(way, way)) - (a->shape->radius + b->shape->radius + MARGIN + SLOP);
}

// Two bodies of the same mass that come nearer along their centres exchange these parts of their velocities.
static void collide(body *a, body *b) {
    const bmr_vec2 n = bmr_sub(b->pose.position, a->pose.position);
    const double nearer = bmr_dot(n, bmr_sub(a->velocity, b->velocity));
    if (nearer <= 0.0)
        return;
    const bmr_vec2 push = bmr_scale(nearer / bmr_dot(n, n), n);
    a->velocity = bmr_sub(a->velocity, push);
    b->velocity = bmr_add(b->velocity, push);
    a->spin = -a->spin;
    b->spin = -b->spin;
}

static void move(const world *w, body *b) {
    bmr_pose *q = &b->pose;
    q->position = bmr_add(q->position, b->velocity);
    if (fabs(q->position.x) > w->side / 2.0)
        b->velocity.x = copysign(b->velocity.x, -q->position.x);
    if (fabs(q->position.y) > w->side / 2.0)
        b->velocity.y = copysign(b->velocity.y, -q->position.y);
    const double c = q->c - b->spin * q->s, s = q->s + b->spin * q->c, length = sqrt(c * c + s * s);
    q->c = c / length;
    q->s = s / length;
    b->center = bmr_transform(q, b->shape->center);
}

static void step(world *w, bool with_budgets) {
    static const bmr_budget_line no_line = {{0.0f, 0.0f}, 0};
    for (uint32_t i = 0; i < w->bodies; ++i)
        move(w, &w->body[i]);
    // Poses are final now: sum up how far each body can have carried its points.
    for (uint32_t i = 0; with_budgets && i < w->bodies; ++i)
        bmr_mover_update(&w->mover[i], &w->body[i].pose, UNITS);
    for (pair *p = w->pair; p < w->pair + w->pairs; ++p) {
        const bmr_mover *a = &w->mover[p->a], *b = &w->mover[p->b];
        // Nearly always it ends here: the pair is still apart.
        if (with_budgets && !bmr_budget_is_due(p->deadline, a->moved, b->moved))
            continue;
        // Or here, without the shapes: the old direction still separates them.
        double slack = with_budgets ? bmr_budget_line_gap(&p->line, a, b, UNITS) - (MARGIN + SLOP) : 0.0;
        if (slack > 0.0) {
            ++w->renewals;
        } else {
            p->line = no_line;
            slack = slack_of_disks(&w->body[p->a], &w->body[p->b]);
        }
        if (slack <= 0.0) {
            ++w->tests;
            bmr_vec2 direction;
            const double distance = measure(&w->body[p->a], &w->body[p->b], &direction);
            slack = distance - (MARGIN + SLOP);
            if (distance <= MARGIN) {
                ++w->contacts;
                collide(&w->body[p->a], &w->body[p->b]);
            } else if (with_budgets) {
                // The nearest points separate the two: <direction, b - a> >= distance for all their points.
                p->line = bmr_budget_line_make(direction, distance - SLOP, a, b, UNITS);
            }
        }
        if (with_budgets)
            p->deadline = bmr_budget_deadline(slack, a->moved, b->moved, UNITS);
    }
}

static uint32_t state = 1;
static double any(double low, double high) {
    state = state * 1664525u + 1013904223u;
    return low + (high - low) * ((double)(state >> 8) * 0x1p-24);
}

// One after the other: arguments of a call are computed in any order.
static bmr_vec2 any_vector(double most) {
    const double x = any(-most, most);
    return bmr_vec2_make(x, any(-most, most));
}

static void *zeroed(size_t count, size_t size) {
    void *memory = calloc(count, size);
    if (!memory)
        exit(2);
    return memory;
}

static world make(uint32_t bodies) {
    world w = {bodies, bodies * (bodies - 1) / 2, sqrt((double)bodies / DENSITY), NULL, NULL, NULL, 0, 0, 0};
    w.body = zeroed(bodies, sizeof *w.body);
    w.mover = zeroed(bodies, sizeof *w.mover);
    w.pair = zeroed(w.pairs, sizeof *w.pair);
    state = 1;
    for (uint32_t i = 0; i < bodies; ++i) {
        const double x = any(0.3, 1.5), y = any(0.1, 0.5);
        const bmr_vec2 hexagon[CORNERS] = {{x, 0.0},  {0.5 * x, y},   {-0.5 * x, y},
                                           {-x, 0.0}, {-0.5 * x, -y}, {0.5 * x, -y}};
        body *b = &w.body[i];
        if (bmr_polygon_create(hexagon, CORNERS, NULL, &b->shape) != BMR_OK)
            exit(2);
        b->pose = bmr_pose_identity();
        b->pose.position = any_vector(0.5 * w.side);
        b->velocity = any_vector(0.02);
        b->spin = any(-0.01, 0.01);
        // The reach: the shape's bounding disk is about its centre.
        bmr_mover_start(&w.mover[i], &b->pose, b->shape->center, b->shape->radius, UNITS);
    }
    pair *p = w.pair; // all zero: due at once, and no line
    for (uint32_t b = 1; b < bodies; ++b)
        for (uint32_t a = 0; a < b; ++a, ++p) {
            p->a = a;
            p->b = b;
        }
    return w;
}

static void destroy(world *w) {
    for (uint32_t i = 0; i < w->bodies; ++i)
        bmr_polygon_destroy(w->body[i].shape, NULL);
    free(w->body);
    free(w->mover);
    free(w->pair);
}

static bool same(const world *v, const world *w) {
    for (uint32_t i = 0; i < v->bodies; ++i) {
        const bmr_pose *p = &v->body[i].pose, *q = &w->body[i].pose;
        if (p->position.x != q->position.x || p->position.y != q->position.y || p->c != q->c || p->s != q->s)
            return false;
    }
    return v->contacts == w->contacts;
}

int main(int count, char **arguments) {
    const unsigned long bodies = count > 1 ? strtoul(arguments[1], NULL, 10) : 120;
    const unsigned long steps = count > 2 ? strtoul(arguments[2], NULL, 10) : 300;
    if (bodies < 2 || bodies > 20000 || steps < 1)
        return 2;
    world worlds[2] = {make((uint32_t)bodies), make((uint32_t)bodies)};
    clock_t times[2] = {0, 0};
    for (unsigned long i = 0; i < steps; ++i) {
        for (int with = 0; with < 2; ++with) {
            const clock_t begin = clock();
            step(&worlds[with], with != 0);
            times[with] += clock() - begin;
        }
        if (!same(&worlds[0], &worlds[1])) {
            printf("step %lu: the worlds differ\n", i);
            return 1;
        }
    }
    printf("%lu bodies, %u pairs, %lu steps, %lu contacts\n", bodies, worlds[0].pairs, steps,
           worlds[0].contacts);
    for (int with = 0; with < 2; ++with) {
        const world *w = &worlds[with];
        printf("%s budgets: %.1f tests and %.1f renewals a step", with ? "with" : "without",
               (double)w->tests / (double)steps, (double)w->renewals / (double)steps);
        if (count > 1)
            printf(", %.1f us", 1e6 * (double)times[with] / CLOCKS_PER_SEC / (double)steps);
        printf("\n");
    }
    printf("the same bodies in all steps\n");
    destroy(&worlds[0]);
    destroy(&worlds[1]);
    return 0;
}
