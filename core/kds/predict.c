// SPDX-License-Identifier: MIT
// A free direction chosen by how long it is going to last: the structure whose lines come nearest to the
// offline optimum's in number. Its events do not: where bodies turn, each vertex that becomes the nearest is
// one, however far apart they are. At an event, directions across the cone of all that separate are tried in
// both bodies, and the line is taken that survives longest if the motion goes on as it seems to. The other
// body stands by its own vertices, and only failures of the line count: the window rolls along without
// touching it.
//
// It measures how well it foresaw the last events, and doubts what it sees: doubt is a distance that grows
// with the path. In full doubt the best line is the one of most slack. It finds out which of the bodies
// turns, and leans into a drift over several events.
//
// For a Brownian walk across the arc of directions that a line tolerates, nothing online gets below twice the
// optimum on average: the middle of an arc is left after A^2 steps on average, and a range as wide as the arc
// (2 A) is filled after 2 A^2.
#include <float.h>
#include <math.h>

#include "geometry/distance.h"
#include "geometry/length.h"
#include "kds/registry.h"
#include "kds/windowed_line.h"

/// Lines are tried in directions that separate by at least this part of the distance.
#define LEAST_PART 0.1
/// The direction at a right angle to the present velocity, along which nothing changes, needs to separate
/// only by this part.
#define NORMAL_LEAST_PART 1e-3
/// How many directions across the cone are tried: 2^k + 1, so that both ends and the middle are among them.
#define ACROSS 9
#define MOST_CANDIDATES (ACROSS + 2)

/// The motion is foreseen at TIMES times that grow geometrically. At the first, the bodies have moved by
/// FIRST_PART of the gap; at the last, by HORIZON times their size and distance.
#define HORIZON 3.0
#define FIRST_PART 1.0
#define TIMES 16

/// A model's error is how far the other body was from where the model saw it, as a part of the path. Below
/// DOUBT_NONE the model is believed, above DOUBT_ALL it is not believed at all.
#define DOUBT_NONE 0.3
#define DOUBT_ALL 0.6
/// The errors that are supposed at the start, when nothing has been learnt: of the model that is preferred,
/// and of the other one.
#define DOUBT_START 0.25
#define DOUBT_OTHER 0.3
/// The part of the old doubt that remains after an event.
#define DOUBT_DECAY 0.5
/// The largest error that counts: a body that went the opposite way is off by twice the path.
#define DOUBT_MOST 2.0

/// From the doubt LEAN_DOUBT on, the line leans by LEAN_PART (lean_direction). Under translation only:
/// where the bodies turn, the choice of the owner matters more.
#define LEAN_PART 0.4
#define LEAN_DOUBT 0.5
/// This many failures on the same side make it take a line that is turned to that side.
#define LEAN_AFTER 2
/// It may turn towards the end of the cone until it separates by only this part of the distance.
#define LEAN_LEAST_PART 0.25

/// How the pair moves on. Only the relative motion is given, so that it is not known which body turns.
typedef enum predict_model {
    MODEL_B_STRAIGHT, ///< seen from A, B's origin goes straight while B turns
    MODEL_A_STRAIGHT, ///< seen from B, A's origin goes straight while A turns
    MODEL_COUNT
} predict_model;

/// On which side of their lines the last failures were.
typedef struct lean_sides {
    int8_t side; ///< of the last one: the way the closest direction had turned from the line's
    uint8_t row; ///< failures on that side, one after the other
} lean_sides;

typedef struct predict_state {
    bmr_windowed_line now;
    bmr_instant last;          ///< of the last choice
    double wrong[MODEL_COUNT]; ///< mean error of each model, as part of the path
    lean_sides lean;
} predict_state;

/// The motion as foreseen, at times from now on.
typedef struct forecast {
    int count;          ///< of times
    bool turns;         ///< the bodies rotate against each other
    double time[TIMES]; ///< the first is 0
    double loss[TIMES]; ///< what is doubted of a gap by then
    bmr_pose pose[TIMES];
    bmr_pose turn[TIMES]; ///< rotation of a direction fixed in B
} forecast;

typedef struct candidate {
    bmr_vec2 direction; ///< A's frame
    int owner;
    double life, last_gap; ///< how long it lasts; the gap at the end of that
} candidate;

static predict_state *state_of(bmr_kds *kds) {
    return (predict_state *)(void *)kds->state;
}

/// The instant as seen from the body that a model takes to be at rest: the other's frame in that body's.
static bmr_instant seen(const bmr_instant *now, predict_model model) {
    if (model == MODEL_B_STRAIGHT)
        return *now;
    const bmr_vec2 turning = bmr_scale(now->spin, bmr_left(now->pose.position));
    const bmr_instant other = {bmr_pose_inverse(&now->pose),
                               bmr_neg(bmr_unrotate(&now->pose, bmr_sub(now->velocity, turning))),
                               -now->spin};
    return other;
}

/// How far the points of the body that moves are from its frame's origin.
static double arm_of(const bmr_kds *kds, predict_model model) {
    const bmr_polygon *p = kds->shapes[model == MODEL_B_STRAIGHT ? 1 : 0].polygon;
    return p->radius + bmr_length(p->center);
}

static bmr_pose straight_on(const bmr_instant *from, double time) {
    const double angle = from->spin * time;
    const bmr_pose turn = {{0.0, 0.0}, cos(angle), sin(angle)};
    const bmr_vec2 x_axis = bmr_rotate(&turn, bmr_vec2_make(from->pose.c, from->pose.s));
    const bmr_pose pose = {bmr_add(from->pose.position, bmr_scale(time, from->velocity)), x_axis.x, x_axis.y};
    return pose;
}

/// Takes note of how far each model was off since the last choice.
static void learn(predict_state *s, const bmr_kds *kds, const bmr_instant *now) {
    for (int model = 0; model < MODEL_COUNT; ++model) {
        const bmr_instant old = seen(&s->last, (predict_model)model), here = seen(now, (predict_model)model);
        const double arm = arm_of(kds, (predict_model)model);
        const double speed = bmr_length(old.velocity) + arm * fabs(old.spin);
        const double way = bmr_length(bmr_sub(here.pose.position, old.pose.position)) +
                           arm * fabs(bmr_pose_turn(&old.pose, &here.pose));
        if (!(way > 0.0) || !(speed > 0.0))
            continue;
        // The time since then is not known: the model is asked for the pose after a path of the same length.
        const bmr_pose q = straight_on(&old, way / speed);
        const double off =
            bmr_length(bmr_sub(q.position, here.pose.position)) + arm * fabs(bmr_pose_turn(&q, &here.pose));
        s->wrong[model] = DOUBT_DECAY * s->wrong[model] + (1.0 - DOUBT_DECAY) * fmin(off / way, DOUBT_MOST);
    }
}

/// Starts anew, with nothing learnt. Of the two models the one in which the other body moves more slowly is
/// preferred: seen from a body that turns, the other one sweeps around it, and it would be a coincidence if
/// it really did.
static void forget(predict_state *s, const bmr_instant *now) {
    const bmr_instant other = seen(now, MODEL_A_STRAIGHT);
    const bool a_moves = bmr_length(other.velocity) < bmr_length(now->velocity);
    s->wrong[MODEL_B_STRAIGHT] = a_moves ? DOUBT_OTHER : DOUBT_START;
    s->wrong[MODEL_A_STRAIGHT] = a_moves ? DOUBT_START : DOUBT_OTHER;
    s->lean = (lean_sides){0, 0};
}

static double doubt_of(double wrong) {
    return fmin(1.0, fmax(0.0, (wrong - DOUBT_NONE) / (DOUBT_ALL - DOUBT_NONE)));
}

static void foresee(forecast *f, const bmr_kds *kds, const bmr_instant *now, predict_model model,
                    double doubt, double distance) {
    const bmr_instant from = seen(now, model);
    const double speed = bmr_length(from.velocity) + arm_of(kds, model) * fabs(from.spin);
    const double size = kds->shapes[0].polygon->radius + kds->shapes[1].polygon->radius;
    f->turns = now->spin != 0.0;
    f->count = 1;
    f->time[0] = f->loss[0] = 0.0;
    f->pose[0] = now->pose;
    f->turn[0] = bmr_pose_identity();
    if (!(speed > 0.0))
        return;
    // Without rotation the gap is linear in time: two times tell it all.
    f->count = f->turns ? TIMES : 2;
    const double last = HORIZON * (size + distance) / speed;
    const double first = f->turns ? FIRST_PART * (distance - kds->def.margin) / speed : last;
    const double factor = pow(last / first, 1.0 / (TIMES - 2));
    double time = first;
    for (int i = 1; i < f->count; ++i, time *= factor) {
        const bmr_pose pose = straight_on(&from, time);
        f->time[i] = time;
        f->loss[i] = doubt * speed * time;
        f->pose[i] = model == MODEL_B_STRAIGHT ? pose : bmr_pose_inverse(&pose);
        // From the rotation of B now to that of then.
        f->turn[i] = bmr_pose_relative(&now->pose, &f->pose[i]);
    }
}

/// What is left of a candidate's gap at one of the times.
static double gap_at(const bmr_kds *kds, const forecast *f, const candidate *c, int i, uint32_t support[2]) {
    const bmr_polygon *a = kds->shapes[0].polygon, *b = kds->shapes[1].polygon;
    const bmr_vec2 d = c->owner == 0 ? c->direction : bmr_rotate(&f->turn[i], c->direction);
    unsigned steps = 0;
    support[0] = bmr_support_near(a, d, support[0], &steps);
    support[1] = bmr_support_near(b, bmr_unrotate(&f->pose[i], bmr_neg(d)), support[1], &steps);
    bmr_kds_tally(kds, steps);
    const bmr_vec2 p = a->vertices[support[0]], q = bmr_transform(&f->pose[i], b->vertices[support[1]]);
    return bmr_dot(d, bmr_sub(q, p)) - kds->def.margin - f->loss[i];
}

/// How long a candidate lasts. False: not as long as `best`, or not with as large a gap.
static bool outlives(const bmr_kds *kds, const forecast *f, const uint32_t support[2], candidate *c,
                     const candidate *best) {
    uint32_t near[2] = {support[0], support[1]};
    if (f->turns && best->life > 0.0) { // most fall behind at once
        int i = f->count - 1;
        while (i > 0 && f->time[i] > best->life)
            --i;
        if (!(gap_at(kds, f, c, i, near) > 0.0))
            return false;
    }
    double before = gap_at(kds, f, c, 0, near);
    if (!(before > 0.0))
        return false;
    c->last_gap = before;
    c->life = f->time[f->count - 1];
    for (int i = 1; i < f->count; ++i) {
        const double gap = gap_at(kds, f, c, i, near);
        c->last_gap = gap;
        if (!(gap > 0.0)) {
            c->life = f->time[i - 1] + (f->time[i] - f->time[i - 1]) * before / (before - gap);
            break;
        }
        before = gap;
    }
    return c->life > best->life || (c->life == best->life && c->last_gap > best->last_gap);
}

static bmr_vec2 between(bmr_vec2 a, bmr_vec2 b) {
    const bmr_vec2 sum = bmr_add(a, b);
    const double size = bmr_length(sum);
    return size > DBL_EPSILON ? bmr_scale(1.0 / size, sum) : bmr_left(a);
}

/// The directions to try, the closest first.
static int directions(const bmr_kds *kds, const bmr_instant *now, predict_model model, bmr_vec2 closest,
                      double distance, const uint32_t support[2], bmr_vec2 out[MOST_CANDIDATES]) {
    const double margin = kds->def.margin, gap = distance - margin;
    int count = 0;
    out[count++] = closest;
    bmr_vec2 *fan = out + count;
    fan[0] = bmr_kds_cone_end(kds, &now->pose, closest, margin + LEAST_PART * gap, -1, support);
    fan[ACROSS - 1] = bmr_kds_cone_end(kds, &now->pose, closest, margin + LEAST_PART * gap, 1, support);
    for (int step = ACROSS - 1; step > 1; step /= 2)
        for (int i = 0; i + step < ACROSS; i += step)
            fan[i + step / 2] = between(fan[i], fan[i + step]);
    count += ACROSS;
    bmr_vec2 velocity = seen(now, model).velocity;
    if (model == MODEL_A_STRAIGHT)
        velocity = bmr_rotate(&now->pose, velocity);
    const double speed = bmr_length(velocity);
    if (speed > 0.0) {
        bmr_vec2 n = bmr_scale(1.0 / speed, bmr_left(velocity));
        if (bmr_dot(n, closest) < 0.0)
            n = bmr_neg(n);
        if (bmr_kds_separation(kds, &now->pose, n) > margin + NORMAL_LEAST_PART * gap)
            out[count++] = n;
    }
    return count;
}

/// One more failure: of a line across `line`, where the closest direction is `closest` now.
static void note_lean(lean_sides *lean, bmr_vec2 line, bmr_vec2 closest) {
    const double turned = bmr_cross(line, closest);
    const int side = (turned > 0.0) - (turned < 0.0);
    lean->row = side != lean->side ? 1 : (uint8_t)(lean->row < LEAN_AFTER ? lean->row + 1 : LEAN_AFTER);
    lean->side = (int8_t)side;
}

/// Has it failed on the same side often enough?
static bool lean_is_due(const lean_sides *lean) {
    return lean->row >= LEAN_AFTER && lean->side != 0;
}

/// The direction that leans to that side: `part` of the way from the closest direction to the last one that
/// still separates by a quarter of the distance beyond the margin.
static bmr_vec2 lean_direction(const lean_sides *lean, const bmr_kds *kds, const bmr_pose *b_in_a,
                               double part, bmr_vec2 closest, double distance, const uint32_t support[2]) {
    const double margin = kds->def.margin;
    const double least = margin + LEAN_LEAST_PART * (distance - margin);
    const bmr_vec2 end = bmr_kds_cone_end(kds, b_in_a, closest, least, lean->side, support);
    const double angle = part * atan2(bmr_cross(closest, end), bmr_dot(closest, end));
    const bmr_pose turn = {{0.0, 0.0}, cos(angle), sin(angle)};
    return bmr_rotate(&turn, closest);
}

static bool choose(bmr_kds *kds, const bmr_instant *now, bool fresh) {
    predict_state *s = state_of(kds);
    uint32_t support[2] = {s->now.support[0], s->now.support[1]};
    bmr_vec2 closest;
    double distance;
    if (!bmr_windowed_closest(kds, &now->pose, support, &closest, &distance))
        return false;
    if (fresh)
        forget(s, now);
    else {
        learn(s, kds, now);
        note_lean(&s->lean, bmr_windowed_direction(&s->now, &now->pose), closest);
    }
    s->last = *now;
    const predict_model model =
        s->wrong[MODEL_A_STRAIGHT] < s->wrong[MODEL_B_STRAIGHT] ? MODEL_A_STRAIGHT : MODEL_B_STRAIGHT;
    const double doubt = doubt_of(s->wrong[model]);
    bmr_vec2 tried[MOST_CANDIDATES] = {{0.0, 0.0}};
    int count = 1;
    if (doubt > LEAN_DOUBT && now->spin == 0.0 && lean_is_due(&s->lean))
        tried[0] = lean_direction(&s->lean, kds, &now->pose, LEAN_PART, closest, distance, support);
    else
        count = directions(kds, now, model, closest, distance, support, tried);
    forecast f;
    foresee(&f, kds, now, model, doubt, distance);
    candidate best = {tried[0], 0, -1.0, 0.0};
    for (int owner = 0; owner < (f.turns ? 2 : 1); ++owner)
        for (int i = 0; i < count; ++i) {
            candidate c = {tried[i], owner, 0.0, 0.0};
            if (outlives(kds, &f, support, &c, &best))
                best = c;
        }
    bmr_windowed_line_set(&s->now, kds, &now->pose, best.owner, best.direction, support);
    bmr_windowed_exact(&s->now, kds, &now->pose, bmr_windowed_sense(best.owner, bmr_sign(now->spin)));
    return true;
}

static bool start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    (void)report;
    return choose(kds, now, true);
}

static bool repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    (void)failed; // others may have failed at the same time
    predict_state *s = state_of(kds);
    const bmr_windowed_line old = s->now;
    const bmr_windowed_failure failure = bmr_windowed_fails(&old, kds, now);
    if (!failure.crossed && failure.rolled == 0)
        return true; // NONE
    if (!failure.crossed) {
        report->kind = BMR_KDS_ROLL;
        bmr_windowed_exact(&s->now, kds, &now->pose, bmr_windowed_sense(old.owner, bmr_sign(now->spin)));
        if (!bmr_windowed_fails(&s->now, kds, now).crossed)
            return true;
    }
    report->kind = BMR_KDS_PUSH;
    if (!choose(kds, now, false))
        return false;
    report->line_changed = !bmr_windowed_same_line(&old, &s->now);
    return true;
}

static const bmr_kds_class adaptive = {BMR_WINDOWED_CLASS(predict_state, start, repair)};

BMR_KDS_INFO(predict_adaptive, "predict-adaptive", "Free direction, prediction that learns to doubt",
             "beyond the paper", BMR_KDS_RIGID, BMR_KDS_CONTROL, -1, &adaptive);
