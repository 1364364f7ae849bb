// SPDX-License-Identifier: MIT
// What boomerang/kds.h promises of every structure, each on the motions that it is for.
#include "boomerang/kds.h"
#include "checks.h"
#include "driven.h"
#include "kds/point.h"
#include "motions.h"

static test_kds_body regular(size_t n) {
    test_random random = test_random_from(n);
    return test_kds_body_make(test_polygon(TEST_REGULAR, n, &random));
}

static test_kds_body other_body(size_t i, size_t n) {
    return bmr_kds_at(i)->domain == BMR_KDS_POINT ? test_kds_point_make(0.125, 0.0) : regular(n);
}

static bmr_kds *made(size_t i, const bmr_kds_def *def, const test_kds_body *a, const test_kds_body *b) {
    return made_kds(bmr_kds_at(i), def, &a->shape, &b->shape);
}

static bmr_instant at_gap(const test_kds_body *a, const test_kds_body *b, double gap) {
    const bmr_instant now = {test_pose_at(a->polygon, b->polygon, 0.3, 0.5, gap), {0.0, 0.0}, 0.0};
    return now;
}

TEST(an_early_repair_reports_none_and_changes_nothing) {
    for (size_t way = 0; way < 2 * bmr_kds_count(); ++way) {
        const size_t i = way / 2; // at rest, and moving
        own_kds_body a = regular(24), b = other_body(i, 16);
        const bmr_kds_def def = bmr_default_kds_def();
        own_kds *kds = made(i, &def, &a, &b);
        bmr_instant now = at_gap(&a, &b, 0.02);
        if (way % 2)
            now.velocity = bmr_vec2_make(-0.3, 0.2);
        if (way % 2 && bmr_kds_at(i)->domain == BMR_KDS_RIGID)
            now.spin = 0.7;
        bmr_condition before[BMR_KDS_MAX_CONDITIONS], after[BMR_KDS_MAX_CONDITIONS];
        bmr_kds_report report;
        assert_int_equal(bmr_kds_conditions(kds, before), 0); // nothing known yet
        bmr_kds_start(kds, &now, &report);
        assert_int_equal(report.kind, BMR_KDS_START);
        assert_true(report.apart && report.touched > 0);
        const size_t count = bmr_kds_conditions(kds, before);
        assert_true(count >= 1 && count <= BMR_KDS_MAX_CONDITIONS);
        for (size_t k = 0; k <= count; ++k) { // none of them, in the end
            assert_true(k == count || bmr_condition_value(&before[k], &now.pose) > 0.0);
            bmr_kds_repair(kds, &now, k, &report);
            assert_int_equal(report.kind, BMR_KDS_NONE);
            assert_true(report.apart && !report.line_changed);
            assert_int_equal(report.level_before, report.level_after);
            assert_int_equal(bmr_kds_conditions(kds, after), count);
            assert_memory_equal(before, after, count * sizeof *before);
        }
        // The control: a repair that is due does something.
        now.pose = test_pose_at(a.polygon, b.polygon, 0.3 + 3.14, 0.5, 0.02); // on the other side
        size_t due = 0;
        while (due < count && bmr_condition_value(&before[due], &now.pose) > 0.0)
            ++due;
        bmr_kds_repair(kds, &now, due, &report);
        assert_int_not_equal(report.kind, BMR_KDS_NONE);
    }
}

/// The last condition of a tangent, and of no features, is that of its length.
TEST(an_inner_tangent_gives_way_to_features_where_its_points_are_too_near) {
    // Edges are shorter than the least length, and so are tangents near the margin.
    own_kds_body a = regular(BMR_MAX_VERTICES), b = regular(BMR_MAX_VERTICES);
    const bmr_kds_def def = bmr_default_kds_def();
    for (int far = 1; far >= 0; --far) {
        own_kds *kds = made_kds(test_structure("inner-tangent"), &def, &a.shape, &b.shape);
        const bmr_instant now = at_gap(&a, &b, def.margin + (far ? 0.1 : 1e-9));
        bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
        bmr_kds_report report;
        bmr_kds_start(kds, &now, &report);
        assert_true(report.apart);
        const size_t count = bmr_kds_conditions(kds, conditions);
        assert_int_equal(conditions[count - 1].kind == BMR_CONDITION_DISKS, far);
        for (size_t k = 0; k < count; ++k)
            assert_true(bmr_condition_value(&conditions[k], &now.pose) > 0.0);
    }
}

/// Theorem 5.2: translations: O(log min{n, D/s}) an event, O(log mu) or O(mu) events.
/// Bytes: no structure's depend on n but those of sums, of binary searches and of tilings.
TEST(the_state_does_not_grow_with_the_polygons_unless_it_says_so) {
    for (size_t i = 0; i < bmr_kds_count(); ++i) {
        size_t bytes[2];
        for (int large = 0; large < 2; ++large) {
            own_kds_body a = regular(large ? 500 : 8), b = other_body(i, large ? 500 : 8);
            const bmr_kds_def def = bmr_default_kds_def();
            own_kds *kds = made(i, &def, &a, &b);
            bytes[large] = bmr_kds_bytes(kds);
        }
        const char *const name = bmr_kds_at(i)->name;
        const bool linear = strstr(name, "sum-") || strstr(name, "-binary-") || strstr(name, "tiling-");
        assert_true(linear ? bytes[1] > 4 * bytes[0] : bytes[1] == bytes[0]);
        assert_true(bytes[0] <= 16384 && (linear || bytes[0] <= 512));
    }
}

/// Vertex against vertex, nearer than any edge's line would allow: the line is the closest direction's own.
/// It is repaired like any other, whether B turns, goes round A, or both.
TEST(a_free_line_is_repaired_like_that_of_an_edge) {
    const double lean = 0.4; // else an edge of the rectangle around would do
    const double quarter = 0.5 * 3.14159265358979323846;
    bmr_vec2 diamond[4];
    for (int k = 0; k < 4; ++k)
        diamond[k] = bmr_vec2_make(cos(lean + quarter * k), sin(lean + quarter * k));
    static const struct {
        double around, turned; ///< quarter turns: where B is, and by how much it has turned
    } ways[] = {{0, 1}, {1, 1}, {1, 2}, {2, 3}, {3, 3}, {2, 2}, {0, 1}, {1, 1}, {2, 1}, {0, 0}};
    for (size_t i = 0; i < bmr_kds_count(); ++i) {
        bmr_polygon *square = made_polygon(diamond, 4);
        own_kds_body a = test_kds_body_make(square), b;
        const bool point = bmr_kds_at(i)->domain == BMR_KDS_POINT;
        if (point) {
            b = test_kds_point_make(0.0, 0.0);
        } else {
            assert_int_equal(bmr_polygon_create(diamond, 4, NULL, &square), BMR_OK);
            b = test_kds_body_make(square);
        }
        bmr_kds_def def = bmr_default_kds_def();
        def.margin = 0.01;
        own_kds *kds = made(i, &def, &a, &b);
        const double away = (point ? 1.0 : 2.0) + 1.05 * def.margin;
        bmr_kds_report report;
        bmr_instant now = {{{away * cos(lean), away * sin(lean)}, 1.0, 0.0}, {0.0, 0.0}, 0.0};
        bmr_kds_start(kds, &now, &report);
        assert_true(report.apart);
        for (size_t k = 0; k < sizeof ways / sizeof *ways; ++k) {
            const double at = lean + quarter * ways[k].around;
            now.pose.position = bmr_vec2_make(away * cos(at), away * sin(at));
            const bool turns = !point && bmr_kds_at(i)->domain == BMR_KDS_RIGID;
            now.pose.c = turns ? cos(quarter * ways[k].turned) : 1.0;
            now.pose.s = turns ? sin(quarter * ways[k].turned) : 0.0;
            bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
            const size_t count = bmr_kds_conditions(kds, conditions);
            for (size_t c = 0; c < count; ++c)
                if (!(bmr_condition_value(&conditions[c], &now.pose) > 0.0)) {
                    bmr_kds_repair(kds, &now, c, &report);
                    assert_true(report.apart);
                    break;
                }
            assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_OK);
        }
    }
}

TEST(no_pose_is_contact_and_no_point_is_an_error) {
    own_kds_body a = regular(8), b = regular(5), point = test_kds_point_make(0.0, 0.0);
    const bmr_kds_def def = bmr_default_kds_def();
    for (size_t i = 0; i < bmr_kds_count(); ++i) {
        own_kds *kds = NULL;
        if (bmr_kds_at(i)->domain == BMR_KDS_POINT)
            assert_int_equal(bmr_kds_create(bmr_kds_at(i), &def, &a.shape, &b.shape, NULL, &kds),
                             BMR_ERROR_OUT_OF_RANGE);
        bmr_shape bare = {.polygon = a.polygon};
        if (bmr_kds_at(i)->hierarchy >= 0)
            assert_int_equal(bmr_kds_create(bmr_kds_at(i), &def, &bare, &point.shape, NULL, &kds),
                             BMR_ERROR_NULL_ARGUMENT);
        assert_null(kds);
        kds = made(i, &def, &a, &point);
        bmr_instant now = at_gap(&a, &point, 0.5);
        bmr_kds_report report;
        bmr_kds_start(kds, &now, &report);
        assert_true(report.apart);
        now.pose.position.x = NAN;
        bmr_kds_repair(kds, &now, 0, &report);
        assert_int_equal(report.kind, BMR_KDS_CONTACT);
        assert_true(bmr_kds_in_contact(kds));
        bmr_kds_repair(kds, &now, 0, &report); // in contact there is nothing to repair
        assert_int_equal(report.kind, BMR_KDS_NONE);
    }
}

/// The control: a proof, made at one pose, is found wrong at another where it does not hold.
TEST(audits_find_a_stale_proof) {
    for (size_t i = 0; i < bmr_kds_count(); ++i)
        for (int step = 1; step < 12; step++) {
            own_kds_body a = regular(20), b = other_body(i, 20);
            const bmr_kds_def def = bmr_default_kds_def();
            own_kds *kds = made(i, &def, &a, &b);
            bmr_kds_report report;
            bmr_instant now = at_gap(&a, &b, 0.01);
            bmr_kds_start(kds, &now, &report);
            assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_OK);
            const bmr_pose other = test_pose_at(a.polygon, b.polygon, 2.8 + 0.1 * step, 0.5, 0.01);
            assert_int_not_equal(bmr_kds_audit(kds, &other), BMR_OK);
        }
}

/// The memory that is set aside for an explicit Minkowski sum (section 5) is enough for every rotation, and
/// linear.
TEST(the_sum_fits_its_block_at_every_rotation) {
    test_random random = test_random_from(6);
    const size_t sizes[] = {3, 4, 5, 8, 9, 33, 64, 300};
    for (int family = 0; family < TEST_FAMILY_COUNT; ++family)
        for (size_t k = 0; k < sizeof sizes / sizeof *sizes; ++k) {
            own_kds_body a = test_kds_body_make(test_polygon((test_family)family, sizes[k], &random));
            own_kds_body b = test_kds_body_make(test_any_polygon(64, &random));
            const bmr_kds_def def = bmr_default_kds_def();
            own_kds *kds = made_kds(test_structure("sum-triangle-dudley"), &def, &a.shape, &b.shape);
            const double n = a.polygon->count + b.polygon->count;
            assert_true((double)bmr_kds_bytes(kds) <= 2048.0 + 340.0 * n);
            for (int turn = 0; turn < 8; ++turn) {
                bmr_instant now = {{{0.0, 0.0}, 1.0, 0.0}, {0.0, 0.0}, 0.0};
                const double angle = 0.25 * turn * 3.14159265358979 * (turn % 3 ? 1.0 : 1.001);
                now.pose.c = cos(angle);
                now.pose.s = sin(angle);
                now.pose.position.x = 4.0 * (a.polygon->extent + b.polygon->extent);
                bmr_kds_report report;
                bmr_kds_start(kds, &now, &report);
                assert_true(report.apart);
                assert_non_null(bmr_point_get(kds)->hierarchy);
                assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_OK);
                // The same rotation again: nothing is built.
                const bmr_hierarchy *built = bmr_point_get(kds)->hierarchy;
                bmr_kds_start(kds, &now, &report);
                assert_ptr_equal(built, bmr_point_get(kds)->hierarchy);
            }
        }
}

TEST(a_wrong_name_is_answered_with_the_names_there_are) {
    static const char *const wrong[] = {"", "lazy", "lazy-dk", "Lazy-Dudley", "lazy-dudley ", "predict-"};
    const bmr_kds_info *const untouched = bmr_kds_at(3);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
        const bmr_kds_info *info = untouched;
        assert_int_equal(bmr_kds_find(wrong[i], &info), BMR_ERROR_UNKNOWN_NAME);
        assert_ptr_equal(info, untouched);
        char text[1024];
        assert_true(bmr_kds_describe_unknown(wrong[i], text, sizeof text) < sizeof text);
        char quoted[32] = "\"";
        strcat(strcat(quoted, wrong[i]), "\"");
        assert_non_null(strstr(text, quoted));
        for (size_t k = 0; k < bmr_kds_count(); ++k)
            assert_non_null(strstr(text, bmr_kds_at(k)->name));
    }
}

TEST(the_sentence_fits_what_it_is_given) {
    char whole[1024], part[64];
    const size_t length = bmr_kds_describe_unknown("x", whole, sizeof whole);
    assert_int_equal(length, strlen(whole));
    assert_int_equal(bmr_kds_describe_unknown("x", NULL, 0), length);
    assert_int_equal(bmr_kds_describe_unknown("x", NULL, 64), length);
    for (size_t size = 0; size <= sizeof part; ++size) {
        memset(part, '#', sizeof part);
        assert_int_equal(bmr_kds_describe_unknown("x", part, size), length);
        if (size > 0) {
            assert_memory_equal(part, whole, size - 1);
            assert_int_equal(part[size - 1], 0);
        }
        for (size_t i = size; i < sizeof part; ++i)
            assert_int_equal(part[i], '#');
    }
    char longer[200];
    memset(longer, 'y', sizeof longer - 1);
    longer[sizeof longer - 1] = 0;
    assert_int_equal(bmr_kds_describe_unknown(longer, NULL, 0), length + 63); // 64 bytes of it, in place of 1
    assert_true(bmr_kds_describe_unknown(NULL, whole, sizeof whole) == length - 1);
}

static const char *const names[] = {"lazy-compass", "lazy-dudley"};
#define NAMES (sizeof names / sizeof *names)

/// A coarser line proves at least this part of what the finer one does (lazy.c), for each level.
#define COARSEN_PART 0.25

typedef struct coarsenings {
    bmr_kds_proof last; ///< after the event before
    double margin;
    size_t thin, poorer; ///< thin: by less than that part; poorer: by less than all of it
} coarsenings;

/// By how much more than the margin the proof's line separates from its nearest corner.
static double proved(const bmr_kds_proof *proof, const bmr_pose *b_in_a, double margin) {
    const bmr_pose other = proof->owner == 0 ? *b_in_a : bmr_pose_inverse(b_in_a);
    return bmr_dot(proof->line.normal, bmr_transform(&other, proof->nearest)) - proof->line.offset - margin;
}

/// At a roll the corner before and the one after lie on one line along the proof's: what the finer line
/// proves is what it proved for the last corner.
static void check_coarsening(void *context, const test_drive_event *event) {
    coarsenings *c = context;
    const bmr_kds_proof before = c->last;
    const bmr_kds_report *report = &event->report;
    if (!bmr_kds_get_proof(event->kds, &c->last) || report->kind != BMR_KDS_ROLL ||
        report->level_after >= report->level_before)
        return;
    const double rounding = 1e-6, finer = proved(&before, &event->now.pose, c->margin),
                 coarser = proved(&c->last, &event->now.pose, c->margin);
    c->thin +=
        coarser < (1.0 - rounding) * pow(COARSEN_PART, report->level_before - report->level_after) * finer;
    c->poorer += coarser < (1.0 - rounding) * finer;
}

TEST(a_coarser_line_after_a_roll_proves_a_good_part) {
    for (size_t i = 0; i < NAMES; ++i) {
        test_random random = test_random_from(505);
        coarsenings all = {.margin = 1e-7};
        for (int round = 0; round < 4; ++round) {
            own_kds_body a = test_kds_body_make(test_polygon(TEST_REGULAR, 1024, &random));
            own_kds_body b = test_kds_body_make(test_polygon(TEST_REGULAR, 1024, &random));
            const test_path path = test_path_make(TEST_PATH_ORBIT, a.polygon, b.polygon,
                                                  0.02 * a.polygon->radius, true, &random);
            const test_drive how = {.path = &path,
                                    .audit_every = 1000,
                                    .margin = all.margin,
                                    .on_event = check_coarsening,
                                    .context = &all};
            driven(names[i], &a, &b, &how);
        }
        assert_int_equal(all.thin, 0);
        assert_true(all.poorer > 0); // the control: some prove less than all
    }
}
