// SPDX-License-Identifier: MIT
#include "glue/pairs/pair_tables.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "base/compiler.h"
#include "base/memory.h"
#include "base/private_members.h"
#include "start/install.h"

namespace bmr {

std::atomic<uint64_t> internal::changesOfPairTables{0};

namespace {

/// A number in a world's own memory, in bytes between its members that Box2D never reads. A game that puts
/// the memory of a world back to what it was (rollback) puts the number back with it. A table that knows
/// another number then knows another past.
///
/// The process uses no number twice. There are 8 bytes on 64 bits: 7 behind m_allowSleep, and 1 behind
/// m_stepComplete. On 32 bits there are 3 and 1. Two billion steps use up these numbers, and worlds are
/// stepped without a table from then on. A compiler that leaves no bytes between members leaves no room.
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
        const size_t gap = OffsetOf(Named(TheDestructionListener())) - first;
        const size_t bytes = gap < sizeof(Number) ? gap : sizeof(Number);
        const size_t more = OffsetOf(Named(Profile())) - second;
        visit(first, 0, bytes);
        visit(second, bytes, more < sizeof(Number) - bytes ? more : sizeof(Number) - bytes);
    }
};

/// No two of the process are the same. Each thread takes many at a time: threads that step small worlds would
/// wait for each other otherwise.
uint64_t NextNumber() {
    constexpr uint64_t kAtOnce = 1024;
    static std::atomic<uint64_t> taken{0};
    static thread_local uint64_t last = 0;
    if (last % kAtOnce == 0)
        last = taken.fetch_add(kAtOnce, std::memory_order_relaxed);
    return ++last;
}

bool WorldSign::Renew(b2ContactManager *manager, Number *written) {
    const uint64_t next = NextNumber();
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

struct Entry : PairTable {
    using PairTable::PairTable;
    static void *operator new(size_t bytes) { return TakeMemory(nullptr, bytes); }
    static void operator delete(void *entry) { std::free(entry); }
    void Leave() { m_left = true; }
    WorldSign::Number sign = 0;
    Entry *next = nullptr;
    bool isDropped = false; ///< and goes with the last hold
};

// Chains of worlds, by address. Programs have a few; some have thousands.
constexpr uint32_t kChainBits = 10;
Entry *chains[1u << kChainBits];

struct Remembered {
    const b2ContactManager *manager;
    Entry *table;
    uint64_t changes;
};
thread_local Remembered remembered = {nullptr, nullptr, 0};

/// The link that leads to it, or the chain's last. Locked.
Entry **LinkTo(const b2ContactManager *manager) {
    const uint64_t mixed = static_cast<uint64_t>(reinterpret_cast<uintptr_t>(manager)) * 0x9e3779b97f4a7c15u;
    Entry **link = &chains[mixed >> (64u - kChainBits)];
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
    internal::changesOfPairTables.fetch_add(1, std::memory_order_release);
    ended->Leave();
    ended->isDropped = true;
    if (!ended->IsHeld())
        delete ended;
}

/// One that the world has left is found, too.
Entry *FindAnyEntry(const b2ContactManager *manager) {
    const uint64_t now = internal::changesOfPairTables.load(std::memory_order_acquire);
    if (remembered.manager != manager || remembered.changes != now) {
        const HoldsProcessLock lock;
        remembered = {manager, *LinkTo(manager), now};
    }
    Entry *const table = remembered.table;
    if (BMR_RARELY(table != nullptr && table->sign != WorldSign::Read(manager))) {
        Drop(manager);
        return nullptr;
    }
    return table;
}

} // namespace

PairTable *internal::FindPairTableOfSome(const b2ContactManager *manager) {
    Entry *const table = FindAnyEntry(manager);
    return table != nullptr && !table->WasLeft() ? table : nullptr;
}

PairTable *FindAndSignPairTable(b2ContactManager *manager) {
    auto *const table = static_cast<Entry *>(FindPairTable(manager));
    if (table == nullptr || WorldSign::Renew(manager, &table->sign))
        return table;
    Drop(manager);
    return nullptr;
}

PairTable *MakePairTable(b2ContactManager *manager) {
    if (Entry *const table = FindAnyEntry(manager))
        return table->WasLeft() ? nullptr : table;
    auto *const made = new Entry(manager);
    if (!WorldSign::Renew(manager, &made->sign)) {
        delete made;
        return nullptr;
    }
    const HoldsProcessLock lock;
    *LinkTo(manager) = made;
    internal::changesOfPairTables.fetch_add(1, std::memory_order_release);
    return made;
}

PairTable *PairTableForStep(b2ContactManager *manager) {
    DropPairTableOfEmpty(manager);
    if (const Entry *const entry = FindAnyEntry(manager)) {
        if (entry->IsHeld())
            return nullptr;
        if (entry->WasLeft())
            Drop(manager);
    }
    if (PairTable *const table = FindAndSignPairTable(manager))
        return table;
    return manager->m_contactCount >= CostOfAPass() ? MakePairTable(manager) : nullptr;
}

void DropPairTableOfEmpty(const b2ContactManager *manager) {
    if (manager->m_contactCount > 0 || !AnyPairTable())
        return;
    const Entry *const table = FindAnyEntry(manager);
    if (table != nullptr && !table->IsHeld())
        Drop(manager);
}

void LeaveTable(const b2ContactManager *manager) {
    if (PairTable *const table = FindPairTable(manager)) {
        table->GiveMarksBack();
        static_cast<Entry *>(table)->Leave();
    }
}

PairTable::Hold::~Hold() {
    if (m_table == nullptr)
        return;
    if (!m_complete && !m_table->WasLeft())
        LeaveTable(m_table->m_manager);
    auto *const entry = static_cast<Entry *>(m_table);
    if (--m_table->m_holds == 0 && entry->isDropped)
        delete entry;
}

void PairTable::Ending::Complete() {
    if (m_number != kNone && !m_table->WasLeft() && m_table->m_contacts[m_number] == m_contact)
        m_table->Remove(m_number);
    Hold::Complete();
}

void DropPairTable(const b2ContactManager *manager) {
    if (AnyPairTable())
        Drop(manager);
}

void Forget(b2World *world) {
    if (world != nullptr)
        DropPairTable(&world->GetContactManager());
}

} // namespace bmr
