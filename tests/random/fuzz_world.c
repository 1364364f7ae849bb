// SPDX-License-Identifier: MIT
// Sequences of calls of a kinetic world: bodies added, removed, moved and sent elsewhere, between advances
// and inside of contacts, with arguments of any kind. After each call: the world's own audit; no two bodies
// overlap but those that are to pass. The same calls on all pairs: the same contacts, bit for bit. Where
// numbers are wild, the contract alone.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "boomerang/distance.h"
#include "boomerang/world.h"
#include "harness.h"
#include "paths.h"

#define MOST_BODIES 10
#define MOST_CONTACTS 400
#define MOST_EVENTS 20000
#define SHAPES 5
#define END 4.0

typedef struct note {
    bmr_body a, b;
    double time, x, y, approach;
} note;

typedef struct script {
    fuzz_bytes bytes;
    bool wild;
    bmr_world *world;
    bmr_boundary boundary;
    double size;
    const bmr_shape *shapes;
    size_t events, contacts;
    double last;
    note notes[MOST_CONTACTS];
} script;

static const bmr_shape *make_shapes(void) {
    static bmr_shape shapes[SHAPES];
    static const bmr_vec2 points[SHAPES][5] = {
        {{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}},
        {{0.4, 0.0}, {-0.2, 0.3}, {-0.2, -0.3}, {0.4, 0.0}, {0.4, 0.0}},
        {{0.01, 0.0}, {0.003, 0.01}, {-0.008, 0.006}, {-0.008, -0.006}, {0.003, -0.01}},
        {{2.0, 0.0}, {-2.0, 0.0}, {0.0, 1e-3}, {0.0, -1e-3}, {2.0, 0.0}},
        {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}}};
    for (int i = 0; i < SHAPES && !shapes[i].polygon; i++) {
        bmr_polygon *polygon = NULL;
        FUZZ_CHECK(bmr_polygon_create(points[i], 5, NULL, &polygon) == BMR_OK, "a shape");
        shapes[i].polygon = polygon;
    }
    return shapes;
}

// ---- the calls ----

static bmr_body any_body(script *s) {
    const uint8_t how = fuzz_u8(&s->bytes);
    if (how > 250)
        return fuzz_u64(&s->bytes); // there is none of that name
    const size_t count = bmr_world_get_counts(s->world).bodies;
    size_t place = 0;
    bmr_body body = BMR_NO_BODY;
    for (size_t i = 0; count > 0 && i <= how % count; i++)
        body = bmr_world_next_body(s->world, &place);
    return body;
}

static bool known(const script *s, bmr_body body) {
    bmr_body_state state;
    return bmr_world_get(s->world, body, &state) == BMR_OK;
}

static fuzz_motion_range range_of(const script *s) {
    const fuzz_motion_range range = {s->size, 4.0, 3.0, 0.0, END, s->wild, false};
    return range;
}

static void check_error(const script *s, bmr_error error, bool asked) {
    const bool allowed = error == BMR_OK ||
                         (s->wild && (error == BMR_ERROR_NOT_FINITE || error == BMR_ERROR_OUT_OF_RANGE)) ||
                         (asked && error == BMR_ERROR_OUT_OF_RANGE);
    FUZZ_CHECK(allowed, "error %d", error);
}

static void add(script *s) {
    const fuzz_motion_range range = range_of(s);
    const bmr_shape *shape = &s->shapes[fuzz_below(&s->bytes, SHAPES)];
    bmr_motion *motion = fuzz_motion(&s->bytes, &range);
    const uint8_t how = fuzz_u8(&s->bytes);
    if (bmr_world_get_counts(s->world).bodies >= MOST_BODIES) {
        bmr_motion_destroy(motion);
        return;
    }
    bmr_body_def def = bmr_default_body_def(shape, motion);
    if (how > 200)
        def.mass = def.inertia = s->wild ? fuzz_number(&s->bytes) : INFINITY;
    bmr_body body = 7777;
    const bmr_error error = bmr_world_add(s->world, &def, &body);
    if (!motion)
        FUZZ_CHECK(error == BMR_ERROR_NULL_ARGUMENT, "no motion, and error %d", error);
    else
        check_error(s, error, s->boundary == BMR_PERIODIC);
    FUZZ_CHECK((error == BMR_OK) == (body != 7777) || known(s, body), "an error wrote a body");
    bmr_motion_destroy(motion);
}

static void move(script *s) {
    const fuzz_motion_range range = range_of(s);
    const bmr_body body = any_body(s);
    const bool there = known(s, body);
    if (fuzz_u8(&s->bytes) % 2) {
        bmr_motion *motion = fuzz_motion(&s->bytes, &range);
        const bmr_error error = bmr_world_set_motion(s->world, body, motion);
        if (motion)
            check_error(s, error, !there);
        bmr_motion_destroy(motion);
        return;
    }
    bmr_motion_piece piece = fuzz_piece(&s->bytes, &range);
    fuzz_tame(&piece, &range);
    bmr_body_state state;
    if (fuzz_u8(&s->bytes) % 4 && piece.kind == BMR_PIECE_SCREW &&
        bmr_world_get(s->world, body, &state) == BMR_OK) { // it goes on from where it is
        piece.origin = bmr_world_time(s->world);
        piece.as.screw.start = state.pose;
    }
    const bmr_error error = bmr_world_set_piece(s->world, body, &piece);
    check_error(s, error, !there);
    FUZZ_CHECK(there || error != BMR_OK, "a body that is not there was moved");
}

static void change(script *s) {
    switch (fuzz_below(&s->bytes, 4)) {
    case 0:
        add(s);
        break;
    case 1: {
        const bmr_body body = any_body(s);
        const bool there = known(s, body);
        FUZZ_CHECK((bmr_world_remove(s->world, body) == BMR_OK) == there, "removed, or not");
        FUZZ_CHECK(!known(s, body), "it is still there");
        break;
    }
    default:
        move(s);
        break;
    }
}

/// B's pose where its image is that is nearest to A.
static bmr_pose nearest_image(const script *s, const bmr_pose *a, bmr_pose b) {
    const double width = 2.0 * s->size;
    if (s->boundary == BMR_PERIODIC) {
        b.position.x -= width * floor((b.position.x - a->position.x) / width + 0.5);
        b.position.y -= width * floor((b.position.y - a->position.y) / width + 0.5);
    }
    return b;
}

/// A contact is reported where the two are within the margin, up to some 16ths of it, and no sooner.
static void check_distance(const script *s, const bmr_contact *c) {
    const double margin = bmr_default_world_def().kds.margin;
    bmr_body_state a, b;
    bmr_closest_points closest;
    if (s->wild || bmr_is_wall(c->b) || bmr_world_get(s->world, c->a, &a) != BMR_OK ||
        bmr_world_get(s->world, c->b, &b) != BMR_OK)
        return;
    const bmr_pose pose = nearest_image(s, &a.pose, b.pose);
    if (bmr_distance(a.shape->polygon, &a.pose, b.shape->polygon, &pose, &closest) != BMR_OK)
        return;
    const double distance = closest.distance + (fuzz_control("early-contact") ? margin : 0.0);
    FUZZ_CHECK(distance <= 1.5 * margin, "a contact at %.17g, %g apart", c->time, distance);
}

static bmr_response answer(void *context, bmr_world *world, const bmr_contact *c) {
    script *s = context;
    FUZZ_CHECK(c->time >= s->last, "back in time");
    FUZZ_CHECK(bmr_world_advance(world, END) == BMR_ERROR_OUT_OF_RANGE, "advanced from inside");
    check_distance(s, c);
    s->last = c->time;
    if (s->contacts < MOST_CONTACTS) {
        const note kept = {c->a, c->b, c->time, c->points[0].x, c->points[0].y, c->approach[0]};
        s->notes[s->contacts] = kept;
    }
    s->contacts++;
    bmr_response response = {BMR_RESPONSE_IMPULSE, 1.0};
    const uint8_t how = fuzz_u8(&s->bytes);
    if (how < 32)
        response.kind = BMR_RESPONSE_PASS;
    else if (how < 80)
        response.restitution = how / 80.0;
    else if (how < 112)
        change(s);
    else if (how < 120) {
        response.kind = BMR_RESPONSE_MINE;
        change(s);
    }
    return response;
}

/// A world that has too many events is emptied, from inside of one.
static void count_events(void *context, bmr_world *world, const bmr_world_event *event) {
    script *s = context;
    if ((event->kind == BMR_WORLD_CROSS && !s->wild) || ++s->events < MOST_EVENTS)
        return;
    size_t place = 0;
    for (bmr_body body; (body = bmr_world_next_body(world, &place)) != BMR_NO_BODY;)
        FUZZ_CHECK(bmr_world_remove(world, body) == BMR_OK, "not removed");
}

// ---- what must hold ----

typedef struct passing {
    bmr_body a, b;
    bool passes;
} passing;

static void find_pair(void *context, const bmr_world_pair *pair) {
    passing *p = context;
    p->passes |= pair->a == p->a && pair->b == p->b && pair->watch == BMR_WATCH_PASSING;
    p->passes |= pair->a == p->b && pair->b == p->a && pair->watch == BMR_WATCH_PASSING;
}

static void check_overlaps(const script *s) {
    size_t first = 0;
    for (bmr_body a; (a = bmr_world_next_body(s->world, &first)) != BMR_NO_BODY;) {
        size_t second = first;
        bmr_body_state p, q;
        bmr_world_get(s->world, a, &p);
        for (bmr_body b; (b = bmr_world_next_body(s->world, &second)) != BMR_NO_BODY;) {
            bmr_world_get(s->world, b, &q);
            q.pose = nearest_image(s, &p.pose, q.pose);
            bmr_overlap overlap;
            if (bmr_penetration(p.shape->polygon, &p.pose, q.shape->polygon, &q.pose, &overlap) != BMR_OK ||
                overlap.depth < 1e-9)
                continue;
            passing pair = {a, b, false};
            bmr_world_each_pair(s->world, find_pair, &pair);
            if (fuzz_control("overlap"))
                pair.passes = false;
            FUZZ_CHECK(pair.passes, "%llu and %llu overlap by %g", (unsigned long long)a,
                       (unsigned long long)b, overlap.depth);
        }
    }
}

static void advance(script *s, double until) {
    bmr_error error = bmr_world_advance(s->world, until);
    for (int i = 0; i < (s->wild ? 1 : 50) && error == BMR_ERROR_STALLED; i++)
        error = bmr_world_advance(s->world, until);
    // Bodies that nothing stops against bodies that nothing moves can spin faster and faster.
    check_error(s, error == BMR_ERROR_STALLED ? BMR_OK : error, true);
}

static void run(script *s, const uint8_t *data, size_t size, bool all_pairs) {
    s->bytes = fuzz_bytes_make(data, size);
    s->shapes = make_shapes();
    s->last = -INFINITY;
    const uint8_t how = fuzz_u8(&s->bytes);
    s->wild = how >= 192;
    s->boundary = s->wild ? BMR_OPEN : (bmr_boundary)(how % 3);
    s->size = 6.0;
    bmr_world_def def = bmr_default_world_def();
    static const char *const structures[] = {"hybrid", "predict-adaptive"};
    FUZZ_CHECK(bmr_kds_find(structures[how / 3 % 2], &def.structure) == BMR_OK, "a structure");
    def.boundary = s->boundary;
    def.low = bmr_vec2_make(-s->size, -s->size);
    def.high = bmr_vec2_make(s->size, s->size);
    def.all_pairs = all_pairs;
    def.zeno = how / 6 % 2 ? BMR_ZENO_ELASTIC : BMR_ZENO_ERROR;
    def.contact = answer;
    def.observer = count_events;
    def.context = s;
    FUZZ_CHECK(bmr_world_create(&def, 0.0, NULL, &s->world) == BMR_OK, "a world");
    for (int i = 0; i < 3; i++)
        add(s);
    for (int i = 0; i < 30 && !fuzz_done(&s->bytes); i++) {
        change(s);
        if (fuzz_u8(&s->bytes) % 2)
            continue;
        const double now = bmr_world_time(s->world);
        advance(s, fmin(END, now + fuzz_in(&s->bytes, 0.0, 1.0)));
        if (s->wild || all_pairs)
            continue;
        const bmr_error audit =
            fuzz_control("audit") && i > 2 ? BMR_ERROR_FALSE_CERTIFICATE : bmr_world_audit(s->world);
        FUZZ_CHECK(audit == BMR_OK, "audit: %d", audit);
        check_overlaps(s);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static script grid, all;
    memset(&grid, 0, sizeof grid);
    memset(&all, 0, sizeof all);
    run(&grid, data, size, false);
    const bool full = grid.events >= MOST_EVENTS;
    bmr_world_destroy(grid.world);
    if (grid.wild)
        return 0;
    run(&all, data, size, true);
    bmr_world_destroy(all.world);
    if (full || all.events >= MOST_EVENTS)
        return 0;
    if (fuzz_control("other-bits") && all.contacts > 0)
        all.notes[0].time = nextafter(all.notes[0].time, INFINITY);
    if (fuzz_control("missed-contact") && all.contacts > 0)
        all.contacts--;
    FUZZ_CHECK(grid.contacts == all.contacts, "%zu contacts, %zu of all pairs", grid.contacts, all.contacts);
    for (size_t i = 0; i < grid.contacts && i < MOST_CONTACTS; i++)
        FUZZ_CHECK(memcmp(&grid.notes[i], &all.notes[i], sizeof grid.notes[i]) == 0,
                   "contact %zu: %.17g and %.17g", i, grid.notes[i].time, all.notes[i].time);
    return 0;
}
