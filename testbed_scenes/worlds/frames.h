// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_WORLD_FRAMES_H
#define BOOMERANG_TESTBED_WORLD_FRAMES_H

#include <vector>

#include "picture/frame.h"
#include "worlds/run.h"

namespace testbed {

/// A kinetic world as frames for pictures, one at each look. Of a frame
///   - bodies are the world's, and four static ones after them, the walls; in a periodic box they are taken
///     back into it;
///   - the hulls that proofs name are the bodies' disks;
///   - boxes are the cells that bodies live in;
///   - pairs are those that the world watches. Those whose bodies are neighbours across a side of a periodic
///     box have no proof here, for nothing can be drawn between them;
///   - touching are the contacts since the frame before, at their own times;
///   - events are those of pairs, in the words of structures (near: "start"), and "part".
class WorldFrames {
public:
    explicit WorldFrames(const WorldSetup &setup) : m_setup(setup) {}

    /// All that happens between frames, as the run tells it.
    void Add(const bmr_contact &contact);
    void Add(const bmr_world_event &event);
    shown::Frame Take(const WorldRun &run);

private:
    int NumberOf(bmr_body body) const;
    /// How often the box lies between where the world has a body and where it is shown.
    bmr_vec2 Wrapped(bmr_vec2 position) const;
    void AddBodies(const WorldRun &run);
    void AddWalls();
    void AddPair(const bmr_world_pair &pair, const WorldRun &run);
    void SetClosest(const bmr_world_pair &pair, const WorldRun &run, shown::Pair *record) const;
    bmr_pose OtherPose(const bmr_world_pair &pair, const WorldRun &run) const;
    bmr_vec2 FootOn(bmr_body wall, bmr_vec2 place) const;
    shown::Proof DisksProof(const bmr_world_pair &pair, const WorldRun &run) const;
    shown::Proof LineProof(const bmr_world_pair &pair, const WorldRun &run) const;
    void AddDisk(int body, double radius);
    shown::Proof ProofOf(const bmr_world_pair &pair, const WorldRun &run) const;

    const WorldSetup &m_setup;
    int64_t m_step = 0;
    shown::Frame m_frame; ///< the next
};

} // namespace testbed

#endif
