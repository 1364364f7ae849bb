// SPDX-License-Identifier: MIT
#include "glue/pairs/marks.h"

#include "base/private_members.h"

namespace bmr {

void Marks::Read(uint32_t i, b2Contact *contact) {
    const uint32 flags = ContactAccess::Flags(contact);
    const int32 count = ContactAccess::CountOfImpacts(contact);
    const bool isKnown = (flags & ContactAccess::kTimeIsKnown) != 0;
    Begin(i);
    if ((flags & ContactAccess::kInIsland) != 0)
        inIsland.Set(i);
    if (isKnown)
        known.Set(i);
    if (count > 0 || (isKnown && ContactAccess::TimeOfImpact(contact) < 1.0f))
        Meet(i, isKnown ? ContactAccess::TimeOfImpact(contact) : 1.0f, static_cast<uint8_t>(count));
}

void Marks::WriteTo(b2Contact *contact, uint32_t i) const {
    uint32 &flags = ContactAccess::Flags(contact);
    flags &= ~(ContactAccess::kInIsland | ContactAccess::kTimeIsKnown);
    flags |= inIsland.Has(i) ? ContactAccess::kInIsland : 0;
    flags |= known.Has(i) ? ContactAccess::kTimeIsKnown : 0;
    ContactAccess::TimeOfImpact(contact) = Time(i);
    ContactAccess::CountOfImpacts(contact) = CountOf(i);
}

} // namespace bmr
