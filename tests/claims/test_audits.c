// SPDX-License-Identifier: MIT
// Audits see what is wrong in a state, each promise by itself: what is damaged here is damaged nowhere else.
#include "boomerang/mass.h"
#include "boomerang/pair.h"
#include "boomerang/polygon.h"
#include "certificate/walk.h"
#include "checks.h"
#include "kds/point.h"
#include "kds/structure.h"
#include "kds/windowed_line.h"
#include "kds_driver.h"
#include "motions.h"
#include "polygons.h"

static test_kds_body regular(size_t n) {
    test_random random = test_random_from(n);
    return test_kds_body_make(test_polygon(TEST_REGULAR, n, &random));
}

/// A structure of a name, started at a distance.
typedef struct stage {
    test_kds_body a, b;
    bmr_instant now;
    bmr_kds *kds;
} stage;

static stage stage_of(const char *name, test_kds_body a, test_kds_body b, double gap) {
    stage s = {a, b, {test_pose_at(a.polygon, b.polygon, 0.3, 0.5, gap), {0.0, 0.0}, 0.0}, NULL};
    const bmr_kds_def def = bmr_default_kds_def();
    const bmr_kds_info *info = test_structure(name);
    assert_non_null(info);
    assert_int_equal(bmr_kds_create(info, &def, &s.a.shape, &s.b.shape, NULL, &s.kds), BMR_OK);
    assert_ptr_equal(s.kds->info, info);
    bmr_kds_report report;
    bmr_kds_repair(s.kds, &s.now, 0, &report); // before its start there is nothing to repair
    assert_int_equal(report.kind, BMR_KDS_NONE);
    assert_false(report.apart);
    bmr_kds_start(s.kds, &s.now, &report);
    assert_true(report.apart);
    assert_int_equal(bmr_kds_audit(s.kds, &s.now.pose), BMR_OK);
    return s;
}
static void stage_destroy(stage *s) {
    bmr_kds_destroy(s->kds, NULL);
    test_kds_body_destroy(&s->a);
    test_kds_body_destroy(&s->b);
}
#define own_stage OWNED(stage_destroy) stage

static void assert_refused(const stage *s) {
    assert_int_equal(bmr_kds_audit(s->kds, &s->now.pose), BMR_ERROR_INVALID_STRUCTURE);
}

TEST(the_edge_and_the_corner_of_a_lazy_structure_are_of_its_level) {
    own_stage s = stage_of("lazy-dudley", regular(64), regular(64), 1e-3);
    bmr_lazy_place *lazy = (bmr_lazy_place *)(void *)s.kds->state; // it begins with it
    const bmr_lazy_place right = *lazy;
    const bmr_hierarchy *h = s.a.hierarchies[BMR_HIERARCHY_DUDLEY];
    const bmr_edge last = bmr_hierarchy_edge_count(h) - 1;
    assert_int_equal(bmr_hierarchy_level(h, last), bmr_hierarchy_depth(h));
    lazy->corner.before = last; // of a deeper level
    assert_refused(&s);
    lazy->corner.before = right.corner.after; // not the edge before this one
    assert_refused(&s);
    *lazy = right;
    assert_true(bmr_hierarchy_level(h, lazy->edge) > 0);
    lazy->level = 0; // above its edge
    assert_refused(&s);
    *lazy = right;
    assert_int_equal(bmr_kds_audit(s.kds, &s.now.pose), BMR_OK);
}

/// Below the deepest level there is none to begin with: the deepest is all.
TEST(an_inflation_may_begin_below_both_hierarchies) {
    own_kds_body a = regular(24), b = regular(16);
    bmr_kds_def def = bmr_default_kds_def();
    def.root_level = 50;
    own_kds *kds = NULL;
    assert_int_equal(
        bmr_kds_create(test_structure("inflated-translation"), &def, &a.shape, &b.shape, NULL, &kds), BMR_OK);
    const bmr_instant now = {test_pose_at(a.polygon, b.polygon, 0.3, 0.5, 0.2), {0.0, 0.0}, 0.0};
    bmr_kds_report report;
    bmr_kds_start(kds, &now, &report);
    assert_true(report.apart);
    assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_OK);
}

TEST(the_edge_of_a_triangle_is_one_of_the_hierarchy) {
    own_stage s = stage_of("triangle-levels-dudley", regular(64), test_kds_point_make(0.125, 0.0), 0.1);
    bmr_point_state *point = bmr_point_get(s.kds);
    const bmr_edge right = point->edge;
    assert_true(right != BMR_NO_EDGE);
    // Every edge but its own and those whose triangles it is in, too: it is in no triangle of the far side.
    size_t refused = 0;
    for (bmr_edge edge = 0; edge < bmr_hierarchy_edge_count(point->hierarchy); ++edge) {
        point->edge = edge;
        refused += bmr_kds_audit(s.kds, &s.now.pose) != BMR_OK;
    }
    assert_true(refused > 32);
    point->edge = right;
}

/// How the state of the separating edge begins.
typedef struct edge_begin {
    bmr_line line;
    int owner;
    bool is_edge;
    uint32_t edge, vertex;
} edge_begin;

TEST(the_separating_edge_has_its_own_line_and_the_nearest_vertex) {
    own_stage s = stage_of("separating-edge-walk", regular(16), regular(16), 0.2);
    edge_begin *e = (edge_begin *)(void *)s.kds->state;
    assert_true(e->is_edge);
    const edge_begin right = *e;
    e->line.offset += 0.01; // separates still
    assert_refused(&s);
    *e = right;
    e->vertex = (right.vertex + 8) % 16;
    assert_refused(&s);
    *e = right;
    assert_int_equal(bmr_kds_audit(s.kds, &s.now.pose), BMR_OK);
}

/// A sum has as many vertices as both, and its block is made for all of them: what could not be is refused at
/// once.
TEST(sums_that_are_too_large_are_refused) {
    const bmr_kds_def def = bmr_default_kds_def();
    const bmr_kds_info *info = test_structure("sum-triangle-dudley");
    test_random random = test_random_from(1);
    own_polygon *many = test_polygon(TEST_REGULAR, BMR_MAX_VERTICES / 2 + 1, &random);
    const bmr_vec2 far[] = {{0.75 * BMR_MAX_COORDINATE, 0.0}, {0.0, 0.75 * BMR_MAX_COORDINATE}, {0.0, 0.0}};
    own_polygon *large = made_polygon(far, 3);
    for (int k = 0; k < 2; ++k) {
        bmr_shape shape;
        memset(&shape, 0, sizeof shape);
        shape.polygon = k == 0 ? many : large;
        bmr_kds *kds = NULL;
        assert_int_equal(bmr_kds_create(info, &def, &shape, &shape, NULL, &kds), BMR_ERROR_OUT_OF_RANGE);
        assert_null(kds);
    }
}

TEST(a_certificate_whose_bracket_is_wider_than_half_a_turn_is_none) {
    test_random random = test_random_from(3);
    own_polygon *p = test_polygon(TEST_REGULAR, 8, &random);
    const bmr_pose right = {{4.0, 0.0}, 1.0, 0.0};
    bmr_certificate k;
    memset(&k, 0, sizeof k);
    k.normal[0] = 1.0f;
    k.offset = 1.5f;
    for (int i = 0; i < 2; ++i)
        k.window[i][0] = -1.5f;
    k.low[0] = k.high[0] = 0.5f;
    k.low[1] = 0.8660254f;
    k.high[1] = -0.8660254f;
    double gap;
    assert_int_equal(bmr_certificate_check(&k, &right, 0.0, &gap), BMR_CHECK_ROLLED);
    assert_int_equal(bmr_certificate_audit(&k, p, p, &right), BMR_ERROR_FALSE_CERTIFICATE);
}

TEST(a_polygon_beyond_the_range_is_refused) {
    test_random random = test_random_from(3);
    bmr_polygon *p = test_polygon(TEST_REGULAR, 8, &random);
    const bmr_polygon right = *p;
    bmr_vec2 *vertices = (bmr_vec2 *)p->vertices;
    const bmr_vec2 first = vertices[0];
    vertices[0].x = 2.0 * BMR_MAX_COORDINATE;
    assert_int_equal(bmr_polygon_audit(p), BMR_ERROR_OUT_OF_RANGE);
    bmr_hierarchy *h = NULL;
    vertices[0] = first;
    assert_int_equal(bmr_hierarchy_build_dudley(p, NULL, &h), BMR_OK);
    vertices[0].x = 2.0 * BMR_MAX_COORDINATE;
    assert_int_equal(bmr_hierarchy_audit(h), BMR_ERROR_OUT_OF_RANGE); // what its polygon's audit says
    vertices[0] = first;
    assert_int_equal(bmr_hierarchy_audit(h), BMR_OK);
    bmr_hierarchy_destroy(h, NULL);
    p->lowest = (uint16_t)p->count;
    assert_int_equal(bmr_polygon_audit(p), BMR_ERROR_INVALID_STRUCTURE);
    *p = right;
    bmr_polygon_destroy(p, NULL);
}

TEST(audit_refuses_wrong_measures) {
    bmr_vec2 points[16];
    test_regular_points(16, 1.0, 0.1, points);
    bmr_polygon *polygon = made_polygon(points, 16);
    assert_int_equal(bmr_polygon_audit(polygon), BMR_OK);
    const bmr_polygon good = *polygon;
    polygon->radius = 0.999 * good.radius;
    assert_int_equal(bmr_polygon_audit(polygon), BMR_ERROR_INVALID_STRUCTURE);
    *polygon = good;
    polygon->extent = nextafter(good.extent, 0.0);
    assert_int_equal(bmr_polygon_audit(polygon), BMR_ERROR_INVALID_STRUCTURE);
    *polygon = good;
    polygon->highest = (uint16_t)(good.highest + 1);
    assert_int_equal(bmr_polygon_audit(polygon), BMR_ERROR_INVALID_STRUCTURE);
    *polygon = good;
    polygon->lowest = 1;
    assert_int_equal(bmr_polygon_audit(polygon), BMR_ERROR_INVALID_STRUCTURE);
    *polygon = good;
    polygon->count = 0;
    assert_int_equal(bmr_polygon_audit(polygon), BMR_ERROR_INVALID_STRUCTURE);
    *polygon = good;
    ((bmr_vec2 *)(polygon + 1))[3].x = NAN; // the vertices lie in the same block
    assert_int_equal(bmr_polygon_audit(polygon), BMR_ERROR_NOT_FINITE);
    bmr_polygon_destroy(polygon, NULL);
}

TEST(what_has_no_area_has_no_mass) {
    const bmr_vec2 points[] = {{0.0, 0.0}, {3.0, 0.0}};
    own_polygon *segment = made_polygon(points, 2);
    bmr_mass mass = {-7.0, {0.0, 0.0}, 0.0};
    assert_int_equal(bmr_polygon_mass(segment, &mass), BMR_ERROR_OUT_OF_RANGE);
    assert_int_equal(bmr_polygon_mass(NULL, &mass), BMR_ERROR_NULL_ARGUMENT);
    assert_true(mass.area == -7.0);
}
