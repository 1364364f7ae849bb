// SPDX-License-Identifier: MIT
#include "hierarchy/builder.h"

#include <stdbool.h>
#include <string.h>

#include "geometry/distance.h"
#include "geometry/memory.h"

uint32_t bmr_ceil_log2(uint32_t n) {
    uint32_t k = 0;
    while (((uint32_t)1 << k) < n)
        ++k;
    return k;
}

/// The polygon's own edges, in its order: none for a point.
static uint32_t items_of_edges(const bmr_polygon *polygon, bmr_item *items) {
    if (polygon->count == 1)
        return 0;
    for (uint32_t i = 0; i < polygon->count; ++i) {
        items[i].normal = bmr_polygon_normal(polygon, i);
        items[i].touch = i;
        items[i].own = 1;
    }
    return polygon->count;
}

static void reverse(bmr_item *items, uint32_t begin, uint32_t end) {
    while (begin + 1 < end) {
        const bmr_item swapped = items[begin];
        items[begin++] = items[--end];
        items[end] = swapped;
    }
}

void bmr_items_start_at_east(bmr_item *items, uint32_t count) {
    uint32_t start = 0;
    for (uint32_t i = 1; i < count; ++i)
        if (bmr_tree_quadrant(items[i].normal) < bmr_tree_quadrant(items[i - 1].normal))
            start = i;
    reverse(items, 0, start);
    reverse(items, start, count);
    reverse(items, 0, count);
}

/// Masks an id to the width of its bit-field (BMR_ID_BITS). Ids always fit; the mask lets the compiler see
/// it.
#define ID(id) ((id) & ((1u << BMR_ID_BITS) - 1u))

static bool agree(bmr_vec2 a, bmr_vec2 b, double angle) {
    return fabs(bmr_cross(a, b)) <= angle && bmr_dot(a, b) > 0.0;
}

/// A boomerang that waits for its cut: node `BMR_ROOTS + index in the queue` will be the edge that cuts it.
typedef struct pending {
    uint32_t before, after; ///< its outer edges
    uint32_t low, high;     ///< the items in it
    uint32_t position;      ///< compass: the index of its angle among the 4 * 2^level of its level
} pending;

/// Scratch of one build. Nodes come out in breadth-first order because the queue is one.
typedef struct work {
    const bmr_build *build;
    pending *queue;
    bmr_vec2 *normals; ///< of each node, unit length
    bmr_node *nodes;
    uint32_t queued;
    uint32_t degenerate; ///< nodes that are neither roots nor own edges
} work;

static uint32_t last_touch(const work *w, uint32_t id) {
    const bmr_node *node = &w->nodes[id];
    return node->wide ? bmr_vertex_after(w->build->polygon, (uint32_t)node->touch) : (uint32_t)node->touch;
}

static uint64_t level_of_cut(const work *w, const pending *boomerang) {
    const uint64_t before = w->nodes[boomerang->before].level, after = w->nodes[boomerang->after].level;
    return (before > after ? before : after) + 1;
}

/// Queues a boomerang for its cut and returns the id of the node to be, or BMR_NO_CHILD if there is nothing
/// to cut: the two outer edges touch the same vertex (height 0) below the levels that cut these, too, or
/// every edge between them agrees with one of them.
static uint32_t enqueue(work *w, pending boomerang) {
    const bmr_item *items = w->build->items;
    if (last_touch(w, boomerang.before) == w->nodes[boomerang.after].touch) {
        if (level_of_cut(w, &boomerang) > w->build->corner_levels)
            return BMR_NO_CHILD;
        boomerang.high = boomerang.low; // what is left agrees with one of the outer edges
        w->queue[w->queued] = boomerang;
        return BMR_ROOTS + w->queued++;
    }
    const bmr_vec2 before = w->normals[boomerang.before], after = w->normals[boomerang.after];
    while (boomerang.low < boomerang.high && agree(before, items[boomerang.low].normal, BMR_MERGE_ANGLE))
        ++boomerang.low;
    while (boomerang.low < boomerang.high && agree(after, items[boomerang.high - 1].normal, BMR_MERGE_ANGLE))
        --boomerang.high;
    if (boomerang.low == boomerang.high)
        return BMR_NO_CHILD;
    w->queue[w->queued] = boomerang;
    return BMR_ROOTS + w->queued++;
}

/// Index of the first item of [low, high) counter-clockwise of a direction.
static uint32_t first_item_after(const bmr_item *items, uint32_t low, uint32_t high, bmr_vec2 direction) {
    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        if (bmr_cross(direction, items[middle].normal) > 0.0)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/// Makes the node that bisects the angle of a boomerang; returns the first item after it.
static uint32_t cut_by_compass(work *w, const pending *b, bmr_node *node, bmr_vec2 *normal) {
    const bmr_build *build = w->build;
    const bmr_item *items = build->items;
    const uint32_t direction = (BMR_ROOTS << (node->level - 1)) + b->position;
    *normal = build->compass->directions[direction];
    const uint32_t split = first_item_after(items, b->low, b->high, *normal);
    uint32_t touch = split < b->high  ? items[split].touch
                     : split > b->low ? bmr_vertex_after(build->polygon, items[split - 1].touch)
                                      : last_touch(w, b->before); // a vertex: no items
    bool wide = false;
    if (split > b->low && agree(items[split - 1].normal, *normal, BMR_SAME_ANGLE)) {
        touch = items[split - 1].touch;
        wide = true;
    } else if (split < b->high && agree(items[split].normal, *normal, BMR_SAME_ANGLE)) {
        wide = true;
    }
    node->direction = ID(direction);
    node->touch = touch & 0xFFFFu;
    node->wide = wide;
    return split;
}

static void cut_by_item(work *w, const bmr_item *item, bmr_node *node, bmr_vec2 *normal) {
    node->touch = item->touch & 0xFFFFu;
    node->own = item->own & 1u;
    node->wide = item->own & 1u;
    if (!item->own)
        node->direction = ID(BMR_ROOTS + w->degenerate++);
    *normal = item->normal;
}

static void cut(work *w, uint32_t index) {
    const pending b = w->queue[index];
    const uint32_t id = BMR_ROOTS + index;
    bmr_node *node = &w->nodes[id];
    memset(node, 0, sizeof *node);
    node->outer_before = ID(b.before);
    node->outer_after = ID(b.after);
    node->level = level_of_cut(w, &b) & 63u;
    uint32_t low_end, high_begin;
    if (node->level <= w->build->compass_levels) {
        low_end = high_begin = cut_by_compass(w, &b, node, &w->normals[id]);
    } else {
        low_end = b.low + (b.high - b.low) / 2;
        high_begin = low_end + 1;
        cut_by_item(w, &w->build->items[low_end], node, &w->normals[id]);
    }
    const pending half_before = {b.before, id, b.low, low_end, 2 * b.position};
    const pending half_after = {id, b.after, high_begin, b.high, 2 * b.position + 1};
    node->child_before = ID(enqueue(w, half_before));
    node->child_after = ID(enqueue(w, half_after));
}

static const bmr_vec2 root_normals[BMR_ROOTS] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};

static void make_root(work *w, uint32_t k) {
    const bmr_polygon *p = w->build->polygon;
    bmr_node *node = &w->nodes[k];
    memset(node, 0, sizeof *node);
    uint32_t touch = bmr_polygon_support(p, root_normals[k]);
    if (p->count > 1) {
        const uint32_t previous = touch > 0 ? touch - 1 : p->count - 1;
        if (agree(bmr_polygon_normal(p, touch), root_normals[k], BMR_SAME_ANGLE)) {
            node->wide = 1;
        } else if (agree(bmr_polygon_normal(p, previous), root_normals[k], BMR_SAME_ANGLE)) {
            touch = previous;
            node->wide = 1;
        }
    }
    node->touch = touch & 0xFFFFu;
    node->direction = k & 3u;
    node->outer_before = (k + 3) & 3u;
    node->outer_after = (k + 1) & 3u;
    w->normals[k] = root_normals[k];
}

static void make_tree(work *w) {
    const bmr_build *build = w->build;
    for (uint32_t k = 0; k < BMR_ROOTS; ++k)
        make_root(w, k);
    uint32_t low = 0;
    for (uint32_t k = 0; k < BMR_ROOTS; ++k) {
        uint32_t high = low;
        while (high < build->item_count && bmr_tree_quadrant(build->items[high].normal) == k)
            ++high;
        const uint32_t next = (k + 1) & 3u;
        const pending corner = {k, next, low, high, k};
        const uint32_t top = enqueue(w, corner);
        w->nodes[k].child_after = ID(top);
        w->nodes[next].child_before = ID(top);
        low = high;
    }
    for (uint32_t i = 0; i < w->queued; ++i)
        cut(w, i);
}

/// On each compass level the boomerangs that are cut hold different edges, where vertices are not cut.
size_t bmr_most_cuts(size_t items, uint32_t compass_levels, uint32_t corner_levels) {
    size_t most = items;
    for (uint32_t level = 1; level <= compass_levels; ++level) {
        const size_t all = (size_t)BMR_ROOTS << (level - 1);
        most += level <= corner_levels || all < items ? all : items;
    }
    return most;
}

/// The directions of a tree without a compass: the roots', then the degenerate edges' in the order of their
/// ids.
static void keep_directions(const work *w, bmr_hierarchy *h) {
    bmr_vec2 *directions = (bmr_vec2 *)(h->nodes + h->count);
    for (uint32_t id = 0; id < h->count; ++id)
        if (!h->nodes[id].own)
            directions[h->nodes[id].direction] = w->normals[id];
    h->directions = directions;
}

static bmr_error keep_tree(const work *w, const bmr_allocator *allocator, bmr_hierarchy **hierarchy) {
    bmr_hierarchy head = {0};
    head.polygon = w->build->polygon;
    head.stamp = w->build->polygon->stamp;
    head.kind = (uint8_t)w->build->kind;
    head.corner_levels = (uint8_t)w->build->corner_levels;
    head.count = BMR_ROOTS + w->queued;
    head.direction_count = w->build->compass ? 0 : BMR_ROOTS + w->degenerate;
    head.depth = (uint16_t)w->nodes[head.count - 1].level; // breadth-first: the last is a deepest
    bmr_hierarchy *h = bmr_allocate(allocator, bmr_hierarchy_bytes(&head));
    if (!h)
        return BMR_ERROR_NO_MEMORY;
    *h = head;
    memcpy(h->nodes, w->nodes, h->count * sizeof *h->nodes);
    if (w->build->compass)
        h->directions = w->build->compass->directions;
    else
        keep_directions(w, h);
    *hierarchy = h;
    return BMR_OK;
}

bmr_error bmr_build_tree(const bmr_build *build, const bmr_allocator *allocator, bmr_hierarchy **hierarchy) {
    const size_t cuts = bmr_most_cuts(build->item_count, build->compass_levels, build->corner_levels),
                 nodes = BMR_ROOTS + cuts;
    const size_t size = nodes * (sizeof(bmr_node) + sizeof(bmr_vec2)) + cuts * sizeof(pending);
    char *scratch = bmr_allocate(allocator, size);
    if (!scratch)
        return BMR_ERROR_NO_MEMORY;
    work w = {build, NULL, NULL, NULL, 0, 0};
    w.nodes = (bmr_node *)scratch;
    w.normals = (bmr_vec2 *)(w.nodes + nodes);
    w.queue = (pending *)(w.normals + nodes);
    make_tree(&w);
    const bmr_error error = keep_tree(&w, allocator, hierarchy);
    bmr_release(allocator, scratch, size);
    return error;
}

void bmr_hierarchy_destroy(bmr_hierarchy *hierarchy, const bmr_allocator *allocator) {
    if (hierarchy)
        bmr_release(allocator, hierarchy, bmr_hierarchy_bytes(hierarchy));
}

bmr_error bmr_build_of_edges(bmr_build build, const bmr_allocator *allocator, bmr_hierarchy **hierarchy) {
    const size_t size = build.polygon->count * sizeof(bmr_item);
    bmr_item *items = bmr_allocate(allocator, size);
    if (!items)
        return BMR_ERROR_NO_MEMORY;
    build.items = items;
    build.item_count = items_of_edges(build.polygon, items);
    bmr_items_start_at_east(items, build.item_count);
    const bmr_error error = bmr_build_tree(&build, allocator, hierarchy);
    bmr_release(allocator, items, size);
    return error;
}

bmr_error bmr_hierarchy_build_dobkin_kirkpatrick(const bmr_polygon *polygon, const bmr_allocator *allocator,
                                                 bmr_hierarchy **hierarchy) {
    if (!polygon || !hierarchy)
        return BMR_ERROR_NULL_ARGUMENT;
    const bmr_build build = {polygon, BMR_HIERARCHY_DOBKIN_KIRKPATRICK, NULL, 0, NULL, 0, 0};
    return bmr_build_of_edges(build, allocator, hierarchy);
}
