// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_ISLANDS_H
#define BOOMERANG_GLUE_ISLANDS_H

#include <cstdint>
#include <optional>

#include <box2d/b2_time_step.h>
#include <box2d/b2_world.h>

#include "glue/pairs/contact_marks.h"
#include "glue/pairs/pair_table.h"
#include "solver/island_solver.h"

namespace bmr {

/// b2World::Solve: islands of bodies that touch or are joined are built, depth first, and solved; then boxes
/// follow their bodies, and new contacts are looked for.
///
/// Where the world has a ledger and few of its contacts touch, islands are built from links between these
/// alone, in the order of Box2D's lists. Once code of the game has made a step inside this one they are built
/// from the lists of bodies.
class IslandPass {
public:
    IslandPass(b2World *world, const b2TimeStep &step, IslandSolver *solver);
    void Run();

private:
    void SolveIslands(b2Profile *profile);
    void ClearFlags();
    bool Link();
    void LinkTo(b2Body *body, b2Contact *contact, b2Body *other);

    b2Body *FirstSeed();
    b2Body *NextSeed(const b2Body *seed);
    void BuildIsland(b2Body *seed);
    void Take(b2Body *body);
    void Take(b2Contact *contact, b2Body *other);
    void WakeInIsland(b2Body *body);
    void TakeJoints(const b2Body *body);
    void Push(b2Body *body);
    void MakeRoom();
    void SolveIsland();
    void AfterGame();
    void Synchronize();
    void PutPlaceBack(b2Body *body);
    void Follow(b2Body *body);

    b2World *m_world;
    b2ContactManager *m_manager;
    const b2TimeStep &m_step;
    IslandSolver *m_solver;
    b2ContactListener *m_listener; ///< its PostSolve is called, unless it is nullptr
    Ledger *m_ledger;              ///< nullptr: it does not know all pairs
    std::optional<Ledger::Pass> m_pass;
    ContactMarks m_marks;
    IslandRoom &m_room;
    uint32_t m_stackCount = 0, m_linkCount = 0;
    uint32_t m_seed = 0;
    bool m_mayLink = false;       ///< no gear joint reads the places of bodies in islands
    bool m_isLinked = false;      ///< the links are all contacts that touch of bodies that are awake
    bool m_seedsAreAwake = false; ///< they are Bodies::Awake
    bool m_awakeAlone = false;    ///< only bodies of Bodies::Awake are in islands
    bool m_tells = false;         ///< PostSolve was called, and what was owed ahead of it is done
    bool m_gameStepped = false;   ///< contacts and bodies may be others than as the pass began
    const b2Contact *m_newest;    ///< of the world's contacts, and their count, as the pass began
    int32 m_contactCount;
    uint64_t m_latest; ///< LatestStep, as the pass began
};

} // namespace bmr

#endif
