// SPDX-License-Identifier: MIT
// b2Fixture::Synchronize.
#include <box2d/b2_fixture.h>

#include "base/rounding_mode.h"
#include "reach/stock.h"
#include "start/settings.h"
#include "tree/fixture_boxes.h"

using namespace bmr;

BMR_FOR_LOADERS("_ZN9b2Fixture11SynchronizeEP12b2BroadPhaseRK11b2TransformS4_");

void b2Fixture::Synchronize(b2BroadPhase *broadPhase, const b2Transform &xf1, const b2Transform &xf2) {
    if (PassesRun(HookOf::Synchronize) && RoundsToNearest())
        tree::SynchronizeBoxes(
            this, broadPhase, xf1, xf2,
            [](b2Fixture *fixture, b2BroadPhase *phase, const b2Transform &first, const b2Transform &second) {
                stock::Synchronize(fixture, phase, first, second);
            });
    else
        stock::Synchronize(this, broadPhase, xf1, xf2);
}
