// SPDX-License-Identifier: MIT
// What bmr_polynomial_first_root makes of a solver that finds nothing, or gives up: in GSL's place this
// program has one of its own.
#include "checks.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_poly.h>

#include "kinetic/roots.h"

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
