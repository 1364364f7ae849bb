// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>

#include "debug/event.h"
#include "start/install.h"
#include "start/recognise.h"
#include "start/settings.h"

namespace bmr {

Presence GetPresence() {
    Presence presence;
    presence.way = TheWay();
    presence.box2d = VersionOfBox2D();
    if (const char *const why = WhyRefused())
        presence.whyNot = why;
    return presence;
}

Counted internal::ReadCounts() {
    Counted read;
    const Counts &counts = GetCounts();
    VisitCounts([](const char *, uint64_t &to, const auto &from) { to = from; }, read, counts);
    for (int kind = 0; kind < BMR_EVENT_KIND_COUNT; ++kind)
        read.events[kind] = counts.events[kind];
    return read;
}

Statistics GetStatistics() {
    const Counted counted = internal::ReadCounts();
    Statistics s;
    s.steps = counted.steps;
    s.pairs = counted.pairs;
    s.looks = counted.looks;
    s.renewals = counted.renewals;
    std::copy(std::begin(counted.events), std::end(counted.events), s.events);
    s.verified = counted.verified;
    s.differences = counted.differences;
    return s;
}

} // namespace bmr
