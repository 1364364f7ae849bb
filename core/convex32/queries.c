// SPDX-License-Identifier: MIT
#include "convex32/convex32.h"
#include "convex32/directions.h"

/// @file
/// The edges whose lines a point is near to, or outside of, without looking at all edges.
///
/// Edges are taken in four sectors by their normals: within 45 degrees of +x, +y, -x, -y. Seen along the
/// sector's axis, the point's depth below the lines of one sector rises up to the edge that the axis through
/// the point hits, and falls behind it; and an edge's separation is that depth times a cosine between 0.707
/// and 1. So the edges of a sector with a separation above some bound lie side by side around the edge hit,
/// which halving finds.

enum { CONVEX32_SECTORS = 4 };

/// Edges first, first + 1, ... in cyclic order.
typedef struct edge_range {
    uint32_t first, count;
} edge_range;

/// The edges of a sector: 0, +x; 1, +y; 2, -x; 3, -y. A polygon with a table.
static inline edge_range sector_edges(const bmr_convex32 *p, uint32_t sector) {
    const uint32_t eighth = 1u << (p->bucket_bits - 3);
    const uint32_t first = p->buckets[eighth * (2 * sector + 1)];
    const uint32_t last = p->buckets[(eighth * (2 * sector + 3)) & (8 * eighth - 1)];
    const edge_range range = {first, last >= first ? last - first : last + p->count - first};
    return range;
}

static inline uint32_t convex32_wrap(const bmr_convex32 *p, uint32_t i) {
    return i < p->count ? i : i - p->count;
}

/// How far a vertex lies along the sector's edges: strictly rising from each to the next.
static inline float sector_key(bmr_vec32 v, uint32_t sector) {
    const float key = (sector & 1u) != 0 ? v.x : v.y;
    return sector == 1 || sector == 2 ? -key : key;
}

/// Of a sector that is not empty, the edge that the axis through the point hits, or the end nearer to it.
static inline uint32_t sector_hit(const bmr_convex32 *p, edge_range edges, uint32_t sector, bmr_vec32 point) {
    const float key = sector_key(point, sector);
    uint32_t low = 0, high = edges.count - 1;
    while (low < high) {
        const uint32_t middle = (low + high + 1) / 2;
        if (sector_key(p->vertices[convex32_wrap(p, edges.first + middle)], sector) <= key)
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

/// In Box2D's order of operations.
static inline float edge_separation(const bmr_convex32 *p, uint32_t edge, bmr_vec32 point) {
    const bmr_vec32 n = p->normals[edge], v = p->vertices[edge];
    return n.x * (point.x - v.x) + n.y * (point.y - v.y);
}

/// The edges of the sector around `hit` with a float separation above -margin, and perhaps more.
static inline edge_range around(const bmr_convex32 *p, edge_range edges, uint32_t hit, bmr_vec32 point,
                                float margin) {
    uint32_t low = hit, high = hit + 1;
    while (low > 0 && edge_separation(p, convex32_wrap(p, edges.first + low - 1), point) > -1.5f * margin)
        --low;
    while (high < edges.count &&
           edge_separation(p, convex32_wrap(p, edges.first + high), point) > -1.5f * margin)
        ++high;
    const edge_range range = {convex32_wrap(p, edges.first + low), high - low};
    return range;
}

/// |x| + |y| of all that goes into a separation.
static inline float separation_size(const bmr_convex32 *p, bmr_vec32 point) {
    return convex32_size(point) + convex32_size(p->extent);
}

/// A separation is wrong by less than 5 * 2^-24 of the size: differences, products and the sum by one part in
/// 2^24 each, the normal's rounding. Below minus this much no edge farther from the one hit comes out above
/// zero: (1 + 1.415) times the error, and more than that, see `around`.
#define CONVEX32_SEPARATION_NOISE 0x1p-20f

/// A size that leaves room for every product.
#define LARGE 1e15f

static bool contains_by_all(const bmr_convex32 *p, bmr_vec32 point) {
    for (uint32_t i = 0; i < p->count; ++i)
        if (edge_separation(p, i, point) > 0.0f)
            return false;
    return true;
}

bool bmr_convex32_contains(const bmr_convex32 *polygon, bmr_vec32 point) {
    if (!polygon->buckets || !(convex32_size(point) < LARGE))
        return contains_by_all(polygon, point);
    const float margin = CONVEX32_SEPARATION_NOISE * separation_size(polygon, point);
    edge_range edges[CONVEX32_SECTORS];
    uint32_t hits[CONVEX32_SECTORS];
    bool unsure[CONVEX32_SECTORS];
    for (uint32_t k = 0; k < CONVEX32_SECTORS; ++k) {
        unsure[k] = false;
        edges[k] = sector_edges(polygon, k);
        if (edges[k].count == 0)
            continue;
        hits[k] = sector_hit(polygon, edges[k], k, point);
        const float separation =
            edge_separation(polygon, convex32_wrap(polygon, edges[k].first + hits[k]), point);
        if (separation > 0.0f)
            return false;
        unsure[k] = separation > -1.5f * margin;
    }
    for (uint32_t k = 0; k < CONVEX32_SECTORS; ++k) {
        if (!unsure[k])
            continue;
        const edge_range near = around(polygon, edges[k], hits[k], point, margin);
        for (uint32_t i = 0; i < near.count; ++i)
            if (edge_separation(polygon, convex32_wrap(polygon, near.first + i), point) > 0.0f)
                return false;
    }
    return true;
}

void bmr_convex32_box(const bmr_convex32 *polygon, const bmr_transform32 *pose, bmr_vec32 *lower,
                      bmr_vec32 *upper) {
    // A coordinate is a dot product with a row of the pose, then a sum that keeps the order.
    const float s = pose->s, c = pose->c;
    const bmr_vec32 right = {c, -s}, up = {s, c}, left = {-c, s}, down = {-s, -c};
    const bmr_vec32 *v = polygon->vertices;
    const bmr_vec32 most_right = v[bmr_convex32_support(polygon, right)],
                    most_up = v[bmr_convex32_support(polygon, up)],
                    most_left = v[bmr_convex32_support(polygon, left)],
                    most_down = v[bmr_convex32_support(polygon, down)];
    upper->x = (c * most_right.x - s * most_right.y) + pose->p.x;
    upper->y = (s * most_up.x + c * most_up.y) + pose->p.y;
    lower->x = (c * most_left.x - s * most_left.y) + pose->p.x;
    lower->y = (s * most_down.x + c * most_down.y) + pose->p.y;
}

/// @file
/// Box2D's ray cast goes through the edges in order, and keeps the part of the segment that is inside all
/// so far. Floats decide wrongly only of edges that rounding can move onto the ends of that part. So: move
/// all edges outward by `noise`, which is more than any rounding. The part of the segment inside of that
/// larger polygon, from `lower` to `upper`, can be relied on: in every order of the edges the loop over
/// all of them ends with nothing outside of it. An edge that is more than the noise away from the line's
/// places at both `lower` and `upper` is without effect, since what it says is nowhere between. The others
/// are asked in the order of the loop, and answer as in the loop, ties and rounding included.

/// Sizes that leave room for every product.
#define LARGE 1e15f
#define SMALL 1e-15f
/// Rounding of a separation at a place on the segment: 3 * 2^-24 of the distance of the vertex and of the
/// place from the segment's begin, besides 2 * 2^-24 of the polygon's extent for normals. As much again is
/// left for comparisons that an ulp decides.
#define NOISE 0x1.8p-22
/// A product of a normal with the ray's direction that is a smaller part of its length may come out with the
/// other sign.
#define ALONG 0x1p-21
/// The noise is that of places at most this many times as far from the segment's begin as the polygon.
#define FAR 2.0
/// Where the direction is so much nearer to a sector's axis than to its sides, in parts of its length, it
/// leaves all the sector's edges.
#define CLEARLY 0x1p-18f
/// Two places with a range for each sector, and one more piece for each that runs past the last edge.
enum { MOST_RANGES = 2 * 2 * CONVEX32_SECTORS };

typedef struct ray_state {
    bmr_vec32 p1, d;
    float lower, upper;
    uint32_t edge;
} ray_state;

#define NO_EDGE UINT32_MAX

/// One edge more. False where nothing of the segment is left.
static inline bool clip_by_edge(const bmr_convex32 *p, uint32_t i, ray_state *ray) {
    const bmr_vec32 n = p->normals[i], v = p->vertices[i];
    const float numerator = n.x * (v.x - ray->p1.x) + n.y * (v.y - ray->p1.y);
    const float denominator = n.x * ray->d.x + n.y * ray->d.y;
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

/// The segment, and the part of it inside of the larger polygon, as far as that has been cut off.
typedef struct ray_part {
    double px, py, dx, dy;
    double noise;
    double along; ///< the least product of a normal with d to rely on
    double lower, upper;
} ray_part;

/// How far the line's place is outside of an edge.
static inline double separation_on(const bmr_convex32 *p, const ray_part *part, uint32_t edge, double at) {
    const bmr_vec32 n = p->normals[edge], v = p->vertices[edge];
    return (double)n.x * (part->px + at * part->dx - (double)v.x) +
           (double)n.y * (part->py + at * part->dy - (double)v.y);
}

/// Cuts off what is outside of this edge, moved out. False where nothing is left.
static bool cut(const bmr_convex32 *p, uint32_t edge, ray_part *part) {
    const bmr_vec32 n = p->normals[edge];
    const double out = separation_on(p, part, edge, 0.0) - part->noise;
    const double denominator = (double)n.x * part->dx + (double)n.y * part->dy;
    if (denominator < 0.0)
        part->lower = fmax(part->lower, -out / denominator);
    else if (denominator > part->along)
        part->upper = fmin(part->upper, -out / denominator);
    else if (denominator == 0.0 && out > 0.0)
        return false;
    return part->lower <= part->upper;
}

/// How far to the left of the line an edge begins, once moved out, times the length of d.
static inline double side_of_begin(const bmr_convex32 *p, const ray_part *part, uint32_t edge) {
    const bmr_vec32 n = p->normals[edge], v = p->vertices[edge];
    const double x = (double)v.x + part->noise * (double)n.x - part->px;
    const double y = (double)v.y + part->noise * (double)n.y - part->py;
    return part->dx * y - part->dy * x;
}

/// Cuts by the edges, of those from vertex `from` to vertex `to`, that the line crosses once they are moved
/// out: one, or the two at a corner. Along them it goes from one side of the line (sign 1: left) to the
/// other.
static bool cut_by_chain(const bmr_convex32 *p, uint32_t from, uint32_t to, double sign, ray_part *part) {
    uint32_t low = 0, high = to > from ? to - from : to + p->count - from;
    while (low + 1 < high) {
        const uint32_t middle = (low + high) / 2;
        if (sign * side_of_begin(p, part, convex32_wrap(p, from + middle)) > 0.0)
            low = middle;
        else
            high = middle;
    }
    const uint32_t edge = convex32_wrap(p, from + low);
    return cut(p, edge, part) && cut(p, convex32_next(p, edge), part);
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

/// The edges of a sector that are not farther inside than the noise from the line's place, and perhaps more.
static void add_near(const bmr_convex32 *p, const ray_part *part, double at, edge_range edges,
                     uint32_t sector, range_list *list) {
    const double bound = -1.5 * part->noise; // see `around`
    const bmr_vec32 place = {(float)(part->px + at * part->dx), (float)(part->py + at * part->dy)};
    const uint32_t hit = sector_hit(p, edges, sector, place);
    if (separation_on(p, part, convex32_wrap(p, edges.first + hit), at) <= bound)
        return;
    uint32_t low = hit, high = hit + 1;
    while (low > 0 && separation_on(p, part, convex32_wrap(p, edges.first + low - 1), at) > bound)
        --low;
    while (high < edges.count && separation_on(p, part, convex32_wrap(p, edges.first + high), at) > bound)
        ++high;
    edge_range range = {convex32_wrap(p, edges.first + low), high - low};
    if (range.first + range.count > p->count) {
        const edge_range wrapped = {0, range.first + range.count - p->count};
        add_piece(list, wrapped);
        range.count -= wrapped.count;
    }
    add_piece(list, range);
}

/// Adds the edges that may cut the segment: those that it enters near the beginning of its part, and those
/// that it leaves near the end.
static void add_ends(const bmr_convex32 *p, const ray_part *part, bmr_vec32 d, range_list *list) {
    const float clearly = CLEARLY * convex32_size(d), along[2] = {d.x, d.y};
    for (uint32_t k = 0; k < CONVEX32_SECTORS; ++k) {
        const edge_range edges = sector_edges(p, k);
        if (edges.count == 0)
            continue;
        const float ahead = k < 2 ? along[k] : -along[k - 2], across = fabsf(along[(k + 1) & 1u]);
        if (!(ahead - across > clearly))
            add_near(p, part, part->lower, edges, k, list);
        if (!(-ahead - across > clearly))
            add_near(p, part, part->upper, edges, k, list);
    }
}

/// Clips the segment by each edge of the list once, in ascending order: ranges of the list may overlap.
static bool clip_by_list(const bmr_convex32 *p, const range_list *list, ray_state *ray) {
    uint32_t done = 0; // all edges before this one
    for (uint32_t k = 0; k < list->count; ++k) {
        const uint32_t end = list->ranges[k].first + list->ranges[k].count;
        const uint32_t first = list->ranges[k].first > done ? list->ranges[k].first : done;
        if (end <= first)
            continue;
        const edge_range left = {first, end - first};
        if (!clip_by_range(p, left, ray))
            return false;
        done = end;
    }
    return true;
}

/// The vertex at which a line along `d` leaves the polygon, in exact arithmetic.
static uint32_t leaving_vertex(const bmr_convex32 *p, bmr_vec32 d) {
    uint32_t vertex = convex32_near_leaving(p, d, convex32_size(d));
    while (convex32_turn(p->normals[vertex], d) >= 0.0)
        vertex = convex32_next(p, vertex);
    while (convex32_turn(p->normals[convex32_previous(p, vertex)], d) < 0.0)
        vertex = convex32_previous(p, vertex);
    return vertex;
}

/// The part of the segment inside of the larger polygon. False where there is none.
static bool cut_by_all(const bmr_convex32 *p, const ray_state *ray, ray_part *part) {
    const bmr_vec32 to_left = {-ray->d.y, ray->d.x}, to_right = {ray->d.y, -ray->d.x};
    const uint32_t left = leaving_vertex(p, to_left), right = leaving_vertex(p, to_right);
    // Passed by on this side: left by one edge before the next is entered.
    if (side_of_begin(p, part, left) <= 0.0 &&
        !(cut(p, left, part) && cut(p, convex32_previous(p, left), part)))
        return false;
    if (side_of_begin(p, part, right) >= 0.0 &&
        !(cut(p, right, part) && cut(p, convex32_previous(p, right), part)))
        return false;
    // Counter-clockwise from left to right, the edges face the ray.
    return cut_by_chain(p, left, right, 1.0, part) && cut_by_chain(p, right, left, -1.0, part);
}

/// False also where nothing can be said in less than all edges: then `*unsure`.
static bool clip_by_near(const bmr_convex32 *p, ray_state *ray, bool *unsure) {
    const float size = convex32_size(ray->d), begin = convex32_size(ray->p1);
    *unsure =
        !p->buckets || !(size > SMALL && size < LARGE) || !(begin < LARGE) || !(fabsf(ray->upper) < LARGE);
    if (*unsure)
        return false;
    const double reach = (double)separation_size(p, ray->p1), length = (double)ray->upper * (double)size;
    const bool far = length > FAR * reach;
    ray_part part = {.px = (double)ray->p1.x,
                     .py = (double)ray->p1.y,
                     .dx = (double)ray->d.x,
                     .dy = (double)ray->d.y,
                     .noise = NOISE * (reach + (far ? FAR * reach : fmax(length, 0.0))),
                     .along = far ? ALONG * (double)size : 0.0,
                     .lower = 0.0,
                     .upper = (double)ray->upper};
    if (!cut_by_all(p, ray, &part))
        return false;
    *unsure = far && part.upper * (double)size > FAR * reach;
    if (*unsure)
        return false;
    range_list list = {.count = 0};
    add_ends(p, &part, ray->d, &list);
    return clip_by_list(p, &list, ray);
}

bool bmr_convex32_ray(const bmr_convex32 *polygon, bmr_vec32 p1, bmr_vec32 p2, float max_fraction,
                      float *fraction, uint32_t *edge) {
    const edge_range all = {0, polygon->count};
    ray_state ray = {p1, {p2.x - p1.x, p2.y - p1.y}, 0.0f, max_fraction, NO_EDGE};
    bool unsure;
    bool left_over = clip_by_near(polygon, &ray, &unsure);
    if (unsure)
        left_over = clip_by_range(polygon, all, &ray);
    if (!left_over || ray.edge == NO_EDGE)
        return false;
    *fraction = ray.lower;
    *edge = ray.edge;
    return true;
}
