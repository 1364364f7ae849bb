// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONTACT_NUMBER_H
#define BOOMERANG_GLUE_CONTACT_NUMBER_H

#include <cstdint>

#include <box2d/b2_contact.h>

#include "base/compiler.h"
#include "base/private_members.h"

namespace bmr {

/// A contact's number in the ledger, in the bits of its flags that Box2D does not use: bits 6 to 31 hold the
/// number plus 1. Box2D's constructor writes the flags whole, so that a new contact has no number; everything
/// else in Box2D sets and clears single flags.
struct ContactNumber : b2Contact {
    static constexpr uint32_t kShift = 6, kBox2DsFlags = (1u << kShift) - 1;
    /// So many contacts can have a number at a time.
    static constexpr uint32_t kMost = ~uint32_t{0} >> kShift;
    static_assert(ContactAccess::kAll == kBox2DsFlags);

    /// Ledger::kNone where it has none.
    static uint32_t Read(const b2Contact *contact) {
        return (contact->*(&ContactNumber::m_flags) >> kShift) - 1;
    }
    static void Write(b2Contact *contact, uint32_t number) {
        uint32 &flags = ContactAccess::Flags(contact);
        flags = (flags & kBox2DsFlags) | (number + 1) << kShift;
    }

    /// A contact takes four cache lines, and the next one in a list need not be the next in memory. At the
    /// list's end `contact` is nullptr, which does no harm: addresses are numbers here, because a pointer
    /// must not be moved from nullptr.
    static void Prefetch(const b2Contact *contact) {
        constexpr uintptr_t kLine = 64;
        const uintptr_t first = reinterpret_cast<uintptr_t>(contact);
        for (uintptr_t line = 0; line < 4; ++line)
            BMR_PREFETCH(
                reinterpret_cast<const void *>(first + line * kLine)); // NOLINT(performance-no-int-to-ptr)
    }
};

} // namespace bmr

#endif
