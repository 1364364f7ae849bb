// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_IMAGE_H
#define BOOMERANG_TESTBED_IMAGE_H

#include <cstdint>
#include <vector>

namespace testbed {

/// Pixels in memory, row by row from the top, each 0xRRGGBB.
struct Image {
    int width = 0, height = 0;
    std::vector<uint32_t> pixels;
};

} // namespace testbed

#endif
