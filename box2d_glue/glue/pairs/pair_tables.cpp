// SPDX-License-Identifier: MIT
#include "glue/pairs/pair_tables.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "base/compiler.h"
#include "base/memory.h"
#include "base/private_members.h"
#include "glue/pairs/pair_table.h"
#include "start/current_step.h"
#include "start/install.h"

namespace bmr {

std::atomic<uint64_t> internal::changesOfLedgers{0};

namespace {

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
struct Entry : Ledger {
    using Ledger::Ledger;
    static void *operator new(size_t bytes) { return TakeMemory(nullptr, bytes); }
    static void operator delete(void *entry) { std::free(entry); }
    void Leave() { m_left = true; }
    WorldSign::Number sign = 0;
    Entry *next = nullptr;
};

// Chains of worlds, by address. Programs have a few; some have thousands.
constexpr uint32_t kChainBits = 10;
Entry *chains[1u << kChainBits];

struct Remembered {
    const b2ContactManager *manager;
    Entry *ledger;
    uint64_t changes;
};
thread_local Remembered remembered = {nullptr, nullptr, 0};

Entry **ChainOf(const b2ContactManager *manager) {
    const uint64_t mixed = static_cast<uint64_t>(reinterpret_cast<uintptr_t>(manager)) * 0x9e3779b97f4a7c15u;
    return &chains[mixed >> (64u - kChainBits)];
}

/// The link that leads to it, or the chain's last. Locked.
Entry **LinkTo(const b2ContactManager *manager) {
    Entry **link = ChainOf(manager);
    while (*link != nullptr && (*link)->Manager() != manager)
        link = &(*link)->next;
    return link;
}

void Drop(const b2ContactManager *manager) {
    const HoldsProcessLock lock;
    Entry **link = LinkTo(manager);
    Entry *const ended = *link;
    if (ended == nullptr)
        return;
    *link = ended->next;
    internal::changesOfLedgers.fetch_add(1, std::memory_order_release);
    ended->Leave();
    if (!ended->IsInPass())
        delete ended;
}

} // namespace

Ledger *internal::FindLedgerOfSome(const b2ContactManager *manager) {
    const uint64_t now = changesOfLedgers.load(std::memory_order_acquire);
    if (remembered.manager != manager || remembered.changes != now) {
        const HoldsProcessLock lock;
        remembered = {manager, *LinkTo(manager), now};
    }
    Entry *const ledger = remembered.ledger;
    if (BMR_RARELY(ledger != nullptr && ledger->sign != WorldSign::Read(manager))) {
        Drop(manager);
        return nullptr;
    }
    return ledger;
}

Ledger *FindAndSignLedger(b2ContactManager *manager) {
    auto *const ledger = static_cast<Entry *>(FindLedger(manager));
    if (ledger == nullptr || WorldSign::Renew(manager, &ledger->sign))
        return ledger;
    Drop(manager);
    return nullptr;
}

Ledger *MakeLedger(b2ContactManager *manager) {
    if (Ledger *ledger = FindLedger(manager))
        return ledger;
    auto *const made = new Entry(manager);
    if (!WorldSign::Renew(manager, &made->sign)) {
        delete made;
        return nullptr;
    }
    const HoldsProcessLock lock;
    *LinkTo(manager) = made;
    internal::changesOfLedgers.fetch_add(1, std::memory_order_release);
    return made;
}

Ledger *LedgerForStep(b2ContactManager *manager) {
    DropLedgerOfEmpty(manager);
    if (Ledger *const ledger = FindAndSignLedger(manager))
        return ledger;
    return manager->m_contactCount >= CostOfAPass() ? MakeLedger(manager) : nullptr;
}

void DropLedgerOfEmpty(const b2ContactManager *manager) {
    if (manager->m_contactCount > 0)
        return;
    const Ledger *const ledger = FindLedger(manager);
    if (ledger != nullptr && !ledger->IsInPass())
        Drop(manager);
}

void LeaveTable(const b2ContactManager *manager) {
    if (Ledger *const ledger = FindLedger(manager)) {
        ledger->GiveMarksBack();
        Drop(manager);
    }
}

Ledger::Pass::~Pass() {
    if (!m_complete && !m_ledger->WasLeft())
        LeaveTable(m_ledger->m_manager);
    if (--m_ledger->m_passes == 0 && m_ledger->WasLeft())
        delete static_cast<Entry *>(m_ledger);
}

void Ledger::Ending::Complete() {
    if (!m_ledger->WasLeft())
        m_ledger->Remove(m_number, m_contact);
    else
        DropLedger(m_ledger->m_manager); // made by a step meanwhile: it may know the contact
    Pass::Complete();
}

void DropLedger(const b2ContactManager *manager) {
    if (AnyLedger())
        Drop(manager);
}

void Forget(b2World *world) {
    if (world != nullptr)
        DropLedger(&world->GetContactManager());
}

} // namespace bmr
