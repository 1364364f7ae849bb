// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_HOOKS_UNTOLD_IMPACTS_H
#define BOOMERANG_HOOKS_UNTOLD_IMPACTS_H

#include "hooks/stepping.h"

namespace bmr {
class Ledger;
}

namespace bmr::hooks {

/// What b2World::SolveTOI would know of the contacts that the ledger kept out of its first search: that no
/// impact is counted for them, and for those that may meet at all that they do not. Nobody asks for it until
/// there is an impact: then Box2D looks at other contacts of the two bodies, and forgets what it knew of
/// them. Code of the game is called after that alone. So where steps are interleaved on one thread
/// (stepping.h) all but the running one are told already.
class UntoldImpacts : public InChain<UntoldImpacts> {
public:
    explicit UntoldImpacts(Ledger *ledger) : InChain(&stepping.untold), m_ledger(ledger) {}

    /// Writes it into the contacts, once.
    void Tell();
    /// The contacts say it by now: Box2D goes on with those that may still have an impact.
    void Finish();
    /// Box2D's search has found the first impact.
    void FoundImpact();

private:
    Ledger *m_ledger;
    bool m_told = false;
};

/// Have questions of Box2D's search for impacts come by our b2TimeOfImpact? Until then nobody can be relied
/// on to say that an impact was found.
bool TimeOfImpactIsReached();
void NoteTimeOfImpactIsReached();

} // namespace bmr::hooks

#endif
