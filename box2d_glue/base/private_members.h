// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PRIVATE_MEMBERS_H
#define BOOMERANG_GLUE_PRIVATE_MEMBERS_H

#include <box2d/b2_body.h>
#include <box2d/b2_broad_phase.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_joint.h>
#include <box2d/b2_time_step.h>
#include <box2d/b2_world.h>

/// @file
/// What Box2D shows itself alone, and its stand-ins here need too.

namespace bmr {

// An explicit instantiation may name private members, and hands them out.
template <typename Tag, typename Type, Type Member> struct Naming {
    friend Type Named(Tag) { return Member; }
};

/// Name: the tag that names a member of Class; Name::Of: the type of a pointer to that member.
#define BMR_NAME_MEMBER(Name, Class, member, ...)                                                            \
    struct Name {                                                                                            \
        using Of = __VA_ARGS__;                                                                              \
        friend Of Named(Name);                                                                               \
    };                                                                                                       \
    template struct Naming<Name, Name::Of, &Class::member>

BMR_NAME_MEMBER(ShouldCollide, b2Body, ShouldCollide, bool (b2Body::*)(const b2Body *other) const);
BMR_NAME_MEMBER(ContactList, b2Body, m_contactList, b2ContactEdge *b2Body::*);
BMR_NAME_MEMBER(NextContact, b2Contact, m_next, b2Contact *b2Contact::*);
BMR_NAME_MEMBER(NextBody, b2Body, m_next, b2Body *b2Body::*);
BMR_NAME_MEMBER(BodyFlags, b2Body, m_flags, uint16 b2Body::*);
BMR_NAME_MEMBER(IslandIndex, b2Body, m_islandIndex, int32 b2Body::*);
BMR_NAME_MEMBER(TransformMember, b2Body, m_xf, b2Transform b2Body::*);
BMR_NAME_MEMBER(SweepMember, b2Body, m_sweep, b2Sweep b2Body::*);
BMR_NAME_MEMBER(LinearVelocity, b2Body, m_linearVelocity, b2Vec2 b2Body::*);
BMR_NAME_MEMBER(AngularVelocity, b2Body, m_angularVelocity, float b2Body::*);
BMR_NAME_MEMBER(Force, b2Body, m_force, b2Vec2 b2Body::*);
BMR_NAME_MEMBER(Torque, b2Body, m_torque, float b2Body::*);
BMR_NAME_MEMBER(InverseMass, b2Body, m_invMass, float b2Body::*);
BMR_NAME_MEMBER(InverseInertia, b2Body, m_invI, float b2Body::*);
BMR_NAME_MEMBER(SynchronizeFixtures, b2Body, SynchronizeFixtures, void (b2Body::*)());
BMR_NAME_MEMBER(SynchronizeTransform, b2Body, SynchronizeTransform, void (b2Body::*)());
BMR_NAME_MEMBER(AdvanceBody, b2Body, Advance, void (b2Body::*)(float));
BMR_NAME_MEMBER(SleepTime, b2Body, m_sleepTime, float b2Body::*);

BMR_NAME_MEMBER(InitVelocityConstraints, b2Joint, InitVelocityConstraints,
                void (b2Joint::*)(const b2SolverData &));
BMR_NAME_MEMBER(SolveVelocityConstraints, b2Joint, SolveVelocityConstraints,
                void (b2Joint::*)(const b2SolverData &));
BMR_NAME_MEMBER(SolvePositionConstraints, b2Joint, SolvePositionConstraints,
                bool (b2Joint::*)(const b2SolverData &));

BMR_NAME_MEMBER(TreeNodes, b2DynamicTree, m_nodes, b2TreeNode *b2DynamicTree::*);
BMR_NAME_MEMBER(TreeCapacity, b2DynamicTree, m_nodeCapacity, int32 b2DynamicTree::*);
BMR_NAME_MEMBER(TreeRoot, b2DynamicTree, m_root, int32 b2DynamicTree::*);
BMR_NAME_MEMBER(TreeInsertions, b2DynamicTree, m_insertionCount, int32 b2DynamicTree::*);

BMR_NAME_MEMBER(Tree, b2BroadPhase, m_tree, b2DynamicTree b2BroadPhase::*);
BMR_NAME_MEMBER(JointInIsland, b2Joint, m_islandFlag, bool b2Joint::*);
BMR_NAME_MEMBER(ContactManager, b2World, m_contactManager, b2ContactManager b2World::*);
BMR_NAME_MEMBER(AllowSleep, b2World, m_allowSleep, bool b2World::*);
BMR_NAME_MEMBER(TheDestructionListener, b2World, m_destructionListener, b2DestructionListener *b2World::*);
BMR_NAME_MEMBER(Profile, b2World, m_profile, b2Profile b2World::*);
BMR_NAME_MEMBER(NewContacts, b2World, m_newContacts, bool b2World::*);
BMR_NAME_MEMBER(Locked, b2World, m_locked, bool b2World::*);
BMR_NAME_MEMBER(InverseStep, b2World, m_inv_dt0, float b2World::*);
BMR_NAME_MEMBER(StepComplete, b2World, m_stepComplete, bool b2World::*);
#undef BMR_NAME_MEMBER

inline const b2Sweep &SweepOf(const b2Body &body) {
    return body.*Named(SweepMember());
}
inline b2Sweep &SweepOf(b2Body *body) {
    return body->*Named(SweepMember());
}

/// b2Body::e_islandFlag, which is private.
struct BodyInIsland {
    static bool Is(const b2Body *body) { return (body->*Named(BodyFlags()) & kFlag) != 0; }
    static void Set(b2Body *body) {
        body->*Named(BodyFlags()) = static_cast<uint16>(body->*Named(BodyFlags()) | kFlag);
    }
    static void Clear(b2Body *body) {
        body->*Named(BodyFlags()) = static_cast<uint16>(body->*Named(BodyFlags()) & ~kFlag);
    }

    static constexpr uint16 kAwake = 0x0002;
    /// Bit 0 is none of them.
    static uint32_t OtherFlags(const b2Body *body) { return body->*Named(BodyFlags()) & ~uint32_t{kFlag}; }

private:
    static constexpr uint16 kFlag = 0x0001;
};

/// Names protected members of b2Contact's, and flags of its.
struct ContactAccess : b2Contact {
    static uint32 &Flags(b2Contact *contact) { return contact->*(&ContactAccess::m_flags); }
    static float &TimeOfImpact(b2Contact *contact) { return contact->*(&ContactAccess::m_toi); }
    static int32 &CountOfImpacts(b2Contact *contact) { return contact->*(&ContactAccess::m_toiCount); }
    static constexpr uint32 kInIsland = e_islandFlag, kTimeIsKnown = e_toiFlag, kEnabled = e_enabledFlag,
                            kTouching = e_touchingFlag;
    static constexpr uint32 kAll =
        e_islandFlag | e_touchingFlag | e_enabledFlag | e_filterFlag | e_bulletHitFlag | e_toiFlag;

    static bool WantsFiltering(const b2Contact &contact) {
        return (contact.*(&ContactAccess::m_flags) & e_filterFlag) != 0;
    }
    static void FilteringIsDone(b2Contact *contact) { Flags(contact) &= ~uint32{e_filterFlag}; }

    /// Most are enabled: what is not written need not go back to memory.
    static void Enable(b2Contact *contact) {
        if ((Flags(contact) & e_enabledFlag) == 0)
            Flags(contact) |= e_enabledFlag;
    }
};

/// Names protected members of b2Fixture's.
struct FixtureAccess : b2Fixture {
    static int32 ProxyOf(const b2Fixture *fixture, int32 child) { return Proxies(fixture)[child].proxyId; }
    static b2FixtureProxy *Proxies(const b2Fixture *fixture) { return fixture->*(&FixtureAccess::m_proxies); }
    static int32 ProxyCount(const b2Fixture *fixture) { return fixture->*(&FixtureAccess::m_proxyCount); }
};

} // namespace bmr

#endif
