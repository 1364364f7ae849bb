// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_FILES_H
#define BOOMERANG_TESTBED_FILES_H

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "boomerang/motion.h"

namespace testbed {

/// What is wrong with a file that somebody wrote: "motion.txt, line 3: ...".
class FileError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
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

/// A motion file: one statement a line, # begins a comment. Angles are in radians.
///
///     time FROM UNTIL                        the times to follow (default 0 1)
///     body A | body B                        whose motion the following lines tell; a body without any rests
///     rest T X Y ANGLE                       from time T on it stands still
///     screw T X Y ANGLE VX VY SPIN           from T on: a straight line, a constant spin
///     algebraic T ANGLE x X0 X1.. y Y0 Y1.. [a A0 A1.. b B0 B1..]
///                                            from T on, with u = t - T: position (sum Xk u^k, sum Yk u^k),
///                                            turned by ANGLE and by 2 atan2(sum Bk u^k, sum Ak u^k)
///     sample T X Y ANGLE                     screws from sample to sample; not to be mixed with the others
MotionFile ReadMotionFile(const std::string &path);

} // namespace testbed

#endif
