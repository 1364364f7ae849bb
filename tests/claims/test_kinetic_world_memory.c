// SPDX-License-Identifier: MIT
// Kinetic worlds: their memory, what happens where there is none, walls with every structure, and places that
// are no numbers or have no ids left.
#include "failing_allocator.h"
#include "world/parts.h"
#include "world_stage.h"

TEST(memory_is_linear_and_given_back) {
    const bmr_polygon *b = box(0.5), *huge = box(300.0);
    double each[2];
    for (int i = 0; i < 2; i++) {
        const int side = i == 0 ? 10 : 40;
        test_heap heap;
        test_heap_init(&heap, SIZE_MAX);
        stage *s = make_stage(BMR_OPEN, 0.0);
        assert_int_equal(bmr_world_create(&s->def, 0.0, &heap.allocator, &s->world), BMR_OK);
        const size_t empty = heap.bytes;
        assert_int_equal(bmr_world_get_counts(s->world).bytes, empty);
        for (int k = 0; k < side * side; k++)
            fly(s, b, 2.0 * (k % side), 2.0 * (k / side), 0.0, 0.1 * (k % 3), 0.0);
        advance(s, 1.0);
        const size_t full = heap.bytes;
        assert_int_equal(bmr_world_get_counts(s->world).bytes, full);
        each[i] = (double)(full - empty) / (side * side);
        // A level far above comes and goes; its cells with it, after a while.
        const bmr_body top = add_piece(s, huge, flight(1.0, 1e4, 0.0, 0.0, 0.0, 0.0), 0.0);
        assert_int_equal(bmr_world_remove(s->world, top), BMR_OK);
        for (int k = side * side - 1; k >= 0; k--)
            assert_int_equal(bmr_world_remove(s->world, (bmr_body)k), BMR_OK);
        // Tables keep a little.
        assert_in_range(heap.bytes, empty, empty + 8 * 1024 + 40 * (size_t)(side * side));
        assert_int_equal(heap.wrong_sizes, 0);
        bmr_world_destroy(s->world);
        assert_int_equal(heap.blocks, 0);
        free(s);
    }
    assert_near(each[1] / each[0], 1.0, 0.3);
}

/// Sixty bodies come, meet, jump and go; whatever has no memory is done again. Its contacts, hashed.
static uint64_t lack_of_memory(size_t fail_at, size_t *asked, size_t *failures) {
    test_heap heap;
    test_heap_init(&heap, fail_at);
    stage *s = make_stage(BMR_OPEN, 0.0);
    bmr_error error = bmr_world_create(&s->def, 0.0, &heap.allocator, &s->world);
    if (error == BMR_ERROR_NO_MEMORY)
        error = bmr_world_create(&s->def, 0.0, &heap.allocator, &s->world);
    assert_int_equal(error, BMR_OK);
    const bmr_polygon *b = box(0.5), *big = box(3.0);
    test_random random = {4};
    for (int i = 0; i < 60; i++) {
        const bmr_motion_piece piece =
            flight(0.0, 2.0 * (i % 8), 2.0 * (i / 8), test_random_uniform(&random, -1.0, 1.0),
                   test_random_uniform(&random, -1.0, 1.0), test_random_uniform(&random, -1.0, 1.0));
        own_motion *motion = made_motion(piece);
        const bmr_shape shape = {.polygon = i % 20 == 19 ? big : b};
        const bmr_body_def def = bmr_default_body_def(&shape, motion);
        bmr_body body = BMR_NO_BODY;
        error = bmr_world_add(s->world, &def, &body);
        if (error == BMR_ERROR_NO_MEMORY) {
            ++*failures;
            assert_true(body == BMR_NO_BODY);
            error = bmr_world_add(s->world, &def, &body);
        }
        assert_int_equal(error, BMR_OK);
    }
    for (int i = 0; i < 60; i++) {
        error = bmr_world_advance(s->world, 0.05 * (i + 1));
        if (error == BMR_ERROR_NO_MEMORY) {
            ++*failures;
            assert_int_equal(bmr_world_audit(s->world), BMR_OK);
            error = bmr_world_advance(s->world, 0.05 * (i + 1));
        }
        assert_int_equal(error, BMR_OK);
        const bmr_body body = (bmr_body)(59 - i);
        const bmr_motion_piece away = flight(0.0, 100.0 + i, 0.0, 0.0, 0.1, 0.0);
        error = i % 3 ? bmr_world_remove(s->world, body) : bmr_world_set_piece(s->world, body, &away);
        if (error == BMR_ERROR_NO_MEMORY) {
            ++*failures;
            error = bmr_world_set_piece(s->world, body, &away);
        }
        assert_int_equal(error, BMR_OK);
    }
    uint64_t hash = s->count;
    for (size_t i = 0; i < s->count; i++) {
        uint64_t bits;
        memcpy(&bits, &s->contacts[i].time, sizeof bits);
        hash = (hash ^ bits) * UINT64_C(1099511628211);
    }
    *asked = heap.asked;
    bmr_world_destroy(s->world);
    assert_int_equal(heap.blocks, 0);
    assert_int_equal(heap.wrong_sizes, 0);
    free(s);
    return hash;
}

TEST(every_allocation_may_fail_once) {
    size_t asked = 0, failures = 0, ignored;
    const uint64_t expected = lack_of_memory(SIZE_MAX, &asked, &failures);
    assert_true(asked > 500 && failures == 0);
    const size_t step = 1 + asked / test_scaled(300);
    size_t tried = 0;
    for (size_t i = 0; i < asked; i += step, tried++)
        assert_true(lack_of_memory(i, &ignored, &failures) == expected);
    // (A table that cannot be made smaller stays.)
    assert_true(failures > tried / 2);
}

TEST(walls_work_with_every_structure) {
    const bmr_polygon *b = box(1.0);
    bmr_hierarchy *hierarchies[BMR_HIERARCHY_KIND_COUNT];
    own_compass *compass;
    assert_int_equal(bmr_compass_create(4, NULL, &compass), BMR_OK);
    for (int k = 0; k < BMR_HIERARCHY_KIND_COUNT; k++)
        assert_int_equal(bmr_hierarchy_build((bmr_hierarchy_kind)k, b, compass, NULL, &hierarchies[k]),
                         BMR_OK);
    bmr_shape shape = {.polygon = b};
    for (int k = 0; k < BMR_HIERARCHY_KIND_COUNT; k++)
        shape.hierarchies[k] = hierarchies[k];
    size_t tried = 0, refused = 0;
    for (size_t i = 0; i < 2 * bmr_kds_count(); i++) {
        // A hall, and in the corner of one that is wider than its walls' proofs could be good to.
        const double size = i % 2 == 0 ? 6.0 : 2e8, off = size - 6.0;
        own_stage *s = make_stage(BMR_WALLED, size);
        s->def.structure = bmr_kds_at(i / 2);
        if (s->def.structure->domain != BMR_KDS_RIGID) {
            refused++;
            assert_int_equal(bmr_world_create(&s->def, 0.0, NULL, &s->world), BMR_ERROR_OUT_OF_RANGE);
            continue;
        }
        tried++;
        open_stage(s);
        const bmr_motion_piece pieces[2] = {flight(0.0, off - 3.0, off + 0.3, 1.0, 0.4, 0.5),
                                            flight(0.0, off + 3.0, off, -1.0, 0.2, -0.7)};
        for (int k = 0; k < 2; k++) {
            own_motion *motion = made_motion(pieces[k]);
            const bmr_body_def def = bmr_default_body_def(&shape, motion);
            bmr_body body;
            assert_int_equal(bmr_world_add(s->world, &def, &body), BMR_OK);
        }
        advance(s, 12.0);
        assert_true(s->count > 3);
    }
    assert_true(tried > 5 && refused > 5);
    for (int k = 0; k < BMR_HIERARCHY_KIND_COUNT; k++)
        bmr_hierarchy_destroy(hierarchies[k], NULL);
}

TEST(a_place_that_is_no_number_is_an_error) {
    for (int all = 0; all < 2; all++) {
        own_stage *s = make_stage(BMR_OPEN, 0.0);
        s->def.all_pairs = all;
        const bmr_polygon *b = box(1.0);
        fly(s, b, 0.0, 0.0, 0.0, 0.0, 0.0);
        // At the world's time its terms are infinite, of different signs.
        const bmr_algebraic_piece nowhere = {.degree = 2, .y = {0.0, -1e300, 1e300}};
        own_motion *motion = made_motion(test_algebraic(-1e300, nowhere));
        const bmr_shape shape = {.polygon = b};
        const bmr_body_def def = bmr_default_body_def(&shape, motion);
        bmr_body body;
        assert_int_equal(bmr_world_add(s->world, &def, &body), BMR_ERROR_NOT_FINITE);
        int level = 7;
        assert_int_equal(bmr_grid_level(s->world, 1.0, bmr_vec2_make(NAN, 0.0), &level),
                         BMR_ERROR_NOT_FINITE);
        assert_int_equal(bmr_grid_level(s->world, 1.0, bmr_vec2_make(0.0, NAN), &level),
                         BMR_ERROR_NOT_FINITE);
        assert_int_equal(level, 7);
    }
}

/// After 2^32 bodies at one place there are no ids left for it.
TEST(a_place_whose_ids_are_used_up_is_left_alone) {
    own_stage *s = make_stage(BMR_OPEN, 0.0);
    const bmr_polygon *b = box(1.0);
    bmr_body body = fly(s, b, 0.0, 0.0, 0.0, 0.0, 0.0);
    const bmr_body first = body;
    assert_int_equal(bmr_world_remove(s->world, body), BMR_OK);
    s->world->generations[0] = UINT32_MAX - 1; // as if there had been so many
    body = fly(s, b, 0.0, 0.0, 0.0, 0.0, 0.0);
    assert_int_equal(body, (uint64_t)(UINT32_MAX - 1) << 32);
    assert_int_equal(bmr_world_remove(s->world, body), BMR_OK);
    for (int i = 0; i < 3; i++) {
        body = fly(s, b, 0.0, 0.0, 0.0, 0.0, 0.0);
        assert_int_equal(body & UINT32_MAX, 1);
        assert_int_not_equal(body, first);
        assert_int_equal(bmr_world_remove(s->world, body), BMR_OK);
        assert_int_equal(bmr_world_body_count(s->world), 0);
    }
}
