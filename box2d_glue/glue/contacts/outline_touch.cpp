// SPDX-License-Identifier: MIT
#include "boomerang/outline_shape.h"
#include "glue/contacts/outline_whole.h"

namespace bmr {

bool TouchesAlone(const b2Contact &contact) {
    bool alone = true;
    ForEachOfWholes(contact, [&alone](const b2Contact &other, const b2Fixture &, const b2Fixture &) {
        alone = !other.IsTouching();
        return alone;
    });
    return alone;
}

} // namespace bmr
