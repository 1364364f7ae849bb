// SPDX-License-Identifier: MIT
// Re-proving a pair's state from nothing but the polygons (and, for the lazy structures, the hierarchies).
#include "kds/kds.h"

bmr_error bmr_pair_audit(const bmr_pair *pair, const bmr_pair_def *def, const bmr_shape *a,
                         const bmr_shape *b, const bmr_pose *b_in_a) {
    if (!pair || !def || !a || !b || !b_in_a)
        return BMR_ERROR_NULL_ARGUMENT;
    if (pair->state == BMR_PAIR_NEW || pair->state == BMR_PAIR_CONTACT)
        return BMR_OK;
    if (pair->state != BMR_PAIR_APART || pair->owner > 1 || pair->level < BMR_LEVEL_DISKS)
        return BMR_ERROR_INVALID_STRUCTURE;
    if (pair->level == BMR_LEVEL_DISKS)
        return bmr_disks_audit(&pair->certificate, a->polygon, b->polygon, b_in_a);
    const bmr_pose a_in_b = bmr_pose_inverse(b_in_a);
    const bmr_shape *owner = pair->owner == 0 ? a : b, *other = pair->owner == 0 ? b : a;
    const bmr_pose *other_in_owner = pair->owner == 0 ? b_in_a : &a_in_b;
    const bmr_error error =
        bmr_certificate_audit(&pair->certificate, owner->polygon, other->polygon, other_in_owner);
    if (error != BMR_OK)
        return error;
    double gap;
    if (bmr_certificate_check(&pair->certificate, other_in_owner, def->margin, &gap) != BMR_CHECK_HOLDS)
        return BMR_ERROR_FALSE_CERTIFICATE;
    return def->structure == BMR_FREE_DIRECTION || pair->free
               ? bmr_free_audit(pair, owner, other)
               : bmr_lazy_audit(pair, owner, other, other_in_owner);
}
