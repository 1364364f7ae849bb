// SPDX-License-Identifier: MIT
#ifndef BOX2D_BUILDS_RANDOM_GAME_H
#define BOX2D_BUILDS_RANDOM_GAME_H

#include <cstdio>

#include "drawn.h"
#include "game.h"
#include "impact_watch.h"
#include "random_world.h"

namespace box2d_builds {

/// What listeners and filters of random games did: a campaign in which one of these is 0 has not tried it.
struct Deeds {
    unsigned long edits = 0, filters = 0, thrown = 0, otherSteps = 0, draws = 0, disabled = 0,
                  ownDisabled = 0, enabled = 0, refused = 0, destroyed = 0, made = 0, moved = 0, solid = 0,
                  disabledInImpacts = 0;
    void operator+=(const Deeds &more);
    void Print(FILE *to) const;
};

/// A random world (tests/differential) in which listeners and filters do more: all that a game may do, and,
/// in a Box2D without assertions, what games do there all the same. Stock survives it: no listener ends what
/// Box2D is in the midst of, or Box2D is known to go on with it as it was. What is done depends on numbers
/// that are the same in each run.
class RandomGame final : public Game, private b2ContactFilter {
public:
    explicit RandomGame(long seed);
    const Deeds &Done() const { return m_done; }

    void Build(testbed::Stage &stage, int size) override;
    void BeforeStep(testbed::Stage &stage, int step) override;
    float TimeStep() const override { return m_world.TimeStep(); }
    uint64_t Probes() const override;
    void AfterException() override;
    void SetOther(Playing *other) override { m_other = other; }

    void OnBegin(b2Contact &contact) override;
    void OnEnd(b2Contact &contact) override;
    void OnPreSolve(b2Contact &contact) override;
    void OnPostSolve(b2Contact &contact) override;
    void OnGoodbye(b2Joint &joint) override { m_world.OnGoodbye(joint); }

private:
    enum Occasion : uint32_t { kBegin, kEnd, kPreSolve, kPostSolve, kFilter };

    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override;
    uint32_t Mix(const b2Fixture &a, const b2Fixture &b, Occasion occasion) const;
    b2Body *Third(uint32_t mixed) const;

    void Act(b2Contact &contact, Occasion occasion);
    void ActLocked(b2Contact &contact, uint32_t mixed, Occasion occasion);
    void ActBetweenSteps(b2Contact &contact, uint32_t mixed);
    void ActReleased(b2Contact &contact, uint32_t mixed, Occasion occasion);
    void Edit(b2Body *body, uint32_t mixed);
    void ChangeFilter(b2Fixture *fixture, uint32_t mixed);
    void TurnSolid(b2Body *body);
    void StepOther();
    void LookWhereBodiesAre();
    void Throw(Occasion occasion);
    void TryWhatIsRefused(b2Body *body, uint32_t mixed);

    long m_seed;
    differential::RandomWorld m_world;
    testbed::Stage *m_stage = nullptr;
    Playing *m_other = nullptr;
    ImpactWatch m_watch;
    Drawn m_drawn;
    Deeds m_done;
    int m_step = 0;
    bool m_acting = false;   ///< what a listener does calls listeners: those only look
    bool m_mayThrow = false; ///< once between two calls of BeforeStep
    bool m_mayOwn = false;   ///< one body of the contact that is told of may be disabled, once a step
};

} // namespace box2d_builds

#endif
