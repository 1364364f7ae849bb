// SPDX-License-Identifier: MIT
// Box2D's b2_world.cpp, in which each island is solved by Box2D and by ours from the same state, and compared
// to the bit; some with the other value of g_blockSolve. Then every other one goes on as ours leaves it, with
// the world's own listener.
#include "checked_world.h"

#include <cfenv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <sys/mman.h>

#include <box2d/box2d.h>

#include "base/private_members.h"
#include "dynamics/b2_contact_solver.h"
#include "dynamics/b2_island.h"
#include "passes/island_solver.h"

extern B2_API bool g_blockSolve;

namespace box2d_builds {

namespace {

Checked *Share() {
    void *const shared =
        mmap(nullptr, sizeof(Checked), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    return shared == MAP_FAILED ? std::abort(), nullptr : static_cast<Checked *>(shared);
}

[[noreturn]] void Fail(const char *what) {
    std::printf("FAILED: %s is another one after island %ld\n", what, checked.islands);
    std::fflush(stdout);
    std::_Exit(EXIT_FAILURE);
}

size_t SizeOf(b2Joint &joint) {
    switch (joint.GetType()) {
    case e_revoluteJoint:
        return sizeof(b2RevoluteJoint);
    case e_prismaticJoint:
        return sizeof(b2PrismaticJoint);
    case e_distanceJoint:
        return sizeof(b2DistanceJoint);
    case e_pulleyJoint:
        return sizeof(b2PulleyJoint);
    case e_mouseJoint:
        return sizeof(b2MouseJoint);
    case e_gearJoint:
        return sizeof(b2GearJoint);
    case e_wheelJoint:
        return sizeof(b2WheelJoint);
    case e_weldJoint:
        return sizeof(b2WeldJoint);
    case e_frictionJoint:
        return sizeof(b2FrictionJoint);
    default:
        return sizeof(b2MotorJoint);
    }
}

size_t SizeOf(const b2Shape &shape) {
    switch (shape.GetType()) {
    case b2Shape::e_circle:
        return sizeof(b2CircleShape);
    case b2Shape::e_edge:
        return sizeof(b2EdgeShape);
    case b2Shape::e_polygon:
        return sizeof(b2PolygonShape);
    default:
        return sizeof(b2ChainShape);
    }
}

/// Floats, or other words of that size; a NaN has any payload.
bool AreAlike(const void *one, const void *other, size_t bytes) {
    for (size_t at = 0; at + sizeof(float) <= bytes; at += sizeof(float)) {
        float a, b;
        std::memcpy(&a, static_cast<const char *>(one) + at, sizeof a);
        std::memcpy(&b, static_cast<const char *>(other) + at, sizeof b);
        if (std::memcmp(&a, &b, sizeof a) != 0 && (a == a || b == b))
            return false;
    }
    return true;
}

/// The bytes of all that an island writes to, joints and static bodies last; and of the shapes, which a
/// filter may change behind the islands.
class State {
public:
    explicit State(const b2Island &island) {
        AddBodies(island, false);
        for (int32 i = 0; i < island.m_contactCount; ++i) {
            b2Contact *const contact = island.m_contacts[i];
            Add(contact, sizeof(b2Contact));
            for (b2Fixture *fixture : {contact->GetFixtureA(), contact->GetFixtureB()})
                Add(fixture->GetShape(), SizeOf(*fixture->GetShape()));
        }
        m_ofThis = m_bytes.size();
        for (int32 i = 0; i < island.m_jointCount; ++i)
            Add(island.m_joints[i], SizeOf(*island.m_joints[i]));
        AddBodies(island, true);
    }
    /// The same objects as they are now.
    State Now() const {
        State now = *this;
        char *to = now.m_bytes.data();
        for (const Part &part : m_parts) {
            std::memcpy(to, part.object, part.size);
            to += part.size;
        }
        return now;
    }
    /// But for static bodies, which other islands write to, and joints, which know their bodies' places.
    bool IsLikeAlone(const State &other) const {
        return AreAlike(m_bytes.data(), other.m_bytes.data(), m_ofThis);
    }
    void PutBack() const {
        const char *from = m_bytes.data();
        for (const Part &part : m_parts) {
            std::memcpy(part.object, from, part.size);
            from += part.size;
        }
    }
    void TurnABit() { m_bytes.front() = static_cast<char>(m_bytes.front() ^ 1); }
    bool IsLike(const State &other) const {
        return m_bytes.size() == other.m_bytes.size() &&
               AreAlike(m_bytes.data(), other.m_bytes.data(), m_bytes.size());
    }

private:
    struct Part {
        void *object;
        size_t size;
    };
    void AddBodies(const b2Island &island, bool isStatic) {
        for (int32 i = 0; i < island.m_bodyCount; ++i)
            if ((island.m_bodies[i]->GetType() == b2_staticBody) == isStatic)
                Add(island.m_bodies[i], sizeof(b2Body));
    }
    void Add(void *object, size_t size) {
        m_parts.push_back({object, size});
        m_bytes.insert(m_bytes.end(), static_cast<char *>(object), static_cast<char *>(object) + size);
    }
    std::vector<Part> m_parts;
    std::vector<char> m_bytes;
    size_t m_ofThis = 0; ///< bytes ahead of those
};

struct Recorder final : b2ContactListener {
    std::vector<float> told;
    void PostSolve(b2Contact *, const b2ContactImpulse *impulse) override {
        told.push_back(static_cast<float>(impulse->count));
        for (int32 i = 0; i < impulse->count; ++i) {
            told.push_back(impulse->normalImpulses[i]);
            told.push_back(impulse->tangentImpulses[i]);
        }
    }
    bool IsLike(const Recorder &other) const {
        return told.size() == other.told.size() &&
               AreAlike(told.data(), other.told.data(), told.size() * sizeof(float));
    }
};

std::vector<float> ReactionsOf(const std::vector<b2Joint *> &joints) {
    std::vector<float> reactions;
    for (const b2Joint *joint : joints) {
        const b2Vec2 force = joint->GetReactionForce(1.0f);
        reactions.insert(reactions.end(), {force.x, force.y, joint->GetReactionTorque(1.0f)});
    }
    return reactions;
}

bmr::IslandSolvers solvers;

class CheckedIsland : public b2Island {
public:
    using b2Island::b2Island;
    ~CheckedIsland() { CheckTogether(); }

    void Solve(b2Profile *profile, const b2TimeStep &step, const b2Vec2 &gravity, bool allowSleep) {
        *profile = {};
        m_step = step;
        m_gravity = gravity;
        m_allowSleep = allowSleep;
        const bool mayWait = m_listener == nullptr && std::fegetround() == FE_TONEAREST;
        if (mayWait)
            m_solved.push_back({{m_bodies, m_bodies + m_bodyCount},
                                {m_contacts, m_contacts + m_contactCount},
                                {m_joints, m_joints + m_jointCount},
                                State(*this),
                                State(*this),
                                {}});
        Check([&] { b2Island::Solve(profile, step, gravity, allowSleep); },
              [&](b2ContactListener *listener) {
                  WithOurs(step, listener,
                           [&](bmr::IslandSolver *solver) { solver->Solve(gravity, allowSleep); });
              });
        if (!mayWait)
            return;
        m_solved.back().after = m_solved.back().before.Now();
        m_solved.back().reactions = ReactionsOf(m_solved.back().joints);
    }
    void SolveTOI(const b2TimeStep &step, int32 a, int32 b) {
        if (a != 0 || b != 1)
            Fail("the place of a body that meets another");
        ++checked.impacts;
        Check([&] { b2Island::SolveTOI(step, a, b); },
              [&](b2ContactListener *listener) {
                  WithOurs(step, listener, [](bmr::IslandSolver *solver) { solver->SolveToi(); });
              });
    }

private:
    struct Taken { // a listener may step the world, or throw
        bmr::IslandSolver *const solver = solvers.Take();
        ~Taken() { bmr::IslandSolvers::GiveBack(solver); }
    };
    struct Solved {
        std::vector<b2Body *> bodies;
        std::vector<b2Contact *> contacts;
        std::vector<b2Joint *> joints;
        State before, after;
        std::vector<float> reactions;
    };

    /// All islands of a step again, by one solver of ours, as a pass without a listener solves them.
    void CheckTogether() {
        if (m_solved.size() < 2)
            return;
        std::vector<State> now;
        size_t bodies = 0, contacts = 0, joints = 0;
        for (const Solved &of : m_solved) {
            now.push_back(of.before.Now());
            bodies += of.bodies.size();
            contacts += of.contacts.size();
            joints += of.joints.size();
        }
        for (size_t i = m_solved.size(); i-- > 0;) // static bodies are as the first island finds them
            m_solved[i].before.PutBack();
        const Taken taken;
        taken.solver->Reserve(static_cast<uint32_t>(bodies), static_cast<uint32_t>(contacts),
                              static_cast<uint32_t>(joints));
        bool hasGear = false;
        for (const Solved &of : m_solved)
            for (const b2Joint *joint : of.joints)
                hasGear = hasGear || joint->GetType() == e_gearJoint;
        taken.solver->Begin(m_step, nullptr, !hasGear);
        for (const Solved &of : m_solved) {
            for (b2Body *body : of.bodies)
                taken.solver->Add(body);
            for (b2Contact *contact : of.contacts)
                taken.solver->Add(contact);
            for (b2Joint *joint : of.joints)
                taken.solver->Add(joint);
            taken.solver->Solve(m_gravity, m_allowSleep);
        }
        taken.solver->Finish(nullptr);
        for (const Solved &of : m_solved) {
            for (size_t i = 0; i < of.bodies.size(); ++i)
                of.bodies[i]->*Named(bmr::IslandIndex()) = static_cast<int32>(i);
            const std::vector<float> reactions = ReactionsOf(of.joints);
            if (!of.before.Now().IsLikeAlone(of.after) ||
                !AreAlike(reactions.data(), of.reactions.data(), reactions.size() * sizeof(float)))
                Fail("what an island leaves, solved with others,");
            ++checked.together;
        }
        for (const State &of : now)
            of.PutBack();
    }
    template <typename Solving>
    void WithOurs(const b2TimeStep &step, b2ContactListener *listener, const Solving &solve) {
        const Taken taken;
        taken.solver->Reserve(static_cast<uint32_t>(m_bodyCount), static_cast<uint32_t>(m_contactCount),
                              static_cast<uint32_t>(m_jointCount));
        taken.solver->Begin(step, listener, false);
        for (int32 i = 0; i < m_bodyCount; ++i)
            taken.solver->Add(m_bodies[i]);
        for (int32 i = 0; i < m_contactCount; ++i)
            taken.solver->Add(m_contacts[i]);
        for (int32 i = 0; i < m_jointCount; ++i)
            taken.solver->Add(m_joints[i]);
        solve(taken.solver);
        taken.solver->Finish(nullptr);
    }
    template <typename Stock, typename Ours> void Check(const Stock &stock, const Ours &ours) {
        if (std::fegetround() != FE_TONEAREST) { // no step of ours
            stock();
            return;
        }
        ++checked.islands;
        checked.contacts += m_contactCount;
        checked.joints += m_jointCount;
        const bool goesOnByOurs = checked.islands % 2 == 0;
        const bool blocks = g_blockSolve;
        if (checked.islands % 7 == 0)
            g_blockSolve = !blocks;
        const State before(*this);
        Recorder toldByOurs, toldByStock;
        b2ContactListener *const listener = m_listener;
        m_listener = &toldByStock;
        stock();
        m_listener = listener;
        const State left(*this);
        before.PutBack();
        checked.isInOurs = true;
        ours(&toldByOurs);
        checked.isInOurs = false;
        State leftByOurs(*this);
        if (checked.islands == checked.turnsABitIn)
            leftByOurs.TurnABit();
        if (!leftByOurs.IsLike(left))
            Fail("what an island leaves");
        if (!toldByOurs.IsLike(toldByStock))
            Fail("an impulse that a listener is told of");
        before.PutBack();
        g_blockSolve = blocks;
        if (goesOnByOurs)
            ours(listener);
        else
            stock();
    }

    b2TimeStep m_step = {};
    b2Vec2 m_gravity = {0.0f, 0.0f};
    bool m_allowSleep = false;
    std::vector<Solved> m_solved; ///< by this world's step, if there is no listener
};

} // namespace

Checked &checked = *Share();

} // namespace box2d_builds

using box2d_builds::CheckedIsland;
#define b2Island CheckedIsland
#include "dynamics/b2_world.cpp"
