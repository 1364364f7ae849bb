// SPDX-License-Identifier: MIT
// The driver that tests kinetic structures is itself shown a right structure and wrong ones.
#include "checks.h"
#include "kds/structure.h"
#include "kds_driver.h"
#include "structure_named.h"

/// A structure of one line, in the closest direction.
static bool line_start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    (void)report;
    uint32_t a = 0, b = 0;
    bmr_vec2 direction;
    double distance;
    if (!bmr_kds_closest(kds, &now->pose, &a, &b, &direction, &distance))
        return false;
    memcpy(kds->state, &direction, sizeof direction);
    return true;
}
static bmr_line line_of(const bmr_kds *kds) {
    const bmr_polygon *a = kds->shapes[0].polygon;
    bmr_line line = {*(const bmr_vec2 *)(const void *)kds->state, 0.0};
    line.offset = bmr_dot(line.normal, a->vertices[bmr_polygon_support(a, line.normal)]);
    return line;
}
/// B is a point in this test: beyond the line is all there is to it.
static size_t line_conditions(const bmr_kds *kds, bmr_condition *conditions) {
    const bmr_line line = line_of(kds);
    conditions[0] = bmr_condition_beyond(0, line.normal, line.offset + kds->def.margin,
                                         kds->shapes[1].polygon->vertices[0], 0);
    return 1;
}
static size_t no_conditions(const bmr_kds *kds, bmr_condition *conditions) {
    (void)kds, (void)conditions;
    return 0;
}
static bool line_repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    (void)failed;
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    line_conditions(kds, conditions);
    if (bmr_condition_value(conditions, &now->pose) > 0.0)
        return true;
    report->kind = BMR_KDS_PUSH;
    report->line_changed = true;
    return line_start(kds, now, report);
}
static bool silent_repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    const bool apart = line_repair(kds, now, failed, report);
    report->line_changed = false;
    return apart;
}
static bool lazy_repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    (void)kds, (void)now, (void)failed;
    report->kind = BMR_KDS_PUSH;
    return true;
}
static bool fearful_repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    (void)kds, (void)now, (void)failed, (void)report;
    return false;
}
static void line_proof(const bmr_kds *kds, bmr_kds_proof *proof) {
    proof->owner = 0;
    proof->line = line_of(kds);
    proof->nearest = kds->shapes[1].polygon->vertices[0];
    proof->level = 0;
}

static const bmr_kds_class silent = {sizeof(bmr_vec2), NULL,          NULL,       line_start,
                                     line_conditions,  silent_repair, line_proof, NULL};
static const bmr_kds_class careless = {sizeof(bmr_vec2), NULL,        NULL,       line_start,
                                       no_conditions,    line_repair, line_proof, NULL};
static const bmr_kds_class idle = {sizeof(bmr_vec2), NULL,        NULL,       line_start,
                                   line_conditions,  lazy_repair, line_proof, NULL};
static const bmr_kds_class fearful = {sizeof(bmr_vec2), NULL,           NULL,       line_start,
                                      line_conditions,  fearful_repair, line_proof, NULL};

static test_drive_result drive(const bmr_kds_class *class, test_path_kind kind, uint64_t seed) {
    const bmr_kds_info info = {"test", "", "", BMR_KDS_POINT, false, -1, class};
    const bmr_kds_def def = bmr_default_kds_def();
    test_random random = {seed};
    own_kds_body a = test_kds_body_make(test_polygon(TEST_CIRCLE, 16, &random));
    own_kds_body b = test_kds_point_make(0.1, 0.2);
    const test_path path = test_path_make(kind, a.polygon, b.polygon, 0.05, true, &random);
    const test_drive how = {.path = &path};
    own_kds *kds = made_kds(&info, &def, &a.shape, &b.shape);
    const test_drive_result result = test_drive_run(kds, a.polygon, b.polygon, &how);
    return result;
}

TEST(wrong_structures_are_found_out) {
    const test_drive_result no_watch = drive(&careless, TEST_PATH_HIT, 1);
    assert_true(no_watch.false_audits > 0);
    assert_true(no_watch.missed_contacts > 0);
    assert_int_equal(no_watch.error, BMR_ERROR_FALSE_CERTIFICATE);
    const test_drive_result dead = drive(&idle, TEST_PATH_ORBIT, 1);
    assert_true(dead.dead_repairs > 0);
    const test_drive_result afraid = drive(&fearful, TEST_PATH_ORBIT, 1);
    assert_true(afraid.false_contacts > 0);
    const test_drive_result secret = drive(&silent, TEST_PATH_ORBIT, 1);
    assert_true(secret.silent_lines > 0 && secret.false_audits == 0);
}

TEST(a_path_s_rates_are_those_of_its_poses) {
    test_random random = {7};
    own_kds_body a = test_kds_body_make(test_polygon(TEST_CIRCLE, 8, &random));
    for (int kind = 0; kind < TEST_PATH_KIND_COUNT; ++kind) {
        const test_path path = test_path_make((test_path_kind)kind, a.polygon, a.polygon, 0.1, true, &random);
        double speed, spin, reach;
        test_path_bounds(&path, &speed, &spin, &reach);
        for (int k = 0; k < 10; ++k) {
            const double t = 0.05 + 0.1 * k, h = 1e-6;
            const bmr_instant now = test_path_at(&path, t), back = test_path_at(&path, t - h),
                              on = test_path_at(&path, t + h);
            const bmr_vec2 v = bmr_scale(0.5 / h, bmr_sub(on.pose.position, back.pose.position));
            assert_true(hypot(v.x - now.velocity.x, v.y - now.velocity.y) < 1e-6 * (1.0 + speed) * 100.0);
            const double turned = back.pose.c * on.pose.s - back.pose.s * on.pose.c;
            assert_true(fabs(turned / (2.0 * h) - now.spin) < 1e-6 * (1.0 + spin) * 100.0);
            assert_true(hypot(now.velocity.x, now.velocity.y) <= speed * (1.0 + 1e-12));
            assert_true(fabs(now.spin) <= spin * (1.0 + 1e-12));
        }
    }
}

/// Hands out one place, again and again: for a polygon that is made without scratch memory.
static _Alignas(64) unsigned char place[1024];
static void *take_place(void *context, size_t size) {
    (void)context;
    return size <= sizeof place ? place : NULL;
}
static void leave_place(void *context, void *block, size_t size) {
    (void)context, (void)block, (void)size;
}

static bmr_shape triangle_in_place(double width, const bmr_allocator *allocator) {
    const bmr_vec2 vertices[] = {{0.0, 0.0}, {width, 0.0}, {0.0, 1.0}};
    bmr_polygon *made = NULL;
    assert_int_equal(bmr_polygon_create_raw(vertices, 3, allocator, &made), BMR_OK);
    const bmr_shape shape = {.polygon = made};
    return shape;
}

/// The hierarchy is kept while its polygon is freed and another made at the same address.
TEST(a_hierarchy_of_a_polygon_that_is_no_more_is_refused) {
    const bmr_allocator one_place = {take_place, leave_place, NULL};
    const bmr_kds_info *info = test_structure("lazy-dudley");
    const bmr_kds_def def = bmr_default_kds_def();
    bmr_shape a = triangle_in_place(1.0, NULL), b = triangle_in_place(1.0, &one_place);
    own_hierarchy *of_a = NULL, *of_b = NULL;
    assert_int_equal(bmr_hierarchy_build_dudley(a.polygon, NULL, &of_a), BMR_OK);
    assert_int_equal(bmr_hierarchy_build_dudley(b.polygon, NULL, &of_b), BMR_OK);
    a.hierarchies[BMR_HIERARCHY_DUDLEY] = of_a;
    // Of the second the old lines are support lines, up to rounding: the stamp alone tells.
    const double widths[] = {2.0, 1.0 + 0x1p-48, 1.0};
    for (int k = 0; k < 3; ++k) {
        const bool same = widths[k] == 1.0;
        b = triangle_in_place(widths[k], &one_place);
        b.hierarchies[BMR_HIERARCHY_DUDLEY] = of_b;
        const bmr_error expected = same ? BMR_OK : BMR_ERROR_WRONG_HIERARCHY;
        assert_ptr_equal(bmr_hierarchy_polygon(of_b), b.polygon);
        assert_int_equal(bmr_hierarchy_audit(of_b), same ? BMR_OK : BMR_ERROR_INVALID_STRUCTURE);
        bmr_kds *kds = NULL;
        assert_int_equal(bmr_kds_create(info, &def, &a, &b, NULL, &kds), expected);
        bmr_kds_destroy(kds, NULL);
        kds = NULL;
        assert_int_equal(bmr_kds_create(info, &def, &b, &a, NULL, &kds), expected);
        bmr_kds_destroy(kds, NULL);
    }
    bmr_polygon_destroy((bmr_polygon *)(uintptr_t)a.polygon, NULL);
}
