// SPDX-License-Identifier: MIT
// What a coarser line of the lazy structures of two polygons proves (section 5).
#include "checks.h"
#include "kds_driver.h"
#include "motions.h"
#include "structure_named.h"

static const char *const names[] = {"lazy-compass", "lazy-dudley"};
#define NAMES (sizeof names / sizeof *names)

/// A coarser line proves at least this part of what the finer one does (lazy.c), for each level.
#define COARSEN_PART 0.25

typedef struct coarsenings {
    bmr_kds_proof last; ///< after the event before
    double margin;
    size_t seen, thin, poorer; ///< thin: by less than that part; poorer: by less than all of it
} coarsenings;

/// By how much more than the margin the proof's line separates from its nearest corner.
static double proved(const bmr_kds_proof *proof, const bmr_pose *b_in_a, double margin) {
    const bmr_pose other = proof->owner == 0 ? *b_in_a : bmr_pose_inverse(b_in_a);
    return bmr_dot(proof->line.normal, bmr_transform(&other, proof->nearest)) - proof->line.offset - margin;
}

/// At a roll the corner before and the one after lie on one line along the proof's: what the finer line
/// proves is what it proved for the last corner.
static void look_at_coarsening(void *context, const test_drive_event *event) {
    coarsenings *c = context;
    const bmr_kds_proof before = c->last;
    const bmr_kds_report *report = &event->report;
    if (!bmr_kds_get_proof(event->kds, &c->last) || report->kind != BMR_KDS_ROLL ||
        report->level_after >= report->level_before)
        return;
    const double rounding = 1e-6, finer = proved(&before, &event->now.pose, c->margin),
                 coarser = proved(&c->last, &event->now.pose, c->margin);
    ++c->seen;
    c->thin +=
        coarser < (1.0 - rounding) * pow(COARSEN_PART, report->level_before - report->level_after) * finer;
    c->poorer += coarser < (1.0 - rounding) * finer;
}

TEST(a_coarser_line_after_a_roll_proves_a_good_part) {
    for (size_t i = 0; i < NAMES; ++i) {
        test_random random = {505};
        bmr_kds_def def = bmr_default_kds_def();
        def.margin = 1e-7;
        coarsenings all = {.margin = def.margin};
        for (int round = 0; round < 4; ++round) {
            own_kds_body a = test_kds_body_make(test_polygon(TEST_REGULAR, 1024, &random));
            own_kds_body b = test_kds_body_make(test_polygon(TEST_REGULAR, 1024, &random));
            const test_path path = test_path_make(TEST_PATH_ORBIT, a.polygon, b.polygon,
                                                  0.02 * a.polygon->radius, true, &random);
            const test_drive how = {.path = &path,
                                    .audit_every = 1000,
                                    .margin = def.margin,
                                    .on_event = look_at_coarsening,
                                    .context = &all};
            own_kds *kds = made_kds(test_structure(names[i]), &def, &a.shape, &b.shape);
            const test_drive_result r = test_drive_run(kds, a.polygon, b.polygon, &how);
            assert_true(test_drive_is_sound(&r));
        }
        assert_int_equal(all.thin, 0);
        assert_true(all.poorer > 0); // the control: some prove less than all
    }
}
