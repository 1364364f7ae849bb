// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_TAKEN_SOLVER_H
#define BOOMERANG_GLUE_TAKEN_SOLVER_H

#include "base/per_thread.h"
#include "base/rounding_mode.h"
#include "passes/island_solver.h"
#include "start/settings.h"

namespace bmr {

/// A solver for one pass. The pass is Box2D's where there is none: Box2D was built with fused products,
/// numbers are not rounded to nearest, or there is no memory.
class TakenSolver {
public:
    TakenSolver(uint32_t bodies, uint32_t contacts, uint32_t joints) {
        IslandSolvers *const solvers =
            GetSettings().solvesIslands && RoundsToNearest() ? PerThread<IslandSolvers>() : nullptr;
        m_solver = solvers != nullptr ? solvers->Take() : nullptr;
        if (m_solver == nullptr || m_solver->Reserve(bodies, contacts, joints))
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
