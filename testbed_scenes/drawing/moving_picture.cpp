// SPDX-License-Identifier: MIT
#include "drawing/moving_picture.h"

#include "drawing/gif.h"
#include "drawing/surface.h"
#include "drawing/webm.h"

namespace testbed {

bool MovingPicture::IsPath(const std::string &path) {
    return EndsWith(path, ".gif") || EndsWith(path, ".webm");
}

std::unique_ptr<MovingPicture> MovingPicture::Make(const std::string &path) {
    return EndsWith(path, ".gif") ? MakeGif(path) : MakeWebm(path);
}

} // namespace testbed
