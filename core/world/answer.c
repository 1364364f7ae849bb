// SPDX-License-Identifier: MIT
// Answers to contacts: impulses, with restitution or without.
#include <math.h>

#include "world/parts.h"

/// Impulses in one answer. Where those at both ends of a stretch at once would have to pull, one is made at
/// one end, and then perhaps at the other: a few are enough with restitution 1; with less, what is left
/// shrinks each time.
#define MOST_IMPULSES 64
/// Approaches below this part of the first one are none.
#define NO_APPROACH 0x1p-46

/// ZENO_ELASTIC takes a pair for jammed when its margin was halved so often. Early: the distance that is left
/// down to what structures can prove is what a pile has to come loose in.
#define JAMMED 3u

/// A motion may lead to no pose at all: a rational rotation whose denominator vanishes.
static bool is_pose(const bmr_pose *q) {
    return isfinite(q->position.x) && isfinite(q->position.y) && isfinite(q->c) && isfinite(q->s);
}

/// The point that approaches fastest.
static size_t fastest(const bmr_contact *contact) {
    return contact->count == 2 && contact->approach[1] < contact->approach[0] ? 1 : 0;
}

/// How much the approach at point k changes by a unit of impulse along the normal there.
static double ease(const bmr_body_pair *c, const bmr_touch *touch, size_t k) {
    double sum = 0.0;
    for (int body = 0; body < 2; body++) {
        const double turn = bmr_cross(touch->arm[body][k], touch->contact.normal);
        sum += 1.0 / c->side[body]->mass + turn * turn / c->side[body]->inertia;
    }
    return sum;
}

static void push(const bmr_body_pair *c, const bmr_touch *touch, size_t k, double impulse,
                 bmr_instant now[2]) {
    const bmr_vec2 normal = touch->contact.normal;
    for (int body = 0; body < 2; body++) {
        const double own = body == 0 ? -impulse : impulse;
        now[body].velocity = bmr_add(now[body].velocity, bmr_scale(own / c->side[body]->mass, normal));
        now[body].spin += own * bmr_cross(touch->arm[body][k], normal) / c->side[body]->inertia;
    }
}

/// The two impulses that turn both approaches round at once, where neither of them pulls: two sides that meet
/// flat part flat. With restitution 1 the energy stays, as it does with one impulse: it changes by half of
/// the sum of each impulse times the approaches before and after.
///
/// They are found as their sum, and half their difference, from the approach at the stretch's middle and the
/// difference of those at its ends. So what is left of the approaches is rounding, however short the stretch
/// is: the equations of its two ends become one and the same as it shrinks.
static bool two_impulses(const bmr_body_pair *c, const bmr_touch *touch, double restitution,
                         double impulse[2]) {
    const double *approach = touch->contact.approach;
    if (touch->contact.count < 2 || !(approach[0] < 0.0) || !(approach[1] < 0.0))
        return false;
    double mass = 0.0, middle[2], along[2], inverse[2]; // turns about both, at the middle and to the ends
    for (int body = 0; body < 2; body++) {
        const double turn[2] = {bmr_cross(touch->arm[body][0], touch->contact.normal),
                                bmr_cross(touch->arm[body][1], touch->contact.normal)};
        mass += 1.0 / c->side[body]->mass;
        inverse[body] = 1.0 / c->side[body]->inertia;
        middle[body] = 0.5 * (turn[0] + turn[1]);
        along[body] = turn[1] - turn[0];
    }
    const double mm = mass + middle[0] * middle[0] * inverse[0] + middle[1] * middle[1] * inverse[1];
    const double ma = middle[0] * along[0] * inverse[0] + middle[1] * along[1] * inverse[1];
    const double aa = along[0] * along[0] * inverse[0] + along[1] * along[1] * inverse[1];
    const double area = middle[0] * along[1] - middle[1] * along[0];
    const double determinant = mass * aa + area * area * inverse[0] * inverse[1]; // mm * aa - ma * ma
    if (!(determinant > 0.0))                                                     // bodies that nothing turns
        return false;
    const double want = -(1.0 + restitution) * 0.5 * (approach[0] + approach[1]);
    const double want_along = -(1.0 + restitution) * (approach[1] - approach[0]);
    const double sum = (aa * want - ma * want_along) / determinant;
    const double half = (mm * want_along - ma * want) / determinant;
    impulse[0] = 0.5 * sum - half;
    impulse[1] = 0.5 * sum + half;
    return impulse[0] >= 0.0 && impulse[1] >= 0.0;
}

/// The restitution of an impulse on points that approach at this speed (> 0). With ZENO_ELASTIC slow ones
/// rebound as fast as they came, and those of a jammed pair at zeno_speed at least, where they came as fast:
/// twice that for each further halving of the margin, as a spring that is pressed together.
static double bounce_of(const bmr_world *w, const bmr_near *n, double restitution, double speed) {
    const unsigned halvings = n->level / bmr_levels_a_halving(w);
    if (w->def.zeno != BMR_ZENO_ELASTIC || (speed >= w->def.zeno_speed && halvings < JAMMED))
        return restitution;
    const double most = ldexp(w->def.zeno_speed, halvings > JAMMED ? (int)(halvings - JAMMED) : 0);
    return fmax(restitution, fmin(1.0, most / speed));
}

/// False: the two cannot be moved.
static bool collide(bmr_world *w, const bmr_body_pair *c, double restitution, bmr_touch *touch,
                    bmr_instant now[2], bool *changed) {
    const double first = touch->contact.approach[fastest(&touch->contact)];
    for (int i = 0; i < MOST_IMPULSES; i++) {
        const size_t k = fastest(&touch->contact);
        const double approach = touch->contact.approach[k];
        if (!(approach < 0.0) || (i > 0 && approach > NO_APPROACH * first))
            break;
        const double bounce = bounce_of(w, c->near, restitution, -approach);
        double impulse[2] = {0.0, 0.0};
        if (!two_impulses(c, touch, bounce, impulse)) {
            impulse[k] = -(1.0 + bounce) * approach / ease(c, touch, k);
            impulse[1 - k] = 0.0;
        }
        if (!isfinite(impulse[0]) || !isfinite(impulse[1])) // nothing moves either
            return false;
        const double before[2] = {touch->contact.approach[0], touch->contact.approach[1]};
        push(c, touch, 0, impulse[0], now);
        if (touch->contact.count == 2)
            push(c, touch, 1, impulse[1], now);
        bmr_touch_move(touch, now);
        w->counts.impulses++;
        if (bounce > restitution) {
            const double kept = -(impulse[0] * before[0] + impulse[1] * before[1]);
            w->counts.softened++;
            w->counts.softened_energy +=
                0.5 * (bounce * bounce - restitution * restitution) / (1.0 + bounce) * kept;
        }
        *changed = true;
    }
    return true;
}

/// Both bodies go on from where they are.
static bmr_error go_on(bmr_world *w, bmr_body_pair *c, const bmr_instant now[2]) {
    for (int i = 0; i < 2; i++) {
        bmr_world_body *const r = c->side[i];
        if (isinf(r->mass) && isinf(r->inertia))
            continue;
        const bmr_course course = {bmr_piece_screw(w->time, now[i].pose, now[i].velocity, now[i].spin),
                                   INFINITY, NULL};
        const bmr_error error = bmr_body_move(w, r, &course);
        if (error != BMR_OK || !w->busy) // the latter: its pose jumped, and the pair is gone
            return error;
    }
    return BMR_OK;
}

static bool makes_sense(const bmr_response *response) {
    return (unsigned)response->kind < BMR_RESPONSE_KIND_COUNT &&
           (response->kind != BMR_RESPONSE_IMPULSE ||
            (response->restitution >= 0.0 && response->restitution <= 1.0));
}

static bmr_error answer(bmr_world *w, bmr_body_pair *c, const bmr_response *response, bmr_touch *touch) {
    if (!makes_sense(response)) {
        bmr_body_pair_pass(w, c);
        return bmr_body_pair_stop(w, c, BMR_ERROR_OUT_OF_RANGE, BMR_TROUBLE_ANSWER);
    }
    bmr_instant now[2];
    bmr_body_pair_now(w, c, now);
    bmr_touch_move(touch, now); // a callback may have changed them
    bool can = response->kind != BMR_RESPONSE_PASS && is_pose(&now[0].pose) && is_pose(&now[1].pose);
    bool changed = false;
    if (can && response->kind == BMR_RESPONSE_IMPULSE)
        can = collide(w, c, response->restitution, touch, now, &changed);
    const bmr_error error = can && changed ? go_on(w, c, now) : BMR_OK;
    if (!w->busy) // a pose that is none: the pair was given up
        return error;
    if (!can || error != BMR_OK) {
        bmr_body_pair_pass(w, c);
        return error;
    }
    return bmr_body_pair_resume(w, c, touch->contact.approach[fastest(&touch->contact)]);
}

bmr_error bmr_contact_report(bmr_world *w, bmr_body_pair *c) {
    bmr_touch touch;
    bmr_touch_describe(w, c, &touch);
    bmr_response response = w->def.response;
    w->busy = c;
    if (w->def.contact) {
        const bmr_contact contact = touch.contact;
        response = w->def.contact(w->def.context, w, &contact);
    }
    // The answer changes motions; this pair's own turn comes after. (NULL: the callback ended it.)
    const bmr_error error = w->busy ? answer(w, c, &response, &touch) : BMR_OK;
    w->busy = NULL;
    bmr_world_observe(w, BMR_WORLD_CONTACT, touch.contact.a, touch.contact.b, NULL);
    return error;
}
