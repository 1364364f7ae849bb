// SPDX-License-Identifier: MIT
// What is proved of the free-direction structures under translation (docs/open-question.md): an event leaves
// no more distance than its place on the line times the sine of the turn; on a path that bends away distance
// and slope of approach together are down to a quarter; so events are few.
#include "checks.h"
#include "driven.h"
#include "hierarchies.h"
#include "motions.h"

/// The vertices and the distance are double; slopes of the path near zero are not looked at.
#define ROUNDING 1e-6
#define LEAST_SLOPE 1e-7

/// A path that bends away costs at most log2(D/sigma) and this: 5 + log4(6).
#define COUNT_BEYOND_LOG 6.3

typedef struct approach {
    const bmr_polygon *a, *b;
    double distance, slope; ///< at the last event; slope 0: there is none
    double worst_product;   ///< of d's' / (ds)
    double worst_sum;       ///< of d'/d + s'/s
    double worst_claim;     ///< of certified slack - true separation
    bmr_vec2 foot, u;       ///< at the last event: c and u, of the configuration point; once `known`
    bool known;
    double worst_lemma; ///< of d' / (X sin theta)
    double worst_count; ///< of events - log2(D/sigma)
    unsigned pairs;
} approach;

static void look(void *context, const test_drive_event *event) {
    approach *p = context;
    bmr_kds_proof proof;
    if (!bmr_kds_get_proof(event->kds, &proof)) {
        p->slope = 0.0;
        p->known = false;
        return;
    }
    const double margin = bmr_default_kds_def().margin;
    const double distance = test_distance(p->a, p->b, &event->now.pose) - margin;
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const size_t count = bmr_kds_conditions(event->kds, conditions);
    for (size_t i = 0; i < count; ++i)
        if (conditions[i].kind == BMR_CONDITION_BEYOND) {
            const double slack = bmr_condition_value(&conditions[i], &event->now.pose);
            // Some corner's slack is the certificate's; the least of them is.
            double least = slack;
            for (size_t j = 0; j < count; ++j)
                if (conditions[j].kind == BMR_CONDITION_BEYOND)
                    least = fmin(least, bmr_condition_value(&conditions[j], &event->now.pose));
            p->worst_claim = fmax(p->worst_claim, least - distance);
            break;
        }
    const bmr_vec2 u =
        proof.owner == 0 ? proof.line.normal : bmr_neg(bmr_rotate(&event->now.pose, proof.line.normal));
    if (p->known && event->report.line_changed && distance > ROUNDING) {
        const bmr_vec2 on_line = bmr_sub(event->now.pose.position, p->foot);
        p->worst_lemma =
            fmax(p->worst_lemma, distance / (hypot(on_line.x, on_line.y) * fabs(bmr_cross(p->u, u))));
    }
    p->known = true;
    p->u = u;
    p->foot = bmr_sub(event->now.pose.position, bmr_scale(distance, u));
    const double slope =
        -bmr_dot(u, event->now.velocity) / hypot(event->now.velocity.x, event->now.velocity.y);
    if (p->slope > LEAST_SLOPE && slope > LEAST_SLOPE && event->report.line_changed) {
        const double d = distance / p->distance, s = slope / p->slope;
        p->worst_product = fmax(p->worst_product, d * s);
        p->worst_sum = fmax(p->worst_sum, d + s);
        ++p->pairs;
    }
    p->distance = distance;
    p->slope = slope;
}

/// D/sigma, at least 1. D is of the sum that is blown up by the margin, sigma the least gap.
static double ratio_of(const approach *p, double nearest) {
    const double margin = bmr_default_kds_def().margin;
    return fmax(1.0, (test_diameter(p->a) + test_diameter(p->b) + 2.0 * margin) / (nearest - margin));
}

static approach drive(const char *name, test_path_kind kind, size_t rounds, uint64_t seed) {
    approach p = {0};
    p.worst_claim = -INFINITY;
    p.worst_count = -INFINITY;
    test_random random = test_random_from(seed);
    for (size_t round = 0; round < rounds; ++round) {
        own_kds_body a = test_kds_body_make(
            test_polygon((test_family)test_random_below(&random, TEST_LENS + 1), 40, &random));
        own_kds_body b = test_kds_body_make(
            test_polygon((test_family)test_random_below(&random, TEST_LENS + 1), 40, &random));
        const double gap =
            (a.polygon->radius + b.polygon->radius) * pow(10.0, -test_random_uniform(&random, 0.0, 4.0));
        const test_path path = test_path_make(kind, a.polygon, b.polygon, gap, false, &random);
        p.a = a.polygon;
        p.b = b.polygon;
        p.slope = 0.0;
        p.known = false;
        const test_drive d = {.path = &path, .stop_at_contact = true, .on_event = look, .context = &p};
        const test_drive_result r = driven(name, &a, &b, &d);
        const unsigned events = (unsigned)test_drive_events(&r);
        p.worst_count = fmax(p.worst_count, events - log2(ratio_of(&p, r.nearest)));
    }
    return p;
}

/// So the free direction has at most log2(D/sigma) + 6.3 events there.
TEST(distance_times_slope_drops_to_a_quarter_on_convex_paths) {
    const test_path_kind convex[] = {TEST_PATH_LINE, TEST_PATH_PARABOLA};
    for (size_t c = 0; c < 2; ++c) {
        const approach p = drive("free-fd2", convex[c], test_scaled(150), 3 + c);
        assert_true(p.pairs > 20);
        assert_true(p.worst_sum <= 1.0 + ROUNDING);
        assert_true(p.worst_product <= 0.25 + ROUNDING);
        assert_true(p.worst_count <= COUNT_BEYOND_LOG);
    }
}

/// The control: an orbit is not convex, and there each event is like the one before.
TEST(it_does_not_on_an_orbit) {
    const approach p = drive("free-fd2", TEST_PATH_ORBIT, 10, 5);
    assert_true(p.worst_product > 0.5);
    assert_true(p.worst_sum > 1.5);
}

TEST(the_distance_left_is_at_most_the_place_times_the_sine) {
    const test_path_kind any[] = {TEST_PATH_CUBIC, TEST_PATH_ORBIT, TEST_PATH_WANDER};
    for (size_t c = 0; c < sizeof any / sizeof *any; ++c) {
        const approach p = drive("free-fd2", any[c], test_scaled(20), 21 + c);
        assert_true(p.worst_lemma > 0.5 && p.worst_lemma <= 1.0 + ROUNDING);
    }
    // The control: lines across other directions.
    assert_true(drive("predict-adaptive", TEST_PATH_ORBIT, 20, 21).worst_lemma > 1.0 + 1e-3);
}

#define PI 3.14159265358979323846
#define CHAIN 12

/// A polygon for the straight path from (0, 1) that falls by 45 degrees: there each event halves distance and
/// slope. Returns how far the path goes until the last of CHAIN events.
static double chain_points(bmr_vec2 points[CHAIN + 3]) {
    double angle = PI / 4.0, distance = 1.0, turned = 0.0, length = 0.0;
    points[0] = bmr_vec2_make(0.0, 0.0);
    for (int i = 0; i < CHAIN; ++i) {
        // The path meets the line through the corner at `place`; the edge to the next corner has turned by
        // half of the angle between path and line.
        const double place = distance / tan(angle), theta = angle / 2.0;
        length += distance / sin(angle);
        turned += theta;
        const bmr_vec2 along = {cos(turned), -sin(turned)};
        points[i + 1] = bmr_add(points[i], bmr_scale(place * cos(theta), along));
        distance = place * sin(theta);
        angle -= theta;
    }
    const bmr_vec2 last = points[CHAIN];
    points[CHAIN + 1] = bmr_vec2_make(last.x, last.y - 1.0);
    points[CHAIN + 2] = bmr_vec2_make(0.0, last.y - 1.0);
    return length + 0.5 * distance / sin(angle);
}

/// The factor 1 of log2 is the best there is.
TEST(a_chain_costs_as_many_events_as_are_proved) {
    bmr_vec2 points[CHAIN + 3];
    const double way = chain_points(points) * sqrt(0.5);
    bmr_polygon *polygon = made_polygon(points, CHAIN + 3);
    own_kds_body a = test_kds_body_make(polygon), b = test_kds_point_make(0.0, 0.0);
    const test_path path = {.cubic = {{0.0, 1.0}, {way, -way}}};
    const test_drive d = {.path = &path};
    const test_drive_result r = driven("free-fd2", &a, &b, &d);
    const approach p = {.a = a.polygon, .b = b.polygon};
    const double bound = log2(ratio_of(&p, r.nearest));
    const unsigned events = (unsigned)test_drive_events(&r);
    assert_true(events >= CHAIN && events <= bound + COUNT_BEYOND_LOG);
    assert_true(events > 0.5 * bound + 2.0); // what was measured on smooth shapes is no bound
}

TEST(no_certificate_claims_more_than_the_separation) {
    const approach p = drive("free-fd2", TEST_PATH_WANDER, test_scaled(20), 8);
    assert_true(p.worst_claim <= ROUNDING);
    // It is exact at an event, up to rounding: a claim of much less would be no closest direction.
    assert_true(p.worst_claim >= -ROUNDING);
}

/// What rotational hysteresis rests on, over all events of FD2 (gamma 0.3): the least slack over the gap, and
/// the least way to an end of the bracket over what a quarter of the short side's cost, 1/16 of gamma g,
/// pays.
typedef struct hold {
    const bmr_polygon *a, *b;
    double least_slack, least_turn;
    unsigned events;
} hold;
#define GAMMA 0.3
#define SHORT_PART (GAMMA / 16.0)
#define WIDEST_SHORT (PI / 12.0)

static void check_hold(void *context, const test_drive_event *event) {
    hold *h = context;
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const size_t count = bmr_kds_conditions(event->kds, conditions);
    bmr_kds_proof proof;
    if (!event->report.line_changed || !bmr_kds_get_proof(event->kds, &proof))
        return;
    const double gap = test_distance(h->a, h->b, &event->now.pose) - bmr_default_kds_def().margin;
    const double diameter = test_diameter(proof.owner == 0 ? h->b : h->a);
    const double turn = fmin(WIDEST_SHORT, 2.0 * atan(0.5 * SHORT_PART * gap / diameter));
    for (size_t i = 0; i < count; ++i) {
        const double value = bmr_condition_value(&conditions[i], &event->now.pose);
        if (conditions[i].kind == BMR_CONDITION_BEYOND)
            h->least_slack = fmin(h->least_slack, value / gap);
        else // a sine, of no more than a right angle
            h->least_turn = fmin(h->least_turn, value / sin(turn));
    }
    ++h->events;
}

static hold hold_of(const char *name) {
    hold h = {NULL, NULL, INFINITY, INFINITY, 0};
    test_random random = test_random_from(41);
    // As many at every scale: the controls look for the worst that can be met.
    for (size_t round = 0; round < 120; ++round) {
        own_kds_body a = test_kds_body_make(
            test_polygon((test_family)test_random_below(&random, TEST_FAMILY_COUNT), 40, &random));
        own_kds_body b = test_kds_body_make(
            test_polygon((test_family)test_random_below(&random, TEST_FAMILY_COUNT), 40, &random));
        const double gap =
            (a.polygon->radius + b.polygon->radius) * pow(10.0, -test_random_uniform(&random, 0.0, 3.0));
        const test_path path = test_path_make(TEST_PATH_WANDER, a.polygon, b.polygon, gap, true, &random);
        h.a = a.polygon;
        h.b = b.polygon;
        const test_drive d = {.path = &path, .on_event = check_hold, .context = &h, .stop_at_contact = true};
        driven(name, &a, &b, &d);
    }
    return h;
}

TEST(two_corners_leave_slack_and_room_on_both_sides) {
    const hold fd2 = hold_of("free-fd2");
    assert_true(fd2.events > 100);
    assert_true(fd2.least_slack >= 1.0 - GAMMA - ROUNDING);
    assert_true(fd2.least_turn >= 1.0 - ROUNDING);
    assert_true(hold_of("predict-adaptive").least_turn < 0.1); // the control: the body's own vertices
}
