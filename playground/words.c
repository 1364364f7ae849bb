// SPDX-License-Identifier: MIT
#include "words.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#define PI 3.14159265358979323846
#define DEGREES (180.0 / PI)

/// A text that is being written; what is too long is cut.
typedef struct writer {
    char *text;
    size_t size, length;
} writer;

static writer begin(char *text, size_t size) {
    text[0] = '\0';
    return (writer){text, size, 0};
}

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static void
say(writer *w, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const int more = vsnprintf(w->text + w->length, w->size - w->length, format, arguments);
    va_end(arguments);
    if (more > 0)
        w->length += (size_t)more;
    if (w->length >= w->size)
        w->length = w->size - 1;
}

const char *play_label_text(int label) {
    switch (label) {
    case PLAY_LABEL_A:
        return "A";
    case PLAY_LABEL_B:
        return "B";
    case PLAY_LABEL_X:
        return "x";
    default:
        return label < 0 ? NULL : bmr_kds_event_name((bmr_kds_event_kind)label);
    }
}

// ---- the certificate ----

play_levels play_levels_of(const play_duel *duel) {
    play_levels levels = {-1, 0};
    const int kind = duel->def.structure->hierarchy;
    if (kind >= 0)
        for (int body = 0; body < 2; ++body) {
            const int depth = (int)bmr_hierarchy_depth(duel->def.bodies[body]->hierarchies[kind]);
            levels.deepest = depth > levels.deepest ? depth : levels.deepest;
        }
    bmr_kds_proof proof;
    const bmr_kds *kds = play_duel_kds(duel);
    if (kds && bmr_kds_get_proof(kds, &proof))
        levels.level = proof.level > levels.deepest ? levels.deepest : proof.level;
    return levels;
}

/// The slacks of the conditions: the least distance, and the least angle to either side.
typedef struct slacks {
    size_t beyond, turns;
    double distance, angles[2];
} slacks;

static slacks slacks_of(const play_duel *duel) {
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    slacks r = {0, 0, INFINITY, {INFINITY, INFINITY}};
    const bmr_pose pose = play_duel_b_in_a(duel);
    const size_t count = bmr_kds_conditions(play_duel_kds(duel), conditions);
    for (size_t i = 0; i < count; ++i) {
        const double value = bmr_condition_value(&conditions[i], &pose);
        if (conditions[i].kind != BMR_CONDITION_TURN) {
            ++r.beyond;
            r.distance = fmin(r.distance, value);
        } else {
            double *angle = &r.angles[r.turns++ % 2];
            *angle = fmin(*angle, asin(fmin(fmax(value, 0.0), 1.0)) * DEGREES);
        }
    }
    return r;
}

static void say_cell(writer *w, const slacks *r, int level) {
    if (level < 0)
        say(w, "x, the place of B as A sees it, is outside of all cells: one edge of a bounding rectangle is "
               "enough.");
    else
        say(w,
            "x, the place of B as A sees it, is in a cell of level %d. The cell's inner side is the proof.",
            level);
    say(w, " The nearest side is %.3g away.", r->distance);
}

static void say_line(writer *w, const play_duel *duel, const bmr_kds_proof *proof, const slacks *r) {
    const char *owner = proof->owner == 0 ? "A" : "B", *other = proof->owner == 0 ? "B" : "A";
    const play_levels levels = play_levels_of(duel);
    say(w, "All of %s is on one side of the line, all of %s on the other.", owner, other);
    if (levels.deepest > 0)
        say(w, " The line is an edge of %s's level %d of %d%s.", owner, levels.level, levels.deepest,
            levels.level == 0 ? ", its bounding rectangle" : "");
    if (r->beyond == 1)
        say(w, " %s's nearest corner is %.3g beyond it.", other, r->distance);
    else if (r->beyond > 1)
        say(w, " %zu corners of %s are watched, the nearest %.3g beyond it.", r->beyond, other, r->distance);
    if (r->turns >= 2)
        say(w, " A turn of %.3g\xc2\xb0 to one side or %.3g\xc2\xb0 to the other leaves the window.",
            r->angles[0], r->angles[1]);
}

size_t play_describe_proof(const play_duel *duel, char *text, size_t size) {
    writer w = begin(text, size);
    bmr_kds_proof proof;
    const bmr_kds *kds = play_duel_kds(duel);
    if (!kds || !bmr_kds_get_proof(kds, &proof)) {
        say(&w, "In contact: no line separates A and B. Move them apart to see a new proof.");
        return w.length;
    }
    say(&w, "Apart. ");
    const slacks r = slacks_of(duel);
    if (play_is_cell(duel->def.structure))
        say_cell(&w, &r, proof.level);
    else
        say_line(&w, duel, &proof, &r);
    return w.length;
}

// ---- events ----

const char *play_explain(bmr_kds_event_kind kind, bool cell) {
    switch (kind) {
    case BMR_KDS_START:
        return "A proof was made from nothing.";
    case BMR_KDS_PUSH:
        return "The corner crossed the line beyond the ends of the edge. Nothing touched: another edge of "
               "the "
               "same envelope separates.";
    case BMR_KDS_STAB:
        if (cell)
            return "x left its cell through the inner side: the line of the proof. The proof goes to a finer "
                   "level.";
        return "The corner went through the edge itself: the envelopes of this level touch. The proof goes "
               "to "
               "a finer level.";
    case BMR_KDS_ROLL:
        return "A body turned, and another corner is now the nearest to the line. The line stays; the proof "
               "watches the new corner.";
    case BMR_KDS_CROSS:
        return "x left its cell through an outer side, into a neighbour.";
    case BMR_KDS_PAGE_TURN:
        return "Two edges became parallel: a triangle and a parallelogram changed places, as a page turns.";
    case BMR_KDS_COLLAPSE:
        return "Two edges became parallel: a parallelogram got thin and vanished.";
    case BMR_KDS_FEATURE:
        return "The features that are watched changed.";
    case BMR_KDS_HANDOVER:
        return "The line failed. The second line, which was made together with it, still separates and is "
               "watched "
               "from here on.";
    case BMR_KDS_CONTACT:
        return "A and B touch: no line separates them.";
    case BMR_KDS_LEAVE:
        return "A and B came apart, and a proof was made.";
    case BMR_KDS_NONE:
        return "Nothing had failed.";
    default:
        return NULL;
    }
}

size_t play_describe_event(const play_event *event, bool cell, char *text, size_t size) {
    writer w = begin(text, size);
    if (!event) {
        say(&w, "No event yet: the first proof still stands.");
        return w.length;
    }
    const bmr_kds_report *report = &event->report;
    const char *name = bmr_kds_event_name(report->kind);
    say(&w, "%c%s. %s", name[0] - 'a' + 'A', name + 1, play_explain(report->kind, cell));
    if (!play_is_repair(report->kind))
        return w.length;
    if (report->level_after != report->level_before)
        say(&w, " Level %d became level %d, %s.", report->level_before, report->level_after,
            report->level_after > report->level_before ? "finer" : "coarser");
    else
        say(&w, " The level stayed %d.", report->level_after);
    return w.length;
}

static uint64_t repairs_of(const play_duel *duel, size_t follower) {
    uint64_t sum = 0;
    for (int kind = 0; kind < BMR_KDS_EVENT_KIND_COUNT; ++kind)
        if (play_is_repair((bmr_kds_event_kind)kind))
            sum += play_duel_count(duel, follower, (bmr_kds_event_kind)kind);
    return sum;
}

static const char *many(bmr_kds_event_kind kind, uint64_t count) {
    static const char *const endings[BMR_KDS_EVENT_KIND_COUNT] = {
        [BMR_KDS_PUSH] = "es", [BMR_KDS_CROSS] = "es"};
    return count == 1 ? "" : endings[kind] ? endings[kind] : "s";
}

size_t play_describe_counts(const play_duel *duel, char *text, size_t size) {
    writer w = begin(text, size);
    const uint64_t all = repairs_of(duel, 0);
    say(&w, "%llu event%s", (unsigned long long)all, all == 1 ? "" : "s");
    const char *separator = ": ";
    for (int i = 0; i < BMR_KDS_EVENT_KIND_COUNT; ++i) {
        const bmr_kds_event_kind kind = (bmr_kds_event_kind)i;
        const uint64_t count = play_is_repair(kind) ? play_duel_count(duel, 0, kind) : 0;
        if (count == 0)
            continue;
        say(&w, "%s%llu %s%s", separator, (unsigned long long)count, bmr_kds_event_name(kind),
            many(kind, count));
        separator = ", ";
    }
    say(&w, ". Rivals:");
    for (size_t i = 1; i < PLAY_FOLLOWERS; ++i)
        say(&w, "%s %s %llu", i > 1 ? "," : "", duel->followers[i].info->name,
            (unsigned long long)repairs_of(duel, i));
    say(&w, ".");
    return w.length;
}

size_t play_describe_crowd(const play_crowd *crowd, char *text, size_t size) {
    writer w = begin(text, size);
    const bmr_world_counts counts = bmr_world_get_counts(crowd->world);
    const double time = bmr_world_time(crowd->world);
    uint64_t events = 0;
    for (int kind = 0; kind < BMR_WORLD_EVENT_KIND_COUNT; ++kind)
        events += counts.events[kind];
    if (crowd->stopped != BMR_OK)
        say(&w, "The world stopped: %s. ", bmr_error_describe(crowd->stopped));
    say(&w, "%zu bodies, %llu contacts at their own times.", counts.bodies,
        (unsigned long long)crowd->contacts);
    if (time > 0.0)
        say(&w, " %.2f events a body and unit of time.", (double)events / (double)counts.bodies / time);
    say(&w,
        " Of %zu possible pairs, those with a wall included, %zu are candidates and %zu have a proof by a "
        "line.",
        counts.bodies * (counts.bodies - 1) / 2 + BMR_WALLS * counts.bodies, counts.pairs, counts.near);
    if (crowd->energy > 0.0)
        say(&w, " Energy: %.10f of what it was at the start.",
            bmr_world_get_totals(crowd->world).energy / crowd->energy);
    return w.length;
}
