// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_COURSE_H
#define BOOMERANG_TESTBED_COURSE_H

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "boomerang/analysis.h"
#include "boomerang/families.h"
#include "boomerang/kds.h"
#include "boomerang/motion.h"
#include "picture/frame.h"

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

/// A file of the user's cannot be read; says where and why: "motion.txt, line 3: ...".
class FileError : public std::invalid_argument {
public:
    using std::invalid_argument::invalid_argument;
};

/// A polygon file: one point a line, "x y", in any order (the hull is taken); # begins a comment.
std::vector<bmr_vec2> ReadPolygonFile(const std::string &path);

struct MotionDeleter {
    void operator()(bmr_motion *motion) const { bmr_motion_destroy(motion); }
};
using MotionPointer = std::unique_ptr<bmr_motion, MotionDeleter>;

/// The motions of A and B, and the time they are to be followed: from `from` until `until`.
struct MotionFile {
    MotionPointer motions[2];
    double from = 0.0, until = 1.0;
};

/// A motion file: one statement a line, as `boomerang-testbed events --help` explains them. Samples and other
/// pieces are not to be mixed.
MotionFile ReadMotionFile(const std::string &path);

/// What two bodies do: a family's motion, or one from a file.
class Course {
public:
    Course(std::shared_ptr<const Body> a, std::shared_ptr<const Body> b, const bmr_family_def &family);
    Course(std::shared_ptr<const Body> a, std::shared_ptr<const Body> b, MotionFile file);

    const Body &BodyOf(int index) const { return *m_bodies[index]; }
    const bmr_motion *Motion(int index) const { return m_file.motions[index].get(); }
    bmr_course AsCourse() const;
    double From() const { return m_file.from; }
    double Until() const { return m_file.until; }
    double Diameter() const { return m_diameter; }
    /// The least separation over the whole course.
    double Separation() const { return m_separation; }
    /// Does the relative rotation change on the way?
    bool IsRigid() const { return m_rigid; }
    bool IsConvex() const { return m_convex; }

private:
    std::shared_ptr<const Body> m_bodies[2];
    MotionFile m_file;
    bool m_rigid = true, m_convex = false;
    double m_diameter = 0.0, m_separation = 0.0;
};

/// With a margin far below the least separation, or the pair would be in contact where it only passes.
bmr_kds_def DefFor(const Course &course);

/// What one structure did on a course.
struct Outcome {
    bmr_run run = {};
    uint64_t outsideEvents = 0; ///< before and after which the level was -1: outside of every envelope
};

using EventObserver = std::function<void(const bmr_simulation_event &)>;

/// Takes the structure along the course. Every proof is audited by brute force at its event where `audit`.
/// Throws std::runtime_error if an audit fails, or if the simulation stalls.
Outcome Follow(const Course &course, const bmr_kds_info &structure, const bmr_kds_def &def, bool audit,
               const EventObserver &observer = {});

/// Does the structure take this course? (A translating one does not take a rotation, a point's no polygon.)
bool Takes(const bmr_kds_info &structure, const Course &course);

// --- frames ---

shown::Vec ToVec(bmr_vec2 v);
std::vector<shown::Vec> ToVecs(const std::vector<bmr_vec2> &points);
/// A body's only fixture, a polygon.
shown::Fixture PolygonOf(int body, const std::vector<bmr_vec2> &vertices);
/// A line that a structure keeps between two polygons at these poses, as a direction with its supports.
shown::Proof LineOf(const bmr_kds_proof &line, const bmr_polygon *const polygons[2], const bmr_pose poses[2]);

/// Takes one structure along a course, every event at its own time, and makes frames of it: of the course's
/// beginning and of `steps` times more, evenly to its end. Body 0 is A, body 1 is B; the pair's proof has the
/// envelopes of its level, where the structure has a hierarchy. Throws std::runtime_error if the simulation
/// fails, and what onFrame throws.
void VisitFrames(const Course &course, const bmr_kds_info &structure, int64_t steps,
                 const std::function<void(const shown::Frame &)> &onFrame);

/// The structure of a name. Throws std::runtime_error.
const bmr_kds_info *StructureNamed(const char *name);

} // namespace testbed

#endif
