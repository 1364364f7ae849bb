// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_STEPPING_H
#define BOOMERANG_TESTBED_STEPPING_H

#include <unordered_map>
#include <vector>

#include "boomerang/pair.h"
#include "worlds/run.h"

/// @file
/// What a world would cost, and what it would miss, if it were stepped through time instead: the same bodies
/// on the very paths of a kinetic run, looked at every so often with the sampled structures of
/// boomerang/pair.h.

namespace testbed {

/// For how long after a contact a program that goes by steps has to look, or it misses it: as long as the two
/// would stay within the margin if nobody answered. Screw motions only.
double TimeToNotice(const bmr_contact &contact, const WorldRun &run, const WorldSetup &setup);

/// A contact of a kinetic run, and how long it could be noticed.
struct Noticed {
    double time = 0.0, window = 0.0;
};
/// How many of them steps at 0, h, 2 h, .. miss. O(contacts).
size_t CountMissed(const std::vector<Noticed> &contacts, double h);
/// The largest of the steps longest, 0.98 * longest, .. that misses none.
double FaithfulStep(const std::vector<Noticed> &contacts, double longest);

/// The motions of all bodies in a run, as they followed each other.
class Paths {
public:
    explicit Paths(const WorldSetup &setup);
    /// From this time on.
    void Change(size_t body, double time, const bmr_motion_piece &piece);
    struct Leg {
        double from;
        double origin;
        bmr_screw_motion motion;
    };
    const std::vector<Leg> &Of(size_t body) const { return m_legs[body]; }

private:
    std::vector<std::vector<Leg>> m_legs;
};

/// Steps bodies along their paths. Pairs whose disks are near are in a list (Verlet's), which is made anew,
/// by a grid of one size, when bodies may have moved by its skin; each has a sampled structure, 64 bytes.
class Stepper {
public:
    Stepper(const WorldSetup &setup, const Paths &paths);
    /// To a later time. O(bodies + list) where the list still does.
    void StepTo(double time);

    size_t ListSize() const { return m_pairs.size(); }
    size_t ListsMade() const { return m_lists; }
    size_t Repairs() const { return m_repairs; }
    size_t Touching() const { return m_touching; } ///< pairs within the margin at the last step

private:
    void MoveTo(double time);
    void MakeList();
    void Look();

    const WorldSetup &m_setup;
    const Paths &m_paths;
    std::vector<bmr_shape> m_shapes;
    std::vector<size_t> m_leg;
    std::vector<bmr_pose> m_poses;
    std::vector<bmr_pair> m_pairs;
    std::vector<bmr_pair_bodies> m_bodies;
    std::vector<size_t> m_failed;
    bmr_pair_def m_def;
    double m_time = 0.0, m_moved = 0.0, m_skin, m_largest = 0.0;
    size_t m_lists = 0, m_repairs = 0, m_touching = 0;
};

} // namespace testbed

#endif
