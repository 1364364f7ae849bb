// SPDX-License-Identifier: MIT
// What the playground's page draws, counts and says, without a page: pictures are true of the bodies, and
// counts are those of simulations that were made another way.
#include "boomerang/simulation.h"
#include "checks.h"
#include "draw.h"
#include "duel.h"
#include "page.h"
#include "words.h"

// --- Items of a picture of the playground's page, found in its numbers.

typedef struct item {
    size_t count;
    const float *points;
} item;

/// The first item of an ink (and mark) at or after `at`; *at moves behind it. False: there is none.
static bool find_item(const play_page *page, int numbers, int mark, int ink, int *at, item *found) {
    const float *all = play_numbers(page);
    *found = (item){0};
    while (*at < numbers) {
        const float *head = all + *at;
        const size_t count = (size_t)head[4];
        *at += (int)(PLAY_ITEM_HEAD + 2 * count);
        if ((int)head[0] == mark && (int)head[1] == ink) {
            *found = (item){count, head + PLAY_ITEM_HEAD};
            return true;
        }
    }
    return false;
}
static bool first_item(const play_page *page, int numbers, int mark, int ink, item *found) {
    int at = 0;
    return find_item(page, numbers, mark, ink, &at, found);
}
static bmr_vec2 point_of(const item *of, size_t i) {
    i %= of->count;
    return bmr_vec2_make((double)of->points[2 * i], (double)of->points[2 * i + 1]);
}
/// Is a point in an area, up to `slop`?
static bool holds(const item *area, bmr_vec2 point, double slop) {
    for (size_t i = 0; i < area->count; ++i) {
        const bmr_vec2 from = point_of(area, i), side = bmr_sub(point_of(area, i + 1), from);
        const double length = hypot(side.x, side.y);
        if (length > 1e-6 && bmr_cross(side, bmr_sub(point, from)) < -slop * length)
            return false;
    }
    return true;
}

#define HOLDS 120

static int structure(const char *name) {
    const int found = play_structure_find(name);
    assert_true(found >= 0);
    return found;
}

static play_page *open_page(void) {
    play_page *page = play_open();
    assert_non_null(page);
    return page;
}

static void leave_page(play_page *const *page) {
    play_close(*page);
}
#define own_page OWNED(leave_page) play_page
#define REFUSED(call) assert_int_equal(call, BMR_ERROR_OUT_OF_RANGE)

/// Two bodies by hand, B to the right of A.
static play_page *by_hand(const char *name, int n) {
    play_page *page = open_page();
    assert_int_equal(play_set_ngon(page, 0, BMR_NGON_ELLIPSE, n, 1), 0);
    assert_int_equal(play_set_ngon(page, 1, BMR_NGON_RANDOM, n, 2), 0);
    assert_int_equal(play_use_hand(page, structure(name), 0, 0, 0, 2.5, 0.5, 0.3), 0);
    return page;
}

/// The next of a hand's poses: B goes round A, near and far, and turns.
static bmr_pose hand_pose(int i) {
    const double around = 0.11 * i, far = 1.7 + 0.75 * sin(0.37 * i);
    return bmr_pose_from_angle(bmr_vec2_make(far * cos(around), far * sin(around)), 0.3 + 0.17 * i);
}

static void hold(play_page *page, int body, const bmr_pose *pose) {
    assert_int_equal(play_hold(page, body, pose->position.x, pose->position.y, atan2(pose->s, pose->c)), 0);
}

static bmr_pose hold_next(play_page *page, int i) {
    const bmr_pose pose = hand_pose(i);
    hold(page, 1, &pose);
    return pose;
}

// ---- the lesson ----

TEST(the_lesson_begins_with_a_push_a_roll_and_a_stab) {
    own_page *page = open_page();
    assert_int_equal(play_use_lesson(page, structure("lazy-dudley")), 0);
    const double *marks = play_marks(page, 0);
    assert_true(play_mark_count(page, 0) >= 3);
    const int expected[3] = {BMR_KDS_PUSH, BMR_KDS_ROLL, BMR_KDS_STAB};
    double before = 0.0;
    for (int i = 0; i < play_mark_count(page, 0); ++i) {
        const int kind = (int)marks[2 * i + 1];
        assert_true(i >= 3 || kind == expected[i]);
        assert_true(kind != BMR_KDS_CONTACT);
        assert_true(marks[2 * i] >= before + 0.5); // to be seen one by one
        before = marks[2 * i];
    }
    // Seen one after the other, the picture's event is the one that comes.
    for (int i = 0; i < 3; ++i) {
        assert_int_equal(play_seek(page, play_next_event(page)), 0);
        assert_int_equal(play_latest(page), expected[i]);
    }
    // Control: without levels there is no stab.
    assert_int_equal(play_use_lesson(page, structure("free-fd2")), 0);
    assert_true(play_events_in_all(page, 0, BMR_KDS_STAB) == 0.0);
}

// ---- counts ----

static void count_kind(void *context, const bmr_simulation_event *event) {
    ++((uint64_t *)context)[event->report.kind];
}

/// Events of a structure on the way of hand_pose, in one run of one simulation along one sampled motion.
/// (From the same bodies as by_hand's.)
static void count_at_once(const bmr_kds_info *info, int n, uint64_t counts[BMR_KDS_EVENT_KIND_COUNT]) {
    play_body *bodies[2];
    assert_int_equal(play_body_create_ngon(BMR_NGON_ELLIPSE, (size_t)n, 1, 1.0, &bodies[0]), 0);
    assert_int_equal(play_body_create_ngon(BMR_NGON_RANDOM, (size_t)n, 2, 1.0, &bodies[1]), 0);
    double times[HOLDS + 1];
    bmr_pose poses[HOLDS + 1];
    for (int i = 0; i <= HOLDS; ++i) {
        times[i] = i;
        poses[i] = i == 0 ? bmr_pose_from_angle(bmr_vec2_make(2.5, 0.5), 0.3) : hand_pose(i);
    }
    const bmr_motion_piece home = bmr_piece_rest(bmr_pose_identity());
    bmr_motion *motions[2];
    assert_int_equal(bmr_motion_create(&home, NULL, &motions[0]), 0);
    assert_int_equal(bmr_motion_create_sampled(times, poses, HOLDS + 1, NULL, &motions[1]), 0);
    const bmr_shape shapes[2] = {play_body_shape(bodies[0]), play_body_shape(bodies[1])};
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = info;
    bmr_simulation *simulation; // begun while B rests, as by a hand: a structure may go by the rates
    assert_int_equal(
        bmr_simulation_create(&def, shapes, motions, -1.0, count_kind, counts, NULL, &simulation), 0);
    assert_int_equal(bmr_simulation_run(simulation, HOLDS), 0);
    bmr_simulation_destroy(simulation);
    for (int body = 0; body < 2; ++body) {
        bmr_motion_destroy(motions[body]);
        play_body_destroy(bodies[body]);
    }
}

TEST(a_hand_s_counts_are_those_of_one_run_along_the_same_way) {
    const char *const names[] = {"lazy-dudley", "free-fd2", "active-cell-compass"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i) {
        own_page *page = by_hand(names[i], 14);
        for (int k = 1; k <= HOLDS; ++k)
            hold_next(page, k);
        double repairs = 0.0;
        for (int follower = 0; follower < play_follower_count(); ++follower) {
            uint64_t counts[BMR_KDS_EVENT_KIND_COUNT] = {0};
            count_at_once(bmr_kds_at((size_t)play_follower_structure(page, follower)), 14, counts);
            for (int kind = 0; kind < BMR_KDS_EVENT_KIND_COUNT; ++kind) {
                assert_true(play_events(page, follower, kind) == (double)counts[kind]);
                repairs += play_counts(kind) ? (double)counts[kind] : 0.0;
            }
        }
        assert_true(repairs > 100.0); // control: there was something to count
    }
}

TEST(a_course_has_the_same_events_however_it_is_played) {
    own_page *page = open_page();
    assert_int_equal(play_set_ngon(page, 0, BMR_NGON_ELLIPSE, 24, 1), 0);
    assert_int_equal(play_set_ngon(page, 1, BMR_NGON_LENS, 24, 2), 0);
    for (int family = 0; family < play_family_count(); ++family) {
        assert_int_equal(play_use_family(page, structure("lazy-compass"), family, 64.0, 3), 0);
        for (int i = 1; i <= 40; ++i)
            assert_int_equal(play_seek(page, i / 40.0), 0);
        assert_int_equal(play_seek(page, 0.3), 0);
        assert_true(play_time(page) == 0.3);
        const double early = play_event_count(page);
        assert_int_equal(play_seek(page, 1.0), 0);
        assert_true(play_event_count(page) >= early);
        for (int follower = 0; follower < play_follower_count(); ++follower) {
            double in_all = 0.0;
            for (int kind = 0; kind < BMR_KDS_EVENT_KIND_COUNT; ++kind) {
                assert_true(play_events(page, follower, kind) == play_events_in_all(page, follower, kind));
                in_all += play_events_in_all(page, follower, kind);
            }
            // Turning to and fro by so little may cost nothing.
            assert_true(family == BMR_FAMILY_TO_AND_FRO ||
                        (in_all >= 1.0 && play_mark_count(page, follower) > 0));
        }
    }
}

TEST(what_a_hand_does_for_long_is_forgotten_and_its_counts_are_not) {
    own_page *page = by_hand("lazy-dudley", 8);
    double before = 0.0;
    for (int k = 0; k < 4500; ++k) {
        const bmr_pose pose = bmr_pose_from_angle(bmr_vec2_make(2.2, 0.4 * sin(0.05 * k)), 0.1 * k);
        hold(page, 1, &pose);
        const double rolls = play_events(page, 0, BMR_KDS_ROLL);
        assert_true(rolls >= before);
        before = rolls;
    }
    assert_true(before > 100.0);
    assert_true(fabs(play_place(page, 1, 0) - 2.2) < 1e-9);
}

// ---- pictures ----

/// The least and the largest distance of an area's corners from a line, signed.
static void reach_of(const item *area, const item *line, double shift, double *low, double *high) {
    const bmr_vec2 from = point_of(line, 0), along = bmr_sub(point_of(line, 1), from);
    const double length = hypot(along.x, along.y);
    *low = INFINITY;
    *high = -INFINITY;
    for (size_t i = 0; i < area->count; ++i) {
        const double d = bmr_cross(along, bmr_sub(point_of(area, i), from)) / length + shift;
        *low = fmin(*low, d);
        *high = fmax(*high, d);
    }
}
static bool separates(const item *a, const item *b, const item *line, double shift) {
    double low[2], high[2];
    reach_of(a, line, shift, &low[0], &high[0]);
    reach_of(b, line, shift, &low[1], &high[1]);
    const double slop = 1e-5; // of floats
    return (high[0] <= slop && low[1] >= -slop) || (high[1] <= slop && low[0] >= -slop);
}

TEST(the_line_that_is_drawn_separates_what_is_drawn) {
    for (int i = 0; i < play_structure_count(); ++i) {
        if (!play_structure_is_offered(i) || play_structure_role(i) == BMR_KDS_RIVAL) // their lines move
            continue;
        own_page *page = by_hand(play_structure_name(i), 12);
        int lines = 0, refuted = 0;
        for (int k = 1; k <= HOLDS; ++k) {
            hold_next(page, k);
            const int numbers = play_draw(page, PLAY_PICTURE_DUEL, PLAY_ALL_LEVELS);
            item a, b, line;
            assert_true(first_item(page, numbers, PLAY_AREA, PLAY_INK_A, &a));
            assert_true(first_item(page, numbers, PLAY_AREA, PLAY_INK_B, &b));
            if (!first_item(page, numbers, PLAY_PATH, PLAY_INK_LINE, &line)) {
                assert_true(play_distance(page) <= 1e-5); // in contact there is none
                continue;
            }
            ++lines;
            assert_true(separates(&a, &b, &line, 0.0));
            refuted += !separates(&a, &b, &line, 0.7) + !separates(&a, &b, &line, -0.7);
        }
        assert_true(lines > HOLDS / 3);
        assert_true(refuted > 0); // control: a line elsewhere would be seen
    }
}

TEST(envelopes_that_are_drawn_hold_their_body) {
    own_page *page = by_hand("lazy-dudley", 20);
    const int numbers = play_draw(page, PLAY_PICTURE_DUEL, PLAY_ALL_LEVELS);
    item a, envelope;
    int at = 0, levels = 0;
    assert_true(first_item(page, numbers, PLAY_AREA, PLAY_INK_A, &a));
    while (find_item(page, numbers, PLAY_AREA, PLAY_INK_LEVEL_A, &at, &envelope)) {
        ++levels;
        for (size_t i = 0; i < a.count; ++i)
            assert_true(holds(&envelope, point_of(&a, i), 1e-5));
    }
    assert_int_equal(levels, play_deepest(page) - 1);       // all but the proof's and the polygon itself
    assert_false(holds(&a, bmr_vec2_make(3.0, 0.0), 1e-5)); // control
    // Without levels none is drawn.
    assert_false(first_item(page, play_draw(page, PLAY_PICTURE_DUEL, PLAY_NO_LEVELS), PLAY_AREA,
                            PLAY_INK_LEVEL_A, &envelope));
}

// ---- many bodies ----

TEST(a_crowd_keeps_its_energy_until_it_is_kicked) {
    own_page *page = open_page();
    assert_int_equal(play_use_crowd(page, structure("free-fd2"), 40, 7, 0.3, 5), 0);
    for (int i = 0; i < 60; ++i)
        assert_int_equal(play_crowd_go(page, 0.05, 0.05), 0);
    unsigned contacts = 0;
    assert_int_equal(sscanf(play_text(page, PLAY_TEXT_CROWD), "40 bodies, %u contacts", &contacts), 1);
    assert_true(contacts > 20);
    assert_non_null(strstr(play_text(page, PLAY_TEXT_CROWD), "Energy: 1.0000000"));
    item body;
    int bodies = 0;
    const int numbers = play_draw(page, PLAY_PICTURE_CROWD, 7);
    for (int ink = PLAY_INK_A; ink <= PLAY_INK_B; ++ink)
        for (int at = 0; find_item(page, numbers, PLAY_AREA, ink, &at, &body);)
            ++bodies;
    assert_int_equal(bodies, 40);
    assert_int_equal(play_crowd_kick(page, 1.0, 1.0, 30.0, 0.0), 0);
    assert_null(strstr(play_text(page, PLAY_TEXT_CROWD), "Energy: 1.0000000"));
    REFUSED(play_use_crowd(page, structure("free-fd2"), 0, 7, 0.3, 5));
    REFUSED(play_use_crowd(page, structure("free-fd2"), 10, 7, NAN, 5));
    REFUSED(play_use_crowd(page, structure("free-fd2"), 10, 2, 0.3, 5));
}

// ---- words ----

TEST(the_words_say_what_is) {
    own_page *page = by_hand("lazy-dudley", 12);
    assert_non_null(strstr(play_text(page, PLAY_TEXT_PROOF), "level 0 of"));
    assert_non_null(strstr(play_text(page, PLAY_TEXT_EVENT), "No event yet"));
    assert_string_equal(play_text(page, PLAY_TEXT_COUNTS),
                        "0 events. Rivals: closest-features 0, inner-tangent 0, separating-edge-walk 0.");
    const bmr_pose onto = bmr_pose_identity();
    hold(page, 1, &onto);
    assert_int_equal(play_latest(page), BMR_KDS_CONTACT);
    assert_non_null(strstr(play_text(page, PLAY_TEXT_PROOF), "In contact"));
    assert_int_equal(play_level(page), -1);
    const bmr_pose away = bmr_pose_from_angle(bmr_vec2_make(4.0, 0.0), 0.0);
    hold(page, 1, &away);
    assert_int_equal(play_latest(page), BMR_KDS_LEAVE);
    // Each kind of event is explained, and a short text is cut and ended.
    for (int kind = 0; kind < BMR_KDS_EVENT_KIND_COUNT; ++kind)
        assert_true(strlen(play_event_meaning(kind, 0)) > 10 && play_label(kind) != NULL);
    assert_null(play_event_meaning(-1, 1));
    char text[8];
    assert_int_equal(play_describe_event(NULL, false, text, sizeof text), sizeof text - 1);
    assert_int_equal(strlen(text), sizeof text - 1);
}

// ---- what makes no sense ----

TEST(bad_numbers_are_refused) {
    own_page *page = open_page();
    REFUSED(play_use_hand(page, structure("lazy-dudley"), 0, 0, 0, 2, 0, 0));
    assert_int_equal(play_draw(page, PLAY_PICTURE_DUEL, 0), 0);
    assert_string_equal(play_text(page, PLAY_TEXT_PROOF), "");
    REFUSED(play_seek(page, 1.0));
    REFUSED(play_set_ngon(page, 2, 0, 5, 1));
    REFUSED(play_set_ngon(page, 0, 99, 5, 1));
    REFUSED(play_set_ngon(page, 0, 0, 100000, NAN));
}

TEST(a_pair_stands_whatever_it_is_given) {
    own_page *page = by_hand("lazy-dudley", 12);
    hold(page, 1, &(bmr_pose){{NAN, 0.0}, 1.0, 0.0});
    hold(page, 1, &(bmr_pose){{1e9, 0.0}, 1.0, 0.0});
    assert_true(play_place(page, 1, 0) == 2.5);
    REFUSED(play_hold(page, 7, 0, 0, 0));
    REFUSED(play_use_hand(page, -1, 0, 0, 0, 2, 0, 0));
    REFUSED(play_use_hand(page, structure("point-lazy-dudley"), 0, 0, 0, 2, 0, 0));
    REFUSED(play_use_family(page, structure("lazy-dudley"), 0, NAN, 1));
    REFUSED(play_use_family(page, structure("lazy-dudley"), 99, 10.0, 1));
    // After all that the pair still stands.
    assert_non_null(strstr(play_text(page, PLAY_TEXT_PROOF), "Apart."));

    // A drawn shape: the hull of the points; fewer than three of them are none, and the body stays.
    play_sketch_clear(page);
    assert_int_equal(play_sketch_add(page, NAN, 0.0), 0);
    assert_int_equal(play_sketch_add(page, 5.0, 5.0), 1);
    assert_int_equal(play_sketch_add(page, 6.0, 5.0), 2);
    assert_int_equal(play_sketch_take(page, 1), BMR_ERROR_TOO_FEW_POINTS);
    assert_true(play_place(page, 1, 4) == 12.0);
    assert_int_equal(play_sketch_add(page, 5.5, 6.0), 3);
    assert_int_equal(play_sketch_add(page, 5.5, 5.3), 4);
    assert_int_equal(play_sketch_take(page, 1), 0);
    assert_int_equal(play_use_hand(page, structure("lazy-dudley"), 0, 0, 0, 2, 0, 0), 0);
    assert_true(play_place(page, 1, 4) == 3.0);
}
