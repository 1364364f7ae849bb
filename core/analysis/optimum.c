// SPDX-License-Identifier: MIT
// The fewest fixed lines that cover a motion: running intersections of the cones of separating directions.
#include <math.h>
#include <string.h>

#include "analysis/course.h"
#include "kds/structure.h"

#define PI 3.14159265358979323846
/// Halvings of a stretch: double's precision is spent.
#define MAX_DEPTH 44
/// The search splits a stretch in which the bodies may move by more than this part of (size + distance). It
/// compares the stretch's ends and middle, and a whole turn between these would look like no turn at all.
#define LONGEST_PART 0.25
/// Near contact the cone's width goes to zero; ends are not told apart more finely than this times the
/// resolution (radians).
#define LEAST_WIDTH 1e-4
/// What a cone may lose, as a multiple of resolution * least distance / size: a line that passes at the least
/// distance and is seen from some sizes afar can turn by about that angle.
#define LOSS_PART 0.25
/// For that, the least distance is measured to this part of the size, and taken for no less.
#define LEAST_DISTANCE 1e-4

/// The cone of separating directions at a time: [low, high] in angles of A's frame.
typedef struct cone {
    double time, low, high, turn; ///< turn: of B against A
    double loss;                  ///< what its ends may move on by until the next sample
    double distance;
    bool apart;
} cone;

/// Directions that every cone of the certificate so far has, in one body's frame.
typedef struct running {
    bool alive;
    double low, high;
} running;

typedef struct cover {
    bool joined; ///< holds between samples too: cones lose something, new certificates begin a sample early
    running frames[2];
    bool open;
    cone before; ///< the last sample of the open certificate
    double from;
    uint64_t count;
    bmr_cover_line *lines;
    size_t capacity;
} cover;

typedef struct sweep {
    const bmr_course *course;
    bmr_kds *pair; ///< no structure, only the two shapes and the margin
    double resolution, size, most_loss;
    uint32_t support[2];
    uint64_t samples, contacts;
    bool in_contact;
    cover least, found;
} sweep;

static cone cone_at(sweep *s, double time) {
    const bmr_pose pose = bmr_course_pose(s->course, time);
    cone c = {.time = time, .turn = atan2(pose.s, pose.c)};
    bmr_vec2 inside;
    s->samples++;
    c.apart = bmr_kds_closest(s->pair, &pose, &s->support[0], &s->support[1], &inside, &c.distance);
    if (c.apart) {
        const bmr_vec2 low = bmr_kds_cone_end(s->pair, &pose, inside, s->pair->def.margin, -1, s->support),
                       high = bmr_kds_cone_end(s->pair, &pose, inside, s->pair->def.margin, 1, s->support);
        const double middle = atan2(inside.y, inside.x);
        c.low = middle - atan2(bmr_cross(low, inside), bmr_dot(low, inside));
        c.high = middle + atan2(bmr_cross(inside, high), bmr_dot(inside, high));
    }
    return c;
}

/// Narrows the running intersection by a cone. Both are shorter than a half turn, so that what they share is
/// one stretch: that of the copies of the cone that begins within a half turn of the other's beginning.
static void intersect(running *r, const cone *c, int frame, double loss) {
    const double off = frame == 0 ? 0.0 : c->turn;
    const double low = c->low + loss - off, width = c->high - c->low - 2.0 * loss;
    if (!r->alive)
        return;
    const double start = r->low + remainder(low - r->low, 2.0 * PI);
    const double new_low = fmax(r->low, start), new_high = fmin(r->high, start + width);
    r->alive = new_low <= new_high;
    if (r->alive) {
        r->low = new_low;
        r->high = new_high;
    }
}

static void open_certificate(cover *v, const cone *c) {
    v->open = true;
    v->count++;
    v->from = c->time;
    const double loss = v->joined ? fmin(c->loss, 0.5 * (c->high - c->low)) : 0.0;
    for (int frame = 0; frame < 2; frame++) {
        const double off = frame == 0 ? 0.0 : c->turn;
        v->frames[frame] = (running){true, c->low + loss - off, c->high - loss - off};
    }
}

/// Writes the open certificate down: the frames as they were at its last sample.
static void close_certificate(cover *v, const running frames[2], double to) {
    if (v->open && v->count <= v->capacity) {
        const int owner = frames[0].alive ? 0 : 1;
        const double middle = 0.5 * (frames[owner].low + frames[owner].high) + (owner == 0 ? 0.0 : PI);
        v->lines[v->count - 1] =
            (bmr_cover_line){v->from, to, owner, bmr_vec2_make(cos(middle), sin(middle))};
    }
    v->open = false;
}

static void add_to_cover(cover *v, const cone *c) {
    const running last[2] = {v->frames[0], v->frames[1]};
    if (!c->apart) {
        close_certificate(v, last, v->before.time);
        return;
    }
    for (int frame = 0; frame < 2 && v->open; frame++)
        intersect(&v->frames[frame], c, frame, v->joined ? c->loss : 0.0);
    if (!v->open) {
        open_certificate(v, c);
    } else if (!v->frames[0].alive && !v->frames[1].alive) {
        close_certificate(v, last, v->before.time);
        open_certificate(v, v->joined ? &v->before : c);
        const running begun[2] = {v->frames[0], v->frames[1]};
        for (int frame = 0; frame < 2; frame++)
            intersect(&v->frames[frame], c, frame, v->joined ? c->loss : 0.0);
        if (!v->frames[0].alive && !v->frames[1].alive) { // a leap past any resolution
            close_certificate(v, begun, v->before.time);
            open_certificate(v, c);
        }
    }
    v->before = *c;
}

static void add(sweep *s, const cone *c) {
    s->contacts += !c->apart && !s->in_contact ? 1 : 0;
    s->in_contact = !c->apart;
    add_to_cover(&s->least, c);
    add_to_cover(&s->found, c);
}

static double apart_by(double p, double q) {
    return fabs(remainder(p - q, 2.0 * PI));
}

/// Do the ends, in both frames, move by no more than the resolution from p to q?
static bool alike(const sweep *s, const cone *p, const cone *q) {
    if (!p->apart || !q->apart)
        return p->apart == q->apart;
    const double width = fmin(p->high - p->low, q->high - q->low);
    const double most = s->resolution * fmax(width, LEAST_WIDTH);
    return apart_by(p->low, q->low) <= most && apart_by(p->high, q->high) <= most &&
           apart_by(p->low - p->turn, q->low - q->turn) <= most &&
           apart_by(p->high - p->turn, q->high - q->turn) <= most;
}

static double bend(double p, double m, double q) {
    return 0.5 * fabs(remainder(m - p, 2.0 * PI) - remainder(q - m, 2.0 * PI));
}

/// How far an end may go beyond where it is at three equally spaced samples: a parabola through them does by
/// a quarter of this at most, and a kink by half.
static double most_bend(const cone *p, const cone *m, const cone *q) {
    const double of_a = fmax(bend(p->low, m->low, q->low), bend(p->high, m->high, q->high));
    const double of_b = fmax(bend(p->low - p->turn, m->low - m->turn, q->low - q->turn),
                             bend(p->high - p->turn, m->high - m->turn, q->high - q->turn));
    return fmax(of_a, of_b);
}

/// Adds what lies between two samples, and the second one.
static void refine(sweep *s, const cone *p, const cone *q, int depth) {
    const double middle = 0.5 * (p->time + q->time);
    if (depth == 0 || !(middle > p->time && middle < q->time)) {
        add(s, q);
        return;
    }
    cone m = cone_at(s, middle);
    const double reach = bmr_course_speed(s->course, p->time, q->time, s->size) * (q->time - p->time);
    const double loss = m.apart && p->apart && q->apart ? most_bend(p, &m, q) : 0.0;
    if (alike(s, p, q) && alike(s, p, &m) && alike(s, &m, q) && loss <= s->most_loss &&
        reach <= LONGEST_PART * (s->size + p->distance)) {
        cone last = *q;
        m.loss = last.loss = loss;
        add(s, &m);
        add(s, &last);
        return;
    }
    refine(s, p, &m, depth - 1);
    refine(s, &m, q, depth - 1);
}

/// At a piece's end the motion may jump: each piece is swept to just before it.
static void sweep_pieces(sweep *s) {
    const double to = s->course->to;
    cone p = cone_at(s, s->course->from);
    add(s, &p);
    for (double at = s->course->from; at < to;) {
        const double piece_end = bmr_course_piece_end(s->course, at);
        const cone q = cone_at(s, piece_end < to ? nextafter(piece_end, at) : to);
        if (q.time > p.time)
            refine(s, &p, &q, MAX_DEPTH);
        if (piece_end < to) {
            p = cone_at(s, piece_end);
            add(s, &p);
        }
        at = piece_end;
    }
}

bmr_error bmr_offline_optimum(const bmr_course *course, double margin, double resolution,
                              bmr_cover_line *lines, size_t capacity, bmr_optimum *optimum) {
    if (!course || !optimum || !course->polygons[0] || !course->polygons[1] || !course->motions[0] ||
        !course->motions[1] || (capacity > 0 && !lines))
        return BMR_ERROR_NULL_ARGUMENT;
    if (!bmr_course_is_valid(course) || !(margin > 0.0) || !(resolution > 0.0) || !(resolution <= 0.25))
        return BMR_ERROR_OUT_OF_RANGE;
    bmr_kds pair;
    memset(&pair, 0, sizeof pair);
    pair.def = bmr_default_kds_def();
    pair.def.margin = margin;
    pair.shapes[0].polygon = course->polygons[0];
    pair.shapes[1].polygon = course->polygons[1];
    sweep s = {.course = course, .pair = &pair, .resolution = resolution};
    s.size = course->polygons[0]->radius + course->polygons[1]->radius;
    if (!(s.size > 0.0)) // two points: any length will do
        s.size = 1.0;
    double least, time;
    const bmr_error error =
        bmr_least_distance(course->polygons[0], course->polygons[1], course->motions[0], course->motions[1],
                           course->from, course->to, LEAST_DISTANCE * s.size, &least, &time);
    if (error != BMR_OK)
        return error;
    s.most_loss = LOSS_PART * resolution * fmax(least / s.size, LEAST_DISTANCE);
    s.found.joined = true;
    s.found.lines = lines;
    s.found.capacity = capacity;
    sweep_pieces(&s);
    const running last[2] = {s.found.frames[0], s.found.frames[1]};
    close_certificate(&s.found, last, s.found.before.time);
    *optimum = (bmr_optimum){s.least.count, s.found.count, s.samples, s.contacts};
    return BMR_OK;
}
