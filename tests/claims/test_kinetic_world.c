// SPDX-License-Identifier: MIT
// Kinetic worlds: energy and momentum stay, and what a body costs. That nothing overlaps, that contacts come
// at the margin, and that they are those of all pairs, bit for bit: tests/random/fuzz_world.c.
#include "boomerang/mass.h"
#include "boomerang/world.h"
#include "checks.h"
#include "motions.h"
#include "polygons.h"

/// Two polygons of radius 1 or so about their centres of mass; they live as long as the program.
static const bmr_shape *shape_of(int which) {
    static bmr_shape shapes[2];
    test_random random = test_random_from((uint64_t)which);
    if (!shapes[which].polygon) {
        own_polygon *any = test_polygon(TEST_CIRCLE, 40, &random);
        bmr_vec2 points[40];
        bmr_mass mass;
        assert_int_equal(bmr_polygon_mass(any, &mass), BMR_OK);
        for (uint32_t i = 0; i < any->count; i++)
            points[i] = bmr_sub(any->vertices[i], mass.centroid);
        shapes[which].polygon = made_polygon(points, any->count);
    }
    return &shapes[which];
}

/// side * side polygons of radius 1 at random velocities, 2.4 apart, whose contacts are elastic.
static bmr_world *make_gas(int side, bmr_boundary boundary, bool all_pairs) {
    test_random random = test_random_from(5);
    bmr_world_def def = bmr_default_world_def();
    def.boundary = boundary;
    def.high = bmr_vec2_make(2.4 * side, 2.4 * side);
    def.all_pairs = all_pairs;
    bmr_world *w;
    assert_int_equal(bmr_world_create(&def, 0.0, NULL, &w), BMR_OK);
    for (int i = 0; i < side * side; i++) {
        const bmr_vec2 at = {2.4 * (i % side + 0.5), 2.4 * (i / side + 0.5)};
        const bmr_vec2 velocity = {test_random_uniform(&random, -1.0, 1.0),
                                   test_random_uniform(&random, -1.0, 1.0)};
        const bmr_motion_piece piece =
            bmr_piece_screw(0.0, bmr_pose_from_angle(at, test_random_uniform(&random, -3.0, 3.0)), velocity,
                            test_random_uniform(&random, -1.0, 1.0));
        own_motion *motion = made_motion(piece);
        const bmr_body_def body = bmr_default_body_def(shape_of(i % 3 == 0), motion);
        bmr_body id;
        assert_int_equal(bmr_world_add(w, &body, &id), BMR_OK);
    }
    return w;
}

TEST(a_gas_keeps_its_energy_and_momentum) {
    enum { SIDE = 12 };
    const bmr_vec2 size = {2.4 * SIDE, 2.4 * SIDE};
    const double seconds = 4.0 * (double)test_scaled(10);
    for (int boundary = 0; boundary < 3; boundary++) {
        own_world *w = make_gas(SIDE, (bmr_boundary)boundary, false);
        const bmr_world_totals before = bmr_world_get_totals(w);
        for (int step = 1; step <= 4; step++) {
            assert_int_equal(bmr_world_advance(w, seconds * step / 4), BMR_OK);
            assert_int_equal(bmr_world_audit(w), BMR_OK);
        }
        const bmr_world_totals after = bmr_world_get_totals(w);
        const bmr_world_counts counts = bmr_world_get_counts(w);
        const double scale = sqrt(before.energy) * size.x * SIDE * SIDE;
        const double energy = fabs(after.energy - before.energy) / before.energy;
        const double momentum =
            hypot(after.momentum.x - before.momentum.x, after.momentum.y - before.momentum.y);
        const double angular = fabs(after.angular - before.angular);
        static const char *const names[] = {"open", "walls", "periodic"};
        printf("%s: %llu impulses, energy %.1e, momentum %.1e, angular %.1e\n", names[boundary],
               (unsigned long long)counts.impulses, energy, momentum, angular);
        assert_true(counts.impulses > 50 && counts.softened == 0);
        assert_true(energy < 1e-12);
        // Controls: walls take momentum, and a box has no centre to turn about.
        assert_true((momentum < 1e-12 * scale) == (boundary != BMR_WALLED));
        assert_true((angular < 1e-12 * scale) == (boundary == BMR_OPEN));
    }
}

/// Events and candidates of a body in a unit of time; its memory.
static void figures(int side, bool all_pairs, double figure[3]) {
    own_world *w = make_gas(side, BMR_PERIODIC, all_pairs);
    assert_int_equal(bmr_world_advance(w, 2.0), BMR_OK);
    const bmr_world_counts counts = bmr_world_get_counts(w);
    uint64_t events = 0;
    for (int i = 0; i < BMR_WORLD_EVENT_KIND_COUNT; i++)
        events += counts.events[i];
    const double bodies = side * side;
    figure[0] = (double)events / (2.0 * bodies);
    figure[1] = (double)counts.pairs / bodies;
    figure[2] = (double)counts.most_bytes / bodies;
}

TEST(what_a_body_costs_does_not_grow_with_the_world) {
    double few[3], many[3], all_few[3], all_many[3];
    figures(14, false, few);
    figures(28, false, many);
    printf("events %.2f and %.2f, pairs %.2f and %.2f, bytes %.0f and %.0f\n", few[0], many[0], few[1],
           many[1], few[2], many[2]);
    assert_true(fabs(many[0] / few[0] - 1.0) < 0.2);
    assert_true(many[1] < 16.0 && few[1] < 16.0); // about one body a cell, each pair once
    assert_true(many[2] / few[2] < 1.5);
    // Control: of all pairs a body has as many as there are others.
    figures(7, true, all_few);
    figures(14, true, all_many);
    assert_true(all_many[1] > 3.5 * all_few[1] && all_many[2] > 3.0 * all_few[2]);
}
