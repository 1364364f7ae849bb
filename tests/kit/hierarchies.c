// SPDX-License-Identifier: MIT
#include "hierarchies.h"

#include <math.h>
#include <stdlib.h>

const bmr_compass *test_compass(void) {
    static bmr_compass *compass;
    if (!compass && bmr_compass_create(BMR_MAX_VERTICES, NULL, &compass) != BMR_OK)
        abort();
    return compass;
}

bmr_hierarchy *test_hierarchy(bmr_hierarchy_kind kind, const bmr_polygon *polygon) {
    bmr_hierarchy *hierarchy = NULL;
    if (!polygon || bmr_hierarchy_build(kind, polygon, test_compass(), NULL, &hierarchy) != BMR_OK)
        abort();
    return hierarchy;
}

void test_visit_hierarchies(const size_t *sizes, size_t size_count, size_t rounds, uint64_t seed,
                            test_visitor visit, void *context) {
    test_random random = test_random_from(seed);
    for (size_t round = 0; round < rounds; ++round)
        for (size_t i = 0; i < size_count; ++i)
            for (int family = 0; family < TEST_FAMILY_COUNT; ++family) {
                bmr_polygon *p = test_polygon((test_family)family, sizes[i], &random);
                for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
                    bmr_hierarchy *h = test_hierarchy((bmr_hierarchy_kind)kind, p);
                    visit(h, (test_family)family, &random, context);
                    bmr_hierarchy_destroy(h, NULL);
                }
                bmr_polygon_destroy(p, NULL);
            }
}

double test_area(const bmr_vec2 *p, size_t count) {
    double area = 0.0;
    for (size_t i = 2; i < count; ++i)
        area += 0.5 * bmr_cross(bmr_sub(p[i - 1], p[0]), bmr_sub(p[i], p[0]));
    return area;
}

double test_diameter(const bmr_polygon *polygon) {
    double most = 0.0;
    for (uint32_t i = 0; i < polygon->count; ++i)
        for (uint32_t j = 0; j < i; ++j) {
            const bmr_vec2 d = bmr_sub(polygon->vertices[i], polygon->vertices[j]);
            most = fmax(most, bmr_dot(d, d));
        }
    return sqrt(most);
}

double test_farthest(const bmr_vec2 *points, uint32_t count, bmr_vec2 direction) {
    double most = -INFINITY;
    for (uint32_t i = 0; i < count; ++i)
        most = fmax(most, bmr_dot(direction, points[i]));
    return most;
}

bmr_vec2 test_direction(const bmr_hierarchy *hierarchy, test_random *random) {
    if (test_random_below(random, 3) == 0)
        return bmr_hierarchy_line(hierarchy, test_random_below(random, bmr_hierarchy_edge_count(hierarchy)))
            .normal;
    const double angle = test_random_uniform(random, 0.0, 6.3);
    return bmr_vec2_make(cos(angle), sin(angle));
}
