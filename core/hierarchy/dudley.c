// SPDX-License-Identifier: MIT
#include <math.h>
#include <stdbool.h>

#include "geometry/distance.h"
#include "geometry/memory.h"
#include "hierarchy/builder.h"

#define FULL_TURN 6.28318530717958647693
/// Radius of Dudley's circle over that of the polygon's smallest disk: 2 D, with D taken as the disk's
/// diameter (the true one may be 13 % less).
#define CIRCLE_RADII 4.0
/// Below this many vertices, and so this many samples, neighbouring samples are so far apart on the circle
/// that walking from one to the next by local tests could go the wrong way round.
#define WALK_MIN_VERTICES 8

/// Where on the polygon a sample's nearest neighbour is: 2 i for vertex i, 2 i + 1 for the inside of edge i.
typedef uint32_t feature;

static bmr_vec2 sample_point(const bmr_polygon *p, uint32_t j) {
    const double angle = FULL_TURN * (double)j / (double)p->count;
    const double radius = CIRCLE_RADII * p->radius;
    return bmr_vec2_make(p->center.x + radius * cos(angle), p->center.y + radius * sin(angle));
}

static feature nearest_by_search(const bmr_polygon *p, bmr_vec2 x) {
    feature nearest = 0;
    double least = INFINITY;
    for (uint32_t i = 0; i < p->count; ++i) {
        const bmr_vec2 r = bmr_sub(x, p->vertices[i]);
        const double to_vertex = hypot(r.x, r.y);
        if (to_vertex < least) {
            least = to_vertex;
            nearest = 2 * i;
        }
        if (!bmr_tree_beyond(p, i, r) ||
            bmr_tree_beyond(p, i, bmr_sub(x, p->vertices[bmr_vertex_after(p, i)])))
            continue;
        const double to_line = bmr_dot(r, bmr_polygon_normal(p, i));
        if (to_line > 0.0 && to_line < least) {
            least = to_line;
            nearest = 2 * i + 1;
        }
    }
    return nearest;
}

/// The nearest neighbour moves round the polygon as the sample moves round the circle: n + n steps for all
/// samples.
static feature nearest_by_walk(const bmr_polygon *p, bmr_vec2 x, feature at) {
    for (uint32_t step = 0; step < 2 * p->count; ++step) {
        const uint32_t i = at / 2;
        const uint32_t corner = at % 2 ? bmr_vertex_after(p, i) : i;
        // The border between a vertex and an edge is the ray from the vertex along the edge's normal.
        if (!bmr_tree_beyond(p, i, bmr_sub(x, p->vertices[corner])))
            break;
        at = at + 1 < 2 * p->count ? at + 1 : 0;
    }
    return at;
}

static void find_features(const bmr_polygon *p, feature *features) {
    features[0] = nearest_by_search(p, sample_point(p, 0));
    for (uint32_t j = 1; j < p->count; ++j) {
        const bmr_vec2 x = sample_point(p, j);
        features[j] =
            p->count < WALK_MIN_VERTICES ? nearest_by_search(p, x) : nearest_by_walk(p, x, features[j - 1]);
    }
}

/// Collects items in counter-clockwise order.
typedef struct collector {
    const bmr_polygon *polygon;
    bmr_item *items;
    uint32_t count;
} collector;

static void add_edge(collector *c, uint32_t edge) {
    bmr_item *item = &c->items[c->count++];
    item->normal = bmr_polygon_normal(c->polygon, edge);
    item->touch = edge;
    item->own = 1;
}

/// A degenerate edge at a vertex, its outer normal x - n(x). (The paper has n(x) - x, which points inwards.)
/// One that agrees with a neighbouring edge counts as a split of that edge: -1 the edge before, +1 the one
/// after, 0 neither.
static int add_degenerate_edge(collector *c, uint32_t vertex, bmr_vec2 x) {
    const bmr_polygon *p = c->polygon;
    const bmr_vec2 d = bmr_sub(x, p->vertices[vertex]);
    const bmr_vec2 normal = bmr_scale(1.0 / hypot(d.x, d.y), d);
    const uint32_t before = vertex > 0 ? vertex - 1 : p->count - 1;
    if (!(bmr_cross(bmr_polygon_normal(p, before), normal) > BMR_MERGE_ANGLE))
        return -1;
    if (!(bmr_cross(normal, bmr_polygon_normal(p, vertex)) > BMR_MERGE_ANGLE))
        return 1;
    bmr_item *item = &c->items[c->count++];
    item->normal = normal;
    item->touch = vertex;
    item->own = 0;
    return 0;
}

/// One item for each edge, each degenerate edge and each split vertex (which makes one more piece of its
/// edge). The splits must count: they are what makes the median halve the circle, and the height drop
/// fourfold a level.
static uint32_t collect_items(const bmr_polygon *p, const feature *features, bmr_item *items) {
    collector c = {p, items, 0};
    const uint32_t n = p->count;
    uint32_t first = 0; // the first sample at or after vertex 0
    for (uint32_t j = 1; j < n; ++j)
        if (features[j] < features[j - 1])
            first = j;
    uint32_t taken = 0;
    for (uint32_t i = 0; i < n; ++i) {
        uint32_t splits = 0;
        for (; taken < n; ++taken) {
            const uint32_t j = first + taken < n ? first + taken : first + taken - n;
            if (features[j] > 2 * i + 1)
                break;
            const int side = features[j] == 2 * i ? add_degenerate_edge(&c, i, sample_point(p, j)) : 1;
            if (side < 0)
                add_edge(&c, i > 0 ? i - 1 : n - 1);
            else if (side > 0)
                ++splits;
        }
        for (uint32_t piece = 0; piece <= splits; ++piece)
            add_edge(&c, i);
    }
    return c.count;
}

/// Lemma 3.4(a): a Dudley boomerang of level i is O(D/4^i) high.
/// Lemma 3.4(b): O(sqrt(D/s)) Dudley boomerangs are at least s high.
bmr_error bmr_hierarchy_build_dudley(const bmr_polygon *polygon, const bmr_allocator *allocator,
                                     bmr_hierarchy **hierarchy) {
    if (!polygon || !hierarchy)
        return BMR_ERROR_NULL_ARGUMENT;
    const size_t n = polygon->count;
    const size_t size = n * (2 * sizeof(bmr_item) + sizeof(feature));
    bmr_item *items = bmr_allocate(allocator, size);
    if (!items)
        return BMR_ERROR_NO_MEMORY;
    uint32_t count = 0;
    if (n > 1) { // a point has no edges, and nothing to approximate
        feature *features = (feature *)(items + 2 * n);
        find_features(polygon, features);
        count = collect_items(polygon, features, items);
        bmr_items_start_at_east(items, count);
    }
    const bmr_build build = {polygon, BMR_HIERARCHY_DUDLEY, items, count, NULL, 0, 0};
    const bmr_error error = bmr_build_tree(&build, allocator, hierarchy);
    bmr_release(allocator, items, size);
    return error;
}
