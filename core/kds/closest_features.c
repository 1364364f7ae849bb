// SPDX-License-Identifier: MIT
// The rival that tracks the closest pair of features (Lin and Canny, Mirtich): Theta(n) events under
// translation and Theta(n^2) under rotation, however far the polygons are apart.
#include "kds/features.h"
#include "kds/registry.h"

typedef struct closest_features {
    bmr_feature_pair pair;
    bmr_pose last; ///< of the last event, for the line that was proved there
} closest_features;

static closest_features *state_of(bmr_kds *kds) {
    return (closest_features *)(void *)kds->state;
}
static const closest_features *view(const bmr_kds *kds) {
    return (const closest_features *)(const void *)kds->state;
}

static bool start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    closest_features *s = state_of(kds);
    s->last = now->pose;
    return bmr_features_start(kds, now, &s->pair, &report->touched);
}

static size_t conditions(const bmr_kds *kds, bmr_condition *c) {
    return bmr_features_conditions(kds, &view(kds)->pair, c);
}

static bool repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    closest_features *s = state_of(kds);
    bmr_condition c[BMR_KDS_MAX_CONDITIONS];
    const size_t count = bmr_features_conditions(kds, &s->pair, c);
    if (failed >= count || !bmr_features_failed(kds, &c[failed], now))
        return true;
    s->last = now->pose;
    report->kind = BMR_KDS_FEATURE;
    report->line_changed = true;
    return bmr_features_repair(kds, now, failed, &s->pair, &report->touched);
}

static void proof_at(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_kds_proof *proof) {
    bmr_features_proof(kds, &view(kds)->pair, b_in_a, proof);
}

static bmr_error prepare(bmr_kds *kds) {
    kds->proof_at = proof_at;
    return BMR_OK;
}

static void proof(const bmr_kds *kds, bmr_kds_proof *proof) {
    proof_at(kds, &view(kds)->last, proof);
}

static bmr_error audit(const bmr_kds *kds, const bmr_pose *b_in_a) {
    return bmr_features_audit(kds, &view(kds)->pair, b_in_a);
}

static const bmr_kds_class implementation = {.state_bytes = sizeof(closest_features),
                                             .prepare = prepare,
                                             .start = start,
                                             .conditions = conditions,
                                             .repair = repair,
                                             .proof = proof,
                                             .audit = audit};

BMR_KDS_INFO(closest_features, .name = "closest-features", .title = "rival: closest pair of features",
             .section = "5, introduction", .domain = BMR_KDS_RIGID, .role = BMR_KDS_RIVAL, .hierarchy = -1,
             .implementation = &implementation);
