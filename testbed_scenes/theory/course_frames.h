// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_COURSE_FRAMES_H
#define BOOMERANG_TESTBED_COURSE_FRAMES_H

#include <functional>

#include "picture/frame.h"
#include "theory/course.h"

namespace testbed {

/// Takes one structure along a course, every event at its own time, and makes frames of it: of the course's
/// beginning and of `steps` times more, evenly to its end. Body 0 is A, body 1 is B; the pair's proof has the
/// envelopes of its level, where the structure has a hierarchy. Throws std::runtime_error if the simulation
/// fails, and what onFrame throws.
void VisitFrames(const Course &course, const bmr_kds_info &structure, int64_t steps,
                 const std::function<void(const shown::Frame &)> &onFrame);

} // namespace testbed

#endif
