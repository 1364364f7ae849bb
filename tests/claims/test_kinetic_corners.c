// SPDX-License-Identifier: MIT
// Searches and analyses where they are hard or have nothing to do: the queue against brute force, roots that
// a solver does not find, points instead of polygons, contact, and what is refused.
#include "checks.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_poly.h>

#include "boomerang/analysis.h"
#include "course_stage.h"
#include "kinetic/bernstein.h"
#include "kinetic/event_queue.h"
#include "kinetic/first_root.h"

/// In GSL's place: what the solver says here.
static int solver_status = GSL_SUCCESS;
static double solver_root = 0.0;
int gsl_poly_complex_solve(const double *a, size_t n, gsl_poly_complex_workspace *w,
                           gsl_complex_packed_ptr z) {
    (void)a, (void)w;
    for (size_t i = 0; i + 1 < n; i++) {
        z[2 * i] = solver_root;
        z[2 * i + 1] = 0.0;
    }
    return solver_status;
}

/// (t - 1/4) (t^2 + 1) (t^2 + 4): one root, far from what the solver above says.
static const double one_root[] = {-1.0, 4.0, -1.25, 5.0, -0.25, 1.0};

TEST(different_signs_at_the_ends_prove_a_root_that_no_solver_finds) {
    solver_status = GSL_SUCCESS;
    solver_root = 1e9;
    double root = 0.0;
    assert_int_equal(bmr_polynomial_first_root(one_root, 5, 0.0, 1.0, &root), BMR_OK);
    assert_true(fabs(root - 0.25) < 1e-15);
    // And the other way up.
    double turned[6];
    for (int k = 0; k < 6; k++)
        turned[k] = -one_root[k];
    assert_int_equal(bmr_polynomial_first_root(turned, 5, 0.0, 1.0, &root), BMR_OK);
    assert_true(fabs(root - 0.25) < 1e-15);
    // The control: without a change of sign it is the solver's word.
    assert_int_equal(bmr_polynomial_first_root(one_root, 5, 0.5, 1.0, &root), BMR_OK);
    assert_true(root == INFINITY);
}

TEST(a_solver_that_gives_up_is_an_error) {
    solver_status = GSL_EFAILED;
    double root = 7.0;
    assert_int_equal(bmr_polynomial_first_root(one_root, 5, 0.0, 1.0, &root), BMR_ERROR_OUT_OF_RANGE);
    assert_true(root == 7.0);
}

TEST(roots_nearer_than_the_tolerance_are_one) {
    // -(u - r) (u - r - e) (u - r + e), three roots closer than a part can be told: found, not counted.
    const double r = 0.3, e = 1e-7, c[] = {r * r * r - r * e * e, e * e - 3.0 * r * r, 3.0 * r, -1.0};
    double low = -1.0;
    assert_true(bmr_bernstein_first_root(c, 3, 0.0, 1e-4, &low));
    assert_true(low <= r && low + 1e-4 >= r - e);
    // It touches zero and never is below: with no noise asked for, the parts at the touch are too short in
    // the end.
    const double touch[] = {0.09, -0.6, 1.0};
    assert_false(bmr_bernstein_first_root(touch, 2, 0.0, 1e-4, &low));
    // The control: lowered a little, it has a root.
    const double lowered[] = {0.09 - 1e-4, -0.6, 1.0};
    assert_true(bmr_bernstein_first_root(lowered, 2, 0.0, 1e-4, &low));
    assert_true(fabs(low - 0.29) < 1e-3);
}

#define ITEMS 13

TEST(the_queue_has_the_earliest_on_top_however_times_change) {
    double times[ITEMS];
    size_t order[ITEMS], place[ITEMS];
    bmr_event_queue queue = {times, order, place, ITEMS};
    bmr_event_queue_init(&queue);
    assert_true(bmr_event_queue_time(&queue) == INFINITY);
    test_random random = {5};
    for (int round = 0; round < 2000; round++) {
        const size_t item = (size_t)test_random_below(&random, ITEMS);
        bmr_event_queue_set(&queue, item, (double)test_random_below(&random, 40)); // ties, too
        size_t first = 0;
        for (size_t i = 1; i < ITEMS; i++)
            if (times[i] < times[first])
                first = i;
        assert_int_equal(bmr_event_queue_first(&queue), first);
        assert_true(bmr_event_queue_time(&queue) == times[first]);
    }
}

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
TEST(a_path_that_is_faster_than_time_can_be_told_has_no_decomposition) {
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
