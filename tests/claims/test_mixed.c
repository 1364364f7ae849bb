// SPDX-License-Identifier: MIT
// The mixed hierarchy against brute force over all tiles: what lies across each side; its cells where they
// are known beforehand; and the lemmas of section 4, with their constants: its size, what happens to it in a
// full turn, and how many of its cells are tall or lie on a line. (That they tile, and which holds a point:
// tests/random/fuzz_hierarchy.cpp.)
#include "checks.h"
#include "failing_allocator.h"
#include "hierarchies.h"
#include "hierarchy/mixed.h"
#include "hierarchy/mixed_cells.h"
#include "motions.h"

#define TWO_PI 6.283185307179586
static const bmr_hierarchy_kind kinds[] = {BMR_HIERARCHY_COMPASS, BMR_HIERARCHY_DUDLEY};

/// Two polygons with their hierarchies and the tiling at one rotation.
typedef struct scene {
    bmr_polygon *polygons[2];
    bmr_hierarchy *hierarchies[2];
    double angle;
    bmr_mixed mixed;
    bmr_mixed_tiling *tiling;
} scene;

static scene scene_of(bmr_polygon *a, bmr_polygon *b, bmr_hierarchy_kind kind, double angle, double offset) {
    scene s = {.polygons = {a, b}, .angle = angle};
    for (int i = 0; i < 2; ++i)
        s.hierarchies[i] = test_hierarchy(kind, s.polygons[i]);
    s.mixed = bmr_mixed_make(s.hierarchies[0], s.hierarchies[1], cos(angle), sin(angle), offset);
    assert_int_equal(bmr_mixed_tiling_create(&s.mixed, NULL, &s.tiling), BMR_OK);
    return s;
}

static void scene_turn(scene *s, double angle) {
    s->angle = angle;
    s->mixed.c = cos(angle);
    s->mixed.s = sin(angle);
    bmr_mixed_tiling_destroy(s->tiling, NULL);
    assert_int_equal(bmr_mixed_tiling_create(&s->mixed, NULL, &s->tiling), BMR_OK);
}

static void scene_destroy(scene *s) {
    bmr_mixed_tiling_destroy(s->tiling, NULL);
    for (int i = 0; i < 2; ++i) {
        bmr_hierarchy_destroy(s->hierarchies[i], NULL);
        bmr_polygon_destroy(s->polygons[i], NULL);
    }
}

#define own_scene OWNED(scene_destroy) scene

/// An angle of 0 a third of the time, a compass angle another third: aligned hierarchies.
static double some_angle(test_random *random) {
    const uint32_t way = test_random_below(random, 3);
    if (way == 0)
        return 0.0;
    return way == 1 ? TWO_PI / 64.0 * test_random_below(random, 64) : test_random_uniform(random, 0, TWO_PI);
}

static scene random_scene(bmr_hierarchy_kind kind, size_t n, size_t m, test_random *random) {
    const test_family f = (test_family)test_random_below(random, TEST_FAMILY_COUNT);
    const test_family g = (test_family)test_random_below(random, TEST_FAMILY_COUNT);
    bmr_polygon *a = test_polygon(f, n, random), *b = test_polygon(g, m, random);
    return scene_of(a, b, kind, some_angle(random), 0.0);
}

static double size_of(const scene *s) {
    return s->polygons[0]->radius + s->polygons[1]->radius;
}

// --- neighbours ---

/// Brute force: in how many tiles is x, the last one, and how far is x from the border of any.
typedef struct cover {
    uint32_t count, tile;
    double clearance;
} cover;

static bool is_in_box(const bmr_vec2 *p, size_t count, bmr_vec2 x) {
    bmr_vec2 low = p[0], high = p[0];
    for (size_t k = 1; k < count; ++k) {
        low = bmr_vec2_make(fmin(low.x, p[k].x), fmin(low.y, p[k].y));
        high = bmr_vec2_make(fmax(high.x, p[k].x), fmax(high.y, p[k].y));
    }
    return low.x <= x.x && x.x <= high.x && low.y <= x.y && x.y <= high.y;
}

static cover cover_of(const scene *s, bmr_vec2 x) {
    cover c = {0, BMR_MIXED_NO_TILE, INFINITY};
    for (uint32_t i = 0; i < bmr_mixed_tiling_count(s->tiling); ++i) {
        bmr_vec2 p[BMR_MIXED_MAX_SIDES];
        const size_t count = bmr_mixed_polygon(&s->mixed, bmr_mixed_tiling_cell(s->tiling, i), p);
        // A sliver of nothing but rounding has no inside, but may have half planes that meet far away.
        bool inside = is_in_box(p, count, x);
        for (size_t k = 0; k < count; ++k) {
            const bmr_vec2 e = bmr_sub(p[(k + 1) % count], p[k]), r = bmr_sub(x, p[k]);
            const double length = hypot(e.x, e.y), along = bmr_dot(r, e);
            inside &= bmr_cross(e, r) > 0.0 || length == 0.0;
            if (length > 0.0 && along > -1e-9 && along < length * length + 1e-9)
                c.clearance = fmin(c.clearance, fabs(bmr_cross(e, r)) / length);
        }
        c.count += inside;
        c.tile = inside ? i : c.tile;
    }
    return c;
}

/// Lemma 4.3: the neighbour of a cell at a point of its border is found in O(log n).
TEST(across_each_side_lies_the_tile_that_brute_force_finds) {
    test_random random = test_random_from(405);
    size_t compared = 0, inwards = 0, wrong_role = 0;
    unsigned most = 0;
    for (size_t round = 0; round < test_scaled(60); ++round) {
        const size_t n = 3 + test_random_below(&random, 30), m = 3 + test_random_below(&random, 30);
        own_scene s = random_scene(kinds[round % 2], n, m, &random);
        const uint32_t tiles = bmr_mixed_tiling_count(s.tiling);
        for (int k = 0; k < 100 && tiles > 0; ++k) {
            const uint32_t tile = test_random_below(&random, tiles);
            const bmr_mixed_cell *cell = bmr_mixed_tiling_cell(s.tiling, tile);
            bmr_mixed_figure figure;
            bmr_vec2 p[BMR_MIXED_MAX_SIDES];
            bmr_mixed_draw(&s.mixed, cell, &figure);
            const size_t count = bmr_mixed_polygon(&s.mixed, cell, p);
            assert_int_equal(figure.sides, count);
            const size_t i = test_random_below(&random, (uint32_t)count);
            const bmr_vec2 e = bmr_sub(p[(i + 1) % count], p[i]);
            const double length = hypot(e.x, e.y);
            if (length < 1e-6 * size_of(&s))
                continue;
            const bmr_vec2 out = bmr_vec2_make(e.y / length, -e.x / length);
            const bmr_vec2 x = bmr_add(p[i], bmr_scale(test_random_uniform(&random, 0.001, 0.999), e));
            const bmr_vec2 beyond = bmr_add(x, bmr_scale(1e-9 * size_of(&s), out));
            assert_true(fabs(bmr_mixed_figure_value(&s.mixed, &figure, i, x)) <= 1e-12 * size_of(&s));
            assert_true(bmr_mixed_figure_value(&s.mixed, &figure, i, beyond) < 0.0);
            const cover c = cover_of(&s, beyond);
            const bmr_mixed_role role = (bmr_mixed_role)figure.parts[i].role;
            if (c.clearance < 1e-12 * size_of(&s) || (c.count == 0 && role == BMR_MIXED_INNER))
                continue; // on another border; or into the sum, or a sliver before it
            const bmr_mixed_ray ray = {x, out};
            unsigned touched = 0;
            const bmr_mixed_cell next = bmr_mixed_next(&s.mixed, cell, role, &ray, &touched);
            const uint32_t found = bmr_mixed_tiling_find(s.tiling, &next);
            if (found != c.tile) { // a sliver may lie between
                bmr_mixed_cell there = next;
                assert_true(bmr_mixed_walk(&s.mixed, &there, x, beyond, NULL));
                assert_int_equal(bmr_mixed_tiling_find(s.tiling, &there), c.tile);
                continue;
            }
            // O(j): not more stages than lie between the two.
            const int32_t from = bmr_mixed_stage(&s.mixed, cell), to = bmr_mixed_stage(&s.mixed, &next);
            assert_true((int32_t)touched <= 1 + (to > from ? to - from : 0));
            most = touched > most ? touched : most;
            if (role == BMR_MIXED_INNER) {
                uint32_t below;
                const uint32_t *list = bmr_mixed_tiling_below(s.tiling, tile, &below);
                bool listed = false;
                for (uint32_t j = 0; j < below; ++j)
                    listed |= list[j] == found;
                assert_true(listed);
                ++inwards;
            } else {
                assert_int_equal(bmr_mixed_tiling_across(s.tiling, tile, role), found);
                // control: through another side it would be another tile
                const bmr_mixed_role other = role == BMR_MIXED_LOW ? BMR_MIXED_HIGH : BMR_MIXED_LOW;
                wrong_role += bmr_mixed_tiling_across(s.tiling, tile, other) != found;
            }
            ++compared;
        }
    }
    printf("compared %zu sides, %zu of them inwards; at most %u stages looked at\n", compared, inwards, most);
    assert_true(inwards > 0 && compared > inwards && wrong_role > 0);
}

// --- a diamond and a square, whose cells can be written down by hand ---

static scene diamond_and_square(void) {
    static const bmr_vec2 diamond[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    bmr_vec2 square[4];
    test_box_points(0.25, 0.25, square);
    return scene_of(made_polygon(diamond, 4), made_polygon(square, 4), BMR_HIERARCHY_COMPASS, 0.3, 0.0);
}

/// The cell at a point, found from its upper right.
static bmr_mixed_cell cell_at(const bmr_mixed *mixed, double x, double y) {
    bmr_mixed_cell cell;
    unsigned touched = 0;
    assert_true(bmr_mixed_locate(mixed, bmr_vec2_make(x, y), bmr_vec2_make(0.61, 0.79), &cell, &touched));
    return cell;
}

TEST(what_is_no_cell_has_neither_corners_nor_height_nor_neighbours) {
    own_scene s = diamond_and_square();
    const bmr_mixed mixed = s.mixed;
    double slack;
    const bmr_mixed_cell outside = bmr_mixed_outside(&mixed, bmr_vec2_make(5.0, 1.0), &slack);
    assert_int_equal(outside.kind, BMR_MIXED_OUTSIDE);
    assert_true(slack > 0.0);
    const bmr_mixed_cell inside = {BMR_NO_EDGE, {BMR_NO_EDGE, BMR_NO_EDGE}, BMR_MIXED_INSIDE, 0, {0, 0}};
    assert_false(bmr_mixed_exists(&mixed, &inside));
    assert_false(bmr_mixed_holds(&mixed, &inside, bmr_vec2_make(0.0, 0.0)));
    const bmr_mixed_ray ray = {{5.0, 1.0}, {-1.0, 0.0}};
    unsigned touched = 0;
    for (int k = 0; k < 2; ++k) {
        const bmr_mixed_cell *cell = k == 0 ? &inside : &outside;
        bmr_vec2 corners[BMR_MIXED_MAX_SIDES];
        assert_int_equal(bmr_mixed_polygon(&mixed, cell, corners), 0);
        const bmr_mixed_cell next = bmr_mixed_next(&mixed, cell, BMR_MIXED_INNER, &ray, &touched);
        assert_memory_equal(&next, cell, sizeof next);
    }
    assert_int_equal(touched, 0);
}

TEST(a_way_of_no_length_stays_and_one_that_passes_by_is_outside) {
    own_scene s = diamond_and_square();
    const bmr_mixed mixed = s.mixed;
    const bmr_mixed_cell at = cell_at(&mixed, 1.1, 1.1);
    bmr_mixed_cell cell = at;
    unsigned touched = 0;
    const bmr_vec2 here = {1.1, 1.1};
    assert_true(bmr_mixed_walk(&mixed, &cell, here, here, &touched));
    assert_memory_equal(&cell, &at, sizeof at);
    assert_int_equal(touched, 0);
    const bmr_mixed_ray past = {{5.0, 5.0}, {-1.0, 0.0}}, into = {{5.0, 0.0}, {-1.0, 0.0}};
    assert_int_equal(bmr_mixed_enter(&mixed, &past, &touched).kind, BMR_MIXED_OUTSIDE);
    assert_int_not_equal(bmr_mixed_enter(&mixed, &into, &touched).kind, BMR_MIXED_OUTSIDE);
}

TEST(a_tiling_is_one_block_and_needs_both_hierarchies) {
    own_scene s = diamond_and_square();
    bmr_mixed_tiling *tiling = NULL;
    const bmr_mixed half = bmr_mixed_make(s.hierarchies[0], NULL, 1.0, 0.0, 0.0);
    assert_int_equal(bmr_mixed_tiling_create(&half, NULL, &tiling), BMR_ERROR_NULL_ARGUMENT);
    test_heap heap;
    test_heap_init(&heap, SIZE_MAX);
    assert_int_equal(bmr_mixed_tiling_create(&s.mixed, &heap.allocator, &tiling), BMR_OK);
    assert_int_equal(heap.blocks, 1);
    bmr_mixed_tiling_destroy(tiling, &heap.allocator);
    assert_int_equal(heap.blocks + heap.wrong_sizes, 0);
    bmr_mixed_tiling_destroy(NULL, &heap.allocator);
}

// --- Lemma mixed-size ---

static double cells_per_vertex(bmr_hierarchy_kind kind, test_family family, size_t n, size_t m, double angle,
                               test_random *random) {
    own_scene s =
        scene_of(test_polygon(family, n, random), test_polygon(family, m, random), kind, angle, 0.0);
    const double ratio =
        (double)bmr_mixed_tiling_count(s.tiling) / (double)(s.polygons[0]->count + s.polygons[1]->count);
    return ratio;
}

/// Lemma 4.1: the mixed hierarchy has O((n + m) log m) cells.
TEST(the_tiling_is_of_linear_size) {
    static const test_family families[] = {TEST_REGULAR, TEST_CIRCLE, TEST_ELLIPSE, TEST_LENS};
    static const double bounds[] = {13.0, 5.0};
    test_random random = test_random_from(407);
    size_t too_many = 0;
    for (int kind = 0; kind < 2; ++kind)
        for (size_t n = 16; n <= 1024; n *= 4) {
            double most = 0.0, least = INFINITY;
            for (size_t round = 0; round < test_scaled(8); ++round) {
                const test_family family = families[round % 4];
                const double ratio = cells_per_vertex(kinds[kind], family, n,
                                                      round < 4 ? n : n >> test_random_below(&random, 3),
                                                      some_angle(&random), &random);
                most = fmax(most, ratio);
                least = fmin(least, ratio);
            }
            printf("%s n = %4zu: %.2f to %.2f cells a vertex\n", kind ? "Dudley " : "compass", n, least,
                   most);
            assert_true(most <= bounds[kind]);
            too_many += kind == 0 && most > bounds[1]; // control: Dudley's bound is not the compass's
        }
    assert_true(too_many > 0);
}

// --- Collapses ---

/// Section 5, collapse events: the point has left a cell before it collapses.
/// "We do not have to worry about collapse events, since the configuration point will be squeezed out of the
/// cell": two opposite sides of a parallelogram lie on the two ends of its edge y along the line that y
/// becomes parallel to, so that how far any point is inside the one and inside the other adds up to |y|
/// sin(y, line). At a collapse that is 0: one of the two conditions has failed by then, whatever the motion.
TEST(a_cell_that_collapses_has_let_go_of_its_point_before) {
    test_random random = test_random_from(411);
    size_t cells = 0;
    double widest = 0.0;
    for (size_t round = 0; round < test_scaled(40); ++round) {
        own_scene s = random_scene(kinds[round % 2], 12, 12, &random);
        const double size = size_of(&s);
        for (uint32_t i = 0; i < bmr_mixed_tiling_count(s.tiling); ++i) {
            const bmr_mixed_cell *cell = bmr_mixed_tiling_cell(s.tiling, i);
            if (cell->kind != BMR_MIXED_BEFORE && cell->kind != BMR_MIXED_AFTER)
                continue;
            bmr_mixed_figure figure;
            bmr_vec2 corners[BMR_MIXED_MAX_SIDES];
            bmr_mixed_order orders[2];
            bmr_mixed_draw(&s.mixed, cell, &figure);
            bmr_mixed_figure_polygon(&s.mixed, cell, &figure, corners);
            bmr_mixed_orders(&s.mixed, cell, orders);
            const bmr_mixed_order *collapse = &orders[orders[0].page_turn ? 1 : 0];
            assert_false(collapse->page_turn);
            const bmr_pose back = {{0.0, 0.0}, -s.mixed.c, -s.mixed.s}; // -B in A's frame
            bmr_vec2 n[2];
            for (int k = 0; k < 2; ++k) {
                const int owner = k ? 1 - collapse->owner : collapse->owner;
                n[k] =
                    bmr_hierarchy_line(s.hierarchies[owner], k ? collapse->second : collapse->first).normal;
                n[k] = owner ? bmr_rotate(&back, n[k]) : n[k];
            }
            // y is the side on the line of OUTER: from its corner to the next.
            size_t outer = 0;
            while (figure.parts[outer].role != BMR_MIXED_OUTER)
                ++outer;
            const bmr_vec2 y = bmr_sub(corners[outer + 1], corners[outer]);
            const double width = hypot(y.x, y.y) * bmr_cross(n[0], n[1]);
            const bmr_vec2 x = {test_random_uniform(&random, -size, size),
                                test_random_uniform(&random, -size, size)};
            double sum = 0.0;
            for (size_t k = 0; k < figure.sides; ++k)
                if (figure.parts[k].role == BMR_MIXED_LOW || figure.parts[k].role == BMR_MIXED_HIGH)
                    sum += bmr_mixed_figure_value(&s.mixed, &figure, k, x);
            assert_true(fabs(sum - width) <= 1e-9 * size);
            widest = fmax(widest, width / size);
            ++cells;
        }
    }
    printf("%zu parallelograms, the widest %.2f of the radii\n", cells, widest);
    assert_true(cells > 10 * test_scaled(40));
    assert_true(widest > 0.1); // control: the sum is not always nothing
}

// --- Lemma mixed-rotation ---

static int compare_doubles(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/// All rotations at which an edge of A and one of -B are parallel, sorted.
static size_t parallel_angles(const scene *s, double *angles) {
    size_t count = 0;
    for (bmr_edge i = 0; i < bmr_hierarchy_edge_count(s->hierarchies[0]); ++i)
        for (bmr_edge j = 0; j < bmr_hierarchy_edge_count(s->hierarchies[1]); ++j) {
            const bmr_vec2 a = bmr_hierarchy_line(s->hierarchies[0], i).normal;
            const bmr_vec2 b = bmr_neg(bmr_hierarchy_line(s->hierarchies[1], j).normal);
            const double angle = atan2(bmr_cross(b, a), bmr_dot(b, a));
            angles[count++] = angle < 0.0 ? angle + TWO_PI : angle;
        }
    qsort(angles, count, sizeof *angles, compare_doubles);
    return count;
}

typedef struct changes {
    size_t page_turns, collapses, expansions;
} changes;

/// Which parallelograms are there, by (owner, e, y): 0 none, 1 before, 2 after.
static void mark(const scene *s, uint8_t *marks) {
    const uint32_t na = bmr_hierarchy_edge_count(s->hierarchies[0]),
                   nb = bmr_hierarchy_edge_count(s->hierarchies[1]);
    memset(marks, 0, (size_t)2 * na * nb);
    for (uint32_t i = 0; i < bmr_mixed_tiling_count(s->tiling); ++i) {
        const bmr_mixed_cell *c = bmr_mixed_tiling_cell(s->tiling, i);
        if (c->kind == BMR_MIXED_TRIANGLE)
            continue;
        const uint32_t a = c->owner == 0 ? c->edge : c->other[0], b = c->owner == 0 ? c->other[0] : c->edge;
        marks[((size_t)c->owner * na + a) * nb + b] = c->kind == BMR_MIXED_BEFORE ? 1 : 2;
    }
}

/// Turns B through the first `part` of all rotations that matter, and compares the tilings before and after
/// each.
static changes turn_around(scene *s, double part) {
    const size_t pairs =
        (size_t)bmr_hierarchy_edge_count(s->hierarchies[0]) * bmr_hierarchy_edge_count(s->hierarchies[1]);
    double *angles = malloc(pairs * sizeof *angles);
    uint8_t *marks = malloc(4 * pairs);
    assert_non_null(angles);
    assert_non_null(marks);
    changes c = {0, 0, 0};
    const size_t count = parallel_angles(s, angles), end = (size_t)((double)count * part);
    scene_turn(s, 0.5 * (angles[count - 1] - TWO_PI + angles[0]));
    mark(s, marks);
    for (size_t i = 0; i < end; ++i) {
        const double next = i + 1 < count ? angles[i + 1] : angles[0] + TWO_PI;
        if (next - angles[i] < 1e-9)
            continue; // several at once: all are seen after the last
        scene_turn(s, 0.5 * (angles[i] + next));
        memcpy(marks + 2 * pairs, marks, 2 * pairs);
        mark(s, marks);
        for (size_t k = 0; k < 2 * pairs; ++k) {
            const uint8_t now = marks[k], before = marks[2 * pairs + k];
            c.page_turns += now != 0 && before != 0 && now != before;
            c.collapses += before != 0 && now == 0;
            c.expansions += before == 0 && now != 0;
        }
    }
    free(angles);
    free(marks);
    return c;
}

static bool is_full_turn(const changes *c, size_t na, size_t nb) {
    const size_t expected = na * nb - 16;
    return c->page_turns == expected && c->collapses == expected && c->expansions == expected;
}

/// Lemma 4.2: a full turn of Q turns O(mn log m) pages.
TEST(a_full_turn_has_one_page_turn_collapse_and_expansion_for_each_pair_of_edges) {
    static const test_family families[] = {TEST_CIRCLE, TEST_ELLIPSE, TEST_LENS, TEST_CLUSTER};
    test_random random = test_random_from(409);
    for (size_t round = 0; round < test_scaled(8); ++round) {
        const size_t n = 3 + test_random_below(&random, 9), m = 3 + test_random_below(&random, 9);
        own_scene s = scene_of(test_polygon(families[round / 2 % 4], n, &random),
                               test_polygon(families[round / 2 % 4], m, &random), kinds[round % 2], 0.0, 0.0);
        const size_t na = bmr_hierarchy_edge_count(s.hierarchies[0]),
                     nb = bmr_hierarchy_edge_count(s.hierarchies[1]);
        const changes all = turn_around(&s, 1.0), most = turn_around(&s, 0.9);
        assert_true(is_full_turn(&all, na, nb));
        assert_false(is_full_turn(&most, na, nb)); // control: no full turn
    }
}

// --- Lemma mixed2 ---

/// How far a cell reaches from its inner side.
static double height_of(const bmr_mixed *mixed, const bmr_mixed_cell *cell) {
    bmr_vec2 corners[BMR_MIXED_MAX_SIDES];
    bmr_mixed_figure figure;
    bmr_mixed_draw(mixed, cell, &figure);
    bmr_mixed_figure_polygon(mixed, cell, &figure, corners);
    double height = 0.0;
    for (size_t i = 0; i < figure.sides; ++i)
        for (size_t k = 0; k < figure.sides && figure.parts[i].role == BMR_MIXED_INNER; ++k)
            height = fmax(height, fabs(bmr_mixed_figure_value(mixed, &figure, i, corners[k])));
    return height;
}

/// The most cells of height >= s over sqrt(D / s), for s = D / 4^k.
static double tall_cells(const scene *s, double diameter) {
    double most = 0.0;
    for (int k = 0; k < 16; ++k) {
        size_t count = 0;
        for (uint32_t i = 0; i < bmr_mixed_tiling_count(s->tiling); ++i)
            count += height_of(&s->mixed, bmr_mixed_tiling_cell(s->tiling, i)) >= diameter * pow(4.0, -k);
        most = fmax(most, (double)count / pow(2.0, k));
    }
    return most;
}

/// What a line meets: cells, and triangles of the stage that it meets most of.
typedef struct met {
    size_t cells, triangles;
} met;

static met met_by_line(const scene *s, bmr_vec2 x, bmr_vec2 along) {
    size_t triangles[128] = {0};
    met m = {0, 0};
    for (uint32_t i = 0; i < bmr_mixed_tiling_count(s->tiling); ++i) {
        const bmr_mixed_cell *cell = bmr_mixed_tiling_cell(s->tiling, i);
        bmr_vec2 p[BMR_MIXED_MAX_SIDES];
        const size_t count = bmr_mixed_polygon(&s->mixed, cell, p);
        bool left = false, right = false;
        for (size_t k = 0; k < count; ++k) {
            const double side = bmr_cross(along, bmr_sub(p[k], x));
            left |= side > 0.0;
            right |= side < 0.0;
        }
        if (!left || !right)
            continue;
        ++m.cells;
        const size_t stage = (size_t)bmr_mixed_stage(&s->mixed, cell);
        if (cell->kind == BMR_MIXED_TRIANGLE && ++triangles[stage] > m.triangles)
            m.triangles = triangles[stage];
    }
    return m;
}

/// Lemma 4.4(a): O(sqrt(D/s) log(D/s)) and O(sqrt(D/s)) mixed cells are at least s high.
/// Lemma 4.4(b): a convex curve meets O(log(D/s)) and O(sqrt(D/s)) mixed triangles.
TEST(tall_cells_are_few_and_a_line_meets_few_cells) {
    static const test_family families[] = {TEST_REGULAR, TEST_CIRCLE, TEST_ELLIPSE};
    test_random random = test_random_from(411);
    for (int kind = 0; kind < 2; ++kind) {
        double tall = 0.0, small = 0.0;
        size_t lines = 0, cells = 0, most = 0, most_triangles = 0, alone = 0, long_lines = 0;
        // Three at least: the controls need some lines.
        for (size_t round = 0; round < 3 || round < test_scaled(6); ++round) {
            const size_t n = 256;
            own_scene s = scene_of(test_polygon(families[round % 3], n, &random),
                                   test_polygon(families[round / 2 % 3], n, &random), kinds[kind],
                                   some_angle(&random), 0.0);
            const double diameter = fmax(test_diameter(s.polygons[0]), test_diameter(s.polygons[1]));
            tall = fmax(tall, tall_cells(&s, diameter));
            small = fmax(small, tall_cells(&s, 0.01 * diameter));
            for (int k = 0; k < 60; ++k) {
                const double direction = test_random_uniform(&random, 0.0, TWO_PI);
                const int power = 4 + (int)test_random_below(&random, 13);
                const double sigma = diameter * pow(2.0, -power);
                const bmr_pose pose = test_pose_at(s.polygons[0], s.polygons[1], direction, s.angle, sigma);
                const bmr_vec2 along = bmr_vec2_make(-sin(direction), cos(direction));
                const met m = met_by_line(&s, pose.position, along);
                // A line at sigma: at most two triangles a stage, where the paper has one.
                assert_true(m.triangles <= 2);
                alone += m.triangles > 1;
                if (kind == 0)
                    assert_true((double)m.cells <= 3.0 * power + 2.0);
                long_lines += (double)m.cells > 1.5 * power; // control: half the constant
                most_triangles = m.triangles > most_triangles ? m.triangles : most_triangles;
                most = m.cells > most ? m.cells : most;
                cells += m.cells;
                ++lines;
            }
        }
        printf("%s: at most %.1f sqrt(D/s) cells of height >= s; a line at D/16 to D/65536 meets %.1f "
               "cells, at most %zu\n",
               kind ? "Dudley" : "compass", tall, (double)cells / (double)lines, most);
        assert_true(tall <= 15.0);
        assert_true(small > 15.0); // control: as if the polygons were a hundred times smaller
        assert_true(alone > 0);    // control: the paper's "one triangle a level" does not hold
        assert_true(long_lines > 0);
    }
}
