// SPDX-License-Identifier: MIT
#include "glue/passes.h"

#include <box2d/b2_broad_phase.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_contact_manager.h>
#include <box2d/b2_fixture.h>

#include "base/memory.h"
#include "base/private_members.h"
#include "debug/verify.h"
#include "glue/contacts/game_calls.h"
#include "glue/pairs/pair_tables.h"
#include "start/settings.h"
#include "tree/pair_descent.h"

namespace bmr {

namespace {

/// A contact that is being made.
struct LinkedContact : b2Contact {
    /// nullptr where Box2D has no contacts of these shapes.
    static b2Contact *Create(const b2FixtureProxy &a, const b2FixtureProxy &b, b2BlockAllocator *allocator) {
        return b2Contact::Create(a.fixture, a.childIndex, b.fixture, b.childIndex, allocator);
    }

    /// Is there one already? By a walk over the body's list, as Box2D does it.
    static bool ExistsInList(const b2FixtureProxy &a, const b2FixtureProxy &b) {
        const b2ContactEdge *edge = b.fixture->GetBody()->GetContactList();
        while (edge != nullptr && !Joins(*edge, a, b))
            edge = edge->next;
        return edge != nullptr;
    }

    /// Puts it at the head of the world's list and of its bodies'.
    static void Link(b2ContactManager *manager, b2Contact *contact) {
        b2Contact *&list = manager->m_contactList;
        contact->*(&LinkedContact::m_next) = list;
        if (list != nullptr)
            list->*(&LinkedContact::m_prev) = contact;
        list = contact;
        b2Body *bodyA = contact->GetFixtureA()->GetBody(), *bodyB = contact->GetFixtureB()->GetBody();
        Attach(&(contact->*(&LinkedContact::m_nodeA)), contact, bodyA, bodyB);
        Attach(&(contact->*(&LinkedContact::m_nodeB)), contact, bodyB, bodyA);
        ++manager->m_contactCount;
    }

private:
    static bool Joins(const b2ContactEdge &edge, const b2FixtureProxy &a, const b2FixtureProxy &b) {
        if (edge.other != a.fixture->GetBody())
            return false;
        const b2Contact &c = *edge.contact;
        return (c.GetFixtureA() == a.fixture && c.GetFixtureB() == b.fixture &&
                c.GetChildIndexA() == a.childIndex && c.GetChildIndexB() == b.childIndex) ||
               (c.GetFixtureA() == b.fixture && c.GetFixtureB() == a.fixture &&
                c.GetChildIndexA() == b.childIndex && c.GetChildIndexB() == a.childIndex);
    }

    static void Attach(b2ContactEdge *edge, b2Contact *contact, b2Body *body, b2Body *other) {
        b2ContactEdge *&list = body->*Named(ContactList());
        *edge = {other, contact, nullptr, list};
        if (list != nullptr)
            list->prev = edge;
        list = edge;
    }
};

/// The client of b2BroadPhase::UpdatePairs, which has a specialisation for it below: so that code of ours may
/// use the broad phase's private buffers. That one calls Report in the place of AddPair.
class PairFinder {
public:
    explicit PairFinder(b2ContactManager *manager) : m_manager(manager), m_table(WholeTable()) {}

    /// Makes a contact of the pair, unless there is one already.
    void Report(const b2FixtureProxy &a, const b2FixtureProxy &b) {
        if (Exists(a, b))
            return;
        const bool ofGame = IsOfGame(m_manager->m_contactFilter);
        if (PairTable *const table = ofGame ? FindPairTable(m_manager) : nullptr)
            table->deferred.BeforeGame();
        const bool passes = PassesFilters(m_manager, a.fixture, b.fixture);
        if (ofGame)
            m_table = WholeTable(); // the world may have left the one before
        if (!passes)
            return;
        b2Contact *contact = LinkedContact::Create(a, b, m_manager->m_allocator);
        if (contact == nullptr)
            return;
        LinkedContact::Link(m_manager, contact);
        if (m_table != nullptr || m_manager->m_contactCount == CostOfAPass())
            m_table = WholeTable();
    }

private:
    /// The world's table with all of its contacts; nullptr where it has none.
    PairTable *WholeTable() const {
        PairTable *table =
            m_manager->m_contactCount >= CostOfAPass() ? MakePairTable(m_manager) : FindPairTable(m_manager);
        return table != nullptr && (table->IsWhole() || table->CatchUp()) ? table : nullptr;
    }

    bool Exists(const b2FixtureProxy &a, const b2FixtureProxy &b) const {
        if (m_table == nullptr)
            return LinkedContact::ExistsInList(a, b);
        const bool exists = m_table->fixturePairs.HaveContact(a, b);
        if (Verifying())
            VerifyAnswer("whether a contact exists", a.fixture, b.fixture, exists,
                         LinkedContact::ExistsInList(a, b));
        return exists;
    }

    b2ContactManager *m_manager;
    PairTable *m_table;
};

} // namespace

} // namespace bmr

/// The broad phase's own buffer of pairs is used. It is Box2D's to grow: a game may have built Box2D with an
/// allocator of its own, and this library with another one. b2BroadPhase::QueryCallback grows it, in putting
/// in the next pair.
template <> void b2BroadPhase::UpdatePairs(bmr::PairFinder *finder) {
    m_pairCount = 0;
    const auto keep = [this](int32 proxy, int32 leaf) {
        if (m_pairCount == m_pairCapacity) {
            m_queryProxyId = proxy;
            QueryCallback(leaf);
            return;
        }
        m_pairBuffer[m_pairCount++] = {b2Min(proxy, leaf), b2Max(proxy, leaf)};
    };
    bmr::tree::DescentScratch own;
    bmr::tree::DescentScratch *const kept = bmr::PerThread<bmr::tree::DescentScratch>();
    bmr::tree::PairDescent(m_tree, kept != nullptr ? kept : &own, keep).Run(m_moveBuffer, m_moveCount);
    if (bmr::Verifying())
        bmr::VerifyPairs(m_tree, m_moveBuffer, m_moveCount, m_pairBuffer, m_pairCount);
    for (int32 i = 0; i < m_pairCount; ++i) {
        const b2Pair pair = m_pairBuffer[i];
        finder->Report(*static_cast<const b2FixtureProxy *>(m_tree.GetUserData(pair.proxyIdA)),
                       *static_cast<const b2FixtureProxy *>(m_tree.GetUserData(pair.proxyIdB)));
    }
    for (int32 i = 0; i < m_moveCount; ++i)
        if (m_moveBuffer[i] != e_nullProxy)
            m_tree.ClearMoved(m_moveBuffer[i]);
    m_moveCount = 0;
}

namespace bmr {

void FindNewContacts(b2ContactManager *manager) {
    DropPairTableOfEmpty(manager);
    PairFinder finder(manager);
    manager->m_broadPhase.UpdatePairs(&finder);
    if (PairTable *table = FindPairTable(manager))
        table->CatchUp();
}

} // namespace bmr
