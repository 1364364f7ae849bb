// SPDX-License-Identifier: MIT
// Every function of boomerang::kinetic that allocates, with every one of its allocations failing once: those
// of the allocator, and GSL's own, which come from malloc and are counted with them (the linker's --wrap).
#include <stdio.h>
#include <string.h>

#define CHECKS_OWN_MAIN
#include "checks.h"

#include <gsl/gsl_rng.h>

#include "boomerang/analysis.h"
#include "boomerang/families.h"
#include "boomerang/simulation.h"
#include "boomerang/time_of_contact.h"
#include "boomerang/world.h"
#include "every_allocation.h"
#include "structure_named.h"

enum { COUNT = 12, SAMPLES = 5, CHANGES = 20 };
static bmr_vec2 points[COUNT];
static bmr_polygon *polygon;
static bmr_motion *motions[3];
static bmr_motion_piece piece;

static bmr_pose pose_of(double x) {
    const bmr_pose pose = {{x, 0.0}, 0.8, 0.6};
    return pose;
}

static int prepare(void) {
    piece = bmr_piece_screw(0.0, pose_of(10.0), bmr_vec2_make(-1.0, 0.1), 0.3);
    if (bmr_outline_points(BMR_OUTLINE_REGULAR, COUNT, 1, points) != BMR_OK ||
        bmr_polygon_create(points, COUNT, NULL, &polygon) != BMR_OK)
        return 1;
    for (int i = 0; i < 3; ++i) {
        const bmr_motion_piece rest = bmr_piece_rest(pose_of(-5.0 * i));
        if (bmr_motion_create(i == 0 ? &piece : &rest, NULL, &motions[i]) != BMR_OK)
            return 1;
    }
    return 0;
}

static void give_back(void) {
    for (int i = 0; i < 3; ++i)
        bmr_motion_destroy(motions[i]);
    bmr_polygon_destroy(polygon, NULL);
}

// --- GSL's allocations ---

gsl_rng *__real_gsl_rng_alloc(const gsl_rng_type *type); // NOLINT: the linker's name
gsl_rng *__wrap_gsl_rng_alloc(const gsl_rng_type *type); // NOLINT
void __real_gsl_rng_free(gsl_rng *random);               // NOLINT
void __wrap_gsl_rng_free(gsl_rng *random);               // NOLINT

/// Whose books GSL's generators are in; NULL: nobody's.
static test_heap *counting;

gsl_rng *__wrap_gsl_rng_alloc(const gsl_rng_type *type) { // NOLINT
    if (counting && counting->asked++ == counting->fail_at)
        return NULL;
    gsl_rng *made = __real_gsl_rng_alloc(type);
    if (counting && made)
        ++counting->blocks;
    return made;
}

void __wrap_gsl_rng_free(gsl_rng *random) { // NOLINT
    if (counting && random)
        --counting->blocks;
    __real_gsl_rng_free(random);
}

/// To be around each call: the allocator's context is the heap.
static void count_gsl(const bmr_allocator *allocator) {
    counting = allocator ? allocator->context : NULL;
}

// --- motions ---

static void hash_motion(const bmr_motion *motion, uint64_t *bits) {
    for (int i = -5; i <= 30; ++i) {
        const bmr_pose pose = bmr_motion_pose(motion, i, NULL, NULL);
        test_hash(bits, &pose, sizeof pose);
    }
}

static bmr_error made_motion(bmr_error error, bmr_motion *made, uint64_t *bits) {
    if (error != BMR_OK)
        return made == NULL ? error : BMR_ERROR_COUNT;
    hash_motion(made, bits);
    bmr_motion_destroy(made);
    return BMR_OK;
}

static bmr_error run_motion_create(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_motion *made = NULL;
    const bmr_error error = bmr_motion_create(&piece, allocator, &made);
    return made_motion(error, made, bits);
}

static bmr_error run_motion_create_sampled(const bmr_allocator *allocator, uint64_t *bits) {
    double times[SAMPLES];
    bmr_pose poses[SAMPLES];
    for (int i = 0; i < SAMPLES; ++i) {
        times[i] = i;
        poses[i] = pose_of(i * i);
    }
    bmr_motion *made = NULL;
    const bmr_error error = bmr_motion_create_sampled(times, poses, SAMPLES, allocator, &made);
    return made_motion(error, made, bits);
}

/// A motion that could not be changed is as it was, and the change can be made once there is memory.
static bmr_error run_motion_change(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_motion *made = NULL;
    bmr_error error = bmr_motion_create(&piece, allocator, &made);
    for (int i = 0; i < CHANGES && error == BMR_OK; ++i) {
        const bmr_motion_piece change = bmr_piece_screw(i, pose_of(i), bmr_vec2_make(i, 1.0), 0.0);
        uint64_t before = TEST_HASH_START, after = TEST_HASH_START;
        hash_motion(made, &before);
        error = bmr_motion_change(made, i, &change);
        if (error == BMR_OK)
            continue;
        hash_motion(made, &after);
        if (after != before || bmr_motion_change(made, i, &change) != BMR_OK)
            error = BMR_ERROR_COUNT;
    }
    if (error == BMR_OK)
        return made_motion(error, made, bits);
    bmr_motion_destroy(made);
    return error;
}

// --- simulations ---

static bmr_error run_simulation_create(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = test_structure("free-fd1");
    bmr_shape shapes[3];
    memset(shapes, 0, sizeof shapes);
    for (int i = 0; i < 3; ++i)
        shapes[i].polygon = polygon;
    bmr_simulation *made = NULL;
    const bmr_error error =
        bmr_simulation_create(&def, shapes, motions, 3, 0.0, NULL, NULL, allocator, &made);
    if (error != BMR_OK)
        return made == NULL ? error : BMR_ERROR_COUNT;
    if (bmr_simulation_run(made, 20.0) != BMR_OK) // it has all the memory that it needs
        return BMR_ERROR_COUNT;
    const bmr_simulation_counts counts = bmr_simulation_get_counts(made);
    test_hash(bits, &counts, sizeof counts);
    bmr_simulation_destroy(made);
    return BMR_OK;
}

// --- worlds ---

static bmr_error open_world(const bmr_allocator *allocator, bmr_world **made) {
    bmr_world_def def = bmr_default_world_def();
    def.structure = test_structure("free-fd1");
    def.boundary = BMR_WALLED;
    def.low = bmr_vec2_make(-30.0, -30.0);
    def.high = bmr_vec2_make(30.0, 30.0);
    return bmr_world_create(&def, 0.0, allocator, made);
}

/// Of the world: destroys it.
static bmr_error close_world(bmr_world *world, bmr_error error, uint64_t *bits) {
    const bmr_world_totals totals = bmr_world_get_totals(world);
    const bmr_world_counts counts = bmr_world_get_counts(world);
    test_hash(bits, &totals, sizeof totals);
    test_hash(bits, counts.events, sizeof counts.events);
    if (bmr_world_audit(world) != BMR_OK)
        error = BMR_ERROR_COUNT;
    bmr_world_destroy(world);
    return error;
}

static bmr_error run_world_create(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_world *made = NULL;
    const bmr_error error = open_world(allocator, &made);
    if (error != BMR_OK)
        return made == NULL ? error : BMR_ERROR_COUNT;
    return close_world(made, BMR_OK, bits);
}

/// What had no memory changed nothing, and can be done once there is some.
static bmr_error add_bodies(bmr_world *world, bmr_motion *const *moves, int count) {
    bmr_shape shape = {.polygon = polygon};
    bmr_error failed = BMR_OK;
    for (int i = 0; i < count; ++i) {
        const bmr_body_def def = bmr_default_body_def(&shape, moves[i]);
        bmr_body body = 77;
        const bmr_error error = bmr_world_add(world, &def, &body);
        if (error == BMR_OK)
            continue;
        failed = error;
        if (body != 77 || bmr_world_body_count(world) != (size_t)i || bmr_world_audit(world) != BMR_OK ||
            bmr_world_add(world, &def, &body) != BMR_OK)
            return BMR_ERROR_COUNT;
    }
    return failed;
}

static bmr_error run_world_add(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_world *made = NULL;
    bmr_error error = open_world(allocator, &made);
    if (error != BMR_OK)
        return error;
    error = add_bodies(made, motions, 3);
    return close_world(made, error, bits);
}

static bmr_error run_world_set_motion(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_world *made = NULL;
    bmr_error error = open_world(allocator, &made);
    if (error != BMR_OK)
        return error;
    error = add_bodies(made, motions, 3);
    bmr_motion *plan; // jumps at once, and again later
    const bmr_motion_piece rest = bmr_piece_rest(pose_of(20.0)), more = bmr_piece_rest(pose_of(-20.0));
    if (bmr_motion_create(&rest, NULL, &plan) != BMR_OK || bmr_motion_change(plan, 1.0, &more) != BMR_OK)
        return BMR_ERROR_COUNT;
    const bmr_error set = bmr_world_set_motion(made, 1, plan);
    if (set != BMR_OK) {
        bmr_body_state state;
        error = set;
        if (bmr_world_get(made, 1, &state) != BMR_OK || state.pose.position.x != -5.0 ||
            bmr_world_set_motion(made, 1, plan) != BMR_OK)
            error = BMR_ERROR_COUNT;
    }
    bmr_motion_destroy(plan);
    return close_world(made, error, bits);
}

static bmr_error run_world_advance(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_world *made = NULL;
    bmr_error error = open_world(allocator, &made);
    if (error != BMR_OK)
        return error;
    error = add_bodies(made, motions, 3);
    const bmr_error first = bmr_world_advance(made, 30.0);
    if (first != BMR_OK)
        error = bmr_world_audit(made) == BMR_OK && bmr_world_advance(made, 30.0) == BMR_OK ? first
                                                                                           : BMR_ERROR_COUNT;
    return close_world(made, error, bits);
}

static bmr_error run_time_of_contact(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_shape shape;
    memset(&shape, 0, sizeof shape);
    shape.polygon = polygon;
    double time = -1.0;
    const bmr_error error =
        bmr_time_of_contact(&shape, motions[0], &shape, motions[1], 0.0, 20.0, 1e-6, allocator, &time);
    if (error != BMR_OK)
        return time == -1.0 ? error : BMR_ERROR_COUNT;
    test_hash(bits, &time, sizeof time);
    return BMR_OK;
}

static bmr_error run_run_course(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_run_def def;
    memset(&def, 0, sizeof def);
    def.structure = test_structure("free-fd1");
    def.shapes[0].polygon = def.shapes[1].polygon = polygon;
    def.simulation = bmr_default_simulation_def();
    const bmr_course course = {{polygon, polygon}, {motions[0], motions[1]}, 0.0, 5.0};
    bmr_run run;
    memset(&run, 0x77, sizeof run);
    const bmr_run untouched = run;
    const bmr_error error = bmr_run_course(&def, &course, 2.0, allocator, &run);
    if (error != BMR_OK)
        return memcmp(&run, &untouched, sizeof run) == 0 ? error : BMR_ERROR_COUNT;
    test_hash(bits, &run.counts, sizeof run.counts);
    test_hash(bits, &run.events, sizeof run.events);
    return BMR_OK;
}

// --- analysis ---

static bmr_error run_adversary_create(const bmr_allocator *allocator, uint64_t *bits) {
    for (int kind = 0; kind < BMR_ADVERSARY_COUNT; ++kind) {
        bmr_adversary made = {{NULL, NULL}, {NULL, NULL}};
        const bmr_error error = bmr_adversary_create((bmr_adversary_kind)kind, COUNT, 0.1, allocator, &made);
        if (error != BMR_OK)
            return made.polygons[0] == NULL && made.motions[0] == NULL ? error : BMR_ERROR_COUNT;
        for (int k = 0; k < 2; ++k) {
            hash_motion(made.motions[k], bits);
            test_hash(bits, made.polygons[k]->vertices,
                      made.polygons[k]->count * sizeof *made.polygons[k]->vertices);
        }
        bmr_adversary_destroy(&made, allocator);
    }
    return BMR_OK;
}

static bmr_error run_family_create(const bmr_allocator *allocator, uint64_t *bits) {
    count_gsl(allocator);
    bmr_error error = BMR_OK;
    for (int family = 0; family < BMR_FAMILY_COUNT && error == BMR_OK; ++family) {
        const bmr_family_def def = {(bmr_family)family, 4.0, 1, 16, 0};
        bmr_family_motion made;
        memset(&made, 0x77, sizeof made);
        const bmr_family_motion untouched = made;
        error = bmr_family_create(&def, polygon, polygon, allocator, &made);
        if (error == BMR_OK) {
            hash_motion(made.motions[0], bits);
            hash_motion(made.motions[1], bits);
            bmr_family_destroy(&made);
        } else if (memcmp(&made, &untouched, sizeof made) != 0)
            error = BMR_ERROR_COUNT;
    }
    count_gsl(NULL);
    return error;
}

static bmr_error run_outline_points(const bmr_allocator *allocator, uint64_t *bits) {
    count_gsl(allocator);
    bmr_error error = BMR_OK;
    for (int outline = 0; outline < BMR_OUTLINE_COUNT && error == BMR_OK; ++outline) {
        bmr_vec2 made[COUNT] = {{77.0, 77.0}};
        error = bmr_outline_points((bmr_outline)outline, COUNT, 7, made);
        if (error == BMR_OK)
            test_hash(bits, made, sizeof made);
        else if (made[0].x != 77.0)
            error = BMR_ERROR_COUNT;
    }
    count_gsl(NULL);
    return error;
}

static const test_attempt attempts[] = {
    {"bmr_motion_create", run_motion_create},
    {"bmr_motion_create_sampled", run_motion_create_sampled},
    {"bmr_motion_change", run_motion_change},
    {"bmr_simulation_create", run_simulation_create},
    {"bmr_time_of_contact", run_time_of_contact},
    {"bmr_run_course", run_run_course},
    {"bmr_adversary_create", run_adversary_create},
    {"bmr_family_create", run_family_create},
    {"bmr_outline_points", run_outline_points},
    {"bmr_world_create", run_world_create},
    {"bmr_world_add", run_world_add},
    {"bmr_world_set_motion", run_world_set_motion},
    {"bmr_world_advance", run_world_advance},
};
#define ATTEMPTS (sizeof attempts / sizeof *attempts)

TEST(every_allocation_may_fail) {
    assert_int_equal(prepare(), 0);
    for (size_t i = 0; i < ATTEMPTS; ++i) {
        const char *wrong = test_every_allocation(&attempts[i]);
        if (wrong)
            fail_msg("%s %s", attempts[i].name, wrong);
    }
    give_back();
}

int main(int argc, char **argv) {
    if (argc > 1 && strcmp(argv[1], "--list") == 0) {
        for (size_t i = 0; i < ATTEMPTS; ++i)
            printf("%s\n", attempts[i].name);
        return 0;
    }
    return check_run("");
}
