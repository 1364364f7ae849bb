// SPDX-License-Identifier: MIT
// See names.h. The whole class is renamed; hooks/profile_clock.cpp knows what a timer of b2Timer's holds.
#include <new>

#define b2Timer BmrStockTimer
#include BMR_BOX2D_SOURCE
#undef b2Timer

class b2Timer;

namespace bmr {
namespace stock {

void ConstructTimer(b2Timer *timer);
void ResetTimer(b2Timer *timer);
float GetMilliseconds(const b2Timer *timer);

void ConstructTimer(b2Timer *timer) {
    new (static_cast<void *>(timer)) BmrStockTimer();
}

void ResetTimer(b2Timer *timer) {
    reinterpret_cast<BmrStockTimer *>(timer)->Reset();
}

float GetMilliseconds(const b2Timer *timer) {
    return reinterpret_cast<const BmrStockTimer *>(timer)->GetMilliseconds();
}

} // namespace stock
} // namespace bmr
