// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_HOOKS_STEPPING_H
#define BOOMERANG_HOOKS_STEPPING_H

#include <cstdint>

#include "ledger/proof_rest.h"
#include "start/compiler.h"
#include "start/rounding_mode.h"

class b2ContactManager;
class b2World;
struct b2TOIInput;
struct b2TOIOutput;

/// @file
/// What the hooks share: whether a world is being stepped on this thread, and by whom.

namespace bmr::hooks {

class ImpactSearch;
class ShortList;
class StepMark;
class TouchingList;
class UntoldImpacts;

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

/// What the hooks keep on a thread while it steps worlds, and no longer. (Marks and lists are chained: see
/// InChain. A list is looked up by the world it is of.)
struct Stepping {
    InChain<StepMark> *mark;       ///< the newest of the steps that have not ended; nullptr outside of steps
    InChain<ShortList> *shortList; ///< the newest that is alive
    uint32_t knownImpacts;         ///< so many questions are left that KnownImpacts sends to Box2D
    bool *stepComplete;            ///< while there are any: what KnownImpacts sets to true
    ProofRest restOfSearches; ///< of proofs ahead of Box2D's search for impacts, in worlds without a ledger
    ProofRest restOfImpacts;  ///< of proofs when it asks once more
    bool impactsAreBox2Ds;    ///< nothing is to be proved in the search that is under way: it would not pay
    /// Whose new contacts were looked for last, if that came by here.
    const b2ContactManager *searched;
    InChain<TouchingList> *touchingList; ///< the newest that is alive
    InChain<UntoldImpacts> *untold;      ///< of the newest search for impacts that has not ended
    InChain<ImpactSearch> *impactSearch; ///< the newest call of b2World::SolveTOI that has not ended
};

/// This thread's.
extern BMR_THREAD Stepping stepping;

/// Does this world step in the midst of its own step, by a listener or a filter? All flags and times of
/// contacts and bodies are then left as Box2D leaves them, by Box2D: when the outer step goes on it reads
/// them, be it building islands or looking for impacts.
bool IsInOwnStep(const b2World *world);

/// Only in a step, and rounding to nearest, are questions answered here; all others get Box2D's own answers.
inline bool InStep() {
    return stepping.mark != nullptr && RoundsToNearest();
}

/// A call of Box2D's own b2World::SolveTOI, as long as it lives. Which questions to b2TimeOfImpact are its
/// own, and which a listener's? It reads of an answer whether the two touch, and no more; a listener may read
/// all. Its input lies in its own frame, in the same place each time, and it asks first before it calls a
/// listener.
class ImpactSearch : public InChain<ImpactSearch> {
public:
    ImpactSearch() : InChain(&stepping.impactSearch) {}

    /// Is it a search of this thread's that asks with this input?
    static bool Asks(const b2TOIInput *input) {
        if (stepping.impactSearch == nullptr)
            return false;
        ImpactSearch *const newest = stepping.impactSearch->Object();
        if (newest->m_input == nullptr)
            newest->m_input = input;
        for (const ImpactSearch *search = newest; search != nullptr; search = search->Older()) {
            if (search->m_input == input)
                return true;
        }
        return false;
    }

private:
    const b2TOIInput *m_input = nullptr;
};

/// Box2D's own b2TimeOfImpact, or what stands for it where a polygon is too big for that.
void RealTimeOfImpact(b2TOIOutput *output, const b2TOIInput *input);

/// As long as it lives this thread's questions to b2TimeOfImpact go to Box2D.
class ImpactsAreBox2Ds {
public:
    ImpactsAreBox2Ds() { stepping.impactsAreBox2Ds = true; }
    ~ImpactsAreBox2Ds() { stepping.impactsAreBox2Ds = m_before; }
    ImpactsAreBox2Ds(const ImpactsAreBox2Ds &) = delete;
    ImpactsAreBox2Ds &operator=(const ImpactsAreBox2Ds &) = delete;

private:
    bool m_before = stepping.impactsAreBox2Ds;
};

/// As long as it lives, so many of this thread's next questions to b2TimeOfImpact go to Box2D at once: a
/// proof was sought for them already, in vain. They are the first thing that b2World::SolveTOI does, before
/// it calls anybody. Once it asks it has read `stepComplete`, which was false for it alone, and nobody else
/// is to see that.
class KnownImpacts {
public:
    KnownImpacts(uint32_t count, bool *stepComplete) {
        *stepComplete = false;
        stepping.knownImpacts = count;
        stepping.stepComplete = stepComplete;
    }
    ~KnownImpacts() { stepping.knownImpacts = 0; }
    KnownImpacts(const KnownImpacts &) = delete;
    KnownImpacts &operator=(const KnownImpacts &) = delete;

    static bool Take() {
        if (stepping.knownImpacts == 0)
            return false;
        --stepping.knownImpacts;
        *stepping.stepComplete = true;
        return true;
    }
};

} // namespace bmr::hooks

#endif
