// SPDX-License-Identifier: MIT
#include "world/world_sign.h"

#include "start/current_step.h"

namespace bmr {

bool WorldSign::Renew(b2ContactManager *manager, Number *written) {
    const uint64_t next = NextStep();
    const auto number = static_cast<Number>(next);
    if (number != next)
        return false;
    char *const world = const_cast<char *>(WorldOf(manager));
    Visit([number, world](size_t at, size_t from, size_t bytes) {
        std::memcpy(world + at, reinterpret_cast<const char *>(&number) + from, bytes);
    });
    *written = Read(manager);
    return true;
}

} // namespace bmr
