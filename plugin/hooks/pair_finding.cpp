// SPDX-License-Identifier: MIT
// b2ContactManager::FindNewContacts: pairs of proxies whose fat boxes have come to overlap. The same contacts
// are made in the same order, and the same filters asked. What is done otherwise:
//
//   - Proxies of one body that were moved together descend the tree together, with the box around them all.
//     Each is then held against the few leaves of other bodies that this found. The leaves come in the order
//     of the descent, so each proxy meets them in the order in which its own would have.
//   - The tree is descended with boxes in registers, and a node is looked at before it is put on the stack.
//   - Two fixtures of one body, nearly all that a body of many fixtures finds, are passed over at once: not
//     where the world has a filter of the game's own, which may step this world in the midst of it. Box2D
//     then goes on in the newer pairs, at the place that it had come to in the older ones.
//   - Existing contacts are found in the ledger's table of pairs, where AddPair would walk over the body's
//     list. Worlds of few contacts have no ledger, and short lists.
#include <box2d/b2_broad_phase.h>
#include <box2d/b2_contact.h>

#include "passes/contact_access.h"
#include "reach/stock.h"
#include "start/settings.h"
#include "tell/verify.h"
#include "tree/descent.h"
#include "world/ledger.h"
#include "world/ledgers.h"

namespace bmr::hooks {

namespace {

using namespace tree;

const b2Body *BodyOf(const void *proxy) {
    return static_cast<const b2FixtureProxy *>(proxy)->fixture->GetBody();
}

/// Does the proxy report this leaf? Not itself; and where both were moved, one of the two does.
bool Reports(int32 proxy, int32 leaf, bool moved) {
    return leaf != proxy && !(moved && leaf > proxy);
}

/// One proxy's own descent.
template <typename Keep> struct OneProxy {
    const b2Body *passedOver; ///< leaves of this one; nullptr: of none
    int32 proxy;
    const Keep &keep;

    static bool Visit(Box) { return true; }
    bool Take(int32 leaf, const b2TreeNode &node) const {
        if (Reports(proxy, leaf, node.moved) && BodyOf(node.userData) != passedOver)
            keep(proxy, leaf);
        return true;
    }
};

/// The descent of proxies of one body that follow each other among the moved ones.
struct ManyProxies {
    // Each proxy is held against each leaf: with more of them, descents of its own cost less.
    static constexpr int32 kMostLeaves = 128;
    // A proxy's own descent looks at about two nodes for each level of the tree, and at those leaves of its
    // own body that are near, with the nodes above them. In bodies of 10 to 63 triangles about one corner
    // (the scene asteroids) that is 134 nodes on average: with a quarter of that, four of ten descents
    // together were given up, in vain.
    static constexpr int32 kVisitsForAProxy = 128;

    struct Leaf {
        b2AABB box;
        int32 proxy;
        bool moved;
    };

    const b2Body *passedOver; ///< leaves of this one; nullptr: of none
    int32 visitsLeft;
    int32 count = 0;
    Leaf leaves[kMostLeaves];

    // cppcheck-suppress uninitMemberVar ; leaves are written before they are read
    ManyProxies(const b2Body *body, int32 proxies)
        : passedOver(body), visitsLeft(proxies * kVisitsForAProxy) {}

    /// Gives up where too much is near; and at a box that is not a number, because the boxes above it in the
    /// tree need not hold it, so that whether a proxy finds it depends on the way down.
    bool Visit(Box box) { return --visitsLeft >= 0 && HasNumbers(box); }
    bool Take(int32 leaf, const b2TreeNode &node) {
        if (BodyOf(node.userData) == passedOver)
            return true;
        if (count == kMostLeaves)
            return false;
        leaves[count++] = {node.aabb, leaf, node.moved};
        return true;
    }
};

/// A contact that is being made.
struct NewContact : b2Contact {
    /// nullptr where Box2D has no contacts of these shapes.
    static b2Contact *Create(const b2FixtureProxy &a, const b2FixtureProxy &b, b2BlockAllocator *allocator) {
        return b2Contact::Create(a.fixture, a.childIndex, b.fixture, b.childIndex, allocator);
    }

    /// Puts it at the head of the world's list.
    static void Link(b2Contact *contact, b2Contact **list) {
        contact->*(&NewContact::m_next) = *list;
        if (*list != nullptr)
            *list->*(&NewContact::m_prev) = contact;
        *list = contact;
    }

    /// Puts it at the head of its bodies' lists.
    static void Join(b2Contact *contact) {
        b2Body *bodyA = contact->GetFixtureA()->GetBody(), *bodyB = contact->GetFixtureB()->GetBody();
        Attach(&(contact->*(&NewContact::m_nodeA)), contact, bodyA, bodyB);
        Attach(&(contact->*(&NewContact::m_nodeB)), contact, bodyB, bodyA);
    }

private:
    static void Attach(b2ContactEdge *edge, b2Contact *contact, b2Body *body, b2Body *other) {
        b2ContactEdge *&list = body->*Named(ContactList());
        *edge = {other, contact, nullptr, list};
        if (list != nullptr)
            list->prev = edge;
        list = edge;
    }
};

/// What b2BroadPhase::UpdatePairs is instantiated for.
class PairFinder {
public:
    explicit PairFinder(b2ContactManager *manager)
        : m_manager(manager), m_ledger(FollowedLedger()),
          m_ownPairs(!OnlyCompares() && IsOfGame(manager->m_contactFilter)) {}

    /// Mode::Verify: the pairs are found and compared with Box2D's way of finding them; nothing else is done.
    static bool OnlyCompares() { return Verifying(); }
    void Compare(const b2DynamicTree &tree, const int32 *moves, int32 count, const b2Pair *found,
                 int32 foundCount);

    /// Calls `keep(proxy, leaf)` for the pairs that Box2D would find, without those of one body if nobody can
    /// see them.
    template <typename Keep>
    void FindPairs(const b2DynamicTree &tree, const int32 *moves, int32 count, const Keep &keep) const;

    /// Makes a contact of the pair, unless there is one already.
    void Report(const b2FixtureProxy &a, const b2FixtureProxy &b) {
        if ((m_ownPairs && a.fixture->GetBody() == b.fixture->GetBody()) || Exists(a, b) ||
            !PassesFilters(m_manager, a.fixture, b.fixture))
            return;
        b2Contact *contact = NewContact::Create(a, b, m_manager->m_allocator);
        if (contact == nullptr)
            return;
        NewContact::Link(contact, &m_manager->m_contactList);
        NewContact::Join(contact);
        ++m_manager->m_contactCount;
        if (m_ledger != nullptr || m_manager->m_contactCount == WorthALedgerAnyway())
            m_ledger = FollowedLedger();
    }

private:
    template <typename Keep>
    bool FindTogether(const b2DynamicTree &tree, const TreeNodes &nodes, const int32 *moves, int32 count,
                      const Keep &keep) const;

    /// The world's ledger with all of its contacts; nullptr where it has none.
    Ledger *FollowedLedger() const {
        if (!HookIsOn(Hook::Ledger))
            return nullptr;
        Ledger *ledger =
            m_manager->m_contactCount >= WorthALedgerAnyway() ? MakeLedger(m_manager) : FindLedger(m_manager);
        return ledger != nullptr && (ledger->IsWhole() || ledger->CatchUp()) && !ledger->MayHaveUnlisted()
                   ? ledger
                   : nullptr;
    }

    bool Exists(const b2FixtureProxy &a, const b2FixtureProxy &b) const {
        // A filter may have made or ended contacts, where the world is not locked.
        if (m_ledger == nullptr || m_ledger->GetProxyPairs().HasUnknown() || !m_ledger->IsWhole())
            return ExistsInList(a, b);
        return m_ledger->GetProxyPairs().Exists(a.proxyId, b.proxyId);
    }

    /// By a walk over the body's list, as Box2D does it.
    static bool ExistsInList(const b2FixtureProxy &a, const b2FixtureProxy &b) {
        const b2ContactEdge *edge = b.fixture->GetBody()->GetContactList();
        while (edge != nullptr && !Joins(*edge, a, b))
            edge = edge->next;
        return edge != nullptr;
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

    const b2Body *PassedOver(const b2Body *body) const { return m_ownPairs ? nullptr : body; }

    b2ContactManager *m_manager;
    Ledger *m_ledger;
    bool m_ownPairs; ///< pairs of one body are found, too
};

/// How many of the moves from the first on are of its body; those that were taken back count as such.
int32 CountTogether(const b2DynamicTree &tree, const int32 *moves, int32 count) {
    const b2Body *body = BodyOf(tree.GetUserData(moves[0]));
    int32 together = 1;
    while (together < count && (moves[together] == b2BroadPhase::e_nullProxy ||
                                BodyOf(tree.GetUserData(moves[together])) == body))
        ++together;
    return together;
}

template <typename Keep>
void PairFinder::FindPairs(const b2DynamicTree &tree, const int32 *moves, int32 count,
                           const Keep &keep) const {
    TreeNodes nodes;
    tree.Query(&nodes, b2AABB());
    for (int32 i = 0; i < count;) {
        if (moves[i] == b2BroadPhase::e_nullProxy) {
            ++i;
            continue;
        }
        const int32 together = CountTogether(tree, moves + i, count - i);
        if (together == 1 || !FindTogether(tree, nodes, moves + i, together, keep)) {
            for (int32 j = i; j < i + together; ++j) {
                if (moves[j] == b2BroadPhase::e_nullProxy)
                    continue;
                OneProxy<Keep> one = {PassedOver(BodyOf(tree.GetUserData(moves[j]))), moves[j], keep};
                Descend(nodes, BoxOf(tree.GetFatAABB(moves[j])), &one);
            }
        }
        i += together;
    }
}

/// The pairs in Box2D's order, from its own query, held against those that were found.
struct ComparingQuery {
    const b2DynamicTree *tree;
    int32 proxy;
    const b2Pair *next, *end;
    bool same = true;

    bool QueryCallback(int32 leaf) {
        if (!Reports(proxy, leaf, tree->WasMoved(leaf)) ||
            BodyOf(tree->GetUserData(leaf)) == BodyOf(tree->GetUserData(proxy)))
            return true;
        same = same && next != end && next->proxyIdA == b2Min(leaf, proxy) &&
               next->proxyIdB == b2Max(leaf, proxy);
        next += same ? 1 : 0;
        return same;
    }
};

void PairFinder::Compare(const b2DynamicTree &tree, const int32 *moves, int32 count, const b2Pair *found,
                         int32 foundCount) {
    CountVerified();
    ComparingQuery query = {&tree, b2BroadPhase::e_nullProxy, found, found + foundCount};
    for (int32 i = 0; i < count; ++i) {
        query.proxy = moves[i];
        if (moves[i] != b2BroadPhase::e_nullProxy)
            tree.Query(&query, tree.GetFatAABB(moves[i]));
    }
    if (!query.same || query.next != query.end)
        ReportDifference("pair finding", nullptr, nullptr, "pair %d of %d is another",
                         static_cast<int>(query.next - found), foundCount);
    for (int32 i = 0; i < foundCount; ++i) {
        const auto *a = static_cast<const b2FixtureProxy *>(tree.GetUserData(found[i].proxyIdA));
        const auto *b = static_cast<const b2FixtureProxy *>(tree.GetUserData(found[i].proxyIdB));
        if (Exists(*a, *b) != ExistsInList(*a, *b))
            ReportDifference("pair finding", a->fixture, b->fixture, "whether there is a contact");
    }
}

/// False, and nothing kept, where the proxies are to descend one by one.
template <typename Keep>
bool PairFinder::FindTogether(const b2DynamicTree &tree, const TreeNodes &nodes, const int32 *moves,
                              int32 count, const Keep &keep) const {
    Box around = BoxOf(tree.GetFatAABB(moves[0]));
    for (int32 i = 0; i < count; ++i) {
        if (moves[i] == b2BroadPhase::e_nullProxy)
            continue;
        const Box box = BoxOf(tree.GetFatAABB(moves[i]));
        if (!HasNumbers(box))
            return false;
        around = Around(around, box);
    }
    ManyProxies many(PassedOver(BodyOf(tree.GetUserData(moves[0]))), count);
    if (!Descend(nodes, around, &many))
        return false;
    for (int32 i = 0; i < count; ++i) {
        if (moves[i] == b2BroadPhase::e_nullProxy)
            continue;
        const Box box = BoxOf(tree.GetFatAABB(moves[i]));
        for (int32 j = 0; j < many.count; ++j) {
            const ManyProxies::Leaf &leaf = many.leaves[j];
            if (tree::Overlap(BoxOf(leaf.box), box) && Reports(moves[i], leaf.proxy, leaf.moved))
                keep(moves[i], leaf.proxy);
        }
    }
    return true;
}

} // namespace

} // namespace bmr::hooks

/// The broad phase's own buffer of pairs is used. It is Box2D's to grow: a game may have built Box2D with an
/// allocator of its own, and this library with another one. b2BroadPhase::QueryCallback grows it, in putting
/// in the next pair.
template <> void b2BroadPhase::UpdatePairs(bmr::hooks::PairFinder *finder) {
    m_pairCount = 0;
    const auto keep = [this](int32 proxy, int32 leaf) {
        if (m_pairCount == m_pairCapacity) {
            m_queryProxyId = proxy;
            QueryCallback(leaf);
            return;
        }
        m_pairBuffer[m_pairCount++] = {b2Min(proxy, leaf), b2Max(proxy, leaf)};
    };
    finder->FindPairs(m_tree, m_moveBuffer, m_moveCount, keep);
    if (finder->OnlyCompares()) {
        finder->Compare(m_tree, m_moveBuffer, m_moveCount, m_pairBuffer, m_pairCount);
        return;
    }
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

using namespace bmr;
using namespace bmr::hooks;

BMR_FOR_LOADERS("_ZN16b2ContactManager15FindNewContactsEv");

void b2ContactManager::FindNewContacts() {
    if (NothingIsInstalled())
        return stock::FindNewContacts(this);
    if (m_contactList == nullptr)
        if (Ledger *ledger = FindLedger(this))
            ledger->BeginEmpty();
    const bool ours = HookIsOn(Hook::PairFinding);
    if (ours) {
        PairFinder finder(this);
        m_broadPhase.UpdatePairs(&finder);
    }
    if (!ours || Verifying()) {
        // Box2D's contacts are made without a number: none may be taken for one that ended without a word in
        // its place.
        if (Ledger *ledger = FindLedger(this); ledger != nullptr && !ledger->IsWhole())
            ledger->Resync();
        stock::FindNewContacts(this);
    }
    if (Ledger *ledger = FindLedger(this)) {
        ledger->CatchUp();
        ledger->NoteSearch();
    }
}
