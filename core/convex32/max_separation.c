// SPDX-License-Identifier: MIT
#include "edge_search.h"

#include <float.h>

// The function that is searched: for a unit direction u, s(u) = min u.q - max u.p over the other's vertices q
// and the reference's p. At the normal of an edge of the reference it is that edge's separation. Two facts do
// the work.
//
// Any pair of vertices bounds it: s(u) <= u.(q - p). The pair that is closest at one end of an arc of
// directions and that at the other end give a bound over the whole arc, which is tight where the arc is
// short. Arcs whose bound is less than the best edge's separation are dropped, the others split: branch and
// bound, exact however deeply the polygons overlap.
//
// And the directions with s(u) >= t form one arc for every t >= 0 (they are those with u.(q - p) >= t for all
// pairs, each of which is an arc of at most half a turn). So where the best edge separates, and the edges on
// either side of it do so by less, no other edge comes near.

/// A unit in the last place of 1, halved, is 2^-24. A normal that was turned is off by 3 of them, a vertex
/// that was moved by 4 of its and the frame's size, their difference's product with the normal by 2 more of
/// its length: less than 8 of all sizes together.
static const float noise_of_size = 0x1p-21f;

/// The products of one normal with neighbouring vertices share the errors of the normal and the place; what
/// is left is 3 halves of units of the difference.
static const float noise_of_product = 0x1p-22f;

/// Edges around the hint that are tried before the search is given to branch and bound.
enum { NEAR_EDGES = 12 };

/// Arcs are split where their bound is until this depth, and in the middle below, so that they end.
enum { GUIDED_SPLITS = 24, MOST_ARCS = GUIDED_SPLITS + 16 + 4 };

typedef struct least {
    float separation;
    uint32_t vertex;
} least;

static inline float separate(bmr_vec32 normal, bmr_vec32 place, bmr_vec32 point) {
    return normal.x * (point.x - place.x) + normal.y * (point.y - place.y);
}

static least least_of_few(const bmr_convex32 *other, bmr_vec32 normal, bmr_vec32 place) {
    least found = {FLT_MAX, 0};
    for (uint32_t j = 0; j < other->count; ++j) {
        const float s = separate(normal, place, other->vertices[j]);
        if (s < found.separation) {
            found.separation = s;
            found.vertex = j;
        }
    }
    return found;
}

/// Is the point, rounding included, separated by more than this, which is off by less than `noise`?
static inline bool clearly_above(bmr_vec32 normal, bmr_vec32 place, bmr_vec32 point, float separation,
                                 float noise) {
    const bmr_vec32 d = minus(point, place);
    return dot(normal, d) > separation + (noise + noise_of_product * convex32_size(d));
}

/// On both sides of a vertex that is the least to rounding: the least as it was rounded.
static least least_around(const bmr_convex32 *other, bmr_vec32 normal, bmr_vec32 place, uint32_t vertex) {
    const bmr_vec32 *const v = other->vertices;
    least found = {separate(normal, place, v[vertex]), vertex};
    const float noise = noise_of_product * convex32_size(minus(v[vertex], place));
    for (int side = 0; side < 2; ++side) {
        uint32_t j = vertex;
        for (uint32_t steps = 1; steps < other->count; ++steps) {
            j = side == 0 ? convex32_next(other, j) : convex32_previous(other, j);
            const float s = separate(normal, place, v[j]);
            if (s < found.separation) {
                found.separation = s;
                found.vertex = j;
            }
            if (clearly_above(normal, place, v[j], found.separation, noise))
                break;
        }
    }
    return found;
}

static inline least least_separated(const bmr_convex32 *other, bmr_vec32 normal, bmr_vec32 place,
                                    uint32_t hint) {
    enum { NEAR_STEPS = 4 };
    if (other->count <= 8)
        return least_of_few(other, normal, place);
    const bmr_vec32 *const v = other->vertices;
    uint32_t at = hint < other->count ? hint : 0;
    uint32_t next = convex32_next(other, at), last = convex32_previous(other, at);
    float here = separate(normal, place, v[at]);
    float ahead = separate(normal, place, v[next]), behind = separate(normal, place, v[last]);
    int steps = 0;
    for (; steps < NEAR_STEPS && ahead < here; ++steps) {
        behind = here;
        here = ahead;
        at = next;
        next = convex32_next(other, at);
        ahead = separate(normal, place, v[next]);
    }
    for (; steps < NEAR_STEPS && behind < here; ++steps) {
        here = behind;
        at = last;
        last = convex32_previous(other, at);
        behind = separate(normal, place, v[last]);
    }
    if (steps == NEAR_STEPS) {
        at = bmr_convex32_find_farthest(other, negative(normal), at);
        next = convex32_next(other, at);
        last = convex32_previous(other, at);
        here = separate(normal, place, v[at]);
    }
    const float noise = noise_of_product * convex32_size(minus(v[at], place));
    if (clearly_above(normal, place, v[next], here, noise) &&
        clearly_above(normal, place, v[last], here, noise)) {
        const least found = {here, at};
        return found;
    }
    return least_around(other, normal, place, farthest32(other, negative(normal), at));
}

edge_view bmr_convex32_view(const edge_search *search, uint32_t edge, uint32_t vertex_hint) {
    edge_view view;
    view.edge = edge;
    view.normal = turn(&search->frame, search->reference->normals[edge]);
    view.place = move(&search->frame, search->reference->vertices[edge]);
    const least found = least_separated(search->other, view.normal, view.place, vertex_hint);
    view.vertex = found.vertex;
    view.separation = found.separation;
    view.nearest = search->other->vertices[found.vertex];
    view.noise =
        noise_of_size * (search->frame_size + convex32_size(view.place) + convex32_size(view.nearest));
    return view;
}

static inline bool better(const edge_view *a, const edge_view *b) {
    return a->separation > b->separation || (a->separation == b->separation && a->edge < b->edge);
}

/// Directions from one edge's normal, counter-clockwise, to another's.
typedef struct arc {
    edge_view from, to;
    uint32_t inside; ///< edges between
    uint32_t depth;
    float bound;         ///< no direction in it separates more
    bmr_vec32 direction; ///< where it is reached
} arc;

static inline void raise_bound(arc *a, float bounded, bmr_vec32 direction) {
    if (bounded > a->bound) {
        a->bound = bounded;
        a->direction = direction;
    }
}

/// Bounds what is inside; what the two edges themselves separate is known.
static void bound(const edge_search *search, arc *a) {
    const edge_view *const l = &a->from, *const r = &a->to;
    const float turned = cross(l->normal, r->normal);
    if (turned <= 0.0f && dot(l->normal, r->normal) <= 0.0f) {
        // Half a turn or more: no two pairs bound it.
        a->bound = FLT_MAX;
        a->direction.x = -l->normal.y;
        a->direction.y = l->normal.x;
        return;
    }
    const uint32_t second = convex32_next(search->reference, l->edge);
    const bmr_vec32 end =
        second == r->edge ? r->place : move(&search->frame, search->reference->vertices[second]);
    const bmr_vec32 d = minus(l->nearest, end), e = minus(r->nearest, r->place);
    // The pair of the left end bounds up to a direction w, that of the right end from there on. Any w will
    // do; the best is where they give the same. Edges so short that their vertices' rounding turns it get one
    // that is not, so the larger of the two counts.
    const bmr_vec32 change = minus(d, e);
    bmr_vec32 w;
    if (dot(l->normal, change) >= 0.0f) { // that of the right end all the way
        w = l->normal;
        a->bound = dot(w, e);
    } else if (dot(r->normal, change) <= 0.0f) {
        w = r->normal;
        a->bound = dot(w, d);
    } else {
        const float inverse = 1.0f / sqrtf(dot(change, change));
        w.x = change.y * inverse;
        w.y = -change.x * inverse;
        const float at_d = dot(w, d), at_e = dot(w, e);
        a->bound = at_d > at_e ? at_d : at_e;
    }
    a->direction = w;
    // On its own side of w each may also have its maximum where it points.
    if (cross(l->normal, d) > 0.0f && cross(w, d) < 0.0f)
        raise_bound(a, sqrtf(dot(d, d)), d);
    if (cross(w, e) > 0.0f && cross(r->normal, e) < 0.0f)
        raise_bound(a, sqrtf(dot(e, e)), e);
    // Or at the end; not quite there, where the separation is known, but at the first edge inside.
    if (a->inside > 0) {
        const bmr_convex32 *const reference = search->reference;
        const bmr_vec32 first = turn(&search->frame, reference->normals[second]);
        const bmr_vec32 last =
            turn(&search->frame, reference->normals[convex32_previous(reference, r->edge)]);
        if (cross(first, w) >= 0.0f)
            raise_bound(a, dot(first, d), first);
        if (cross(w, last) >= 0.0f)
            raise_bound(a, dot(last, e), last);
    }
    a->bound += l->noise + r->noise;
}

/// Between two neighbouring edges there is none of the reference, but there may be some of the other.
static void bound_rest(const edge_search *search, const edge_view *from, const edge_view *to, float *rest) {
    if (from->vertex == to->vertex || search->tolerance == 0.0f)
        return;
    arc a = {*from, *to, 0, 0, 0.0f, {0.0f, 0.0f}};
    bound(search, &a);
    if (a.bound > *rest)
        *rest = a.bound;
}

typedef struct branches {
    const edge_search *search;
    edge_found *found;
    float floor;
    uint32_t count;
    arc arcs[MOST_ARCS];
} branches;

static bool worth_splitting(const branches *b, float bounded) {
    return bounded >= b->found->best.separation - b->found->best.noise && bounded >= b->floor;
}

static void add_arc(branches *b, const edge_view *from, const edge_view *to, uint32_t depth) {
    const uint32_t count = b->search->reference->count;
    const uint32_t inside = steps32(from->edge, to->edge, count) - 1;
    if (inside == 0) {
        bound_rest(b->search, from, to, &b->found->rest);
        return;
    }
    arc *const a = &b->arcs[b->count];
    a->from = *from;
    a->to = *to;
    a->inside = inside;
    a->depth = depth;
    bound(b->search, a);
    if (!worth_splitting(b, a->bound))
        return;
    ++b->count;
    if (b->count > 1 && b->arcs[b->count - 2].depth == depth &&
        b->arcs[b->count - 2].bound > a->bound) { // the more promising of two first
        const arc swap = *a;
        *a = b->arcs[b->count - 2];
        b->arcs[b->count - 2] = swap;
    }
}

/// An edge inside the arc, near the direction.
static uint32_t inner_edge(const bmr_convex32 *reference, const arc *a, bmr_vec32 direction) {
    const uint32_t count = reference->count, first = convex32_next(reference, a->from.edge);
    uint32_t vertex = 0, along = a->inside / 2 + 1;
    if (a->depth < GUIDED_SPLITS) {
        vertex = farthest32(reference, direction, first);
        along = steps32(first, vertex, count);
        if (along > a->inside)
            along = a->inside / 2 + 1;
    }
    // Of the two edges that meet there the one that points more along it.
    const uint32_t next = (first + along) % count, last = convex32_previous(reference, next);
    if (along == 0 || (along < a->inside &&
                       dot(direction, minus(reference->normals[next], reference->normals[last])) > 0.0f))
        return next;
    return last;
}

static void split(branches *b) {
    const arc a = b->arcs[--b->count];
    if (!worth_splitting(b, a.bound)) // found better since
        return;
    const edge_search *const search = b->search;
    const uint32_t edge = inner_edge(search->reference, &a, turn_back(&search->frame, a.direction));
    const edge_view middle = bmr_convex32_view(search, edge, a.from.vertex);
    if (better(&middle, &b->found->best))
        b->found->best = middle;
    add_arc(b, &a.from, &middle, a.depth + 1);
    add_arc(b, &middle, &a.to, a.depth + 1);
}

/// All edges from `high` on to `low`, which were looked at and may be the same.
static void search_arcs(const edge_search *search, const edge_view *low, const edge_view *high, float floor,
                        edge_found *found) {
    const bmr_convex32 *const reference = search->reference;
    const uint32_t count = reference->count, first = convex32_next(reference, high->edge);
    const uint32_t inside = steps32(first, low->edge, count);
    if (inside == 0) {
        bound_rest(search, high, low, &found->rest);
        return;
    }
    // Cut where the reference is farthest the other way, so that no arc is more than half a turn.
    const uint32_t vertex =
        farthest32(reference, negative(reference->normals[found->best.edge]), (first + inside / 2) % count);
    uint32_t along = steps32(first, vertex, count);
    if (along > inside)
        along = inside / 2;
    edge_view left = *high, right = *low;
    if (along > 0) {
        left = bmr_convex32_view(search, (first + along - 1) % count, high->vertex);
        if (better(&left, &found->best))
            found->best = left;
    }
    if (along < inside) {
        right = bmr_convex32_view(search, (first + along) % count, left.vertex);
        if (better(&right, &found->best))
            found->best = right;
    }
    bound_rest(search, &left, &right, &found->rest);
    branches b;
    b.search = search;
    b.found = found;
    b.floor = floor;
    b.count = 0;
    if (along > 0)
        add_arc(&b, high, &left, 0);
    if (along < inside)
        add_arc(&b, &right, low, 0);
    while (b.count > 0)
        split(&b);
}

/// Two upper bounds that follow from one edge, the other polygon's vertex closest to it, and the end that the
/// edge shares with the next one: of the next edge's separation, and of that along any direction in between.
typedef struct beyond {
    float next, between;
} beyond;

static inline beyond bound_beyond(const edge_view *view, bmr_vec32 shared_end, bmr_vec32 next_normal,
                                  float turned, float outwards) {
    const bmr_vec32 d = minus(view->nearest, shared_end);
    beyond b;
    b.next = dot(next_normal, d) + 2.0f * view->noise;
    // As the direction turns by an angle t the product is cos t times what it began as, the separation, and
    // sin t times what lies across.
    const float across = outwards * cross(view->normal, d), cosine = dot(view->normal, next_normal);
    b.between = view->separation + 2.0f * view->noise;
    if (across > 0.0f || b.between < 0.0f) {
        if (b.between < 0.0f)
            b.between *= cosine;
        if (across > 0.0f)
            b.between += across * turned;
        if (cosine <= 0.0f)
            b.between = convex32_size(d);
    }
    return b;
}

static inline beyond beyond_high(const edge_search *search, const edge_view *high) {
    const uint32_t next = convex32_next(search->reference, high->edge);
    const bmr_vec32 normal = turn(&search->frame, search->reference->normals[next]);
    return bound_beyond(high, move(&search->frame, search->reference->vertices[next]), normal,
                        cross(high->normal, normal), 1.0f);
}

static inline beyond beyond_low(const edge_search *search, const edge_view *low) {
    const uint32_t last = convex32_previous(search->reference, low->edge);
    const bmr_vec32 normal = turn(&search->frame, search->reference->normals[last]);
    return bound_beyond(low, low->place, normal, cross(normal, low->normal), -1.0f);
}

/// Of the directions between two neighbouring edges: `between` is one bound, the pairs at both ends give
/// another.
static inline void raise_rest(const edge_search *search, const edge_view *from, const edge_view *to,
                              float between, edge_found *found) {
    if (between <= found->best.separation + search->tolerance)
        found->rest = between > found->rest ? between : found->rest;
    else
        bound_rest(search, from, to, &found->rest);
}

void bmr_convex32_seek(const edge_search *search, uint32_t edge_hint, uint32_t vertex_hint, float floor,
                       edge_found *found) {
    const bmr_convex32 *const reference = search->reference;
    const uint32_t count = reference->count;
    edge_view *const best = &found->best;
    *best = bmr_convex32_view(search, edge_hint < count ? edge_hint : 0, vertex_hint);
    found->rest = -FLT_MAX;
    edge_view high = *best, low = *best;
    beyond above = beyond_high(search, &high), below = beyond_low(search, &low);
    // Uphill and past ties, on both sides.
    for (uint32_t tried = 0; tried < NEAR_EDGES && steps32(high.edge, low.edge, count) != 1; ++tried) {
        const float close = best->separation - best->noise;
        if (above.next >= close) {
            const edge_view next =
                bmr_convex32_view(search, convex32_next(reference, high.edge), high.vertex);
            raise_rest(search, &high, &next, above.between, found);
            high = next;
            above = beyond_high(search, &high);
            if (better(&high, best))
                *best = high;
        } else if (below.next >= close) {
            const edge_view last =
                bmr_convex32_view(search, convex32_previous(reference, low.edge), low.vertex);
            raise_rest(search, &last, &low, below.between, found);
            low = last;
            below = beyond_low(search, &low);
            if (better(&low, best))
                *best = low;
        } else
            break;
    }
    const float close = best->separation - best->noise;
    if (best->separation > 2.0f * best->noise && above.next < close && below.next < close) {
        const float rest = above.between > below.between ? above.between : below.between;
        if (rest > found->rest)
            found->rest = rest;
        return;
    }
    search_arcs(search, &low, &high, floor, found);
}

float bmr_convex32_max_separation(const bmr_convex32 *reference, const bmr_convex32 *other,
                                  const bmr_transform32 *frame, uint32_t edge_hint, uint32_t *edge,
                                  uint32_t *other_vertex) {
    const edge_search search = edge_search_of(reference, other, *frame, 0.0f);
    edge_found found;
    bmr_convex32_seek(&search, edge_hint, 0, -FLT_MAX, &found);
    *edge = found.best.edge;
    *other_vertex = found.best.vertex;
    return found.best.separation;
}
