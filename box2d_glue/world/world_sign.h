// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_WORLD_SIGN_H
#define BOOMERANG_GLUE_WORLD_SIGN_H

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "base/private_members.h"

namespace bmr {

/// A number in a world's own memory, in bytes between its members that Box2D never reads. A game that puts
/// the memory of a world back to what it was (rollback) puts the number back with it. A ledger that knows
/// another number then knows another past.
///
/// The process uses no number twice. There are 8 bytes on 64 bits: 7 behind m_allowSleep, and 1 behind
/// m_stepComplete. On 32 bits there are 3 and 1. Two billion steps use up these numbers, and worlds are
/// stepped without a ledger from then on. A compiler that leaves no bytes between members leaves no room.
class WorldSign {
public:
    using Number = uintptr_t;

    /// False where the numbers are used up.
    static bool Renew(b2ContactManager *manager, Number *written);
    static Number Read(const b2ContactManager *manager) {
        const char *const world = WorldOf(manager);
        Number number = 0;
        Visit([&number, world](size_t at, size_t from, size_t bytes) {
            std::memcpy(reinterpret_cast<char *>(&number) + from, world + at, bytes);
        });
        return number;
    }

private:
    template <typename Type> static size_t OffsetOf(Type b2World::*member) {
        size_t offset = 0;
        std::memcpy(&offset, &member, sizeof member); // which is what a pointer to a member holds
        return offset;
    }
    static const char *WorldOf(const b2ContactManager *manager) {
        return reinterpret_cast<const char *>(manager) - OffsetOf(Named(ContactManager()));
    }
    /// visit(offset in the world, offset in the number, bytes) for both pieces.
    template <typename V> static void Visit(const V &visit) {
        const size_t first = OffsetOf(Named(AllowSleep())) + sizeof(bool);
        const size_t second = OffsetOf(Named(StepComplete())) + sizeof(bool);
        const size_t room = OffsetOf(Named(TheDestructionListener())) - first;
        const size_t bytes = room < sizeof(Number) ? room : sizeof(Number);
        const size_t more = OffsetOf(Named(Profile())) - second;
        visit(first, 0, bytes);
        visit(second, bytes, more < sizeof(Number) - bytes ? more : sizeof(Number) - bytes);
    }
};

} // namespace bmr

#endif
