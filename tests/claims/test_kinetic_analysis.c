// SPDX-License-Identifier: MIT
// The optimum covers and is small, clear decompositions bracket a known size, fits find known growth, and the
// adversaries cost the rivals what the paper says.
#include "adversaries.h"
#include "checks.h"
#include "course_stage.h"

#include "failing_allocator.h"
#include "kds/structure.h"
#include "polygons.h"

#define PI 3.14159265358979323846
#define MARGIN 1e-6

/// The separation along a direction fixed in a body's frame, towards the other: brute force over all
/// vertices.
static double brute_separation(const bmr_course *course, double time, int owner, bmr_vec2 direction) {
    const bmr_pose pose = relative_at(course->motions, time);
    const bmr_vec2 u = owner == 0 ? direction : bmr_neg(bmr_rotate(&pose, direction));
    const bmr_polygon *a = course->polygons[0], *b = course->polygons[1];
    double most = -INFINITY, least = INFINITY;
    for (uint32_t i = 0; i < a->count; i++)
        most = fmax(most, bmr_dot(u, a->vertices[i]));
    for (uint32_t i = 0; i < b->count; i++)
        least = fmin(least, bmr_dot(u, bmr_transform(&pose, b->vertices[i])));
    return least - most;
}

/// The least separation of a cover line over its time, sampled.
static double cover_line_separation(const bmr_course *course, const bmr_cover_line *line, int samples) {
    double least = INFINITY;
    for (int k = 0; k <= samples; k++) {
        const double time = line->from + (line->to - line->from) * k / samples;
        least = fmin(least, brute_separation(course, time, line->owner, line->direction));
    }
    return least;
}

static bmr_course course_of(const bmr_family_motion *m, const bmr_polygon *a, const bmr_polygon *b) {
    const bmr_course course = {{a, b}, {m->motions[0], m->motions[1]}, 0.0, 1.0};
    return course;
}

TEST(test_optimum_of_convex_passes_and_of_a_spin_is_1) {
    static const bmr_family families[] = {BMR_FAMILY_LINE, BMR_FAMILY_PARABOLA, BMR_FAMILY_SPIN};
    for (size_t k = 0; k < 3; k++)
        for (uint64_t seed = 0; seed < 3; seed++)
            for (int step = 0; step < 3; step++) {
                const double ratio = 4.0 * pow(16.0, step);
                own_polygon *a = ngon(BMR_NGON_ELLIPSE, 64, seed), *b = ngon(BMR_NGON_DISC, 40, seed);
                own_family m = family_motion(families[k], ratio, seed, a, b);
                const bmr_course course = course_of(&m, a, b);
                bmr_optimum optimum;
                assert_int_equal(bmr_offline_optimum(&course, MARGIN, 0.02, NULL, 0, &optimum), BMR_OK);
                if (optimum.found != 1)
                    printf("%s, ratio %g, seed %d: %d to %d\n", bmr_family_name(families[k]), ratio,
                           (int)seed, (int)optimum.least, (int)optimum.found);
                assert_int_equal(optimum.least, 1);
                assert_int_equal(optimum.found, 1);
                assert_int_equal(optimum.contacts, 0);
            }
}

#define MOST_LINES 4096

static void check_cover(const bmr_course *course, const bmr_cover_line *lines, uint64_t count) {
    assert_true(count <= MOST_LINES);
    double reached = course->from;
    for (uint64_t k = 0; k < count; k++) {
        assert_true(lines[k].from <= reached && lines[k].to >= lines[k].from);
        reached = lines[k].to;
        assert_true(cover_line_separation(course, &lines[k], 200) > MARGIN);
        // The control: the same line turned away does not separate.
        bmr_cover_line wrong = lines[k];
        wrong.direction = bmr_neg(wrong.direction);
        assert_true(cover_line_separation(course, &wrong, 200) < 0.0);
    }
    assert_true(reached == course->to);
}

TEST(test_covers_hold_at_times_between_samples_and_bounds_are_near) {
    bmr_cover_line *lines = malloc(MOST_LINES * sizeof *lines);
    for (int family = 0; family < BMR_FAMILY_COUNT; family++)
        for (int step = 1; step < 4; step++) {
            const double ratio = pow(8.0, step);
            own_polygon *a = ngon(BMR_NGON_ELLIPSE, 64, 1), *b = ngon(BMR_NGON_DISC, 40, 2);
            own_family m = family_motion((bmr_family)family, ratio, 3, a, b);
            const bmr_course course = course_of(&m, a, b);
            bmr_optimum optimum;
            assert_int_equal(bmr_offline_optimum(&course, MARGIN, 0.02, lines, MOST_LINES, &optimum), BMR_OK);
            check_cover(&course, lines, optimum.found);
            assert_true(optimum.least >= 1 && optimum.least <= optimum.found);
            // Each end of a cone loses 2 %: a certificate a twentieth of its life, and the last one's rest.
            assert_true((double)optimum.found <= 1.1 * (double)optimum.least + 2.0);
        }
    free(lines);
}

#define DIRECTIONS 720
/// Greedy over finitely many directions at finitely many times, by brute force.
static uint64_t brute_cover(const bmr_course *course, int samples) {
    bool alive[2][DIRECTIONS] = {{false}};
    uint64_t count = 0;
    for (int k = 0; k <= samples; k++) {
        const double time = course->from + (course->to - course->from) * k / samples;
        bool holds[2][DIRECTIONS], any = false;
        for (int owner = 0; owner < 2; owner++)
            for (int i = 0; i < DIRECTIONS; i++) {
                const bmr_vec2 u = {cos(2.0 * PI * i / DIRECTIONS), sin(2.0 * PI * i / DIRECTIONS)};
                holds[owner][i] = brute_separation(course, time, owner, u) >= MARGIN;
                any = any || (holds[owner][i] && alive[owner][i]);
            }
        count += any ? 0 : 1;
        for (int owner = 0; owner < 2; owner++)
            for (int i = 0; i < DIRECTIONS; i++)
                alive[owner][i] = any ? alive[owner][i] && holds[owner][i] : holds[owner][i];
    }
    return count;
}

TEST(test_optimum_agrees_with_brute_force_over_directions) {
    static const bmr_family families[] = {BMR_FAMILY_ALGEBRAIC, BMR_FAMILY_ORBIT, BMR_FAMILY_RIGID_ALGEBRAIC,
                                          BMR_FAMILY_TUMBLE};
    for (size_t k = 0; k < 4; k++) {
        own_polygon *a = ngon(BMR_NGON_ELLIPSE, 12, k), *b = ngon(BMR_NGON_REGULAR, 9, k);
        own_family m = family_motion(families[k], 6.0, k, a, b);
        const bmr_course course = course_of(&m, a, b);
        bmr_optimum optimum;
        assert_int_equal(bmr_offline_optimum(&course, MARGIN, 0.02, NULL, 0, &optimum), BMR_OK);
        const uint64_t brute = brute_cover(&course, 500);
        // Finitely many directions can only be worse; finitely many times only miss the last bit of a life.
        assert_true(brute + 1 >= optimum.least);
        assert_true((double)brute <= 1.15 * (double)optimum.found + 1.0);
    }
}

static bmr_polygon *point(void) {
    const bmr_vec2 origin = {0.0, 0.0};
    return made_polygon(&origin, 1);
}

TEST(test_contact_divides_a_cover) {
    own_polygon *a = ngon(BMR_NGON_REGULAR, 16, 1), *b = point();
    own_course course = course_past(a, b, -3.0, 0.3, 6.0, 0.0);
    bmr_cover_line lines[4];
    bmr_optimum optimum;
    assert_int_equal(bmr_offline_optimum(&course, MARGIN, 0.02, lines, 4, &optimum), BMR_OK);
    assert_int_equal(optimum.contacts, 1);
    assert_int_equal(optimum.least, 2);
    assert_int_equal(optimum.found, 2);
    assert_true(lines[0].to < 0.5 && lines[1].from > 0.5 && lines[1].to == 1.0);
}

/// A point that goes straight away from a point, from distance 1 to e^5: a disk with the segment [x, y] as
/// its diameter is clear if y / x <= (kappa + 1) / (kappa - 1), and so the smallest size is known.
TEST(test_clear_decomposition_of_a_ray_brackets_the_known_size) {
    own_polygon *a = point();
    own_course course = course_past(a, a, 1.0, 0.0, exp(5.0) - 1.0, 0.0);
    for (int step = 0; step < 7; step++) {
        const double kappa = 1.5 * pow(1.7, step);
        const double exact = ceil(5.0 / log((kappa + 1.0) / (kappa - 1.0)));
        // What the two greedy rules let pass: y - x <= 2 x / (kappa - 1), and y - x <= x / kappa.
        const double least = ceil(5.0 / log1p(2.0 / (kappa - 1.0))), found = ceil(5.0 / log1p(1.0 / kappa));
        bmr_clear clear;
        assert_int_equal(bmr_clear_decomposition(&course, kappa, 0.0, &clear), BMR_OK);
        assert_true((double)clear.least <= exact && exact <= (double)clear.found);
        // A step less in each segment at most: a twentieth of the radius.
        assert_true((double)clear.least >= 0.9 * least - 1.0 && (double)clear.least <= least);
        assert_true((double)clear.found >= found && (double)clear.found <= 1.15 * found + 1.0);
    }
}

/// Of a body that turns in place, a segment may turn by radius / diameter.
TEST(test_clear_decomposition_counts_rotation) {
    own_polygon *a = point();
    const bmr_pose start = {{1.0, 0.0}, 1.0, 0.0};
    own_course course = course_along(a, a, bmr_piece_screw(0.0, start, bmr_vec2_make(0.0, 0.0), 6.0 * PI));
    bmr_clear still, turning;
    assert_int_equal(bmr_clear_decomposition(&course, 3.0, 0.0, &still), BMR_OK);
    assert_int_equal(bmr_clear_decomposition(&course, 3.0, 2.0, &turning), BMR_OK);
    assert_int_equal(still.found, 1);
    const double found = 6.0 * PI * 2.0 * 3.0; // angle * diameter / (d / kappa)
    assert_true((double)turning.found >= found - 1.0 && (double)turning.found <= 1.15 * found + 1.0);
    assert_true(turning.least < turning.found && turning.least > 1);
}

TEST(test_hysteresis_takes_the_least_of_each_kind) {
    own_polygon *a = point();
    bmr_hysteresis h = bmr_hysteresis_make();
    const bmr_pose poses[] = {{{2.0, 0.0}, 1.0, 0.0},
                              {{2.0, 1.0}, 1.0, 0.0},            // 1 / 2
                              {{2.0, 1.0}, cos(0.1), sin(0.1)},  // 5 * 0.1 / sqrt 5
                              {{2.5, 1.0}, cos(0.0), sin(0.0)}}; // (0.5 + 0.5) / sqrt 5
    for (size_t k = 0; k < 4; k++)
        bmr_hysteresis_add(&h, a, a, 5.0, &poses[k]);
    assert_int_equal(h.intervals, 3);
    assert_true(fabs(h.displacement - 0.5) < 1e-12);
    assert_true(fabs(h.rotation - 0.5 / sqrt(5.0)) < 1e-12);
    assert_true(fabs(h.both - 0.5 / sqrt(5.0)) < 1e-12);
}

TEST(test_fits_find_power_and_logarithm) {
    test_random random = test_random_from(5);
    double x[12], power[12], logarithm[12];
    for (int k = 0; k < 12; k++) {
        x[k] = exp2(k + 1.0);
        power[k] = 3.0 * sqrt(x[k]) * (1.0 + 0.02 * test_random_uniform(&random, -1.0, 1.0));
        logarithm[k] = 2.0 + 0.9 * log2(x[k]) + 0.05 * test_random_uniform(&random, -1.0, 1.0);
    }
    bmr_growth growth;
    assert_int_equal(bmr_fit_growth(x, power, 12, &growth), BMR_OK);
    assert_true(fabs(growth.exponent - 0.5) < 0.01 &&
                fabs(growth.exponent - 0.5) < 2.0 * growth.exponent_error);
    assert_true(growth.exponent_error > 0.0 && growth.exponent_error < 0.01);
    assert_true(fabs(growth.constant - 3.0) < 0.1);
    assert_false(growth.logarithmic);
    assert_int_equal(bmr_fit_growth(x, logarithm, 12, &growth), BMR_OK);
    assert_true(growth.logarithmic);
    assert_true(fabs(growth.slope - 0.9) < 0.02 && fabs(growth.slope - 0.9) < 2.0 * growth.slope_error);
    assert_true(fabs(growth.offset - 2.0) < 0.1);
    logarithm[0] = 0.0;
    assert_int_equal(bmr_fit_growth(x, logarithm, 12, &growth), BMR_OK);
}

static bmr_run run_structure(const char *name, const bmr_course *course, double diameter) {
    bmr_run_def def = {
        .structure = test_structure(name), .simulation = bmr_default_simulation_def(), .audit = true};
    assert_non_null(def.structure);
    assert_int_equal(def.structure->hierarchy, -1);
    for (int k = 0; k < 2; k++)
        def.shapes[k].polygon = course->polygons[k];
    bmr_run run;
    assert_int_equal(bmr_run_course(&def, course, diameter, NULL, &run), BMR_OK);
    assert_int_equal(run.audit, BMR_OK);
    return run;
}

static uint64_t adversary_events(adversary_kind kind, size_t n, double separation, const char *name) {
    const adversary made = adversary_make(kind, n, separation);
    own_polygon *a = made.polygons[0], *b = made.polygons[1];
    own_motion *p = made.motions[0], *q = made.motions[1];
    assert_int_equal(bmr_polygon_audit(a), BMR_OK);
    assert_int_equal(bmr_polygon_audit(b), BMR_OK);
    const bmr_course course = {{a, b}, {p, q}, 0.0, 1.0};
    double least, time;
    assert_int_equal(bmr_least_distance(course.polygons[0], course.polygons[1], course.motions[0],
                                        course.motions[1], 0.0, 1.0, 1e-3 * separation, &least, &time),
                     BMR_OK);
    assert_true(fabs(least - separation) <= 0.01 * separation + 2.0 * (1.0 - cos(PI / (double)n)));
    return run_structure(name, &course, 2.0).events;
}

/// The exponent of events in n, from n = 16 to 128; `last`: how many there are at 128.
static double exponent_in_n(adversary_kind kind, double separation, const char *name, double *last) {
    double x[4], y[4];
    for (int k = 0; k < 4; k++) {
        x[k] = 16 << k;
        y[k] = (double)adversary_events(kind, (size_t)x[k], separation, name) + 1.0;
    }
    bmr_growth growth;
    assert_int_equal(bmr_fit_growth(x, y, 4, &growth), BMR_OK);
    printf("%s, separation %g, %s: %g %g %g %g events, exponent %.2f\n",
           kind == ADVERSARY_PASS ? "pass" : "gear", separation, name, y[0] - 1, y[1] - 1, y[2] - 1, y[3] - 1,
           growth.exponent);
    *last = y[3] - 1.0;
    return growth.exponent;
}

TEST(test_adversaries_cost_the_rivals_n_and_n_squared_at_any_separation) {
    const int steps = test_scaled(3) < 3 ? 1 : 3; // the nearest alone where little is asked
    for (int step = 0; step < steps; step++) {
        const double separation = 0.1 * pow(30.0, step);
        double last;
        assert_true(exponent_in_n(ADVERSARY_PASS, separation, "closest-features", &last) > 0.9);
        assert_true(exponent_in_n(ADVERSARY_PASS, separation, "inner-tangent", &last) > 0.9);
        // (This one walks along few edges where the two are far apart.)
        assert_true(step > 0 ||
                    exponent_in_n(ADVERSARY_PASS, separation, "separating-edge-walk", &last) > 0.9);
        // The control: a structure that is sensitive to separation does not care for n.
        assert_true(exponent_in_n(ADVERSARY_PASS, separation, "free-fd2", &last) < 0.2);
        assert_true(exponent_in_n(ADVERSARY_GEAR, separation, "closest-features", &last) > 1.8);
        assert_true(100 * (double)adversary_events(ADVERSARY_GEAR, 128, separation, "free-fd2") < last);
    }
}

static int audits;
static bmr_error audit_with_errors(const bmr_kds *kds, const bmr_pose *b_in_a) {
    (void)kds, (void)b_in_a;
    ++audits;
    return audits == 2 ? BMR_ERROR_INVALID_STRUCTURE : audits > 2 ? BMR_ERROR_NO_MEMORY : BMR_OK;
}

TEST(test_a_run_keeps_the_first_error_of_its_audits) {
    // (Classes of some other structures are the beginning of something larger.)
    bmr_kds_info info = *test_structure("closest-features");
    bmr_kds_class class = *(const bmr_kds_class *)info.implementation;
    class.audit = audit_with_errors;
    info.implementation = &class;
    const adversary made = adversary_make(ADVERSARY_PASS, 32, 0.1);
    own_polygon *a = made.polygons[0], *b = made.polygons[1];
    own_motion *p = made.motions[0], *q = made.motions[1];
    const bmr_course course = {{a, b}, {p, q}, 0.0, 1.0};
    for (int audit = 0; audit < 2; ++audit) {
        const bmr_run_def def = {.structure = &info,
                                 .shapes = {{.polygon = course.polygons[0]}, {.polygon = course.polygons[1]}},
                                 .simulation = bmr_default_simulation_def(),
                                 .audit = audit != 0};
        bmr_run run;
        audits = 0;
        assert_int_equal(bmr_run_course(&def, &course, 2.0, NULL, &run), BMR_OK);
        assert_true(run.events > 2);
        assert_int_equal(run.audit, audit ? BMR_ERROR_INVALID_STRUCTURE : BMR_OK);
        assert_int_equal(audits, audit ? 2 : 0); // what comes after it is not looked at
    }
}

// ---- points, contact, and what is refused ----

static const bmr_vec2 square[] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};

TEST(one_line_covers_a_point_that_passes_a_point) {
    const bmr_vec2 origin = {0.0, 0.0};
    own_polygon *a = made_polygon(&origin, 1), *b = made_polygon(&origin, 1);
    own_course course = course_past(a, b, -3.0, 1.0, 6.0, 0.0);
    bmr_optimum optimum;
    assert_int_equal(bmr_offline_optimum(&course, 1e-3, 0.02, NULL, 0, &optimum), BMR_OK);
    assert_int_equal(optimum.least, 1);
    assert_int_equal(optimum.found, 1);
}

TEST(a_run_into_contact_has_a_distance_of_zero_there) {
    own_kds_body a = test_kds_body_make(made_polygon(square, 4)),
                 b = test_kds_body_make(made_polygon(square, 4));
    own_course course = course_past(a.polygon, b.polygon, 4.0, 0.5, -4.0, 0.0);
    const bmr_run_def def = {.structure = test_structure("lazy-dudley"),
                             .shapes = {a.shape, b.shape},
                             .simulation = bmr_default_simulation_def()};
    bmr_run run;
    assert_int_equal(bmr_run_course(&def, &course, 2.0, NULL, &run), BMR_OK);
    assert_int_equal(run.counts.events[BMR_KDS_CONTACT], 1);
    assert_true(run.hysteresis.distance == 0.0);
    // What is no course is refused: its end before its beginning.
    course.from = 2.0;
    assert_int_equal(bmr_run_course(&def, &course, 2.0, NULL, &run), BMR_ERROR_OUT_OF_RANGE);
}

/// At a time this late the next one that a double tells is an eighth of a second on: a hundred metres.
TEST(a_path_that_is_faster_than_time_resolves_has_no_decomposition) {
    own_polygon *p = made_polygon(square, 4);
    const double late = 1e15;
    const bmr_pose from = {{10.0, 0.0}, 1.0, 0.0};
    own_course course = course_along(p, p, bmr_piece_screw(late, from, bmr_vec2_make(800.0, 0.0), 0.0));
    course.from = late;
    course.to = late + 1.0;
    bmr_clear clear;
    assert_int_equal(bmr_clear_decomposition(&course, 3.0, 0.0, &clear), BMR_ERROR_OUT_OF_RANGE);
}

TEST(a_family_of_polygons_that_are_too_far_from_their_origins_is_refused) {
    // So far from its origin that the distance asked for is below the rounding of its vertices.
    bmr_vec2 far[4];
    for (int i = 0; i < 4; i++)
        far[i] = bmr_vec2_make(square[i].x + 1e5, square[i].y);
    own_polygon *p = made_polygon(far, 4);
    const bmr_family_def family = {BMR_FAMILY_LINE, 1e9, 1, 0, 0};
    bmr_family_motion path;
    assert_int_equal(bmr_family_create(&family, p, p, NULL, &path), BMR_ERROR_OUT_OF_RANGE);
}
