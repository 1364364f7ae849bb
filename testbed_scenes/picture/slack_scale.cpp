// SPDX-License-Identifier: MIT
#include "picture/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace testbed {

Colour ColourOfSlack(double slack) {
    // Evenly spaced in the logarithm of the slack.
    constexpr std::array<Colour, 4> kStops = {
        {{1.0, 0.93, 0.25}, {0.42, 0.82, 0.4}, {0.16, 0.64, 0.66}, {0.36, 0.46, 0.85}}};
    const double share = std::clamp(
        std::log(std::max(slack, kLeastSlack) / kLeastSlack) / std::log(kMostSlack / kLeastSlack), 0.0, 1.0);
    const double place = share * static_cast<double>(kStops.size() - 1);
    const auto index = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    const double part = place - static_cast<double>(index);
    const Colour &from = kStops[index], &to = kStops[index + 1];
    const auto mix = [part](double a, double b) { return a + part * (b - a); };
    return {mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue)};
}

std::string LengthText(double length, bool kinetic) {
    char text[40];
    std::snprintf(text, sizeof text, kinetic ? "%.3g" : "%.3g m", length);
    return text;
}

} // namespace testbed
