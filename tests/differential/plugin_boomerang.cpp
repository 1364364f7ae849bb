// SPDX-License-Identifier: MIT
#include "plugin.h"

#include <cstdio>
#include <cstdlib>

#include <boomerang/box2d.h>

namespace differential {

namespace {

/// What is told is so, wherever it happens: a certificate that proves something holds. (Of polygons whose
/// normals were edited nothing is certified.)
void OnEvent(void *, const b2Body *, const b2Body *, const bmr_event &event) {
    double gap = 0.0;
    const bool holds = event.gap > 0.0 ? event.pair->state == BMR_PAIR_APART &&
                                             bmr_pair_check(event.pair, event.pose, 0.0, &gap)
                                       : event.pair->stamp == 0 || event.kind == BMR_EVENT_CONTACT;
    if (!holds) {
        std::fprintf(stderr, "the certificate of a %s does not hold\n", bmr_event_name(event.kind));
        std::abort();
    }
}

} // namespace

const char *Kind() {
    return "plugin";
}

bool InstallPlugin(const std::string &structure, bool prefilter, bool told) {
    for (int i = 0; i < BMR_STRUCTURE_COUNT; ++i) {
        bmr::Options options;
        options.structure = static_cast<bmr_structure>(i);
        options.prefilter = prefilter;
        options.onEvent = told ? OnEvent : nullptr;
        // With one structure as games have it, with the others also where it does not pay.
        options.everywhere = structure != "free-direction";
        if (structure == bmr_structure_name(options.structure))
            return bmr::Install(options);
    }
    return false;
}

} // namespace differential
