// SPDX-License-Identifier: MIT
#include "convex32_loops.h"

#include <math.h>

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

double loop_distance(const bmr_vec32 *v, size_t count, bmr_vec32 q) {
    double least = INFINITY;
    bool inside = true;
    for (size_t i = 0; i < count; ++i) {
        const bmr_vec32 a = v[i], b = v[i + 1 < count ? i + 1 : 0];
        const double x = (double)b.x - (double)a.x, y = (double)b.y - (double)a.y;
        const double px = (double)q.x - (double)a.x, py = (double)q.y - (double)a.y;
        const double t = fmin(fmax((px * x + py * y) / (x * x + y * y), 0.0), 1.0);
        const double dx = px - t * x, dy = py - t * y;
        least = fmin(least, dx * dx + dy * dy);
        inside = inside && x * py - y * px >= 0.0;
    }
    return inside ? 0.0 : sqrt(least);
}
