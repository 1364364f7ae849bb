// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_TAKEN_SOLVER_H
#define BOOMERANG_GLUE_TAKEN_SOLVER_H

#include "base/per_thread.h"
#include "base/rounding_mode.h"
#include "passes/island_solver.h"
#include "start/settings.h"

namespace bmr {

/// A solver for one pass. There is none if no solver gives Box2D's bits, if rounding is not to nearest, or if
/// there is no memory. Then the pass is Box2D's.
class TakenSolver {
public:
    TakenSolver(b2World *world, uint32_t bodies, uint32_t contacts, uint32_t joints) {
        const IslandsBy solvedBy = GetSettings().islandsBy;
        IslandSolvers *const solvers =
            solvedBy != IslandsBy::Nobody && RoundsToNearest() ? PerThread<IslandSolvers>() : nullptr;
        m_solver = solvers != nullptr ? solvers->Take() : nullptr;
        if (m_solver == nullptr)
            return;
        m_solver->SolveBy(solvedBy, world);
        if (m_solver->Reserve(bodies, contacts, joints))
            return;
        IslandSolvers::GiveBack(m_solver);
        m_solver = nullptr;
    }
    ~TakenSolver() {
        if (m_solver != nullptr)
            IslandSolvers::GiveBack(m_solver);
    }
    TakenSolver(const TakenSolver &) = delete;
    TakenSolver &operator=(const TakenSolver &) = delete;
    IslandSolver *Get() const { return m_solver; }

private:
    IslandSolver *m_solver;
};

} // namespace bmr

#endif
