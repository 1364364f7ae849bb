// SPDX-License-Identifier: MIT
// b2TimeOfImpact: where b2World::SolveTOI asks, a pair that is proved apart over its whole motion is
// separated without a search. It looks at whether the answer is e_touching, and at the time only then;
// Box2D's own search may end as e_failed or e_overlapped, too. The counters b2_toi* and b2_gjk* stand still
// where Box2D is not asked. A game that asks, also in a step, gets Box2D's own answer. Of big polygons Box2D
// is never asked: its search knows no more than 256 vertices.
#include <box2d/b2_time_of_impact.h>

#include "hooks/stepping.h"
#include "hooks/untold_impacts.h"
#include "proofs/convex_distance.h"
#include "proofs/sweep_apart.h"
#include "reach/stock.h"
#include "start/current_step.h"
#include "start/settings.h"
#include "tell/verify.h"

namespace bmr::hooks {

namespace {
constexpr uint32_t kImpactsToRest = 256;
} // namespace

void RealTimeOfImpact(b2TOIOutput *output, const b2TOIInput *input) {
    if (AnyBigPolygon() && BigImpact(output, *input))
        return;
    stock::TimeOfImpact(output, input);
}

} // namespace bmr::hooks

using namespace bmr;
using namespace bmr::hooks;

BMR_FOR_LOADERS("_Z14b2TimeOfImpactP11b2TOIOutputPK10b2TOIInput");

void b2TimeOfImpact(b2TOIOutput *output, const b2TOIInput *input) {
    if (NothingIsInstalled() && !AnyBigPolygon())
        return stock::TimeOfImpact(output, input);
    const bool isSearch = ImpactSearch::Asks(input) || !GameMayRun();
    if (KnownImpacts::Take()) { // counted by who sought
        RealTimeOfImpact(output, input);
        NoteTimeOfImpactIsReached();
        if (output->state == b2TOIOutput::e_touching && stepping.untold != nullptr)
            stepping.untold->Object()->FoundImpact();
        return;
    }
    if (AnyBigPolygon() && BigImpact(output, *input))
        return;
    if (!isSearch || !HookIsOn(Hook::TimeOfImpact) || stepping.impactsAreBox2Ds || !InStep() ||
        !stepping.restOfImpacts.IsOver()) {
        stock::TimeOfImpact(output, input);
        return;
    }
    Count(&Counts::toiQueries);
    const bool never = NeverTouch(*input);
    stepping.restOfImpacts.Note(1, never ? 0 : 1, kImpactsToRest);
    if (!never) {
        stock::TimeOfImpact(output, input);
        return;
    }
    Count(&Counts::toiAnswered);
    output->state = b2TOIOutput::e_separated;
    output->t = input->tMax;
    if (Verifying()) {
        const b2TOIOutput ours = *output;
        stock::TimeOfImpact(output, input);
        VerifyImpact(nullptr, nullptr, ours, *output);
    }
}
