// SPDX-License-Identifier: MIT
// One pass of one pair, event by event: each is checked against the geometry that gives it its name.
#include "boomerang/pair.h"
#include "checks.h"
#include "motions.h"
#include "polygons.h"

/// The farthest that anything moves in a step: what an event may come too late.
#define STEP 2e-5
#define STEPS 400000

typedef struct trace {
    test_pair of;
    bmr_pair before; ///< the state that the next event starts from
    double gap;      ///< that the last event left
    size_t seen[BMR_EVENT_KIND_COUNT];
    bool shown;
} trace;

/// The envelope of a level as a polygon.
static bmr_polygon *envelope(const bmr_hierarchy *h, int level) {
    const uint32_t depth = bmr_hierarchy_depth(h), on = (uint32_t)level < depth ? (uint32_t)level : depth;
    static bmr_vec2 points[4096];
    size_t count = 0;
    bmr_edge edge = 0;
    do {
        const bmr_corner corner = bmr_hierarchy_corner_after(h, edge, on);
        assert_true(count < sizeof points / sizeof *points);
        points[count++] = bmr_hierarchy_corner_point(h, corner);
        edge = corner.after;
    } while (edge != 0);
    return made_polygon(points, count);
}

/// The distance of the two envelopes of a level; of the two disks for level -1.
static double distance_on_level(const trace *t, int level, const bmr_pose *q) {
    if (level == BMR_LEVEL_DISKS) {
        const bmr_polygon *a = t->of.shape[0].polygon, *b = t->of.shape[1].polygon;
        const bmr_vec2 way = bmr_sub(bmr_transform(q, b->center), a->center);
        return fmax(0.0, hypot(way.x, way.y) - a->radius - b->radius);
    }
    const bmr_structure structure = t->of.def.structure;
    if (structure >= BMR_FREE_DIRECTION)
        return test_distance(t->of.shape[0].polygon, t->of.shape[1].polygon, q);
    own_polygon *a = envelope(t->of.shape[0].hierarchies[structure], level),
                *b = envelope(t->of.shape[1].hierarchies[structure], level);
    const double distance = test_distance(a, b, q);
    return distance;
}

static bmr_check look(const bmr_pair *pair, const bmr_pose *q, double *gap) {
    const bmr_pose inverse = bmr_pose_inverse(q);
    return bmr_certificate_check(&pair->certificate, pair->owner == 0 ? q : &inverse, 0.0, gap);
}

static void check_event(void *context, const bmr_event *event) {
    trace *t = context;
    const bmr_pair *now = event->pair, *was = &t->before;
    const double slop =
        BMR_PAIR_SLOP * (t->of.shape[0].polygon->extent + t->of.shape[1].polygon->extent) + STEP;
    const bool lazy = t->of.def.structure < BMR_FREE_DIRECTION;
    double gap = 0.0;
    ++t->seen[event->kind];
    if (t->shown && now->state == BMR_PAIR_APART && now->level != BMR_LEVEL_DISKS)
        printf("    %-8s level %2d -> %2d  %c's %3u faces %3u|%-3u gap %.2e\n", bmr_event_name(event->kind),
               event->level_before, event->level_after, now->owner == 0 ? 'A' : 'B', now->edge, now->other,
               now->other_after, event->gap);
    else if (t->shown)
        printf("    %-8s level %2d -> %2d\n", bmr_event_name(event->kind), event->level_before,
               event->level_after);
    // Whatever happened, a pair that is apart holds a proof at this pose, of the gap that is reported.
    if (now->state == BMR_PAIR_APART) {
        assert_int_equal(event->level_after, now->level);
        if (test_pair_audit(&t->of, event->pose) != BMR_OK)
            fail_msg("%s, level %d -> %d: the audit fails", bmr_event_name(event->kind), event->level_before,
                     event->level_after);
        assert_true(event->gap > 0.0);
        assert_true(event->gap <= distance_on_level(t, event->level_after, event->pose) + 1e-15);
    }
    switch (event->kind) {
    case BMR_EVENT_START:
        assert_int_equal(was->state, BMR_PAIR_NEW);
        break;
    case BMR_EVENT_PUSH: // the old line was crossed; the envelopes of the same level are still apart, by
                         // another line
        assert_int_equal(look(was, event->pose, &gap), BMR_CHECK_CROSSED);
        assert_int_equal(event->level_before, event->level_after);
        assert_true(distance_on_level(t, event->level_before, event->pose) > 0.0);
        assert_true(now->edge != was->edge || now->owner != was->owner || !lazy);
        break;
    case BMR_EVENT_STAB: // the envelopes of the old level touch, and of all levels before the new one
        assert_true(event->level_after > event->level_before);
        for (int level = event->level_before; level < event->level_after; ++level)
            assert_true(distance_on_level(t, level, event->pose) <= slop);
        break;
    case BMR_EVENT_ROLL: // the old direction has left its bracket, and the edge stays
        assert_int_equal(look(was, event->pose, &gap), BMR_CHECK_ROLLED);
        if (lazy && !now->free) {
            assert_true(now->edge == was->edge && now->owner == was->owner);
            assert_true(now->other != was->other || now->other_after != was->other_after);
        }
        break;
    case BMR_EVENT_COARSEN: // one level up, and apart there by a fair part of what was proved before
        assert_int_equal(event->level_after, event->level_before - 1);
        assert_true(distance_on_level(t, event->level_after, event->pose) > 0.0);
        assert_true(event->gap >= 0.25 * t->gap - slop);
        break;
    case BMR_EVENT_CONTACT: // hand-over: the polygons themselves touch
        assert_int_equal(now->state, BMR_PAIR_CONTACT);
        assert_true(distance_on_level(t, event->level_after, event->pose) <= slop);
        assert_true(test_distance(t->of.shape[0].polygon, t->of.shape[1].polygon, event->pose) <= slop);
        break;
    case BMR_EVENT_LEAVE:
        assert_int_equal(was->state, BMR_PAIR_CONTACT);
        assert_true(test_distance(t->of.shape[0].polygon, t->of.shape[1].polygon, event->pose) > 0.0);
        break;
    case BMR_EVENT_HANDOVER: // the free direction failed, and the coarse line separates
        assert_true(was->free && !now->free);
        assert_int_equal(now->other_after, was->other_after); // the line that was remembered at the repair
        assert_true(look(was, event->pose, &gap) != BMR_CHECK_HOLDS && event->gap > 0.0);
        break;
    case BMR_EVENT_KIND_COUNT:
    default:
        fail_msg("not to be reached");
    }
    t->before = *now;
    t->gap = event->gap;
}

static bmr_polygon *body(size_t n, double flatness) {
    bmr_vec2 points[64];
    assert_true(n <= 64);
    for (size_t i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * ((double)i + 0.21) / (double)n;
        points[i] = bmr_vec2_make(cos(angle), flatness * sin(angle));
    }
    return made_polygon(points, n);
}

static trace begin(bmr_structure structure, bool shown) {
    trace t = {.of = test_pair_make(structure, body(48, 0.35), body(33, 0.6)), .shown = shown};
    t.before = t.of.pair;
    return t;
}
static void end(trace *t) {
    test_pair_destroy(&t->of);
}
#define own_trace OWNED(end) trace

/// In from afar, slowly turning, a short dive into the other body, out again, and away.
static bmr_pose pass(int i) {
    const double t = 2.0 * i / STEPS - 1.0, angle = 1.2 * t + 0.4;
    const bmr_pose q = {{2.6 * t, 0.62 + 0.75 * t * t}, cos(angle), sin(angle)};
    return q;
}

TEST(every_event_of_a_pass_is_what_its_name_says) {
    for (bmr_structure s = 0; s < BMR_STRUCTURE_COUNT; ++s) {
        own_trace t = begin(s, true);
        printf("  %s\n", bmr_structure_name(s));
        bmr_counters counters = {0};
        const bmr_observer observer = {&counters, check_event, &t};
        for (int i = 0; i <= STEPS; ++i) {
            const bmr_pose q = pass(i);
            bmr_pair_advance(&t.of.pair, &t.of.def, &t.of.shape[0], &t.of.shape[1], &q, &observer, NULL);
        }
        for (int kind = 0; kind < BMR_EVENT_KIND_COUNT; ++kind) {
            assert_int_equal(counters.events[kind], t.seen[kind]); // counted and told alike
            const bool other = kind == BMR_EVENT_HANDOVER && s != BMR_TWO_LINES;
            assert_int_equal(other && t.seen[kind] > 0, false);
            assert_true(t.seen[kind] > 0 || other || (s >= BMR_FREE_DIRECTION && kind == BMR_EVENT_PUSH));
        }
        assert_int_equal(t.seen[BMR_EVENT_START], 1);
        assert_int_equal(t.seen[BMR_EVENT_CONTACT], t.seen[BMR_EVENT_LEAVE]);
        assert_int_equal(t.of.pair.level, BMR_LEVEL_DISKS); // as it came
    }
}

/// The control: the checks above do tell one event from another.
TEST(levels_that_are_apart_do_not_pass_for_touching) {
    own_trace t = begin(BMR_LAZY_COMPASS, false);
    size_t separate = 0, touching = 0;
    for (int i = 0; i <= STEPS; i += STEPS / 100) {
        const bmr_pose q = pass(i);
        double last = -1.0;
        for (int level = BMR_LEVEL_DISKS + 1; level < 8; ++level) {
            const double distance = distance_on_level(&t, level, &q);
            assert_true(distance >= last - 1e-12); // finer envelopes are never nearer
            last = distance;
            separate += distance > 1e-3;
            touching += distance == 0.0;
        }
    }
    assert_true(separate > 50 && touching > 50);
}
