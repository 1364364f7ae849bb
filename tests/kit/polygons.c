// SPDX-License-Identifier: MIT
#include "polygons.h"

#include <math.h>
#include <stdlib.h>

#define PI 3.14159265358979323846

const char *test_family_name(test_family family) {
    switch (family) {
    case TEST_REGULAR:
        return "regular";
    case TEST_CIRCLE:
        return "circle";
    case TEST_ELLIPSE:
        return "ellipse";
    case TEST_NEEDLE:
        return "needle";
    case TEST_NEEDLE_FLAT:
        return "flat needle";
    case TEST_LENS:
        return "lens";
    case TEST_BOX:
        return "box";
    case TEST_TURNED_BOX:
        return "turned box";
    case TEST_OCTAGON:
        return "octagon";
    case TEST_GRID:
        return "grid";
    case TEST_PARALLEL:
        return "parallel";
    case TEST_TINY_EDGES:
        return "tiny edges";
    case TEST_NEARLY_FLAT:
        return "nearly flat";
    case TEST_CLUSTER:
        return "cluster";
    case TEST_FAMILY_COUNT:
        break;
    }
    return "no family";
}

size_t test_regular_points(size_t n, double radius, double phase, bmr_vec2 *points) {
    for (size_t i = 0; i < n; ++i) {
        const double angle = phase + 2.0 * PI * (double)i / (double)n;
        points[i] = bmr_vec2_make(radius * cos(angle), radius * sin(angle));
    }
    return n;
}

size_t test_box_points(double half_width, double half_height, bmr_vec2 *points) {
    points[0] = bmr_vec2_make(-half_width, -half_height);
    points[1] = bmr_vec2_make(half_width, -half_height);
    points[2] = bmr_vec2_make(half_width, half_height);
    points[3] = bmr_vec2_make(-half_width, half_height);
    return 4;
}

void test_move_points(bmr_vec2 *points, size_t count, double angle, double x, double y) {
    const double c = cos(angle), s = sin(angle);
    for (size_t i = 0; i < count; ++i) {
        const bmr_vec2 p = points[i];
        points[i] = bmr_vec2_make(c * p.x - s * p.y + x, s * p.x + c * p.y + y);
    }
}

size_t test_hard_points(test_random *random, bmr_vec2 *points) {
    const size_t n = 3 + test_random_below(random, 58);
    const double scale = ldexp(1.0, (int)test_random_below(random, 40) - 12), ulp = scale * 0x1p-52;
    bmr_vec2 along = {test_random_uniform(random, -1.0, 1.0), test_random_uniform(random, -1.0, 1.0)};
    const uint32_t slope = test_random_below(random, 8); // level, upright and diagonal lines, too
    along.x = slope == 0 ? 0.0 : slope == 1 ? along.y : along.x;
    along.y = slope == 2 ? 0.0 : along.y;
    const uint32_t kinds = 4 + test_random_below(random, 2);
    for (size_t i = 0; i < n; ++i) {
        const double t = test_random_uniform(random, 0.0, 1.0);
        bmr_vec2 p = {scale * (0.3 + t * along.x), scale * (0.2 + t * along.y)};
        const uint32_t kind = test_random_below(random, kinds);
        if (kind == 2) // a few ulps beside the line
            p = bmr_add(p, bmr_vec2_make(ulp * ((double)test_random_below(random, 5) - 2.0),
                                         ulp * ((double)test_random_below(random, 5) - 2.0)));
        else if (kind == 3) // a grid of ulps
            p = bmr_vec2_make(0.5 * scale + ulp * (double)test_random_below(random, 8),
                              0.5 * scale + ulp * (double)test_random_below(random, 8));
        else if (kind == 4) // anywhere
            p = bmr_vec2_make(scale * test_random_uniform(random, -1.0, 1.0), scale * t);
        points[i] = p;
    }
    points[n] = bmr_vec2_make(scale * 0.3, scale * 0.2); // the line's ends: never all in one place
    points[n + 1] = bmr_vec2_make(scale * (0.3 + along.x), scale * (0.2 + along.y));
    return n + 2;
}

static size_t ellipse_points(size_t n, double minor, test_random *random, bmr_vec2 *points) {
    for (size_t i = 0; i < n; ++i) {
        const double angle = test_random_uniform(random, 0.0, 2.0 * PI);
        points[i] = bmr_vec2_make(cos(angle), minor * sin(angle));
    }
    return n;
}

static size_t turned_ellipse_points(size_t n, double minor, test_random *random, bmr_vec2 *points) {
    ellipse_points(n, minor, random, points);
    test_move_points(points, n, test_random_uniform(random, 0.0, 2.0 * PI), 0.0, 0.0);
    return n;
}

static size_t lens_points(size_t n, test_random *random, bmr_vec2 *points) {
    const double half_angle = test_random_uniform(random, 0.05, 0.8);
    const size_t pairs = (n + 1) / 2;
    for (size_t i = 0; i < n; ++i) {
        const size_t pair = i / 2;
        const double angle = half_angle * (2.0 * (double)pair / (double)pairs - 1.0);
        const double bulge = cos(angle) - cos(half_angle);
        points[i] = bmr_vec2_make(sin(angle) / sin(half_angle), i % 2 ? bulge : -bulge);
    }
    test_move_points(points, n, test_random_uniform(random, 0.0, 2.0 * PI), 0.0, 0.0);
    return n;
}

static size_t octagon_points(test_random *random, bmr_vec2 *points) {
    const double a = 1.0, b = 0.0625 * (double)(1 + test_random_below(random, 14));
    const bmr_vec2 corner[8] = {{a, -b}, {a, b}, {b, a}, {-b, a}, {-a, b}, {-a, -b}, {-b, -a}, {b, -a}};
    for (size_t i = 0; i < 8; ++i)
        points[i] = corner[i];
    return 8;
}

static size_t grid_points(size_t n, test_random *random, bmr_vec2 *points) {
    // About as many grid points as asked for, so that many are collinear.
    const uint32_t side = (uint32_t)sqrt((double)n) + 2;
    n -= 3; // the three points below
    for (size_t i = 0; i < n; ++i) {
        const double x = (double)test_random_below(random, side), y = (double)test_random_below(random, side);
        points[i] = bmr_vec2_make(x - 0.5 * side, y - 0.5 * side);
    }
    points[n] = bmr_vec2_make(0.0, 0.5); // never all on one line
    points[n + 1] = bmr_vec2_make(0.5, 0.0);
    points[n + 2] = bmr_vec2_make(0.0, 0.0);
    return n + 3;
}

static int compare_angle(const void *a, const void *b) {
    const bmr_vec2 *u = a, *v = b;
    const double d = atan2(u->y, u->x) - atan2(v->y, v->x);
    return (d > 0.0) - (d < 0.0);
}

static size_t parallel_points(size_t n, test_random *random, bmr_vec2 *points) {
    const size_t half = n / 2 > 2 ? n / 2 : 2;
    for (size_t i = 0; i < half; ++i) { // edge vectors in the upper half plane
        const double x = (double)test_random_below(random, 2001) - 1000.0;
        points[i] = bmr_vec2_make(x, 1.0 + (double)test_random_below(random, 1000));
    }
    points[0] = bmr_vec2_make(1.0 + (double)test_random_below(random, 1000), 0.0);
    qsort(points, half, sizeof *points, compare_angle);
    bmr_vec2 at = {0.0, 0.0};
    for (size_t i = 0; i < half; ++i)
        at = bmr_sub(at, points[i]);
    // Doubled coordinates keep the centre, which is the middle of the two ends, on the grid.
    for (size_t i = 0; i < half; ++i) {
        const bmr_vec2 edge = points[i];
        points[i] = at;
        points[half + i] = bmr_neg(at);
        at = bmr_add(at, bmr_scale(2.0, edge));
    }
    return 2 * half;
}

static size_t tiny_edge_points(size_t n, test_random *random, bmr_vec2 *points) {
    const size_t corners = n / 3 > 2 ? n / 3 : 2;
    for (size_t i = 0; i < corners; ++i) {
        const double angle = 2.0 * PI * ((double)i + test_random_uniform(random, 0.0, 0.9)) / (double)corners;
        // The bump must stay flatter than the polygon's own corner, or it would hide its neighbours.
        const double step = 1e-9, bump = 0.3 * step * PI / (double)corners;
        const bmr_vec2 p = {cos(angle), sin(angle)}, t = {-sin(angle), cos(angle)};
        points[3 * i] = bmr_sub(p, bmr_scale(step, t));
        points[3 * i + 1] = bmr_add(p, bmr_scale(bump, p));
        points[3 * i + 2] = bmr_add(p, bmr_scale(step, t));
    }
    return 3 * corners;
}

static size_t nearly_flat_points(size_t n, test_random *random, bmr_vec2 *points) {
    const double height = test_random_uniform(random, 1e-13, 1e-11);
    points[0] = bmr_vec2_make(0.0, 1.0);
    for (size_t i = 1; i < n; ++i) {
        const double x = 2.0 * (double)(i - 1) / (double)(n - 2) - 1.0;
        points[i] = bmr_vec2_make(x, -height * (1.0 - x * x));
    }
    if (test_random_below(random, 2) == 0)
        test_move_points(points, n, test_random_uniform(random, 0.0, 2.0 * PI), 0.0, 0.0);
    return n;
}

static size_t cluster_points(size_t n, test_random *random, bmr_vec2 *points) {
    const double start = test_random_uniform(random, 0.0, 2.0 * PI);
    for (size_t i = 0; i < n; ++i) {
        const double angle =
            start + (i < 3 ? 2.0 * PI * (double)(i + 1) / 4.0 : test_random_uniform(random, 0.0, 1e-3));
        points[i] = bmr_vec2_make(cos(angle), sin(angle));
    }
    return n;
}

size_t test_points(test_family family, size_t n, test_random *random, bmr_vec2 *points) {
    switch (family) {
    case TEST_REGULAR:
        return test_regular_points(n, 1.0, test_random_uniform(random, 0.0, 2.0 * PI), points);
    case TEST_CIRCLE:
        return ellipse_points(n, 1.0, random, points);
    case TEST_ELLIPSE:
        return turned_ellipse_points(n, 0.25, random, points);
    case TEST_NEEDLE:
        return turned_ellipse_points(n, 1e-6, random, points);
    case TEST_NEEDLE_FLAT:
        return ellipse_points(n, 1e-6, random, points);
    case TEST_LENS:
        return lens_points(n, random, points);
    case TEST_BOX:
        return test_box_points(1.0, test_random_uniform(random, 0.001, 1.0), points);
    case TEST_TURNED_BOX:
        test_box_points(1.0, test_random_uniform(random, 0.001, 1.0), points);
        test_move_points(points, 4, PI / 8.0 * (double)test_random_below(random, 16), 0.0, 0.0);
        return 4;
    case TEST_OCTAGON:
        return octagon_points(random, points);
    case TEST_GRID:
        return grid_points(n, random, points);
    case TEST_PARALLEL:
        return parallel_points(n, random, points);
    case TEST_TINY_EDGES:
        return tiny_edge_points(n, random, points);
    case TEST_NEARLY_FLAT:
        return nearly_flat_points(n, random, points);
    case TEST_CLUSTER:
        return cluster_points(n, random, points);
    case TEST_FAMILY_COUNT:
        break;
    }
    return 0;
}

bmr_polygon *test_polygon(test_family family, size_t n, test_random *random) {
    bmr_vec2 *points = malloc((n + 12) * sizeof *points);
    if (!points)
        return NULL;
    const size_t count = test_points(family, n, random, points);
    bmr_polygon *polygon = NULL;
    if (bmr_polygon_create(points, count, NULL, &polygon) != BMR_OK)
        polygon = NULL;
    free(points);
    return polygon;
}

bmr_polygon *test_moved_polygon(bmr_polygon *polygon, double scale, bmr_vec2 by) {
    bmr_vec2 *points = polygon ? malloc(polygon->count * sizeof *points) : NULL;
    bmr_polygon *moved = NULL;
    for (uint32_t i = 0; points && i < polygon->count; ++i)
        points[i] = bmr_add(bmr_scale(scale, polygon->vertices[i]), by);
    if (!points || bmr_polygon_create(points, polygon->count, NULL, &moved) != BMR_OK)
        abort();
    free(points);
    bmr_polygon_destroy(polygon, NULL);
    return moved;
}

bmr_polygon *test_any_polygon(size_t most, test_random *random) {
    const uint32_t kind = test_random_below(random, 20);
    bmr_polygon *polygon = NULL;
    if (kind < 2) {
        bmr_vec2 ends[2];
        for (int i = 0; i < 2; ++i) {
            ends[i].x = test_random_uniform(random, -1.0, 1.0);
            ends[i].y = test_random_uniform(random, -1.0, 1.0);
        }
        bmr_polygon_create(ends, kind + 1, NULL, &polygon);
    } else {
        const double n = exp(test_random_uniform(random, log(3.0), log((double)most + 1.0)));
        polygon = test_polygon((test_family)test_random_below(random, TEST_FAMILY_COUNT), (size_t)n, random);
    }
    if (test_random_below(random, 4) > 0)
        return polygon;
    const double scale = exp(test_random_uniform(random, log(1e-3), log(1e3)));
    const double away = scale * test_random_uniform(random, 0.0, 10.0);
    return test_moved_polygon(polygon, scale, bmr_vec2_make(away, -away));
}
