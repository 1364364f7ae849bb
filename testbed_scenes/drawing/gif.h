// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_GIF_H
#define BOOMERANG_TESTBED_GIF_H

#include "drawing/moving_picture.h"

namespace testbed {

/// See MovingPicture::Make.
std::unique_ptr<MovingPicture> MakeGif(const std::string &path);

} // namespace testbed

#endif
