// SPDX-License-Identifier: MIT
// Every function of core that takes an allocator, with every one of its allocations failing once. (That none
// is missing here is bad_input/check_allocators.sh's to see.)
#include <math.h>
#include <stdio.h>
#include <string.h>

#define CHECKS_OWN_MAIN
#include "checks.h"

#include "boomerang/kds.h"
#include "boomerang/minkowski.h"
#include "boomerang/outline.h"
#include "convex32/convex32.h"
#include "convex32/convex32_pieces.h"
#include "every_allocation.h"
#include "hierarchy/mixed_cells.h"

enum { COUNT = 60 };
static bmr_vec2 points[COUNT];
static bmr_vec32 points32[COUNT];
static bmr_polygon *polygon, *point;
static bmr_compass *compass;
static bmr_shape shape, point_shape;
static bmr_convex32_block *convex;
static bmr_mixed mixed;

static int prepare(void) {
    for (int i = 0; i < COUNT; ++i) {
        const double angle = 6.283185307179586 * i / COUNT;
        points[i] = bmr_vec2_make(3.0 * cos(angle), sin(angle));
        points32[i] = (bmr_vec32){(float)points[i].x, (float)points[i].y};
    }
    bmr_hierarchy *made[BMR_HIERARCHY_KIND_COUNT] = {NULL};
    int errors = (int)bmr_polygon_create(points, COUNT, NULL, &polygon) |
                 (int)bmr_polygon_create(points, 1, NULL, &point) |
                 (int)bmr_compass_create(COUNT, NULL, &compass) |
                 (int)bmr_convex32_create(points32, COUNT, NULL, &convex);
    if (errors != 0)
        return errors;
    for (int k = 0; k < 2; ++k) {
        bmr_shape *s = k == 0 ? &shape : &point_shape;
        s->polygon = k == 0 ? polygon : point;
        errors |= (int)bmr_hierarchy_build_compass(s->polygon, compass, NULL, &made[BMR_HIERARCHY_COMPASS]) |
                  (int)bmr_hierarchy_build_dudley(s->polygon, NULL, &made[BMR_HIERARCHY_DUDLEY]) |
                  (int)bmr_hierarchy_build_dobkin_kirkpatrick(s->polygon, NULL,
                                                              &made[BMR_HIERARCHY_DOBKIN_KIRKPATRICK]);
        for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind)
            s->hierarchies[kind] = made[kind];
    }
    mixed = bmr_mixed_make(shape.hierarchies[0], shape.hierarchies[0], 0.8, 0.6, 0.0);
    return errors;
}

static void give_back(void) {
    for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
        bmr_hierarchy_destroy((bmr_hierarchy *)shape.hierarchies[kind], NULL);
        bmr_hierarchy_destroy((bmr_hierarchy *)point_shape.hierarchies[kind], NULL);
    }
    bmr_compass_destroy(compass, NULL);
    bmr_polygon_destroy(polygon, NULL);
    bmr_polygon_destroy(point, NULL);
    bmr_convex32_destroy(convex, NULL);
}

// What must stay as it is where there is an error.
static bmr_polygon no_polygon;
static bmr_convex32_block no_convex;

static bmr_error made_polygon(bmr_error error, bmr_polygon *made, const bmr_allocator *allocator,
                              uint64_t *bits) {
    if (error != BMR_OK)
        return made == &no_polygon ? error : BMR_ERROR_COUNT;
    test_hash(bits, made->vertices, made->count * sizeof *made->vertices);
    test_hash(bits, &made->center, sizeof made->center);
    bmr_polygon_destroy(made, allocator);
    return BMR_OK;
}

static bmr_error run_polygon_create(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_polygon *made = &no_polygon;
    const bmr_error error = bmr_polygon_create(points, COUNT, allocator, &made);
    return made_polygon(error, made, allocator, bits);
}

static bmr_error run_polygon_create_raw(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_polygon *made = &no_polygon;
    const bmr_error error = bmr_polygon_create_raw(points, COUNT, allocator, &made);
    return made_polygon(error, made, allocator, bits);
}

static bmr_error run_polygon_copy(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_polygon *made = &no_polygon;
    const bmr_error error = bmr_polygon_copy(polygon, allocator, &made);
    return made_polygon(error, made, allocator, bits);
}

static bmr_error run_minkowski_difference(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_polygon *made = &no_polygon;
    const bmr_error error =
        bmr_minkowski_difference(polygon, polygon, bmr_vec2_make(0.8, 0.6), allocator, &made);
    return made_polygon(error, made, allocator, bits);
}

static bmr_error made_convex(bmr_error error, bmr_convex32_block *made, const bmr_allocator *allocator,
                             uint64_t *bits) {
    if (error != BMR_OK)
        return made == &no_convex ? error : BMR_ERROR_COUNT;
    const bmr_convex32 *p = &made->polygon;
    test_hash(bits, p->vertices, p->count * sizeof *p->vertices);
    test_hash(bits, p->normals, p->count * sizeof *p->normals);
    test_hash(bits, p->buckets, ((size_t)1 << p->bucket_bits) * sizeof *p->buckets);
    bmr_convex32_destroy(made, allocator);
    return BMR_OK;
}

static bmr_error run_convex32_create(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_convex32_block *made = &no_convex;
    const bmr_error error = bmr_convex32_create(points32, COUNT, allocator, &made);
    return made_convex(error, made, allocator, bits);
}

static bmr_error run_convex32_create_raw(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_convex32_block *made = &no_convex;
    const bmr_error error =
        bmr_convex32_create_raw(convex->polygon.vertices, convex->polygon.count, allocator, &made);
    return made_convex(error, made, allocator, bits);
}

/// Every other edge is an inner one.
static bmr_error run_convex32_create_piece(const bmr_allocator *allocator, uint64_t *bits) {
    const bmr_convex32 *hull = &convex->polygon;
    bmr_piece_corner32 corners[COUNT];
    bmr_convex32_block *made = &no_convex;
    for (uint32_t i = 0; i < hull->count; ++i) {
        const uint32_t next = i + 1 < hull->count ? i + 1 : 0;
        corners[i] = (bmr_piece_corner32){hull->vertices[i], hull->vertices[next], i % 2 == 0};
    }
    const bmr_error error = bmr_convex32_create_piece(corners, hull->count, allocator, &made);
    return made_convex(error, made, allocator, bits);
}

static bmr_error run_convex32_simplify(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_vec32 left[COUNT] = {{77.0f, 77.0f}};
    size_t count = 77;
    const bmr_error error = bmr_convex32_simplify(&convex->polygon, 0.05f, allocator, left, &count);
    if (error != BMR_OK)
        return count == 77 && left[0].x == 77.0f ? error : BMR_ERROR_COUNT;
    test_hash(bits, left, count * sizeof *left);
    return BMR_OK;
}

static bmr_error made_hierarchy(bmr_error error, bmr_hierarchy *made, const bmr_allocator *allocator,
                                uint64_t *bits) {
    if (error != BMR_OK)
        return made == NULL ? error : BMR_ERROR_COUNT;
    for (bmr_edge edge = 0; edge < bmr_hierarchy_edge_count(made); ++edge) {
        const bmr_line line = bmr_hierarchy_line(made, edge);
        const bmr_boomerang boomerang = bmr_hierarchy_boomerang(made, edge);
        test_hash(bits, &line, sizeof line);
        test_hash(bits, &boomerang, sizeof boomerang);
    }
    bmr_hierarchy_destroy(made, allocator);
    return BMR_OK;
}

static bmr_error run_hierarchy_build_compass(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_hierarchy *made = NULL;
    const bmr_error error = bmr_hierarchy_build_compass(polygon, compass, allocator, &made);
    return made_hierarchy(error, made, allocator, bits);
}

static bmr_error run_hierarchy_build_dudley(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_hierarchy *made = NULL;
    const bmr_error error = bmr_hierarchy_build_dudley(polygon, allocator, &made);
    return made_hierarchy(error, made, allocator, bits);
}

static bmr_error run_hierarchy_build_dobkin_kirkpatrick(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_hierarchy *made = NULL;
    const bmr_error error = bmr_hierarchy_build_dobkin_kirkpatrick(polygon, allocator, &made);
    return made_hierarchy(error, made, allocator, bits);
}

static bmr_error run_hierarchy_copy(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_hierarchy *made = NULL;
    const bmr_error error =
        bmr_hierarchy_copy(shape.hierarchies[BMR_HIERARCHY_DUDLEY], polygon, allocator, &made);
    return made_hierarchy(error, made, allocator, bits);
}

static bmr_error run_hierarchy_build_compass_with_corners(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_hierarchy *made = NULL;
    const bmr_error error = bmr_hierarchy_build_compass_with_corners(polygon, compass, 2, allocator, &made);
    return made_hierarchy(error, made, allocator, bits);
}

static bmr_error run_chains_create(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_chains *made = NULL;
    const bmr_error error = bmr_chains_create(shape.hierarchies[BMR_HIERARCHY_DUDLEY], allocator, &made);
    if (error != BMR_OK)
        return made == NULL ? error : BMR_ERROR_COUNT;
    const size_t bytes = bmr_chains_bytes(made);
    test_hash(bits, &bytes, sizeof bytes);
    bmr_chains_destroy(made, allocator);
    return BMR_OK;
}

static bmr_error run_compass_create(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_compass *made = NULL;
    const bmr_error error = bmr_compass_create(COUNT, allocator, &made);
    if (error != BMR_OK)
        return made == NULL ? error : BMR_ERROR_COUNT;
    bmr_hierarchy *hierarchy = NULL;
    const bmr_error built = bmr_hierarchy_build_compass(polygon, made, NULL, &hierarchy);
    const bmr_error result = made_hierarchy(built, hierarchy, NULL, bits);
    bmr_compass_destroy(made, allocator);
    return result;
}

static bmr_error run_mixed_tiling_create(const bmr_allocator *allocator, uint64_t *bits) {
    bmr_mixed_tiling *made = NULL;
    const bmr_error error = bmr_mixed_tiling_create(&mixed, allocator, &made);
    if (error != BMR_OK)
        return made == NULL ? error : BMR_ERROR_COUNT;
    for (uint32_t tile = 0; tile < bmr_mixed_tiling_count(made); ++tile)
        test_hash(bits, bmr_mixed_tiling_cell(made, tile), sizeof(bmr_mixed_cell));
    bmr_mixed_tiling_destroy(made, allocator);
    return BMR_OK;
}

/// All structures, one after another: those on an explicit sum or tiling allocate for it.
static bmr_error run_kds_create(const bmr_allocator *allocator, uint64_t *bits) {
    const bmr_kds_def def = bmr_default_kds_def();
    const bmr_instant now = {{{9.0, 2.0}, 0.8, 0.6}, {0.0, 0.0}, 0.0};
    for (size_t i = 0; i < bmr_kds_count(); ++i) {
        const bmr_kds_info *info = bmr_kds_at(i);
        bmr_kds *made = NULL;
        const bmr_error error = bmr_kds_create(
            info, &def, &shape, info->domain == BMR_KDS_POINT ? &point_shape : &shape, allocator, &made);
        if (error != BMR_OK)
            return made == NULL ? error : BMR_ERROR_COUNT;
        bmr_kds_report report;
        bmr_kds_start(made, &now, &report);
        bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
        const size_t count = bmr_kds_conditions(made, conditions);
        test_hash(bits, &count, sizeof count);
        for (size_t k = 0; k < count; ++k) {
            test_hash(bits, &conditions[k].normal, sizeof conditions[k].normal);
            test_hash(bits, &conditions[k].offset, sizeof conditions[k].offset);
        }
        bmr_kds_destroy(made, allocator);
    }
    return BMR_OK;
}

// A star of many notches, and one with a hole.
enum { STAR = BMR_OUTLINE_OPTIMAL_POINTS };
static bmr_vec2 star_points[STAR + 4];
static const uint32_t star_counts[] = {STAR, 4};

static bmr_rings star_with(uint32_t holes) {
    for (uint32_t i = 0; i < STAR; ++i) {
        const double angle = 6.283185307179586 * i / STAR,
                     radius = 1.0 + 0.5 * ((i * 7919 + 3) % 101) / 100.0;
        star_points[i] = bmr_vec2_make(radius * cos(angle), radius * sin(angle));
    }
    for (uint32_t i = 0; i < 4; ++i)
        star_points[STAR + i] = bmr_vec2_make(i % 2 * (i - 2.0) * 0.5, (1.0 - i % 2) * (i - 1.0) * 0.5);
    return (bmr_rings){star_points, star_counts, 1 + holes};
}

static const bmr_outline_fault no_fault = {BMR_ERROR_COUNT, {0, 0}, {0, 0}, {0.0, 0.0}};

static bmr_error run_outline_check(const bmr_allocator *allocator, uint64_t *bits) {
    const bmr_rings rings = star_with(1);
    bmr_outline_fault fault = no_fault;
    const bmr_error error = bmr_outline_check(&rings, allocator, &fault);
    if (error != BMR_OK)
        return fault.error == BMR_ERROR_COUNT ? error : BMR_ERROR_COUNT;
    test_hash(bits, &fault.error, sizeof fault.error);
    return BMR_OK;
}

static bmr_error run_outline_simplify(const bmr_allocator *allocator, uint64_t *bits) {
    const bmr_rings rings = star_with(1);
    uint32_t kept[STAR + 4] = {77}, counts[2] = {77, 77};
    bmr_outline_fault fault = no_fault;
    const bmr_error error = bmr_outline_simplify(&rings, 0.1, allocator, kept, counts, &fault);
    if (error != BMR_OK)
        return kept[0] == 77 && counts[0] == 77 && fault.error == BMR_ERROR_COUNT ? error : BMR_ERROR_COUNT;
    test_hash(bits, counts, sizeof counts);
    test_hash(bits, kept, (counts[0] + counts[1]) * sizeof *kept);
    return BMR_OK;
}

static bmr_error run_outline_decompose(const bmr_allocator *allocator, uint64_t *bits) {
    static bmr_outline_pieces no_pieces;
    for (uint32_t i = 0; i < 3; ++i) {
        const bmr_rings rings = star_with(i % 2);
        const bmr_outline_def def = {i == 2 ? 0.1 : 0.0};
        bmr_outline_pieces *made = &no_pieces;
        bmr_outline_fault fault = no_fault;
        const bmr_error error = bmr_outline_decompose(&rings, &def, allocator, &made, &fault);
        if (error != BMR_OK)
            return made == &no_pieces && fault.error == BMR_ERROR_COUNT ? error : BMR_ERROR_COUNT;
        test_hash(bits, made->edges, made->edge_count * sizeof *made->edges);
        test_hash(bits, made->first, (made->piece_count + 1) * sizeof *made->first);
        bmr_outline_pieces_destroy(made, allocator);
    }
    return BMR_OK;
}

static const test_attempt attempts[] = {
    {"bmr_polygon_create", run_polygon_create},
    {"bmr_polygon_create_raw", run_polygon_create_raw},
    {"bmr_polygon_copy", run_polygon_copy},
    {"bmr_outline_check", run_outline_check},
    {"bmr_outline_simplify", run_outline_simplify},
    {"bmr_outline_decompose", run_outline_decompose},
    {"bmr_minkowski_difference", run_minkowski_difference},
    {"bmr_convex32_create", run_convex32_create},
    {"bmr_convex32_create_raw", run_convex32_create_raw},
    {"bmr_convex32_create_piece", run_convex32_create_piece},
    {"bmr_convex32_simplify", run_convex32_simplify},
    {"bmr_compass_create", run_compass_create},
    {"bmr_hierarchy_build_compass", run_hierarchy_build_compass},
    {"bmr_hierarchy_build_compass_with_corners", run_hierarchy_build_compass_with_corners},
    {"bmr_chains_create", run_chains_create},
    {"bmr_hierarchy_build_dudley", run_hierarchy_build_dudley},
    {"bmr_hierarchy_build_dobkin_kirkpatrick", run_hierarchy_build_dobkin_kirkpatrick},
    {"bmr_hierarchy_copy", run_hierarchy_copy},
    {"bmr_mixed_tiling_create", run_mixed_tiling_create},
    {"bmr_kds_create", run_kds_create},
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

// --- controls: functions that must not pass ---

static bmr_error leak(const bmr_allocator *allocator, uint64_t *bits) {
    static void *first; // which a checker of the whole program shall not call lost
    first = allocator->allocate(allocator->context, 8);
    void *second = first ? allocator->allocate(allocator->context, 8) : NULL;
    if (!second)
        return BMR_ERROR_NO_MEMORY; // the first stays out
    allocator->release(allocator->context, second, 8);
    allocator->release(allocator->context, first, 8);
    test_hash(bits, "x", 1);
    return BMR_OK;
}

static bmr_error hide(const bmr_allocator *allocator, uint64_t *bits) {
    void *block = allocator->allocate(allocator->context, 8);
    if (block)
        allocator->release(allocator->context, block, 8);
    test_hash(bits, block ? "x" : "y", 1);
    return BMR_OK;
}

static bmr_error confuse_sizes(const bmr_allocator *allocator, uint64_t *bits) {
    void *block = allocator->allocate(allocator->context, 8);
    if (!block)
        return BMR_ERROR_NO_MEMORY;
    allocator->release(allocator->context, block, 16);
    test_hash(bits, "x", 1);
    return BMR_OK;
}

TEST(what_leaks_or_hides_is_found) {
    const test_attempt bad[] = {{"leak", leak}, {"hide", hide}, {"confuse_sizes", confuse_sizes}};
    for (size_t i = 0; i < 3; ++i)
        assert_non_null(test_every_allocation(&bad[i]));
}

int main(int argc, char **argv) {
    if (argc > 1 && strcmp(argv[1], "--list") == 0) {
        for (size_t i = 0; i < ATTEMPTS; ++i)
            printf("%s\n", attempts[i].name);
        return 0;
    }
    return check_run("");
}
