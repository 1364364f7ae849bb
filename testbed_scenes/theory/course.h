// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_COURSE_H
#define BOOMERANG_TESTBED_COURSE_H

#include <array>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "boomerang/analysis.h"
#include "boomerang/families.h"
#include "boomerang/kds.h"
#include "boomerang/motion.h"

namespace testbed {

/// Throws what an error code of core means, as a sentence about `what`.
void Require(bmr_error error, const std::string &what);

/// A convex polygon with all three hierarchies, and the chains of those two whose chains are searched: all
/// that its pairs share. Or with none of these.
class Body {
public:
    enum class Hierarchies { All, None };
    /// The hull of the points. Throws std::runtime_error.
    explicit Body(const std::vector<bmr_vec2> &points, Hierarchies hierarchies = Hierarchies::All);

    const bmr_polygon *Polygon() const { return m_polygon.get(); }
    const bmr_hierarchy *Hierarchy(bmr_hierarchy_kind kind) const { return m_hierarchies[kind].get(); }
    bmr_shape Shape() const;
    std::vector<bmr_vec2> Vertices() const;

private:
    struct Deleter {
        void operator()(bmr_polygon *polygon) const { bmr_polygon_destroy(polygon, nullptr); }
        void operator()(bmr_compass *compass) const { bmr_compass_destroy(compass, nullptr); }
        void operator()(bmr_hierarchy *hierarchy) const { bmr_hierarchy_destroy(hierarchy, nullptr); }
        void operator()(bmr_chains *chains) const { bmr_chains_destroy(chains, nullptr); }
    };
    std::unique_ptr<bmr_polygon, Deleter> m_polygon;
    std::unique_ptr<bmr_compass, Deleter> m_compass;
    std::unique_ptr<bmr_hierarchy, Deleter> m_hierarchies[BMR_HIERARCHY_KIND_COUNT];
    std::unique_ptr<bmr_chains, Deleter> m_chains[BMR_HIERARCHY_KIND_COUNT];
};

struct MotionDeleter {
    void operator()(bmr_motion *motion) const { bmr_motion_destroy(motion); }
};
using MotionPointer = std::unique_ptr<bmr_motion, MotionDeleter>;

/// The motions of A and B.
using TwoMotions = std::array<MotionPointer, 2>;

/// What two bodies do from the time 0 to 1: a family's motion, or another.
class Course {
public:
    Course(std::shared_ptr<const Body> a, std::shared_ptr<const Body> b, const bmr_family_def &family);
    Course(std::shared_ptr<const Body> a, std::shared_ptr<const Body> b, TwoMotions motions);

    const Body &BodyOf(int index) const { return *m_bodies[index]; }
    const bmr_motion *Motion(int index) const { return m_motions[static_cast<size_t>(index)].get(); }
    bmr_course AsCourse() const;
    double Diameter() const { return m_diameter; }
    /// The least separation over the whole course; 0: of no family, not measured.
    double Separation() const { return m_separation; }
    /// Does the relative rotation change on the way?
    bool IsRigid() const { return m_rigid; }
    bool IsConvex() const { return m_convex; }

private:
    std::shared_ptr<const Body> m_bodies[2];
    TwoMotions m_motions;
    bool m_rigid = true, m_convex = false;
    double m_diameter = 0.0, m_separation = 0.0;
};

/// With a margin far below the least separation, or the pair would be in contact where it only passes.
bmr_kds_def DefFor(const Course &course);

using EventObserver = std::function<void(const bmr_simulation_event &)>;

/// Takes the structure along the course. Every proof is audited by brute force at its event where `audit`.
/// Throws std::runtime_error if an audit fails, or if the simulation stalls.
bmr_run Follow(const Course &course, const bmr_kds_info &structure, const bmr_kds_def &def, bool audit,
               EventObserver observer = {});

/// Does the structure take this course? (A translating one does not take a rotation, a point's no polygon.)
bool Takes(const bmr_kds_info &structure, const Course &course);

/// The structure of a name. Throws std::runtime_error.
const bmr_kds_info *StructureNamed(const char *name);

} // namespace testbed

#endif
