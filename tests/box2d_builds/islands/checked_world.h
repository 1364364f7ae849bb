// SPDX-License-Identifier: MIT
#ifndef BOX2D_BUILDS_CHECKED_WORLD_H
#define BOX2D_BUILDS_CHECKED_WORLD_H

namespace box2d_builds {

/// What was solved twice so far.
struct Checked {
    long islands, impacts, contacts, joints;
    long together; ///< islands that were solved once more, all of a step's at once
    /// A control: so many islands from now on, one bit of what ours left is turned. Never, where it is 0.
    long turnsABitIn;
    bool isInOurs; ///< ours is at work, and Box2D has solved the same island
};
/// In memory that child processes share.
extern Checked &checked;

} // namespace box2d_builds

#endif
