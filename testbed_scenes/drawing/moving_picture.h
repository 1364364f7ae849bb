// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_MOVING_PICTURE_H
#define BOOMERANG_TESTBED_MOVING_PICTURE_H

#include <memory>
#include <string>

#include "drawing/image.h"

namespace testbed {

/// A file of pictures that follow each other: a GIF, which this program writes itself (on libgif), or a WebM,
/// which it has ffmpeg write. An older file stays until Finish. The same pictures give the same GIF.
class MovingPicture {
public:
    virtual ~MovingPicture() = default;

    /// Whether the path ends in .gif or .webm.
    static bool IsPath(const std::string &path);
    /// Throws std::runtime_error, which says what to install, where this kind cannot be written here.
    static std::unique_ptr<MovingPicture> Make(const std::string &path);

    /// The next picture, and how long it stays, in seconds: hundredths in a GIF (at least two: browsers slow
    /// down what is faster), where what is rounded off goes to the next picture. All pictures have one size.
    /// Throws std::runtime_error.
    virtual void Add(const Image &image, double seconds) = 0;
    /// Once, after the last. Throws std::runtime_error.
    virtual void Finish() = 0;
};

} // namespace testbed

#endif
