// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_INTERPOSE_CONTACT_INDEX_H
#define BOOMERANG_INTERPOSE_CONTACT_INDEX_H

#include <cstdint>

#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "per_thread.h"

namespace bmr::interpose {

/// Words with a number each, forgotten all at once. Open addressing; never more than half full.
class Table {
public:
    Table() = default;
    ~Table();
    Table(const Table &) = delete;
    Table &operator=(const Table &) = delete;

    void Clear();
    uint32_t Count() const { return m_count; }

    /// The number of this word, nullptr where it is not there.
    uint32_t *Find(uint64_t word) {
        if (m_count == 0)
            return nullptr;
        for (uint32_t at = Start(word);; at = (at + 1) & (m_capacity - 1)) {
            Slot &slot = m_slots[at];
            if (slot.round != m_round)
                return nullptr;
            if (slot.word == word)
                return &slot.number;
        }
    }

    /// Puts it in with 0, if it is not there. nullptr without memory.
    uint32_t *Add(uint64_t word) {
        if (2 * (m_count + 1) > m_capacity && !Grow())
            return nullptr;
        uint32_t at = Start(word);
        for (; m_slots[at].round == m_round; at = (at + 1) & (m_capacity - 1))
            if (m_slots[at].word == word)
                return &m_slots[at].number;
        m_slots[at] = {word, m_round, 0};
        ++m_count;
        return &m_slots[at].number;
    }

private:
    struct Slot {
        uint64_t word;
        uint32_t round, number;
    };

    uint32_t Start(uint64_t word) const {
        constexpr uint64_t kMix = 0x9e3779b97f4a7c15u; // the golden ratio's bits spread neighbours apart
        return static_cast<uint32_t>((word * kMix) >> 32) & (m_capacity - 1);
    }

    bool Grow();

    static constexpr uint32_t kFirstCapacity = 256;
    Slot *m_slots = nullptr;
    uint32_t m_capacity = 0, m_count = 0, m_round = 1;
};

/// Which contacts exist, during one call of FindNewContacts.
///
/// Bodies whose contact lists were walked too often have their contacts put into a table. That lives no
/// longer than the call, in memory of the thread: there is nothing to be kept in step with fixtures, proxies
/// and worlds that go away, and proxy ids may name the contacts.
class ContactIndex {
public:
    /// A call's use of the thread's tables; where they are in use already (a filter that steps a world), or
    /// the thread has none any more, it gets none, and whoever uses them begins anew: it may have been his
    /// world.
    class Use {
    public:
        Use() : m_index(PerThread<ContactIndex>()) {
            if (m_index == nullptr)
                return;
            m_index->Forget();
            if (m_index->m_taken)
                m_index = nullptr;
            else
                m_index->m_taken = true;
        }
        ~Use() {
            if (m_index != nullptr)
                m_index->m_taken = false;
        }
        Use(const Use &) = delete;
        Use &operator=(const Use &) = delete;
        ContactIndex *Get() const { return m_index; }

    private:
        ContactIndex *m_index;
    };

    bool Exists(const b2FixtureProxy &a, const b2FixtureProxy &b) {
        const b2ContactEdge *edge = b.fixture->GetBody()->GetContactList();
        for (int i = 0; i < kShortWalk; ++i, edge = edge->next) {
            if (edge == nullptr)
                return false;
            if (Joins(*edge, a, b))
                return true;
        }
        return edge != nullptr && ExistsBehind(edge, a, b);
    }

    /// Contacts may have ended.
    void Forget() {
        m_pairs.Clear();
        m_bodies.Clear();
        m_lastBody = nullptr;
    }

    /// To be told of each contact that the call makes.
    void Remember(const b2Contact &made);

    /// The same by a walk over the whole list, as Box2D does it.
    static bool ExistsInList(const b2FixtureProxy &a, const b2FixtureProxy &b) {
        const b2ContactEdge *edge = b.fixture->GetBody()->GetContactList();
        while (edge != nullptr && !Joins(*edge, a, b))
            edge = edge->next;
        return edge != nullptr;
    }

private:
    // Most lists are no longer than this, and need no table.
    static constexpr int kShortWalk = 8;
    // Putting one contact into the table costs about as much as walking over four: a body is worth it after
    // four walks over a list of 64.
    static constexpr uint32_t kWorthIndexing = 256;
    static constexpr uint32_t kIndexed = 0xffffffffu;

    uint32_t *StepsOf(const b2Body *body) {
        if (body != m_lastBody) {
            m_lastBody = body;
            m_lastSteps = m_bodies.Add(reinterpret_cast<uintptr_t>(body));
        }
        return m_lastSteps;
    }

    static bool Joins(const b2ContactEdge &edge, const b2FixtureProxy &a, const b2FixtureProxy &b) {
        if (edge.other != a.fixture->GetBody())
            return false;
        const b2Contact &c = *edge.contact;
        return (c.GetFixtureA() == a.fixture && c.GetFixtureB() == b.fixture &&
                c.GetChildIndexA() == a.childIndex && c.GetChildIndexB() == b.childIndex) ||
               (c.GetFixtureA() == b.fixture && c.GetFixtureB() == a.fixture &&
                c.GetChildIndexA() == b.childIndex && c.GetChildIndexB() == a.childIndex);
    }
    bool ExistsBehind(const b2ContactEdge *edge, const b2FixtureProxy &a, const b2FixtureProxy &b);
    void Index(const b2Body *body, uint32_t *steps);

    Table m_pairs, m_bodies;
    const b2Body *m_lastBody = nullptr;
    uint32_t *m_lastSteps = nullptr;
    bool m_taken = false;
};

} // namespace bmr::interpose

#endif
