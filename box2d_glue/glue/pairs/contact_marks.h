// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONTACT_MARKS_H
#define BOOMERANG_GLUE_CONTACT_MARKS_H

#include "glue/pairs/marks.h"
#include "glue/pairs/pair_table.h"
#include "glue/pairs/pair_tables.h"

namespace bmr {

/// Box2D's marks at contacts, wherever they are: in the world's ledger (glue/pairs/marks.h) or in the
/// contact.
class ContactMarks {
public:
    explicit ContactMarks(const b2ContactManager *manager) : m_manager(manager) { LookAgain(); }
    /// The game may have run: the world may have a ledger by now.
    void LookAgain() { m_ledger = FindLedger(m_manager); }

    bool IsInIsland(b2Contact *contact) const {
        const uint32_t i = Number(contact);
        return i != Ledger::kNone ? Here().inIsland.Has(i)
                                  : (ContactAccess::Flags(contact) & ContactAccess::kInIsland) != 0;
    }
    void PutInIsland(b2Contact *contact) {
        const uint32_t i = Number(contact);
        if (i != Ledger::kNone)
            Here().inIsland.Set(i);
        else
            ContactAccess::Flags(contact) |= ContactAccess::kInIsland;
    }
    void TakeOutOfIsland(b2Contact *contact) {
        const uint32_t i = Number(contact);
        if (i != Ledger::kNone)
            Here().inIsland.Clear(i);
        else
            ContactAccess::Flags(contact) &= ~ContactAccess::kInIsland;
    }
    bool IsTimeKnown(b2Contact *contact) const {
        const uint32_t i = Number(contact);
        return i != Ledger::kNone ? Here().known.Has(i)
                                  : (ContactAccess::Flags(contact) & ContactAccess::kTimeIsKnown) != 0;
    }
    void ForgetTime(b2Contact *contact) {
        const uint32_t i = Number(contact);
        if (i != Ledger::kNone) {
            Here().known.Clear(i);
            Here().asked.Set(i);
        } else {
            ContactAccess::Flags(contact) &= ~ContactAccess::kTimeIsKnown;
        }
    }
    float Time(b2Contact *contact) const {
        const uint32_t i = Number(contact);
        return i != Ledger::kNone ? Here().Time(i) : ContactAccess::TimeOfImpact(contact);
    }
    void SetTime(b2Contact *contact, float time) {
        const uint32_t i = Number(contact);
        if (i != Ledger::kNone) {
            if (time < 1.0f || Here().met.Has(i))
                Here().Meet(i, time, Here().CountOf(i));
            Here().known.Set(i);
        } else {
            ContactAccess::TimeOfImpact(contact) = time;
            ContactAccess::Flags(contact) |= ContactAccess::kTimeIsKnown;
        }
    }
    void CountImpact(b2Contact *contact) {
        const uint32_t i = Number(contact);
        if (i != Ledger::kNone)
            Here().Meet(i, Here().Time(i), static_cast<uint8_t>(Here().CountOf(i) + 1));
        else
            ++ContactAccess::CountOfImpacts(contact);
    }
    /// As b2World::SolveTOI begins.
    void ForgetImpact(b2Contact *contact) {
        const uint32_t i = Number(contact);
        if (i != Ledger::kNone) {
            Here().Begin(i);
            return;
        }
        ContactAccess::Flags(contact) &= ~(ContactAccess::kTimeIsKnown | ContactAccess::kInIsland);
        ContactAccess::CountOfImpacts(contact) = 0;
        ContactAccess::TimeOfImpact(contact) = 1.0f;
    }

private:
    Marks &Here() const { return m_ledger->GetMarks(); }
    /// kNone: its marks are in the contact.
    uint32_t Number(const b2Contact *contact) const {
        return m_ledger != nullptr && m_ledger->GetMarks().areHere ? m_ledger->NumberOf(contact)
                                                                   : Ledger::kNone;
    }

    const b2ContactManager *m_manager;
    Ledger *m_ledger = nullptr;
};

} // namespace bmr

#endif
