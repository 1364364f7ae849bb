// SPDX-License-Identifier: MIT
#ifndef BMR_OUTLINE_GROUP_H
#define BMR_OUTLINE_GROUP_H

#include "outline/mesh.h"
#include "outline/optimal.h"

/// Some faces of a mesh whose union is a polygon without holes, to be cut anew.
typedef struct bmr_group {
    bmr_mesh *mesh;
    /// Of each face: the number of the last group that it was in. `number` is that of this group.
    uint32_t *member_of;
    uint32_t number;
    uint32_t faces[BMR_LOOP_MOST];
    uint32_t face_count;
    uint32_t corners[BMR_LOOP_MOST]; ///< the halves on its boundary, counter-clockwise
    uint32_t corner_count;
    bool is_whole; ///< nothing lies behind its boundary
    uint32_t spare[2 * BMR_LOOP_MOST];
} bmr_group;

/// A face and those around it, the nearest first, as long as they are a polygon without holes and of at most
/// `most` corners. False where the face alone has more.
bool bmr_group_gather(bmr_group *group, uint32_t face, uint32_t most);

/// The group as a loop whose corner 0 is a notch, with what its notches see. False where there is no notch:
/// all of it is convex. O(n r) at worst for n corners and r notches, and as many faces.
bool bmr_group_loop(bmr_group *group, bmr_loop *loop);

/// Cuts the group anew, into fewer faces than it has. Their numbers, of those that it had, are `faces` then.
void bmr_group_cut(bmr_group *group, const bmr_cut *cuts, uint32_t count);

#endif
