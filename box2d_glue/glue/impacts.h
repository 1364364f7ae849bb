// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_IMPACTS_H
#define BOOMERANG_GLUE_IMPACTS_H

#include <cstdint>

#include <box2d/b2_settings.h>
#include <box2d/b2_time_step.h>
#include <box2d/b2_world.h>

#include "base/columns.h"
#include "glue/pairs/pair_table.h"

namespace bmr {

class ImpactScan;
class IslandSolver;

/// The contacts of the world's list that may have an impact, if one of their bodies is awake. The first
/// search of the list in a step writes them down, and later ones read these: in a pile they are one in a
/// hundred.
class ToiCandidates {
public:
    ToiCandidates(const b2World *world, Column<b2Contact *> *contacts)
        : m_world(world), m_contacts(contacts) {}

    /// False where the list is to be searched. (New contacts come at the head of the list.)
    bool AreKnown() const { return m_known && m_world->GetContactManager().m_contactList == m_newest; }
    uint32_t Count() const { return m_count; }
    b2Contact *operator[](uint32_t i) const { return (*m_contacts)[i]; }

    /// A search of the list begins.
    void Begin() {
        const b2ContactManager &manager = m_world->GetContactManager();
        m_known = true;
        m_contacts->Reserve(static_cast<uint32_t>(manager.m_contactCount));
        m_count = 0;
        m_newest = manager.m_contactList;
    }
    void Add(b2Contact *contact) { (*m_contacts)[m_count++] = contact; }
    /// Code of the game runs: it can make bullets and sensors.
    void Forget() { m_known = false; }

private:
    const b2World *m_world;
    Column<b2Contact *> *m_contacts; ///< where they are written down
    bool m_known = false;
    uint32_t m_count = 0;
    const b2Contact *m_newest = nullptr;
};

/// SolveImpacts (passes.h).
class ImpactPass {
public:
    ImpactPass(b2World *world, const b2TimeStep &step, IslandSolver *solver, PairTable *table);

    void Run();

private:
    void BeginScan();
    void BeginStep();
    void BeginBodies();

    void SearchByTable();
    void FindDisabled();
    void SearchPending();
    void FindTimeOfPair(uint32_t i);
    void Queue(uint32_t i, float time);
    b2Contact *Earliest(float *time);

    b2Contact *EarliestInList(float *time);
    bool IsEarlier(b2Contact *contact, float *time);
    float FindTime(b2Contact *contact);
    float TimeOf(b2Contact *contact, float from);
    bool IsProvedApart(const b2Contact &contact);

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
    void CheckTable();
    void ForgetTime(b2Contact *contact);
    void Wake(b2Body *body);
    void MarkPending(const b2Body *body);
    void ReadWhatGameDid();

    b2World *m_world;
    b2ContactManager *m_manager;
    const b2TimeStep &m_step;
    IslandSolver *m_solver;
    b2ContactListener *m_listener; ///< of PostSolve
    PairTable *m_table;            ///< nullptr: Box2D's list is searched
    ToiCandidates m_candidates;
    ImpactScan *m_scan = nullptr; ///< of the search; nullptr: Box2D answers
    bool m_wasGameCalled = false; ///< since the impact began
};

} // namespace bmr

#endif
