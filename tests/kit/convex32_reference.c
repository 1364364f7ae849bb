// SPDX-License-Identifier: MIT
#include "convex32_reference.h"

#include <float.h>
#include <math.h>

typedef bmr_vec32 vec;
typedef bmr_transform32 pose32;

static vec vec_of(float x, float y) {
    return (vec){x, y};
}

static float product(vec a, vec b) {
    return a.x * b.x + a.y * b.y;
}

static vec difference(vec a, vec b) {
    return vec_of(a.x - b.x, a.y - b.y);
}

static vec opposite(vec a) {
    return vec_of(-a.x, -a.y);
}

static float area(vec a, vec b) {
    return a.x * b.y - a.y * b.x;
}

static vec rotate(const pose32 *t, vec v) {
    return vec_of(t->c * v.x - t->s * v.y, t->s * v.x + t->c * v.y);
}

static vec unrotate(const pose32 *t, vec v) {
    return vec_of(t->c * v.x + t->s * v.y, -t->s * v.x + t->c * v.y);
}

static vec place(const pose32 *t, vec v) {
    return vec_of((t->c * v.x - t->s * v.y) + t->p.x, (t->s * v.x + t->c * v.y) + t->p.y);
}

static vec unplace(const pose32 *t, vec v) {
    return unrotate(t, difference(v, t->p));
}

/// What is at b, in a's frame.
static pose32 seen_from(const pose32 *a, const pose32 *b) {
    return (pose32){unrotate(a, difference(b->p, a->p)), a->c * b->s - a->s * b->c,
                    a->c * b->c + a->s * b->s};
}

static vec unit(vec v) {
    const float length = sqrtf(v.x * v.x + v.y * v.y);
    if (length < FLT_EPSILON)
        return v;
    const float inverse = 1.0f / length;
    return vec_of(v.x * inverse, v.y * inverse);
}

static uint32_t following(const bmr_convex32 *p, uint32_t i) {
    return i + 1 < p->count ? i + 1 : 0;
}

static float separation_in(const bmr_convex32 *reference, const pose32 *frame, uint32_t edge,
                           const bmr_convex32 *other) {
    const vec n = rotate(frame, reference->normals[edge]), v = place(frame, reference->vertices[edge]);
    float least = FLT_MAX;
    for (uint32_t j = 0; j < other->count; ++j) {
        const float s = product(n, difference(other->vertices[j], v));
        if (s < least)
            least = s;
    }
    return least;
}

float reference_edge_separation(const bmr_convex32 *reference, const pose32 *pose, uint32_t edge,
                                const bmr_convex32 *other, const pose32 *other_pose) {
    const pose32 frame = seen_from(other_pose, pose);
    return separation_in(reference, &frame, edge, other);
}

float reference_max_separation(const bmr_convex32 *reference, const pose32 *pose, const bmr_convex32 *other,
                               const pose32 *other_pose, uint32_t *edge) {
    const pose32 frame = seen_from(other_pose, pose);
    float most = -FLT_MAX;
    *edge = 0;
    for (uint32_t i = 0; i < reference->count; ++i) {
        const float s = separation_in(reference, &frame, i, other);
        if (s > most) {
            most = s;
            *edge = i;
        }
    }
    return most;
}

typedef struct clipped {
    vec v;
    bmr_feature32 id;
} clipped;

static int clip(clipped out[2], const clipped in[2], vec normal, float offset, uint32_t index) {
    int count = 0;
    const float d0 = product(normal, in[0].v) - offset, d1 = product(normal, in[1].v) - offset;
    if (d0 <= 0.0f)
        out[count++] = in[0];
    if (d1 <= 0.0f)
        out[count++] = in[1];
    if (d0 * d1 < 0.0f) {
        const float along = d0 / (d0 - d1);
        const vec way = difference(in[1].v, in[0].v);
        out[count].v = vec_of(in[0].v.x + along * way.x, in[0].v.y + along * way.y);
        out[count].id.index_a = (uint8_t)index;
        out[count].id.index_b = in[0].id.index_b;
        out[count].id.type_a = BMR_FEATURE_VERTEX;
        out[count].id.type_b = BMR_FEATURE_FACE;
        ++count;
    }
    return count;
}

static bmr_feature32 exchanged(bmr_feature32 f) {
    return (bmr_feature32){f.index_b, f.index_a, f.type_b, f.type_a};
}

static clipped vertex_of_incident(vec v, uint32_t vertex, uint32_t edge) {
    return (clipped){v, {(uint8_t)edge, (uint8_t)vertex, BMR_FEATURE_FACE, BMR_FEATURE_VERTEX}};
}

static void clip_to(bmr_manifold32 *manifold, bool flip, uint32_t edge, const bmr_convex32 *a,
                    const pose32 *pose_a, const bmr_convex32 *b, const pose32 *pose_b, float radius_sum) {
    const bmr_convex32 *const one = flip ? b : a, *const two = flip ? a : b;
    const pose32 *const pose_one = flip ? pose_b : pose_a, *const pose_two = flip ? pose_a : pose_b;
    const uint32_t edge_end = following(one, edge);
    manifold->type = flip ? BMR_MANIFOLD_FACE_B : BMR_MANIFOLD_FACE_A;

    const vec facing = unrotate(pose_two, rotate(pose_one, one->normals[edge]));
    uint32_t incident = 0;
    float least = FLT_MAX;
    for (uint32_t i = 0; i < two->count; ++i) {
        const float d = product(facing, two->normals[i]);
        if (d < least) {
            least = d;
            incident = i;
        }
    }
    const uint32_t incident_end = following(two, incident);
    const clipped whole[2] = {
        vertex_of_incident(place(pose_two, two->vertices[incident]), incident, edge),
        vertex_of_incident(place(pose_two, two->vertices[incident_end]), incident_end, edge)};

    const vec v1 = one->vertices[edge], v2 = one->vertices[edge_end];
    const vec local_tangent = unit(difference(v2, v1)), tangent = rotate(pose_one, local_tangent);
    const vec normal = vec_of(tangent.y, -tangent.x);
    const vec w1 = place(pose_one, v1), w2 = place(pose_one, v2);
    clipped half[2], rest[2];
    if (clip(half, whole, opposite(tangent), -product(tangent, w1) + radius_sum, edge) < 2 ||
        clip(rest, half, tangent, product(tangent, w2) + radius_sum, edge_end) < 2)
        return;
    manifold->normal = vec_of(local_tangent.y, -local_tangent.x);
    manifold->plane_point = vec_of(0.5f * (v1.x + v2.x), 0.5f * (v1.y + v2.y));
    for (int i = 0; i < 2; ++i)
        if (product(normal, rest[i].v) - product(normal, w1) <= radius_sum) {
            bmr_manifold_point32 *const point = &manifold->points[manifold->count++];
            point->point = unplace(pose_two, rest[i].v);
            point->feature = flip ? exchanged(rest[i].id) : rest[i].id;
        }
}

void reference_collide(bmr_manifold32 *manifold, const bmr_convex32 *a, const pose32 *pose_a,
                       const bmr_convex32 *b, const pose32 *pose_b, float radius_sum, float tolerance) {
    manifold->count = 0;
    uint32_t edge_a, edge_b;
    const float of_a = reference_max_separation(a, pose_a, b, pose_b, &edge_a);
    if (of_a > radius_sum)
        return;
    const float of_b = reference_max_separation(b, pose_b, a, pose_a, &edge_b);
    if (of_b > radius_sum)
        return;
    const bool flip = of_b > of_a + tolerance;
    clip_to(manifold, flip, flip ? edge_b : edge_a, a, pose_a, b, pose_b, radius_sum);
    if (manifold->count == 0 && !flip && (a->count > 8 || b->count > 8))
        clip_to(manifold, true, edge_b, a, pose_a, b, pose_b, radius_sum);
}

void reference_collide_circle(bmr_manifold32 *manifold, const bmr_convex32 *polygon,
                              const pose32 *pose_polygon, vec centre, const pose32 *pose_circle,
                              float radius_sum) {
    manifold->count = 0;
    const vec c = unplace(pose_polygon, place(pose_circle, centre));
    uint32_t edge = 0;
    float most = -FLT_MAX;
    for (uint32_t i = 0; i < polygon->count; ++i) {
        const float s = product(polygon->normals[i], difference(c, polygon->vertices[i]));
        if (s > radius_sum)
            return;
        if (s > most) {
            most = s;
            edge = i;
        }
    }
    const vec v1 = polygon->vertices[edge], v2 = polygon->vertices[following(polygon, edge)];
    const vec middle = vec_of(0.5f * (v1.x + v2.x), 0.5f * (v1.y + v2.y));
    vec normal = polygon->normals[edge], point = middle;
    if (!(most < FLT_EPSILON)) {
        const float u1 = product(difference(c, v1), difference(v2, v1));
        const float u2 = product(difference(c, v2), difference(v1, v2));
        if (u1 <= 0.0f || u2 <= 0.0f) {
            point = u1 <= 0.0f ? v1 : v2;
            const vec d = difference(c, point);
            if (product(d, d) > radius_sum * radius_sum)
                return;
            normal = unit(d);
        } else if (product(difference(c, middle), normal) > radius_sum) {
            return;
        }
    }
    const bmr_feature32 none = {0, 0, 0, 0};
    manifold->count = 1;
    manifold->type = BMR_MANIFOLD_FACE_A;
    manifold->normal = normal;
    manifold->plane_point = point;
    manifold->points[0].point = centre;
    manifold->points[0].feature = none;
}

typedef struct separating {
    vec normal;
    bool of_polygon;
    uint32_t index;
    float separation;
} separating;

static separating best_of_edge(const bmr_convex32 *polygon, const pose32 *frame, vec v1, vec normal) {
    separating best = {vec_of(0.0f, 0.0f), false, 0, -FLT_MAX};
    const vec axes[2] = {normal, opposite(normal)};
    for (int j = 0; j < 2; ++j) {
        float least = FLT_MAX;
        for (uint32_t i = 0; i < polygon->count; ++i) {
            const float s = product(axes[j], difference(place(frame, polygon->vertices[i]), v1));
            if (s < least)
                least = s;
        }
        if (least > best.separation) {
            best.separation = least;
            best.normal = axes[j];
        }
    }
    return best;
}

static separating best_of_polygon(const bmr_convex32 *polygon, const pose32 *frame, vec v1, vec v2) {
    separating best = {vec_of(0.0f, 0.0f), true, 0, -FLT_MAX};
    for (uint32_t i = 0; i < polygon->count; ++i) {
        const vec n = opposite(rotate(frame, polygon->normals[i])), v = place(frame, polygon->vertices[i]);
        const float s1 = product(n, difference(v, v1)), s2 = product(n, difference(v, v2));
        const float s = s1 < s2 ? s1 : s2;
        if (s > best.separation) {
            best.index = i;
            best.separation = s;
            best.normal = n;
        }
    }
    return best;
}

/// Past 8 vertices the larger turn at the ends of the polygon's face, at most Box2D's 0.1.
static float region(const separating *primary, const bmr_convex32 *polygon) {
    if (polygon->count <= 8 || !primary->of_polygon)
        return 0.1f;
    const uint32_t i = primary->index;
    const vec n0 = polygon->normals[(i + polygon->count - 1) % polygon->count], n1 = polygon->normals[i],
              n2 = polygon->normals[following(polygon, i)];
    const float turn0 = area(n0, n1) + 4.0f * FLT_EPSILON, turn2 = area(n1, n2) + 4.0f * FLT_EPSILON;
    const float turn = turn0 > turn2 ? turn0 : turn2;
    return turn > 0.1f || product(n0, n1) <= 0.0f || product(n1, n2) <= 0.0f ? 0.1f : turn;
}

/// False where the one-sided edge's neighbour has the say.
static bool smooth(separating *primary, const separating *of_edge, const bmr_edge32 *edge, vec along,
                   const bmr_convex32 *polygon) {
    const float tolerance = region(primary, polygon);
    const vec edge0 = unit(difference(edge->first, edge->before)), normal0 = vec_of(edge0.y, -edge0.x);
    const vec edge2 = unit(difference(edge->after, edge->second)), normal2 = vec_of(edge2.y, -edge2.x);
    const vec normal1 = vec_of(along.y, -along.x);
    if (product(primary->normal, along) <= 0.0f) {
        if (area(edge0, along) >= 0.0f) {
            const bool flat = area(normal0, normal1) <= 0.1f && product(normal1, normal0) > 0.0f;
            if (!(area(primary->normal, normal0) > tolerance))
                return true;
            if (polygon->count <= 8 || !primary->of_polygon || !flat)
                return false;
        }
    } else {
        if (area(along, edge2) >= 0.0f) {
            const bool flat = area(normal1, normal2) <= 0.1f && product(normal1, normal2) > 0.0f;
            if (!(area(normal2, primary->normal) > tolerance))
                return true;
            if (polygon->count <= 8 || !primary->of_polygon || !flat)
                return false;
        }
    }
    *primary = *of_edge;
    return true;
}

static void clip_edge(bmr_manifold32 *manifold, const separating *primary, const bmr_edge32 *edge,
                      const bmr_convex32 *polygon, const pose32 *frame, float radius_sum, float wider) {
    const vec v1 = edge->first, v2 = edge->second, along = unit(difference(v2, v1));
    clipped whole[2], half[2], rest[2];
    uint32_t i1 = 0, i2 = 1;
    vec r1 = v1, r2 = v2, face = primary->normal, side1 = opposite(along), side2 = along;
    float extra = 0.0f;
    if (!primary->of_polygon) {
        manifold->type = BMR_MANIFOLD_FACE_A;
        uint32_t incident = 0;
        float least = product(face, rotate(frame, polygon->normals[0]));
        for (uint32_t i = 1; i < polygon->count; ++i) {
            const float d = product(face, rotate(frame, polygon->normals[i]));
            if (d < least) {
                least = d;
                incident = i;
            }
        }
        const uint32_t end = following(polygon, incident);
        whole[0] = vertex_of_incident(place(frame, polygon->vertices[incident]), incident, 0);
        whole[1] = vertex_of_incident(place(frame, polygon->vertices[end]), end, 0);
    } else {
        manifold->type = BMR_MANIFOLD_FACE_B;
        i1 = primary->index;
        i2 = following(polygon, i1);
        whole[0] = (clipped){v2, {1, (uint8_t)i1, BMR_FEATURE_VERTEX, BMR_FEATURE_FACE}};
        whole[1] = (clipped){v1, {0, (uint8_t)i1, BMR_FEATURE_VERTEX, BMR_FEATURE_FACE}};
        r1 = place(frame, polygon->vertices[i1]);
        r2 = place(frame, polygon->vertices[i2]);
        face = rotate(frame, polygon->normals[i1]);
        side1 = vec_of(face.y, -face.x);
        side2 = opposite(side1);
        extra = wider;
    }
    if (clip(half, whole, side1, product(side1, r1) + extra, i1) < 2 ||
        clip(rest, half, side2, product(side2, r2) + extra, i2) < 2)
        return;
    manifold->normal = primary->of_polygon ? polygon->normals[i1] : face;
    manifold->plane_point = primary->of_polygon ? polygon->vertices[i1] : v1;
    bool wanted[2];
    float beside[2];
    for (int i = 0; i < 2; ++i) {
        const float left = product(side1, difference(rest[i].v, r1)),
                    right = product(side2, difference(rest[i].v, r2));
        wanted[i] = product(face, difference(rest[i].v, r1)) <= radius_sum;
        beside[i] = left > right ? left : right;
    }
    if (extra > 0.0f && wanted[0] && wanted[1]) // beside the face: the nearer one
        wanted[beside[1] < beside[0] ? 0 : 1] = false;
    for (int i = 0; i < 2; ++i)
        if (wanted[i]) {
            bmr_manifold_point32 *const point = &manifold->points[manifold->count++];
            point->point = primary->of_polygon ? rest[i].v : unplace(frame, rest[i].v);
            point->feature = primary->of_polygon ? exchanged(rest[i].id) : rest[i].id;
        }
}

/// Past 8 vertices also beside the polygon's face, where nothing is above it.
static void clip_polygon(bmr_manifold32 *manifold, const separating *primary, const bmr_edge32 *edge,
                         const bmr_convex32 *polygon, const pose32 *frame, float radius_sum) {
    clip_edge(manifold, primary, edge, polygon, frame, radius_sum, 0.0f);
    if (manifold->count == 0 && primary->of_polygon && polygon->count > 8)
        clip_edge(manifold, primary, edge, polygon, frame, radius_sum, radius_sum);
}

void reference_collide_edge(bmr_manifold32 *manifold, const bmr_edge32 *edge, const pose32 *pose_edge,
                            const bmr_convex32 *polygon, vec centroid, const pose32 *pose_polygon,
                            float radius_sum) {
    manifold->count = 0;
    const pose32 frame = seen_from(pose_edge, pose_polygon);
    const vec v1 = edge->first, v2 = edge->second;
    const vec along = unit(difference(v2, v1)), normal = vec_of(along.y, -along.x);
    if (edge->one_sided && product(normal, difference(place(&frame, centroid), v1)) < 0.0f)
        return;
    const separating of_edge = best_of_edge(polygon, &frame, v1, normal);
    if (of_edge.separation > radius_sum)
        return;
    const separating of_polygon = best_of_polygon(polygon, &frame, v1, v2);
    if (of_polygon.separation > radius_sum)
        return;
    separating primary = of_edge;
    if (of_polygon.separation - radius_sum > 0.98f * (of_edge.separation - radius_sum) + 0.001f)
        primary = of_polygon;
    if (edge->one_sided && !smooth(&primary, &of_edge, edge, along, polygon))
        return;
    clip_polygon(manifold, &primary, edge, polygon, &frame, radius_sum);
    if (manifold->count == 0 && !primary.of_polygon && polygon->count > 8) {
        primary = of_polygon;
        if ((!edge->one_sided || smooth(&primary, &of_edge, edge, along, polygon)) && primary.of_polygon)
            clip_polygon(manifold, &primary, edge, polygon, &frame, radius_sum);
    }
}

static bool same_vec(bmr_vec32 a, bmr_vec32 b) {
    return a.x == b.x && a.y == b.y; // never NaN: poses and polygons are finite
}

bool reference_same_manifold(const bmr_manifold32 *a, const bmr_manifold32 *b) {
    if (a->count != b->count || a->type != b->type || !same_vec(a->normal, b->normal) ||
        !same_vec(a->plane_point, b->plane_point))
        return false;
    for (int i = 0; i < a->count; ++i) {
        const bmr_feature32 f = a->points[i].feature, g = b->points[i].feature;
        if (!same_vec(a->points[i].point, b->points[i].point) || f.index_a != g.index_a ||
            f.index_b != g.index_b || f.type_a != g.type_a || f.type_b != g.type_b)
            return false;
    }
    return true;
}

// --- questions about one polygon ---

float loop_support(const bmr_convex32 *p, bmr_vec32 d) {
    float most = -INFINITY;
    for (uint32_t i = 0; i < p->count; ++i)
        most = fmaxf(most, p->vertices[i].x * d.x + p->vertices[i].y * d.y);
    return most;
}

bool loop_contains(const bmr_convex32 *p, bmr_vec32 q) {
    for (uint32_t i = 0; i < p->count; ++i) {
        const bmr_vec32 n = p->normals[i], v = p->vertices[i];
        const float x = q.x - v.x, y = q.y - v.y;
        if (n.x * x + n.y * y > 0.0f)
            return false;
    }
    return true;
}

bool loop_ray(const bmr_convex32 *p, bmr_vec32 p1, bmr_vec32 p2, float max_fraction, uint32_t skip,
              float *fraction, uint32_t *edge) {
    const float dx = p2.x - p1.x, dy = p2.y - p1.y;
    float lower = 0.0f, upper = max_fraction;
    *edge = UINT32_MAX;
    for (uint32_t i = 0; i < p->count; ++i) {
        const bmr_vec32 n = p->normals[i], v = p->vertices[i];
        const float x = v.x - p1.x, y = v.y - p1.y;
        const float distance = n.x * x + n.y * y, speed = n.x * dx + n.y * dy;
        if (i == skip)
            continue;
        if (speed == 0.0f && distance < 0.0f)
            return false;
        if (speed < 0.0f && distance < lower * speed) {
            lower = distance / speed;
            *edge = i;
        } else if (speed > 0.0f && distance < upper * speed)
            upper = distance / speed;
        if (upper < lower)
            return false;
    }
    *fraction = lower;
    return *edge != UINT32_MAX;
}

void loop_box(const bmr_convex32 *p, const bmr_transform32 *pose, bmr_vec32 *lower, bmr_vec32 *upper) {
    const bmr_vec32 low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    *lower = low;
    *upper = high;
    for (uint32_t i = 0; i < p->count; ++i) {
        const bmr_vec32 v = p->vertices[i];
        const float x = (pose->c * v.x - pose->s * v.y) + pose->p.x;
        const float y = (pose->s * v.x + pose->c * v.y) + pose->p.y;
        lower->x = fminf(lower->x, x);
        lower->y = fminf(lower->y, y);
        upper->x = fmaxf(upper->x, x);
        upper->y = fmaxf(upper->y, y);
    }
}

/// (b - a) x (c - a) of the products of coordinates, which are exact: their sum is made firm by passing on,
/// again and again, what its additions lose.
static long double exact_cross(bmr_vec32 a, bmr_vec32 b, bmr_vec32 c) {
    const long double x[3] = {(long double)a.x, (long double)b.x, (long double)c.x};
    const long double y[3] = {(long double)a.y, (long double)b.y, (long double)c.y};
    long double terms[6];
    for (int i = 0; i < 3; ++i) {
        terms[2 * i] = x[i] * y[(i + 1) % 3];
        terms[2 * i + 1] = -y[i] * x[(i + 1) % 3];
    }
    for (int pass = 0; pass < 6; ++pass)
        for (int i = 1; i < 6; ++i) {
            const long double sum = terms[i - 1] + terms[i], part = sum - terms[i];
            terms[i - 1] = (terms[i - 1] - part) + (terms[i] - (sum - part));
            terms[i] = sum;
        }
    long double sum = 0;
    for (int i = 0; i < 6; ++i)
        sum += terms[i];
    return sum;
}

loop_mass loop_measure(const bmr_convex32 *p) {
    loop_mass m = {0, 0, 0, 0};
    const bmr_vec32 apex = p->vertices[p->count / 3];
    const long double x0 = (long double)apex.x, y0 = (long double)apex.y;
    for (uint32_t i = 0; i < p->count; ++i) {
        const bmr_vec32 v = p->vertices[i], w = p->vertices[i + 1 < p->count ? i + 1 : 0];
        const long double ax = (long double)v.x - x0, ay = (long double)v.y - y0;
        const long double bx = (long double)w.x - x0, by = (long double)w.y - y0;
        const long double cross = exact_cross(apex, v, w);
        m.area += cross / 2;
        m.x += cross * (ax + bx) / 6;
        m.y += cross * (ay + by) / 6;
        // About the apex, of a triangle by its edges' midpoints: exact for squares.
        const long double middle[3][2] = {{ax / 2, ay / 2}, {bx / 2, by / 2}, {(ax + bx) / 2, (ay + by) / 2}};
        for (int e = 0; e < 3; ++e)
            m.inertia += cross / 6 * (middle[e][0] * middle[e][0] + middle[e][1] * middle[e][1]);
    }
    m.x /= m.area;
    m.y /= m.area;
    m.inertia -= m.area * (m.x * m.x + m.y * m.y);
    m.x += x0;
    m.y += y0;
    return m;
}
