// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_IMPACTS_H
#define BOOMERANG_GLUE_IMPACTS_H

#include <cstdint>
#include <optional>

#include <box2d/b2_settings.h>
#include <box2d/b2_time_step.h>
#include <box2d/b2_world.h>

#include "base/columns.h"
#include "glue/pairs/contact_marks.h"
#include "glue/pairs/pair_table.h"

struct b2TOIInput;

namespace bmr {

class ImpactScan;
class IslandSolver;

/// Is nothing to tunnel through it?
bool Stops(const b2Body *body);

/// The contacts of the world's list that may have an impact, if one of their bodies is awake. The first
/// search of the list in a step writes them down, and later ones look at these: in a pile they are one in
/// a hundred.
class Stoppers {
public:
    /// `room` is where they are written down.
    Stoppers(const b2World *world, Column<b2Contact *> *room) : m_world(world), m_room(room) {}

    /// False where the list is to be searched.
    bool AreKnown() const;
    uint32_t Count() const { return m_count; }
    b2Contact *operator[](uint32_t i) const { return (*m_room)[i]; }

    /// A search of the list begins.
    void Begin();
    void Add(b2Contact *contact) {
        if (m_known)
            (*m_room)[m_count++] = contact;
    }

    // The world is locked while listeners are called in an impact: they can make bullets and sensors. A step
    // inside this one unlocks it, unless an exception ends that step.
    void BeforeGame();
    /// Ahead of the search for new contacts.
    void AfterGame();
    void Forget() { m_known = false; }

private:
    uint64_t Digest() const;

    const b2World *m_world;
    Column<b2Contact *> *m_room;
    bool m_known = false, m_hasDigest = false;
    uint32_t m_count = 0;
    int32_t m_contactCount = 0;
    uint64_t m_step = 0; ///< LatestStep, as the search began
    const b2Contact *m_newest = nullptr;
    uint64_t m_digest = 0;
};

/// b2World::SolveTOI: finds the first impact of what is left of the step, lets the bodies of its island meet,
/// and begins again, until there is none.
///
/// In a world with a ledger the times of impact that are known stand in a heap (Marks), and after an impact
/// those pairs alone are asked that Box2D would ask again. In other worlds Box2D's list is searched, and
/// after that its Stoppers. Either way a pair that is proved apart over its whole motion is not asked.
class ImpactPass {
public:
    ImpactPass(b2World *world, const b2TimeStep &step, IslandSolver *solver);

    void Run();

private:
    bool MayUseHeap() const;
    void BeginStep();
    void BeginBodies();

    void SearchByLedger(bool all);
    void SearchPair(uint32_t i);
    void DoubtBudgets();
    void EnableIfOwed(uint32_t i);
    void AskAgain();
    void Ask(uint32_t i);
    void Queue(uint32_t i);
    b2Contact *Earliest(float *time);

    b2Contact *EarliestInList(float *time);
    bool IsEarlier(b2Contact *contact, float *time);
    void FindTime(b2Contact *contact);
    float TimeOf(b2Contact *contact, float from);
    static void FillInput(const b2Contact &contact, b2TOIInput *input);
    bool IsProvedApart(const b2Contact &contact, b2TOIInput *input);

    // An impact (impact_island.cpp).
    struct Island {
        b2Body *bodies[2 * b2_maxTOIContacts];
        int32 bodyCount = 0, contactCount = 0;
    };
    bool Meet(b2Contact *contact, float time);
    void Spread(b2Body *body, float time, Island *island);
    void Add(b2Body *body, Island *island);
    void Add(b2Contact *contact, Island *island);
    void PutBack(b2Body *body, const b2Sweep &sweep);
    void EndIsland(const Island &island);
    void FindNewContacts();
    void Update(b2Contact *contact);
    void BeforeGame();
    void AfterGame();
    void CheckTable();
    void Wake(b2Body *body);
    void AskPairsOf(const b2Body *body);
    void ReadWhatGameDid();
    void Rebuild();

    b2World *m_world;
    b2ContactManager *m_manager;
    const b2TimeStep &m_step;
    IslandSolver *m_solver;
    b2ContactListener *m_listener; ///< its PostSolve is called, unless it is nullptr
    Ledger *m_ledger;              ///< nullptr: Box2D's list is searched
    std::optional<Ledger::Pass> m_pass;
    ContactMarks m_marks;
    Stoppers m_stoppers;
    ImpactScan *m_scan = nullptr; ///< while nothing has moved
    bool m_gameRan;               ///< ahead of the first search; and it may have changed more than motion
    bool m_wasGameCalled = false; ///< since the impact began
    bool m_flagsAreRead;          ///< of all movers, ahead of the pass's first call
    bool m_budgetsDoubted = false;
};

} // namespace bmr

#endif
