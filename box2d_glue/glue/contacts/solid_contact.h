// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SOLID_CONTACT_H
#define BOOMERANG_GLUE_SOLID_CONTACT_H

#include <atomic>
#include <cstdint>
#include <cstring>
#include <new>

#include <box2d/b2_block_allocator.h>
#include <box2d/b2_body.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "base/private_members.h"
#include "boomerang/box2d_glue.h"
#include "convex32/convex32_collide.h"
#include "debug/statistics.h"
#include "glue/pairs/bodies.h"
#include "glue/proofs/overlap.h"

namespace bmr {

/// @file
/// A contact of two polygons is a kinetic structure of its own: it keeps a certificate from update to update.
/// Options::onEvent says which events it has in the paper's words, and of which level. (With Options::pairsBy
/// the structures of two bodies' hulls are in their place, and core tells their events.)
///
/// There is no roll. All vertices of the other polygon are tried at an update, or the farthest is searched:
/// there is no window that the direction could leave. For the same reason any other edge is a push, whichever
/// of the two polygons it belongs to.
///
/// What was handed over to the exact test may leave by the line that its pair in the table then gets.
///
/// So its events are (start (push | stab | coarsen)*)? (contact leave (push | stab | coarsen)*)*, cut
/// off anywhere.

/// The certificate that keeps a contact's polygons apart. For its events alone: no answer depends on it.
enum class CertificateState : uint8_t {
    None,   ///< nothing was found yet
    Coarse, ///< level -1
    Apart,  ///< level 0
    Contact ///< nothing: the exact test answers
};

/// What an update finds out of a contact's certificate.
enum class ProofResult : uint8_t {
    Nothing,    ///< not known to be apart
    ByDisks,    ///< the disks around the two polygons are apart
    Remembered, ///< the certificate of the last update holds
    Another     ///< another one was found
};

/// Our data of a contact, besides Box2D's: 16 bytes at most, for which Box2D's 224-byte block has room.
struct ContactState {
    CertificateState certificate;
    union {
        EdgeMemory edge;             ///< of a PolygonContact
        bmr_convex32_memory closest; ///< of a ConvexContact
    };
};
static_assert(sizeof(ContactState) <= 16);

/// An object's table of virtual functions, which tells contacts apart. Games build Box2D without run-time
/// type information too, where typeid has nothing to read; but the table is always an object's first word,
/// on every ABI that Box2D runs on.
inline const void *VtableOf(const b2Contact &contact) {
    const void *vtable;
    std::memcpy(&vtable, static_cast<const void *>(&contact), sizeof vtable);
    return vtable;
}

/// What the contact register needs of a class of ours: how its objects are made, unmade and recognised.
template <typename Ours> class ContactClass {
public:
    static b2Contact *Make(b2Fixture *fixtureA, int32 indexA, b2Fixture *fixtureB, int32 indexB,
                           b2BlockAllocator *allocator) {
        return new (allocator->Allocate(sizeof(Ours))) Ours(fixtureA, indexA, fixtureB, indexB);
    }
    static void Unmake(Ours *contact, b2BlockAllocator *allocator) {
        contact->~Ours();
        allocator->Free(contact, sizeof(Ours));
    }
    /// Before the first is made.
    static void LearnVtable() {
        const Ours ours;
        vtable.store(VtableOf(ours), std::memory_order_relaxed);
    }
    static bool Has(const b2Contact &contact) {
        return VtableOf(contact) == vtable.load(std::memory_order_relaxed);
    }
    /// `contact` as one of these, or nullptr.
    static Ours *AsOurs(b2Contact *contact) { return Has(*contact) ? static_cast<Ours *>(contact) : nullptr; }
    static const Ours *AsOurs(const b2Contact *contact) { return AsOurs(const_cast<b2Contact *>(contact)); }

private:
    static inline std::atomic<const void *> vtable{nullptr};
};
class ConvexContact;
class PolygonContact;

/// The base of our contacts that the table knows: PolygonContact and ConvexContact. (EdgeContact is none.)
class SolidContact : public b2Contact {
public:
    /// `contact` as one of ours, or nullptr: contacts that were born before the register knew us, and other
    /// shapes', are not.
    static SolidContact *AsOurs(b2Contact *contact) {
        return ContactClass<PolygonContact>::Has(*contact) || ContactClass<ConvexContact>::Has(*contact)
                   ? static_cast<SolidContact *>(contact)
                   : nullptr;
    }

    static const SolidContact *AsOurs(const b2Contact *contact) {
        return AsOurs(const_cast<b2Contact *>(contact));
    }

    /// Are both shapes polygons, of any size?
    bool IsOfPolygons() const {
        return m_fixtureA->GetType() == b2Shape::e_polygon && m_fixtureB->GetType() == b2Shape::e_polygon;
    }

    float RadiusSum() const { return m_fixtureA->GetShape()->m_radius + m_fixtureB->GetShape()->m_radius; }

    /// Is called not by a pass of ours, but by Box2D or by the game: the contact's pair in the table is due.
    void Evaluate(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) final;
    /// Makes the manifold anew, without impulses, of two fixtures that are no sensors.
    void MakeManifold() {
        Fill(&m_manifold, m_fixtureA->GetBody()->GetTransform(), m_fixtureB->GetBody()->GetTransform());
    }

    /// The direction that this contact remembers itself, in the world, from A to B. Zero if there is none.
    virtual bmr_vec2 KnownDirection() const = 0;
    /// A direction, in the world, from A to B, that most likely keeps the two apart: it was remembered at the
    /// last update, by the bodies' structure if it keeps them apart. Zero if there is none. For polygons
    /// alone.
    bmr_vec2 GuessDirection() const;

    /// Takes the result of an update into the contact's state, and reports the event, if it is one. Call it
    /// if Options::statistics is on, for a contact of polygons.
    void TakeResult(ProofResult result);
    /// The same of a contact that was handed over, and of which the table now has a line.
    void LeaveByLine();

    ContactState state;

protected:
    SolidContact() : state() {}
    SolidContact(b2Fixture *fixtureA, int32 indexA, b2Fixture *fixtureB, int32 indexB)
        : b2Contact(fixtureA, indexA, fixtureB, indexB), state() {}

    /// With Options::pairsBy, for two solid polygons: does the structure of their bodies prove them apart at
    /// these poses?
    bool HullsSayApart(const b2Transform &xfA, const b2Transform &xfB) const;

private:
    virtual void Fill(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) = 0;
};

/// Box2D's polygon contact with a separation proof in front. Its results are those of stock's to the bit.
/// It serves polygons of Box2D's own size alone.
class PolygonContact final : public SolidContact, public ContactClass<PolygonContact> {
public:
    // For the contact register.
    static bool Serves(const b2Shape &a, const b2Shape &b);

    using ContactClass<PolygonContact>::AsOurs;

    /// The remembered edge's.
    bmr_vec2 KnownDirection() const override;

    /// The edge that is asked first.
    EdgeMemory *Memory() { return &state.edge; }

private:
    friend class ContactClass<PolygonContact>;
    PolygonContact() = default;
    PolygonContact(b2Fixture *fixtureA, int32 indexA, b2Fixture *fixtureB, int32 indexB)
        : SolidContact(fixtureA, indexA, fixtureB, indexB) {
        state.edge.number = kNoEdge;
    }

    void Fill(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) override;
    bool Search(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB);
    bool EdgeSeparates(const b2Transform &xfA, const b2Transform &xfB) const;
};

/// A contact of an edge, or a link of a chain, with a polygon of up to 8 vertices: as Box2D's own contact,
/// with b2CollideEdgeAndPolygon's manifold made in lanes.
class EdgeContact final : public b2Contact, public ContactClass<EdgeContact> {
public:
    // For the contact register. `fixtureA` is the edge or the chain.
    static bool Serves(const b2Shape &a, const b2Shape &b);

    using ContactClass<EdgeContact>::AsOurs;

    void Evaluate(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) override;

private:
    friend class ContactClass<EdgeContact>;
    EdgeContact() = default;
    using b2Contact::b2Contact;
};

/// Contacts of two polygons are ours from here on (PolygonContact). Once for a process, by Install, which
/// knows that Box2D is one that the glue knows.
void RegisterPolygonContacts();
/// The same of contacts of edges and chains with polygons (EdgeContact), where Box2DCollidesEdgesAsExact32.
void RegisterEdgeContacts();

/// What an update changed, for CallListener.
struct ContactChange {
    bool touched, touches; ///< before, and behind it
    bool isSensor;         ///< one of the two fixtures is
    b2Manifold old;        ///< the manifold before, if the two touch
};

/// b2Contact::Update of any contact, but for the calls of the listener: the same manifold, impulses and
/// flags, and bodies are woken where it wakes them. CallListener comes next.
ContactChange UpdateContact(b2Contact *contact);

static_assert(sizeof(PolygonContact) <= 224, "must stay in the block class of a stock contact");

} // namespace bmr

#endif
