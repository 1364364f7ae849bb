// SPDX-License-Identifier: MIT
#ifndef AS_STOCK_ACTOR_WORLD_H
#define AS_STOCK_ACTOR_WORLD_H

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include <box2d/box2d.h>

#include "state/numbers.h"
#include "state/snapshot.h"

namespace actor {

class World;

/// When a callback of the game's is called.
enum Occasion : uint32_t { kBegin, kEnd, kPreSolve, kPostSolve, kFilter };

/// What a callback knows, and numbers to choose by.
struct Moment {
    World &world;
    b2Contact *contact;
    b2Fixture *fixture; ///< one of the contact's
    b2Body *body;       ///< that fixture's
    b2Body *third;      ///< any body
    uint32_t mixed;
    float amount;
    Occasion occasion;
};

/// kUnlocked: it acts also where a contact ends between steps.
enum Manners { kLocked, kUnlocked };

/// What a listener does, by its number. (Behind the last: nothing.)
struct Reaction {
    const char *name;
    Manners manners;
    void (*act)(Moment &moment);
};
extern const Reaction kReactions[];
extern const uint32_t kReactionCount;
extern std::atomic<uint64_t> reactionsDone[]; ///< how often each was done, in this process
uint8_t ReactionOf(const char *name);

/// A world, the numbers of what is in it, and what its callbacks do: a few bytes, chosen from by the numbers
/// of whom they are called for and by the step. They hold no state, so how often they are called does not
/// matter.
class World final : private b2ContactListener, private b2DestructionListener, private b2ContactFilter {
public:
    explicit World(const b2Vec2 &gravity);
    World(const World &) = delete;
    World &operator=(const World &) = delete;

    b2World &Box2D() { return m_world; }
    b2Body *Create(b2BodyDef def);
    b2Fixture *Create(b2Body *body, b2FixtureDef def, const b2Shape &shape);
    uintptr_t NextFixture() { return m_fixturesMade++; }
    b2Joint *Create(b2JointDef &def);

    /// A step, and another one where a callback threw: until then the world is locked.
    void Step(float timeStep, int32 velocityIterations, int32 positionIterations);
    static bool IsFinite(const b2Body &body);
    /// Has no body left the numbers that was not sent?
    bool IsFinite() const;

    testbed::StateHashes Hashes() const { return testbed::HashState(m_world, m_recorder); }
    testbed::HashSink &Probes() { return m_probes; }
    /// What was recorded is forgotten.
    void StartRecord(bool inWords);
    std::string Describe() const { return testbed::DescribeState(m_world, m_recorder); }
    /// Another listener and another filter, of the same mind; or none.
    void ChangeHands(uint32_t how);
    /// The same from within a callback: the next step has the first ones again.
    void ChangeHandsForNow(uint32_t how);
    /// Another contact than the one that a listener is called for, or outside of steps.
    void Disable(b2Contact *contact) {
        contact->SetEnabled(false);
        m_disabled = true;
    }
    /// Not more than a step can afford, in a crowd in which everybody reads everything.
    bool MayRead() { return (m_read += m_world.GetContactCount()) < 8000; }
    /// Hashes what b2World::DebugDraw draws.
    void Draw();
    b2Body *SomeBody(uint32_t mixed);
    /// In the midst of a step of this world, after bodies were moved: listeners hear of impacts.
    bool IsInImpacts() const { return m_inImpacts; }
    /// From a listener while contacts are brought up to date: a step of the same world, which unlocks it, and
    /// what only an unlocked world lets a game do.
    void StepInItself(const Moment &moment);
    /// Throws, if that was asked for.
    void MayThrow(Occasion occasion);

    static constexpr int kReactionsHeld = 8;
    uint8_t reactions[kReactionsHeld] = {}; ///< what listeners do
    uint8_t refused = 0;                    ///< which pairs the filter refuses
    uint8_t filterReacts =
        0; ///< bit 0: it does some of what listeners do; bit 1: and the rest, as far as it may
    bool hasThrown = false; ///< through a step; from there on bits may be others than stock's
    uint8_t throwing = 0;   ///< 0: no; else one exception, from the occasion throwing % 5, after throwing / 5
    uint8_t ticks = 0;      ///< what happens ahead of each step: see Tick
    int rounding = 0;       ///< of steps: an index of kRoundings
    float rescueBeyond = 0.0f; ///< what is farther from `home` than this is put back; 0: nothing
    b2Vec2 home = {0.0f, 0.0f};
    bool mayBeNowhere = false; ///< bodies were sent where numbers are none
    World *other = nullptr;    ///< a callback may step it

private:
    void BeginContact(b2Contact *contact) override;
    void EndContact(b2Contact *contact) override;
    void PreSolve(b2Contact *contact, const b2Manifold *old) override;
    void PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) override;
    void SayGoodbye(b2Joint *joint) override;
    void SayGoodbye(b2Fixture *fixture) override;
    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override;

    /// The other listener and filter. Its class has no PreSolve, which is seen by who calls it.
    class Other final : public b2ContactListener, public b2ContactFilter {
    public:
        explicit Other(World *world) : m_to(world) {}
        void BeginContact(b2Contact *contact) override { m_to->BeginContact(contact); }
        void EndContact(b2Contact *contact) override { m_to->EndContact(contact); }
        bool ShouldCollide(b2Fixture *a, b2Fixture *b) override { return m_to->ShouldCollide(a, b); }

    private:
        World *m_to;
    };
    struct Thrown {};

    uint32_t Mix(const b2Fixture &a, const b2Fixture &b, Occasion occasion) const;
    void React(b2Contact *contact, Occasion occasion);
    void ReactAsFilter(b2Fixture *a, b2Fixture *b);
    bool ReactAsWildFilter(b2Fixture *a, b2Fixture *b);
    void ChangeUnlocked(const Moment &moment, uint32_t mixed);
    void Tick();
    void Rescue();
    void NoteStepped(float timeStep);
    void RememberPlaces();
    void Watch(const b2Contact &contact);

    b2World m_world;
    Other m_other{this};
    bool m_handsChanged = false; ///< by a callback: until the next step
    bool m_heard = true, m_disabled = false;
    bool m_called = false;   ///< a listener or a filter, since the step began
    bool m_reacting = false; ///< what a callback does calls others: those only read
    bool m_stepping = false;
    bool m_inItself = false;
    bool m_inImpacts = false;
    bool m_mayGoOn = false; ///< the next step, where the last one stopped
    struct Place {
        b2Vec2 center;
        float angle;
    };
    std::vector<Place> m_places; ///< of bodies by their numbers, as the step began
    testbed::EventRecorder m_recorder;
    testbed::HashSink m_probes;
    uintptr_t m_bodiesMade = 0, m_fixturesMade = 0, m_jointsMade = 0;
    uint32_t m_steps = 0;
    int32 m_read = 0; ///< contacts in this step
};

/// The shape of a fixture whose vertices may be changed in place; nullptr where it is any other. (Those of a
/// polygon of any size may not.)
b2PolygonShape *PlainPolygon(b2Fixture &fixture);

/// Hash what anybody may ask Box2D of two fixtures, and of a contact at its poses.
void ProbePair(testbed::HashSink &sink, const b2Fixture &a, int32 childA, const b2Fixture &b, int32 childB);
void ProbeContact(testbed::HashSink &sink, b2Contact &contact, b2Vec2 away);

/// All shapes of a body in place, as games do it that know what they do: boxes in the tree stay as they are.
void EditAll(b2Body *body, float scale, b2Vec2 by);

/// Moves all vertices away from the middle of the body, or toward it once one is farther than `reach`.
/// Normals stay right, and Box2D does not know.
void ScaleInPlace(b2PolygonShape *polygon, float reach);

// What listeners and filters do alike: to a body or a fixture, as a number says.
b2Body *CreateBox(World &world, b2Vec2 at, float angle, b2BodyType type);
/// A polygon: another radius, smaller, or scaled.
void Edit(b2Fixture *fixture, uint32_t mixed);
void SetFilterData(b2Fixture *fixture, uint32_t mixed);
void ThrowBody(b2Body *body, uint32_t mixed);

} // namespace actor

#endif
