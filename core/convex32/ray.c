// SPDX-License-Identifier: MIT
#include "boomerang/convex32.h"
#include "convex32/near_edges.h"

/// @file
/// Box2D's ray cast goes through the edges in order, and keeps the part of the segment that is inside all
/// so far. Edges that the line's part inside the polygon is well inside of change nothing that counts,
/// whenever they come; so the same steps over those edges alone that are near where the line enters and
/// leaves give the same fraction and edge, ties and rounding included. Where the line runs nearly along one
/// of these edges, rounding can put the fraction anywhere, and all edges are asked.

/// Sizes that leave room for every product.
#define LARGE 1e15f
#define SMALL 1e-15f
/// An edge whose normal's product with the ray's direction is smaller than this part of its length is along
/// the ray.
#define ALONG 0.125f
/// How near an edge has to be, in parts of the size of all that goes in. A separation and the point are wrong
/// by less than 10 * 2^-24 together, a place on a line that meets an edge steeper than ALONG by 8 times that;
/// this is three times as much, so what is left out is clear.
#define NEAR 0x1p-16f
/// Two points with a range for each sector, and one more piece for each that runs past the last edge.
enum { MOST_RANGES = 2 * 2 * CONVEX32_SECTORS };

typedef struct ray_state {
    bmr_vec32 p1, d;
    float lower, upper;
    uint32_t edge;
    float least_steep; ///< the smallest |denominator| so far
} ray_state;

#define NO_EDGE UINT32_MAX

/// One edge more. False where nothing of the segment is left.
static inline bool clip_by_edge(const bmr_convex32 *p, uint32_t i, ray_state *ray) {
    const bmr_vec32 n = p->normals[i], v = p->vertices[i];
    const float numerator = n.x * (v.x - ray->p1.x) + n.y * (v.y - ray->p1.y);
    const float denominator = n.x * ray->d.x + n.y * ray->d.y;
    ray->least_steep = fminf(ray->least_steep, fabsf(denominator));
    if (denominator == 0.0f) {
        if (numerator < 0.0f)
            return false;
    } else if (denominator < 0.0f && numerator < ray->lower * denominator) {
        ray->lower = numerator / denominator;
        ray->edge = i;
    } else if (denominator > 0.0f && numerator < ray->upper * denominator)
        ray->upper = numerator / denominator;
    return !(ray->upper < ray->lower);
}

static bool clip_by_range(const bmr_convex32 *p, edge_range range, ray_state *ray) {
    for (uint32_t i = range.first; i < range.first + range.count; ++i)
        if (!clip_by_edge(p, i, ray))
            return false;
    return true;
}

typedef struct range_list {
    edge_range ranges[MOST_RANGES];
    uint32_t count;
} range_list;

/// Adds a piece that does not wrap, in order of the first edges.
static void add_piece(range_list *list, edge_range piece) {
    uint32_t place = list->count++;
    for (; place > 0 && list->ranges[place - 1].first > piece.first; --place)
        list->ranges[place] = list->ranges[place - 1];
    list->ranges[place] = piece;
}

/// The edges with a separation of more than -margin from the point.
static void add_near(const bmr_convex32 *p, bmr_vec32 point, float margin, range_list *list) {
    for (uint32_t k = 0; k < CONVEX32_SECTORS; ++k) {
        const edge_range edges = sector_edges(p, k);
        if (edges.count == 0)
            continue;
        const uint32_t hit = sector_hit(p, edges, k, point);
        if (edge_separation(p, convex32_wrap(p, edges.first + hit), point) <= -1.5f * margin)
            continue;
        edge_range range = around(p, edges, hit, point, margin);
        if (range.first + range.count > p->count) {
            const edge_range wrapped = {0, range.first + range.count - p->count};
            add_piece(list, wrapped);
            range.count -= wrapped.count;
        }
        add_piece(list, range);
    }
}

/// Each edge once, in order. `along` says whether one was along the ray; then the answer is not to be
/// trusted.
static bool clip_by_list(const bmr_convex32 *p, const range_list *list, ray_state *ray, bool *along) {
    const float steep = ALONG * convex32_size(ray->d);
    bool left_over = true;
    uint32_t done = 0; // all edges before this one
    for (uint32_t k = 0; k < list->count && left_over; ++k) {
        const uint32_t end = list->ranges[k].first + list->ranges[k].count;
        const uint32_t first = list->ranges[k].first > done ? list->ranges[k].first : done;
        if (end <= first)
            continue;
        const edge_range left = {first, end - first};
        left_over = clip_by_range(p, left, ray);
        done = end;
    }
    *along = !(ray->least_steep > steep);
    return left_over;
}

/// How far to the left of the ray's line, times the length of d.
static double side_of(const ray_state *ray, bmr_vec32 v) {
    return (double)ray->d.x * ((double)v.y - (double)ray->p1.y) -
           (double)ray->d.y * ((double)v.x - (double)ray->p1.x);
}

/// Where the line crosses the chain from vertex `from` to vertex `to`, along which the vertices go from one
/// of its sides (sign 1: left) to the other. False where it does not.
static bool crosses(const bmr_convex32 *p, const ray_state *ray, uint32_t from, uint32_t to, double sign,
                    bmr_vec32 *point) {
    uint32_t low = 0, high = to > from ? to - from : to + p->count - from;
    if (sign * side_of(ray, p->vertices[from]) <= 0.0 || sign * side_of(ray, p->vertices[to]) >= 0.0)
        return false;
    while (low + 1 < high) {
        const uint32_t middle = (low + high) / 2;
        if (sign * side_of(ray, p->vertices[convex32_wrap(p, from + middle)]) > 0.0)
            low = middle;
        else
            high = middle;
    }
    const bmr_vec32 a = p->vertices[convex32_wrap(p, from + low)],
                    b = p->vertices[convex32_wrap(p, from + high)];
    const double side_a = side_of(ray, a), side_b = side_of(ray, b);
    const double t = side_a / (side_a - side_b);
    point->x = (float)((double)a.x + t * ((double)b.x - (double)a.x));
    point->y = (float)((double)a.y + t * ((double)b.y - (double)a.y));
    return true;
}

/// Does the line pass this vertex so clearly that both its edges say so, where the one is left and the other
/// entered? Then it has left the one before it comes to the other.
static bool passes_by(const bmr_convex32 *p, const ray_state *ray, uint32_t vertex, float margin) {
    const bmr_vec32 v = p->vertices[vertex];
    const double dx = (double)ray->d.x, dy = (double)ray->d.y;
    const bmr_vec32 before = p->normals[convex32_previous(p, vertex)], after = p->normals[vertex];
    if ((dx * (double)before.x + dy * (double)before.y) * (dx * (double)after.x + dy * (double)after.y) >=
        0.0)
        return false;
    const double t = side_of(ray, v) / (dx * dx + dy * dy);
    const bmr_vec32 passed = {(float)((double)v.x + t * dy), (float)((double)v.y - t * dx)};
    return edge_separation(p, vertex, passed) > margin &&
           edge_separation(p, convex32_previous(p, vertex), passed) > margin;
}

/// False also where nothing can be said in less than all edges: then `*unsure`.
static bool clip_by_near(const bmr_convex32 *p, ray_state *ray, bool *unsure) {
    const float size = convex32_size(ray->d);
    const bmr_vec32 to_left = {-ray->d.y, ray->d.x}, to_right = {ray->d.y, -ray->d.x};
    *unsure = true;
    if (!p->buckets || !(size > SMALL && size < LARGE) || !(convex32_size(ray->p1) < LARGE) ||
        !(fabsf(ray->upper) < LARGE))
        return false;
    const uint32_t left = bmr_convex32_support(p, to_left), right = bmr_convex32_support(p, to_right);
    if (left == right) // thinner than rounding
        return false;
    const float margin = NEAR * separation_size(p, ray->p1);
    if (passes_by(p, ray, left, margin) || passes_by(p, ray, right, margin)) {
        *unsure = false;
        return false;
    }
    // Counter-clockwise from left to right, the edges face the ray.
    bmr_vec32 in, out;
    if (!crosses(p, ray, left, right, 1.0, &in) || !crosses(p, ray, right, left, -1.0, &out))
        return false;
    range_list list = {.count = 0};
    add_near(p, in, margin, &list);
    add_near(p, out, margin, &list);
    const bool left_over = clip_by_list(p, &list, ray, unsure);
    // What is left is next to nothing, or next to something: rounding decides.
    *unsure = *unsure || !(fabsf(ray->upper - ray->lower) * size > margin);
    return left_over;
}

bool bmr_convex32_ray(const bmr_convex32 *polygon, bmr_vec32 p1, bmr_vec32 p2, float max_fraction,
                      float *fraction, uint32_t *edge) {
    const ray_state start = {p1, {p2.x - p1.x, p2.y - p1.y}, 0.0f, max_fraction, NO_EDGE, FLT_MAX};
    const edge_range all = {0, polygon->count};
    ray_state ray = start;
    bool unsure;
    bool left_over = clip_by_near(polygon, &ray, &unsure);
    if (unsure) {
        ray = start;
        left_over = clip_by_range(polygon, all, &ray);
    }
    if (!left_over || ray.edge == NO_EDGE)
        return false;
    *fraction = ray.lower;
    *edge = ray.edge;
    return true;
}
