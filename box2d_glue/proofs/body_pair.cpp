// SPDX-License-Identifier: MIT
#include "proofs/body_pair.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>

#include <box2d/b2_block_allocator.h>

#include "proofs/thresholds.h"
#include "start/settings.h"
#include "tell/event.h"

namespace bmr {

namespace {

// Box2D's blocks are aligned to 16 bytes: room to move the object to a cache line of its own.
constexpr int32 kBlockBytes = sizeof(BodyPair) + 48;

// A pair whose hulls overlap is asked again after 1, 2, 4, ... this many new poses: an answer there costs
// about as much as one separation test and saves nothing, while two hulls that part are noticed a sixth of a
// second late at worst.
constexpr uint8_t kMostPatience = 3;

bmr_pose Pose(const b2Transform &xf) {
    return {{static_cast<double>(xf.p.x), static_cast<double>(xf.p.y)},
            static_cast<double>(xf.q.c),
            static_cast<double>(xf.q.s)};
}

/// Equal to no pose of a working simulation; and the verdict beside it is the safe one.
b2Transform NoPose() {
    b2Transform xf;
    xf.p.x = xf.p.y = xf.q.s = xf.q.c = std::numeric_limits<float>::quiet_NaN();
    return xf;
}

bool SamePose(const b2Transform &a, const b2Transform &b) {
    // The same bits, NaNs too: four floats without padding.
    return std::memcmp(&a, &b, sizeof a) == 0; // NOLINT(bugprone-suspicious-memory-comparison)
}

void OnEvent(void *context, const bmr_event *event) {
    const auto *pair = static_cast<const BodyPair *>(context);
    TellOfEvent(pair->a->body, pair->b->body, *event);
}

bmr_pair_def DefOf(const BodyPair &pair) {
    bmr_pair_def def = GetSettings().pairDef;
    def.margin = ContactMargin(static_cast<double>(pair.radiusSum));
    return def;
}

bmr_answer Advance(BodyPair *pair, const bmr_pose &pose) {
    const bmr_pair_def def = DefOf(*pair);
    if (!GetSettings().options.statistics) {
        // A rebuilt hull resets its pairs, so a certificate that is here is of these two hulls: the quick
        // look need not read them.
        double gap;
        if (bmr_pair_takes(&pose) && bmr_pair_check(&pair->kinetic, &pose, def.margin, &gap))
            return BMR_APART;
        return bmr_pair_advance(&pair->kinetic, &def, &pair->a->shape, &pair->b->shape, &pose, nullptr,
                                nullptr);
    }
    bmr_counters counters = {};
    const bmr_observer observer = {&counters, OnEvent, pair};
    const bmr_answer answer =
        bmr_pair_advance(&pair->kinetic, &def, &pair->a->shape, &pair->b->shape, &pose, &observer, nullptr);
    GetCounts().hullChecks.fetch_add(counters.checks, std::memory_order_relaxed);
    return answer;
}

bmr_answer Ask(BodyPair *pair, const b2Transform &poseA, const b2Transform &poseB) {
    if (pair->unasked > 0) {
        --pair->unasked;
        return BMR_STAB_POLYGON;
    }
    if (!WithinReach(poseA, pair->a->reach) || !WithinReach(poseB, pair->b->reach))
        return BMR_STAB_POLYGON;
    const bmr_pose a = Pose(poseA), b = Pose(poseB);
    const bmr_pose relative = bmr_pose_relative(&a, &b);
    const bmr_answer answer = Advance(pair, relative);
    if (answer == BMR_APART) {
        pair->patience = 0;
    } else {
        pair->unasked = static_cast<uint8_t>((1u << pair->patience) - 1u);
        pair->patience = std::min<uint8_t>(static_cast<uint8_t>(pair->patience + 1), kMostPatience);
    }
    return answer;
}

/// Takes a copy of the pair's kinetic pair to these poses; what is proved there, less the rounding of the
/// poses.
double AdvanceCopy(const BodyPair &pair, const bmr_pair_def &def, const b2Transform &poseA,
                   const b2Transform &poseB, bmr_pair *copy) {
    if (pair.a->shape.polygon == nullptr || pair.b->shape.polygon == nullptr ||
        !WithinReach(poseA, pair.a->reach) || !WithinReach(poseB, pair.b->reach))
        return 0.0;
    const bmr_pose a = Pose(poseA), b = Pose(poseB);
    const bmr_pose relative = bmr_pose_relative(&a, &b);
    double gap = 0.0;
    const bmr_answer answer =
        bmr_pair_advance(copy, &def, &pair.a->shape, &pair.b->shape, &relative, nullptr, &gap);
    return answer == BMR_APART ? gap - kRoundingMargin : 0.0;
}

} // namespace

BodyPair *CreateBodyPair(Hull *a, Hull *b, BodyPair *parent, b2BlockAllocator *allocator) {
    char *block = static_cast<char *>(allocator->Allocate(kBlockBytes));
    const size_t offset = (64 - reinterpret_cast<uintptr_t>(block) % 64) % 64;
    BodyPair *pair = new (block + offset) BodyPair();
    pair->offset = static_cast<uint8_t>(offset);
    pair->a = a;
    pair->b = b;
    pair->parent = parent;
    pair->references = 0;
    pair->stamp = 0;
    ResetBodyPair(pair);
    Count(&Counts::structures);
    return pair;
}

void ReleaseBodyPair(BodyPair *pair, b2BlockAllocator *allocator) {
    if (--pair->references > 0)
        return;
    ReleaseHull(pair->a);
    ReleaseHull(pair->b);
    if (pair->parent != nullptr)
        ReleaseBodyPair(pair->parent, allocator);
    allocator->Free(reinterpret_cast<char *>(pair) - pair->offset, kBlockBytes);
}

void ResetBodyPair(BodyPair *pair) {
    bmr_pair_init(&pair->kinetic);
    ++pair->stamp;
    pair->radiusSum = pair->a->radius + pair->b->radius;
    // No transform of Box2D's equals this one: the first question is always answered afresh.
    pair->poseA = pair->poseB = NoPose();
    pair->verdict = BMR_STAB_POLYGON;
    pair->patience = 0;
    pair->unasked = 0;
}

bool KnownApart(BodyPair *pair, const b2Transform &poseA, const b2Transform &poseB) {
    if (SamePose(poseA, pair->poseA) && SamePose(poseB, pair->poseB)) {
        Count(&Counts::verdictsReused);
        return pair->verdict == BMR_APART;
    }
    pair->poseA = poseA;
    pair->poseB = poseB;
    pair->verdict = static_cast<uint8_t>(Ask(pair, poseA, poseB));
    return pair->verdict == BMR_APART;
}

double CertifiedGap(const BodyPair &pair, const b2Transform &poseA, const b2Transform &poseB) {
    bmr_pair_def def = DefOf(pair);
    def.margin = kRoundingMargin; // what float poses may be off by
    def.hysteresis = 0.0;
    bmr_pair copy = pair.kinetic;
    return AdvanceCopy(pair, def, poseA, poseB, &copy);
}

bmr_pair KineticPairAt(const BodyPair &pair, const b2Transform &poseA, const b2Transform &poseB,
                       double *gap) {
    bmr_pair copy = pair.kinetic;
    *gap = AdvanceCopy(pair, DefOf(pair), poseA, poseB, &copy);
    return copy;
}

} // namespace bmr
