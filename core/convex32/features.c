// SPDX-License-Identifier: MIT
#include "convex32/convex32_collide.h"

static bool same(bmr_feature32 a, bmr_feature32 b) {
    return a.index_a == b.index_a && a.index_b == b.index_b && a.type_a == b.type_a && a.type_b == b.type_b;
}

static int points_of(const bmr_manifold32 *manifold) {
    return manifold->count < 2 ? manifold->count : 2;
}

void bmr_convex32_keep_features(bmr_manifold32 *manifold, const bmr_manifold32 *old, float distance) {
    const int count = points_of(manifold), old_count = points_of(old);
    const bool same_side = manifold->type == old->type;
    bool kept[2] = {false, false}, used[2] = {false, false};
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < old_count && !kept[i]; ++j)
            if (!used[j] && same(manifold->points[i].feature, old->points[j].feature))
                kept[i] = used[j] = true;
    for (int i = 0; i < count && same_side; ++i) {
        if (kept[i])
            continue;
        int nearest = -1;
        float least = distance * distance;
        for (int j = 0; j < old_count; ++j) {
            const float x = manifold->points[i].point.x - old->points[j].point.x;
            const float y = manifold->points[i].point.y - old->points[j].point.y;
            if (!used[j] && x * x + y * y <= least) {
                least = x * x + y * y;
                nearest = j;
            }
        }
        if (nearest >= 0) {
            manifold->points[i].feature = old->points[nearest].feature;
            used[nearest] = true;
        }
    }
    // The one point may have taken over the feature that the other point has by itself. Any other number will
    // do for the other.
    if (count == 2 && same(manifold->points[0].feature, manifold->points[1].feature))
        manifold->points[kept[0] ? 1 : 0].feature.index_b ^= 0x80u;
}
