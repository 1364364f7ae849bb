// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_HOOKS_STEPPING_H
#define BOOMERANG_HOOKS_STEPPING_H

#include <cstdint>

#include "base/compiler.h"
#include "base/rounding_mode.h"

class b2ContactManager;
class b2World;

/// @file
/// What the hooks share: whether a world is being stepped on this thread, and by whom.

namespace bmr::hooks {

class StepMark;

/// An object that lives for as long as a call of Box2D's does, in the chain of all of its kind on this
/// thread. A listener may step another world, or its own; and steps of two worlds may be interleaved on one
/// thread, where each runs on a stack of its own and a listener leaves one for the other: the later one need
/// not end first. So an object takes itself out wherever it is in its chain.
template <typename T> class InChain {
public:
    InChain(const InChain &) = delete;
    InChain &operator=(const InChain &) = delete;

    /// What this is a part of; once that is made.
    T *Object() { return static_cast<T *>(this); }

protected:
    /// `newest`: the chain's beginning, in `stepping`.
    explicit InChain(InChain **newest) : m_newest(newest), m_older(*newest) {
        if (m_older != nullptr)
            m_older->m_newer = this;
        *newest = this;
    }
    ~InChain() {
        if (m_older != nullptr)
            m_older->m_newer = m_newer;
        if (m_newer != nullptr)
            m_newer->m_older = m_older;
        else
            *m_newest = m_older;
    }

    T *Older() const { return m_older == nullptr ? nullptr : m_older->Object(); } ///< nullptr: the oldest
    bool IsNewest() const { return m_newer == nullptr; }

private:
    InChain **m_newest;
    InChain *m_older, *m_newer = nullptr;
};

/// What the hooks keep on a thread while it steps worlds, and no longer. Marks are
/// chained: see InChain.
struct Stepping {
    InChain<StepMark> *mark; ///< the newest of the steps that have not ended; nullptr outside of steps
};

/// This thread's.
extern BMR_THREAD Stepping stepping;

/// Does a listener or a filter step this world inside its own step?
bool IsInOwnStep(const b2World *world);

/// Only in a step, and rounding to nearest, are questions answered here; all others get Box2D's own answers.
inline bool InStep() {
    return stepping.mark != nullptr && RoundsToNearest();
}

} // namespace bmr::hooks

#endif
