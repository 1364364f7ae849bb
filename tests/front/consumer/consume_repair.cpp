// SPDX-License-Identifier: MIT
#include <boomerang/repair.h>

int main() {
    const bmr_vec2 bow[] = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
    bmr::Outline drawn;
    drawn.AddRing(bow, 4);
    std::vector<bmr::Outline> repaired;
    return bmr::RepairOutline(drawn, bmr::FillRule::EvenOdd, 0.01, &repaired) == BMR_OK &&
                   repaired.size() == 2
               ? 0
               : 1;
}
