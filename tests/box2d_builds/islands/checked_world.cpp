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

#include <box2d/box2d.h>

#include "dynamics/b2_contact_solver.h"
#include "dynamics/b2_island.h"
#include "passes/island_solver.h"

extern B2_API bool g_blockSolve;

namespace box2d_builds {

Checked checked = {};

namespace {

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

/// The bytes of all that an island writes to.
class State {
public:
    explicit State(const b2Island &island) {
        for (int32 i = 0; i < island.m_bodyCount; ++i)
            Add(island.m_bodies[i], sizeof(b2Body));
        for (int32 i = 0; i < island.m_contactCount; ++i)
            Add(island.m_contacts[i], sizeof(b2Contact));
        for (int32 i = 0; i < island.m_jointCount; ++i)
            Add(island.m_joints[i], SizeOf(*island.m_joints[i]));
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
    void Add(void *object, size_t size) {
        m_parts.push_back({object, size});
        m_bytes.insert(m_bytes.end(), static_cast<char *>(object), static_cast<char *>(object) + size);
    }
    std::vector<Part> m_parts;
    std::vector<char> m_bytes;
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

bmr::IslandSolvers solvers;

class CheckedIsland : public b2Island {
public:
    using b2Island::b2Island;

    void Solve(b2Profile *profile, const b2TimeStep &step, const b2Vec2 &gravity, bool allowSleep) {
        *profile = {};
        Check([&] { b2Island::Solve(profile, step, gravity, allowSleep); },
              [&](b2ContactListener *listener) {
                  WithOurs(step, listener,
                           [&](bmr::IslandSolver *solver) { solver->Solve(gravity, allowSleep); });
              });
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
    template <typename Solving>
    void WithOurs(const b2TimeStep &step, b2ContactListener *listener, const Solving &solve) {
        struct Taken { // a listener may step the world, or throw
            bmr::IslandSolver *const solver = solvers.Take();
            ~Taken() { bmr::IslandSolvers::GiveBack(solver); }
        } const taken;
        if (taken.solver == nullptr ||
            !taken.solver->Reserve(static_cast<uint32_t>(m_bodyCount), static_cast<uint32_t>(m_contactCount),
                                   static_cast<uint32_t>(m_jointCount)))
            Fail("memory");
        taken.solver->Begin(step, listener);
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
        ours(&toldByOurs);
        State left(*this);
        if (checked.islands == checked.turnsABitIn)
            left.TurnABit();
        before.PutBack();
        b2ContactListener *const listener = m_listener;
        m_listener = &toldByStock;
        stock();
        m_listener = listener;
        if (!State(*this).IsLike(left))
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
};

} // namespace

} // namespace box2d_builds

using box2d_builds::CheckedIsland;
#define b2Island CheckedIsland
#include "dynamics/b2_world.cpp"
