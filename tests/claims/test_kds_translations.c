// SPDX-License-Identifier: MIT
// Algebraic translation (docs/open-question.md, Lemma A): the line across the closest points stands while any
// two support lines that bracket it stand. So each failure of it is paid for by one of N + 12 directions, and
// each of these fails at most ceil(a/2) times where heights have at most a zeros. Also what becomes of a spin
// that is over, and where coarse lines of bodies that turn fail (Lemma C).
#include "checks.h"
#include "driven.h"
#include "hierarchies.h"
#include "kds/structure.h"
#include "kds/windowed_line.h"
#include "motions.h"

#define PI 3.14159265358979323846
#define MARGIN 1e-9
#define MOST_DIRECTIONS 200
/// Times at which a failure is found, and slacks, are exact up to this part of the extents.
#define ROUNDING 1e-7

/// Directions that do not turn, in A's frame, with the support of the two bodies' sum at the start.
typedef struct directions {
    size_t count;
    bmr_vec2 w[MOST_DIRECTIONS];
} directions;

static void add(directions *d, bmr_vec2 w) {
    assert_true(d->count < MOST_DIRECTIONS);
    d->w[d->count++] = w;
}

/// The normals of both bodies' edges, the axes of both frames, and A's diagonals: N + 12.
static directions all_directions(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *pose) {
    directions d = {0};
    for (uint32_t i = 0; i < a->count && a->count > 1; ++i)
        add(&d, bmr_polygon_normal(a, i));
    for (uint32_t i = 0; i < b->count && b->count > 1; ++i)
        add(&d, bmr_neg(bmr_rotate(pose, bmr_polygon_normal(b, i))));
    for (int k = 0; k < 8; ++k)
        add(&d, bmr_vec2_make(cos(0.25 * PI * k), sin(0.25 * PI * k)));
    for (int k = 0; k < 4; ++k)
        add(&d, bmr_rotate(pose, bmr_vec2_make(cos(0.5 * PI * k), sin(0.5 * PI * k))));
    return d;
}

/// The control: three lines.
static directions three_directions(void) {
    directions d = {0};
    for (int k = 0; k < 3; ++k)
        add(&d, bmr_vec2_make(cos(0.1 + 2.0 * PI / 3.0 * k), sin(0.1 + 2.0 * PI / 3.0 * k)));
    return d;
}

/// Is every failure paid for? `stood`: at the last choice of a line.
typedef struct account {
    directions all, three;
    directions stood, stood_of_three;
    directions bracket, one; ///< the two that stood next to the line, on either side; one of them alone
    bool known;
    double slop;
    size_t steps, unpaid, unpaid_by_bracket, unpaid_by_one, unpaid_by_three;
} account;

static bool stands(const test_drive_event *event, bmr_vec2 w, double slop) {
    return bmr_kds_separation(event->kds, &event->now.pose, w) > MARGIN + slop;
}

/// Has one of them failed?
static bool pays(const directions *d, const test_drive_event *event, double slop) {
    bool some = false;
    for (size_t i = 0; i < d->count; ++i)
        some = some || !stands(event, d->w[i], slop);
    return some;
}

/// Those that stand.
static directions standing(const directions *d, const test_drive_event *event) {
    directions s = {0};
    for (size_t i = 0; i < d->count; ++i)
        if (stands(event, d->w[i], 0.0))
            add(&s, d->w[i]);
    return s;
}

/// From A to B, in A's frame.
static bmr_vec2 direction_of_line(const test_drive_event *event) {
    bmr_kds_proof proof;
    assert_true(bmr_kds_get_proof(event->kds, &proof));
    return proof.owner == 0 ? proof.line.normal : bmr_neg(bmr_rotate(&event->now.pose, proof.line.normal));
}

/// Adds the one next to `u` on a side (1: counter-clockwise), itself included, within half a turn.
static void add_next(directions *to, const directions *of, bmr_vec2 u, int side) {
    const double same = 1e-9;
    size_t next = of->count;
    double least = PI;
    for (size_t i = 0; i < of->count; ++i) {
        const double angle = side * atan2(bmr_cross(u, of->w[i]), bmr_dot(u, of->w[i]));
        if (angle > -same && angle < least) {
            least = angle;
            next = i;
        }
    }
    if (next < of->count)
        add(to, of->w[next]);
}

static void look(void *context, const test_drive_event *event) {
    account *c = context;
    if (c->known) {
        ++c->steps;
        c->unpaid += !pays(&c->stood, event, c->slop);
        c->unpaid_by_bracket += !pays(&c->bracket, event, c->slop);
        c->unpaid_by_one += !pays(&c->one, event, c->slop);
        c->unpaid_by_three += !pays(&c->stood_of_three, event, c->slop);
    }
    c->known = event->report.apart;
    if (!c->known)
        return;
    c->stood = standing(&c->all, event);
    c->stood_of_three = standing(&c->three, event);
    const bmr_vec2 u = direction_of_line(event);
    c->one = c->bracket = (directions){0};
    add_next(&c->one, &c->stood, u, 1);
    add_next(&c->bracket, &c->stood, u, 1);
    add_next(&c->bracket, &c->stood, u, -1);
}

/// The most of each bound that a run used, and of all steps how many were not paid for.
typedef struct used {
    double by_vertices[3], by_roots;
    size_t steps, unpaid, unpaid_by_bracket, unpaid_by_one, unpaid_by_three;
} used;

static void follow(const test_kds_body *a, const test_kds_body *b, const test_path *path, double fails,
                   used *u) {
    static const char *const names[] = {"free-fd2", "hybrid", "two-lines"};
    const double n = (double)a->polygon->count + b->polygon->count;
    for (int k = 0; k < 3; ++k) {
        const bmr_pose start = test_path_at(path, 0.0).pose;
        account c = {.all = all_directions(a->polygon, b->polygon, &start), .three = three_directions()};
        c.slop = ROUNDING * (a->polygon->extent + b->polygon->extent);
        const test_drive how = {.path = path,
                                .audit_every = 1000,
                                .margin = MARGIN,
                                .stop_at_contact = true,
                                .on_event = look,
                                .context = &c};
        const test_drive_result r = driven(names[k], a, b, &how);
        if (r.events[BMR_KDS_CONTACT] > 0)
            return;
        const double events = (double)test_drive_events(&r);
        assert_true(events <= fails * (n + 12.0));
        u->by_vertices[k] = fmax(u->by_vertices[k], events / (fails * (n + 12.0)));
        u->steps += c.steps;
        u->unpaid += c.unpaid;
        u->unpaid_by_bracket += c.unpaid_by_bracket;
        u->unpaid_by_one += c.unpaid_by_one;
        u->unpaid_by_three += c.unpaid_by_three;
        const double diameter = test_diameter(a->polygon) + test_diameter(b->polygon) + 2.0 * MARGIN;
        const double roots = fails * (9.0 * sqrt(fmax(1.0, diameter / (r.nearest - MARGIN))) + 1.0);
        const double repairs = events - (double)r.events[BMR_KDS_HANDOVER];
        if (k != 1) {
            assert_true(repairs <= roots);
            u->by_roots = fmax(u->by_roots, repairs / roots);
        }
        assert_true(events <= 2.0 * repairs + 1.0);
    }
}

/// Section 7, open question: hysteresis, path-sensitivity and all bounds, in one structure of linear size.
TEST(each_failure_under_translation_is_paid_for_by_a_direction_that_fails) {
    test_random random = test_random_from(48);
    used u = {0};
    for (size_t i = 0; i < test_scaled(600); ++i) {
        test_kds_body body[2];
        for (int k = 0; k < 2; ++k)
            body[k] =
                test_kds_body_make(test_polygon((test_family)test_random_below(&random, TEST_LENS + 1),
                                                3 + test_random_below(&random, i % 3 ? 6 : 60), &random));
        const double gap = (body[0].polygon->radius + body[1].polygon->radius) *
                           pow(10.0, -test_random_uniform(&random, 0.0, 5.0));
        const bool straight = i % 4 == 0;
        const test_path path = test_path_make(straight ? TEST_PATH_LINE : TEST_PATH_CUBIC, body[0].polygon,
                                              body[1].polygon, gap, false, &random);
        follow(&body[0], &body[1], &path, straight ? 1.0 : 2.0, &u);
        for (int k = 0; k < 2; ++k)
            test_kds_body_destroy(&body[k]);
    }
    printf("%zu steps, %zu unpaid, by brackets %zu, by one of the two %zu, by three lines %zu; of ceil(a/2) "
           "(N + 12): free-fd2 %.3f, hybrid %.3f, "
           "two-lines %.3f; of the roots %.3f\n",
           u.steps, u.unpaid, u.unpaid_by_bracket, u.unpaid_by_one, u.unpaid_by_three, u.by_vertices[0],
           u.by_vertices[1], u.by_vertices[2], u.by_roots);
    assert_int_equal(u.unpaid, 0);
    assert_int_equal(u.unpaid_by_bracket, 0);
    // The worst of 4800 motions was 0.182, 0.238, 0.250 and 0.119.
    assert_true(u.by_vertices[0] <= 0.201 && u.by_vertices[1] <= 0.262 && u.by_vertices[2] <= 0.275);
    assert_true(u.by_roots <= 0.131);
    assert_true(u.unpaid_by_one > u.steps / 10); // controls
    assert_true(u.unpaid_by_three > u.steps / 10);
}

/// Takes a structure along an orbit after a spin, given the spin `given` at each repair; the least slack over
/// the gap after each repair but the first.
static double slack_after_spin(const char *name, double given, size_t *repairs) {
    test_random random = test_random_from(49);
    own_kds_body a = test_kds_body_make(test_polygon(TEST_ELLIPSE, 60, &random)),
                 b = test_kds_body_make(test_polygon(TEST_REGULAR, 40, &random));
    bmr_kds_def def = bmr_default_kds_def();
    def.margin = MARGIN;
    own_kds *kds = made_kds(test_structure(name), &def, &a.shape, &b.shape);
    bmr_kds_report report;
    double least = INFINITY;
    for (int i = 0; i <= 40000; ++i) {
        const double angle = 2.0 * PI * i / 40000.0;
        const bmr_instant now = {test_pose_at(a.polygon, b.polygon, angle, 1.0, 0.05),
                                 {-sin(angle), cos(angle)},
                                 i == 0 ? 0.7 : given};
        bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
        if (i == 0) {
            bmr_kds_start(kds, &now, &report);
            assert_true(report.apart);
            continue;
        }
        const size_t count = bmr_kds_conditions(kds, conditions);
        size_t failed = count;
        for (size_t k = 0; k < count && failed == count; ++k)
            if (!(bmr_condition_value(&conditions[k], &now.pose) > 0.0))
                failed = k;
        if (failed == count)
            continue;
        bmr_kds_repair(kds, &now, failed, &report);
        assert_true(report.apart);
        if (report.kind == BMR_KDS_HANDOVER || ++*repairs == 1)
            continue;
        double slack = INFINITY;
        const size_t of_new = bmr_kds_conditions(kds, conditions);
        for (size_t k = 0; k < of_new; ++k)
            if (conditions[k].kind == BMR_CONDITION_BEYOND)
                slack = fmin(slack, bmr_condition_value(&conditions[k], &now.pose));
        least = fmin(least, slack / (test_distance(a.polygon, b.polygon, &now.pose) - MARGIN));
    }
    return least;
}

TEST(a_spin_that_is_over_is_forgotten) {
    static const char *const names[] = {"free-fd2", "hybrid", "two-lines"};
    for (int k = 0; k < 3; ++k) {
        size_t repairs = 0, controls = 0;
        const double forgotten = slack_after_spin(names[k], 0.0, &repairs),
                     leaning = slack_after_spin(names[k], 1e-12, &controls);
        printf("%s: slack over gap %.4f after a spin, %.4f while it is given\n", names[k], forgotten,
               leaning);
        assert_true(repairs > 5 && forgotten >= 0.99);
        assert_true(controls > 5 && leaning < 0.95); // the control
    }
}

/// Failures of coarse lines: at no parallel edge and no vertex on the line, but a right angle after the pick.
typedef struct angles {
    const bmr_polygon *bodies[2];
    bmr_vec2 picked; ///< in the other body's frame
    int owner;
    bool known;
    size_t failures, right, odd;
} angles;

static bmr_vec2 facing(const bmr_kds_proof *proof, const bmr_pose *pose) {
    return proof->owner == 0 ? bmr_unrotate(pose, bmr_neg(proof->line.normal))
                             : bmr_rotate(pose, bmr_neg(proof->line.normal));
}

static void check_angle(void *context, const test_drive_event *event) {
    angles *c = context;
    bmr_kds_proof proof;
    if (c->known && event->failed.kind == BMR_CONDITION_TURN) {
        // The direction at the failure, in the other's frame: an end of the bracket.
        const bmr_polygon *other = c->bodies[1 - c->owner];
        const bmr_vec2 end = event->failed.point;
        bool parallel = false;
        for (uint32_t i = 0; i < other->count; ++i)
            parallel = parallel || fabs(bmr_cross(bmr_polygon_normal(other, i), end)) < 1e-9;
        ++c->failures;
        if (!parallel) {
            const bool right = fabs(bmr_dot(c->picked, end)) < 1e-9;
            c->right += right;
            c->odd += !right;
        }
    }
    c->known = bmr_kds_get_proof(event->kds, &proof);
    if (c->known) {
        c->owner = proof.owner;
        c->picked = facing(&proof, &event->now.pose);
    }
}

/// Lemma C: picks that fail at a right angle take a right angle of turning each.
TEST(a_coarse_line_fails_at_parallel_edges_or_at_right_angles) {
    const bmr_vec2 ends[] = {{-1.0, 0.0}, {1.0, 0.0}},
                   corners[] = {{0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}, {0.5, -0.5}};
    own_kds_body a = test_kds_body_make(made_polygon(ends, 2)),
                 b = test_kds_body_make(made_polygon(corners, 4));
    const double turns = 10.0;
    size_t right = 0;
    for (int i = 0; i < 8; ++i) {
        test_path path = {
            .cubic = {{0.1 * i, 1.3 + 0.2 * i}}, .angle = 0.1 + 0.3 * i, .spin = 2.0 * PI * turns};
        angles c = {.bodies = {a.polygon, b.polygon}};
        const test_drive how = {.path = &path, .margin = MARGIN, .on_event = check_angle, .context = &c};
        driven("coarse", &a, &b, &how);
        assert_int_equal(c.odd, 0);
        assert_true((double)c.right <= 4.0 * turns);
        right += c.right;
        printf("%zu failures at ends of brackets, %zu of them at right angles\n", c.failures, c.right);
    }
    assert_true(right > 0); // so Lemma C without them is false of the code
}
