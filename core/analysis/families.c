// SPDX-License-Identifier: MIT
// The families of motion: their table, their random draws, and the search for their free parameter.
#include "boomerang/families.h"

#include <math.h>
#include <string.h>

#include "analysis/family_paths.h"
#include "geometry/memory.h"
#include "kinetic/roots.h"

#include <gsl/gsl_randist.h>

#define PI 3.14159265358979323846
/// The separation measured is within this part of sigma when the search ends ..
#define SEARCH_TOLERANCE 5e-3
/// .. and is itself measured to this part.
#define MEASURE_TOLERANCE 1e-3
#define SEARCH_STEPS 200
/// A random polynomial path that comes nearer to the middle than this part of its size would have to be blown
/// up too far; it is drawn again, so many times at most.
#define PATH_CLEARANCE 0.2
#define PATH_DRAWS 1000
#define PATH_SAMPLES 65
/// sigma must be this much above the extents' rounding errors.
#define LEAST_SIGMA 1e-12
#define DEFAULT_TURNS 4

typedef struct family_info {
    const char *name;
    bmr_family_path path;
    unsigned degree;        ///< of a polynomial path
    unsigned default_steps; ///< of a walk
    bool rigid, convex;
} family_info;

static const family_info families[BMR_FAMILY_COUNT] = {
    [BMR_FAMILY_LINE] = {"line", bmr_path_pass, 0, 0, false, true},
    [BMR_FAMILY_PARABOLA] = {"parabola", bmr_path_pass, 0, 0, false, true},
    [BMR_FAMILY_ALGEBRAIC] = {"algebraic", bmr_path_polynomial, 5, 0, false, false},
    [BMR_FAMILY_ORBIT] = {"orbit", bmr_path_orbit, 0, 0, false, false},
    [BMR_FAMILY_ZIGZAG] = {"zigzag", bmr_path_zigzag, 0, 64, false, false},
    [BMR_FAMILY_BROWNIAN] = {"brownian", bmr_path_brownian, 0, 1024, false, false},
    [BMR_FAMILY_WANDER] = {"wander", bmr_path_wander, 0, 256, false, false},
    [BMR_FAMILY_SPIN] = {"spin", bmr_path_spin, 0, 0, true, false},
    [BMR_FAMILY_RIGID_ALGEBRAIC] = {"rigid-algebraic", bmr_path_polynomial, 4, 0, true, false},
    [BMR_FAMILY_TUMBLE] = {"tumble", bmr_path_pass, 0, 0, true, false},
    [BMR_FAMILY_RIGID_BROWNIAN] = {"rigid-brownian", bmr_path_brownian, 0, 1024, true, false},
    [BMR_FAMILY_RIGID_WANDER] = {"rigid-wander", bmr_path_wander, 0, 256, true, false},
    [BMR_FAMILY_TO_AND_FRO] = {"to-and-fro", bmr_path_to_and_fro, 0, 256, true, false}};

static bool is_family(bmr_family family) {
    return (unsigned)family < BMR_FAMILY_COUNT;
}
const char *bmr_family_name(bmr_family family) {
    return is_family(family) ? families[family].name : NULL;
}
bool bmr_family_is_rigid(bmr_family family) {
    return is_family(family) && families[family].rigid;
}
bool bmr_family_is_convex(bmr_family family) {
    return is_family(family) && families[family].convex;
}

double bmr_polygon_diameter(const bmr_polygon *polygon) {
    // The farthest pair touches two parallel support lines, and one of those can be turned into an edge.
    double most = 0.0;
    const uint32_t n = polygon->count;
    for (uint32_t i = 0; i < n; i++) {
        const uint32_t j = bmr_polygon_support(polygon, bmr_neg(bmr_polygon_normal(polygon, i)));
        for (uint32_t end = 0; end < 2; end++) {
            const bmr_vec2 p = polygon->vertices[(i + end) % n];
            // One vertex to each side of it: parallel edges, and the rounding of the normal.
            for (uint32_t k = 0; k < 3; k++) {
                const bmr_vec2 q = polygon->vertices[(j + n - 1 + k) % n];
                most = fmax(most, hypot(p.x - q.x, p.y - q.y));
            }
        }
    }
    return most;
}

/// The least distance of a polynomial path from the middle over its largest.
static double clearance(const bmr_family_plan *plan) {
    double least = INFINITY, most = 0.0;
    for (int i = 0; i < PATH_SAMPLES; i++) {
        const double t = 2.0 * i / (PATH_SAMPLES - 1) - 1.0;
        const double r = hypot(bmr_polynomial_value(plan->x, plan->degree, t),
                               bmr_polynomial_value(plan->y, plan->degree, t));
        least = fmin(least, r);
        most = fmax(most, r);
    }
    return least / most;
}

/// In the monomial basis with falling coefficients: all terms matter at the ends, the low ones in between.
static void draw_path(bmr_family_plan *plan, gsl_rng *random) {
    for (int i = 0; i < PATH_DRAWS && (i == 0 || clearance(plan) < PATH_CLEARANCE); i++)
        for (size_t k = 0; k <= plan->degree; k++) {
            plan->x[k] = gsl_ran_gaussian(random, 1.0);
            plan->y[k] = gsl_ran_gaussian(random, 1.0);
        }
}

static bmr_error draw(bmr_family_plan *plan, const bmr_family_def *def, const bmr_allocator *allocator) {
    gsl_rng *random = bmr_random_create(def->seed);
    if (!random)
        return BMR_ERROR_NO_MEMORY;
    const family_info *info = &families[def->family];
    const double rotation = gsl_ran_flat(random, 0.0, 2.0 * PI),
                 heading = gsl_ran_flat(random, 0.0, 2.0 * PI);
    const double sense = gsl_ran_flat(random, 0.0, 1.0) < 0.5 ? -1.0 : 1.0;
    const double bend = gsl_ran_flat(random, 0.5, 2.0), half_turn = gsl_ran_flat(random, 0.5, 1.5);
    plan->turn.c = cos(rotation);
    plan->turn.s = sin(rotation);
    plan->toward = bmr_vec2_make(cos(heading), sin(heading));
    plan->bend = def->family == BMR_FAMILY_PARABOLA ? bend : 0.0;
    plan->spin = sense * 2.0 * PI;
    if (def->family == BMR_FAMILY_TUMBLE)
        plan->spin *= def->turns ? def->turns : DEFAULT_TURNS;
    plan->half_turn[0] = sense * half_turn;
    plan->half_turn[1] = gsl_ran_flat(random, -0.5, 0.5);
    plan->degree = info->degree;
    if (info->degree > 0)
        draw_path(plan, random);
    plan->steps = def->steps && info->default_steps ? def->steps : info->default_steps;
    bmr_error error = BMR_OK;
    size_t bytes;
    const bool is_random_walk = info->path == bmr_path_brownian || info->path == bmr_path_wander;
    if (is_random_walk && !bmr_size_product(plan->steps, sizeof *plan->draws, &bytes)) {
        error = BMR_ERROR_TOO_LARGE;
    } else if (is_random_walk && plan->steps > 0) {
        plan->draws = bmr_allocate(allocator, bytes);
        for (size_t k = 0; plan->draws && k < plan->steps; k++) {
            plan->draws[k].x = gsl_ran_gaussian(random, 1.0);
            plan->draws[k].y = gsl_ran_gaussian(random, 1.0);
            plan->draws[k].angle = gsl_ran_gaussian(random, 1.0);
        }
        error = plan->draws ? BMR_OK : BMR_ERROR_NO_MEMORY;
    }
    gsl_rng_free(random);
    return error;
}

/// Makes the motion of a parameter and measures it to the tolerance. On error nothing is left.
static bmr_error attempt(const bmr_family_plan *plan, double parameter, double tolerance,
                         const bmr_allocator *allocator, bmr_family_motion *made) {
    bmr_error error = families[plan->family].path(plan, parameter, allocator, made->motions);
    if (error != BMR_OK)
        return error;
    error = bmr_least_distance(plan->a, plan->b, made->motions[0], made->motions[1], 0.0, 1.0, tolerance,
                               &made->separation, &made->nearest);
    return bmr_path_finish(error, made->motions);
}

/// The separation is a continuous function of the parameter, 0 at 0 and large at large ones: between a value
/// below sigma and one above there is one at sigma.
static bmr_error search_parameter(const bmr_family_plan *plan, const bmr_allocator *allocator,
                                  bmr_family_motion *made) {
    double low = 0.0, low_separation = 0.0, high = INFINITY, high_separation = INFINITY;
    double parameter = plan->sigma;
    for (int step = 0; step < SEARCH_STEPS; step++) {
        const bmr_error error = attempt(plan, parameter, MEASURE_TOLERANCE * plan->sigma, allocator, made);
        if (error != BMR_OK)
            return error;
        const double off = made->separation - plan->sigma;
        if (fabs(off) <= SEARCH_TOLERANCE * plan->sigma)
            return BMR_OK;
        bmr_motion_destroy(made->motions[0]);
        bmr_motion_destroy(made->motions[1]);
        if (off < 0.0) {
            low = parameter;
            low_separation = made->separation;
        } else {
            high = parameter;
            high_separation = made->separation;
        }
        // Secant where both ends have a separation near sigma, halving where not: an overlap has no slope.
        const double slope = (high_separation - low_separation) / (high - low);
        if (!(high < INFINITY))
            parameter = 2.0 * parameter;
        else if (low_separation > 0.0 && step % 3 != 2)
            parameter = low + (plan->sigma - low_separation) / slope;
        else
            parameter = 0.5 * (low + high);
    }
    return BMR_ERROR_OUT_OF_RANGE;
}

bmr_error bmr_family_create(const bmr_family_def *def, const bmr_polygon *a, const bmr_polygon *b,
                            const bmr_allocator *allocator, bmr_family_motion *made) {
    if (!def || !a || !b || !made)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!is_family(def->family) || !(def->ratio >= 1.0) || !(def->ratio <= 1e9))
        return BMR_ERROR_OUT_OF_RANGE;
    if (def->family == BMR_FAMILY_ZIGZAG && def->steps != 0 && def->steps < 8)
        return BMR_ERROR_OUT_OF_RANGE;
    bmr_family_plan plan;
    memset(&plan, 0, sizeof plan);
    plan.family = def->family;
    plan.a = a;
    plan.b = b;
    plan.diameter = fmax(bmr_polygon_diameter(a), bmr_polygon_diameter(b));
    plan.sigma = plan.diameter / def->ratio;
    if (!(plan.sigma > LEAST_SIGMA * (a->extent + b->extent)))
        return BMR_ERROR_OUT_OF_RANGE;
    bmr_family_motion result = {.diameter = plan.diameter, .sigma = plan.sigma};
    bmr_error error = draw(&plan, def, allocator);
    // The orbit is at its distance by construction, all the time: one sample of each piece is enough.
    if (error == BMR_OK)
        error = def->family == BMR_FAMILY_ORBIT ? attempt(&plan, plan.sigma, INFINITY, allocator, &result)
                                                : search_parameter(&plan, allocator, &result);
    if (plan.draws)
        bmr_release(allocator, plan.draws, plan.steps * sizeof *plan.draws);
    if (error == BMR_OK)
        *made = result;
    return error;
}

void bmr_family_destroy(bmr_family_motion *made) {
    if (made) {
        bmr_motion_destroy(made->motions[0]);
        bmr_motion_destroy(made->motions[1]);
    }
}
