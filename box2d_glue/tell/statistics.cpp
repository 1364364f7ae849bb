// SPDX-License-Identifier: MIT
#include "start/reach.h"
#include "start/recognise.h"
#include "start/settings.h"

namespace bmr {

Presence GetPresence() {
    Presence presence;
    presence.way = TheWay();
    presence.box2d = VersionOfBox2D();
    presence.roundsAsBox2D = GetSettings().sameRounding;
    presence.passesRun = PassesRun();
    if (const char *const why = GetSettings().whyNoPass)
        presence.whyNot = why;
    return presence;
}

Statistics GetStatistics() {
    const Counts &counts = GetCounts();
    Statistics s;
    s.steps = counts.steps;
    s.evaluations = counts.evaluations;
    s.edgeChecks = counts.edgeChecks;
    s.edgeSearches = counts.edgeSearches;
    s.verdictsReused = counts.verdictsReused;
    s.provedApart = counts.provedApart;
    s.handedOver = counts.handedOver;
    s.handedOverTouching = counts.handedOverTouching;
    s.touchingAnswered = counts.touchingAnswered;
    s.toiQueries = counts.toiQueries;
    s.toiAnswered = counts.toiAnswered;
    s.overlapQueries = counts.overlapQueries;
    s.overlapsAnswered = counts.overlapsAnswered;
    s.pairsWatched = counts.pairsWatched;
    s.looks = counts.looks;
    s.renewals = counts.renewals;
    s.verified = counts.verified;
    s.differences = counts.differences;
    s.pairs = counts.pairs;
    s.hulls = counts.hulls;
    s.kinetic.checks = counts.kineticChecks;
    s.kinetic.steps = counts.kineticSteps;
    for (int kind = 0; kind < BMR_EVENT_KIND_COUNT; ++kind)
        s.kinetic.events[kind] = counts.kineticEvents[kind];
    return s;
}

void internal::LinkOfStatistics() {}

} // namespace bmr
