// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_WEBM_H
#define BOOMERANG_TESTBED_WEBM_H

#include "drawing/moving_picture.h"

namespace testbed {

/// See MovingPicture::Make. Pictures go raw through a pipe to the ffmpeg of PATH, which writes VP9 with one
/// thread.
std::unique_ptr<MovingPicture> MakeWebm(const std::string &path);

} // namespace testbed

#endif
