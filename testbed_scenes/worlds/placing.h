// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PLACING_H
#define BOOMERANG_TESTBED_PLACING_H

#include <vector>

#include "boomerang/vector.h"

namespace testbed {

class Dice;

/// Places for disks of these radii in a box, drawn one by one, the largest first, so that no two meet, nor
/// one and a side of the box (in a periodic box: nor one and another's image). False where there was no room
/// after many tries: equal disks take about half of the box. O(disks) for sizes of any ratio.
bool PlaceDisks(const std::vector<double> &radii, bmr_vec2 low, bmr_vec2 high, bool periodic, Dice &dice,
                std::vector<bmr_vec2> *places);

} // namespace testbed

#endif
