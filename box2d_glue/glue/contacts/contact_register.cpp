// SPDX-License-Identifier: MIT
// Box2D's table of who makes contacts between which types of shapes. There is one for the process, so our
// entries are made in one place. The earlier entry is called for all contacts that are not ours, and each
// contact is destroyed by the code that made it.
#include "glue/contacts/convex_contact.h"

#include <atomic>

#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "start/install.h"

namespace bmr {

namespace {

/// The entry of the register for two types.
class Below {
public:
    void Keep(const b2ContactRegister &held) {
        m_held = held;
        m_kept.store(true, std::memory_order_release);
    }
    /// For the maker that Box2D found in the register, which is written later. (Box2D reads the register
    /// without synchronisation: a processor may have read ahead.)
    const b2ContactRegister &Get() const {
        while (!m_kept.load(std::memory_order_acquire)) {
        }
        return m_held;
    }

private:
    b2ContactRegister m_held = {};
    std::atomic<bool> m_kept{false};
};

/// Who sees what is written from here on sees what was written before. (gcc's thread sanitizer knows no
/// fences; where it runs, stores are seen in order.)
void EndOfWrites() {
#if !defined(__SANITIZE_THREAD__)
    std::atomic_thread_fence(std::memory_order_release);
#endif
}

/// One class of contacts in front of the register's earlier entry. There may be several layers, and a game's
/// own between them: each knows only the layer below it.
///
/// `Ours` has Serves(shapeA, shapeB), Make(fixtures, children, allocator), AsOurs(contact) and
/// Unmake(contact, allocator).
template <typename Ours> class Layer : b2Contact {
public:
    /// For shapes of these types; Create is given them in this order.
    static void Register(b2Shape::Type typeA, b2Shape::Type typeB) {
        // To recognise this Box2D, contacts were made. Otherwise the first b2Contact::Create of the process
        // would fill the register and overwrite our entry.
        b2Assert(s_initialized);
        below[typeA][typeB].Keep(s_registers[typeA][typeB]);
        if (typeA != typeB)
            below[typeB][typeA].Keep(s_registers[typeB][typeA]);
        // Another thread may be making contacts: a thread that finds us as the maker finds us as the
        // destroyer, too.
        s_registers[typeA][typeB].destroyFcn = s_registers[typeB][typeA].destroyFcn = Destroy;
        EndOfWrites();
        AddType(Create, Destroy, typeA, typeB);
    }

private:
    static b2Contact *Create(b2Fixture *fixtureA, int32 indexA, b2Fixture *fixtureB, int32 indexB,
                             b2BlockAllocator *allocator) {
        if (Ours::Serves(*fixtureA->GetShape(), *fixtureB->GetShape()))
            return Ours::Make(fixtureA, indexA, fixtureB, indexB, allocator);
        const b2ContactRegister &maker = below[fixtureA->GetType()][fixtureB->GetType()].Get();
        if (maker.createFcn == nullptr)
            return nullptr;
        return maker.primary ? maker.createFcn(fixtureA, indexA, fixtureB, indexB, allocator)
                             : maker.createFcn(fixtureB, indexB, fixtureA, indexA, allocator);
    }

    static void Destroy(b2Contact *contact, b2BlockAllocator *allocator) {
        if (Ours *ours = Ours::AsOurs(contact))
            Ours::Unmake(ours, allocator);
        else
            below[contact->GetFixtureA()->GetType()][contact->GetFixtureB()->GetType()].Get().destroyFcn(
                contact, allocator);
    }

    static Below below[b2Shape::e_typeCount][b2Shape::e_typeCount];
};

template <typename Ours> Below Layer<Ours>::below[b2Shape::e_typeCount][b2Shape::e_typeCount] = {};

std::atomic<bool> convexContactsAreOurs{false};

} // namespace

void RegisterPolygonContacts() {
    const HoldsProcessLock lock;
    PolygonContact::LearnVtable();
    Layer<PolygonContact>::Register(b2Shape::e_polygon, b2Shape::e_polygon);
}

void RegisterEdgeContacts() {
    const HoldsProcessLock lock;
    EdgeContact::LearnVtable();
    Layer<EdgeContact>::Register(b2Shape::e_edge, b2Shape::e_polygon);
    Layer<EdgeContact>::Register(b2Shape::e_chain, b2Shape::e_polygon);
}

bmr_error RegisterConvexContacts() {
    if (convexContactsAreOurs.load(std::memory_order_acquire))
        return BMR_OK;
    if (WhyThisBox2DIsUnknown() != nullptr)
        return BMR_ERROR_UNSUPPORTED;
    const HoldsProcessLock lock;
    if (!convexContactsAreOurs.load(std::memory_order_relaxed)) {
        ConvexContact::LearnVtable();
        Layer<ConvexContact>::Register(b2Shape::e_polygon, b2Shape::e_polygon);
        Layer<ConvexContact>::Register(b2Shape::e_polygon, b2Shape::e_circle);
        Layer<ConvexContact>::Register(b2Shape::e_edge, b2Shape::e_polygon);
        Layer<ConvexContact>::Register(b2Shape::e_chain, b2Shape::e_polygon);
        convexContactsAreOurs.store(true, std::memory_order_release);
    }
    return BMR_OK;
}

} // namespace bmr
