// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_EVENT_H
#define BOOMERANG_GLUE_EVENT_H

#include "boomerang/pair.h"

class b2Body;

namespace bmr {

/// Counts an event of these two bodies, and tells Options::onEvent of it. To be called where
/// Options::statistics is on.
void TellOfEvent(const b2Body *bodyA, const b2Body *bodyB, const bmr_event &event);

} // namespace bmr

#endif
