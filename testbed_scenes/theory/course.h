// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_COURSE_H
#define BOOMERANG_TESTBED_COURSE_H

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "boomerang/analysis.h"
#include "theory/body.h"
#include "theory/files.h"

namespace testbed {

/// What two bodies do: a family's motion, or one from a file.
class Course {
public:
    Course(std::shared_ptr<const Body> a, std::shared_ptr<const Body> b, const bmr_family_def &family);
    Course(std::shared_ptr<const Body> a, std::shared_ptr<const Body> b, const MotionFile &file);

    const Body &BodyOf(int index) const { return *m_bodies[index]; }
    const bmr_motion *Motion(int index) const { return m_motions[index]; }
    bmr_course AsCourse() const;
    double From() const { return m_from; }
    double Until() const { return m_until; }
    double Diameter() const { return m_diameter; }
    /// The least separation over the whole course.
    double Separation() const { return m_separation; }
    /// Does the relative rotation change on the way?
    bool IsRigid() const { return m_rigid; }
    bool IsConvex() const { return m_convex; }

    Course(const Course &) = delete;
    Course &operator=(const Course &) = delete;
    ~Course();

private:
    void Measure();

    std::shared_ptr<const Body> m_bodies[2];
    bmr_family_motion m_made = {};
    bmr_motion *m_motions[2] = {};
    bool m_owned = false, m_rigid = true, m_convex = false;
    double m_from = 0.0, m_until = 1.0, m_diameter = 0.0, m_separation = 0.0;
};

/// With a margin far below the least separation, or the pair would be in contact where it only passes.
bmr_kds_def DefFor(const Course &course, bmr_kds_def def);

/// From when until when two bodies are in contact (their distance is 0).
struct Contact {
    double from, until;
};
/// Every contact of a course, in order. Looked for by the bodies' speed bounds between 1000 times, so that
/// none is missed; of two of them in one thousandth of the course one may be. Ends are exact to a billionth
/// of it. Throws std::runtime_error.
std::vector<Contact> ContactsOf(const Course &course);

/// What one structure did on a course.
struct Outcome {
    bmr_run run = {};
    uint64_t outsideEvents = 0; ///< before and after which the level was -1: outside of every envelope
    double seconds = 0.0;
};

using EventObserver = std::function<void(const bmr_simulation_event &)>;

/// Takes the structure along the course. Every proof is audited by brute force at its event where `audit`.
/// Throws std::runtime_error if an audit fails, or if the simulation stalls.
Outcome Follow(const Course &course, const bmr_kds_info &structure, const bmr_kds_def &def, bool audit,
               const EventObserver &observer = {});

/// Does the structure take this course? (A translating one does not take a rotation, a point's no polygon.)
bool Takes(const bmr_kds_info &structure, const Course &course);

/// The structure of a name. Throws std::runtime_error with the name and all names there are.
const bmr_kds_info *StructureNamed(const char *name);

} // namespace testbed

#endif
