// SPDX-License-Identifier: MIT
#include "drawing/axis.h"

#include <algorithm>
#include <cstdio>

namespace testbed {

void Axis::Add(double value) {
    low = std::min(low, Map(value));
    high = std::max(high, Map(value));
}

void Axis::Widen() {
    if (!logarithmic)
        low = std::min(low, 0.0);
    const double by = high > low ? 0.05 * (high - low) : 0.5;
    low -= logarithmic ? by : 0.0;
    high += by;
}

std::vector<double> Axis::Ticks() const {
    std::vector<double> ticks;
    if (logarithmic) {
        const bool few = high - low < 2.2;
        for (int decade = static_cast<int>(std::floor(low)); decade <= high; ++decade)
            for (const double digit : {1.0, 2.0, 5.0})
                if ((few || digit == 1.0) && decade + std::log10(digit) >= low &&
                    decade + std::log10(digit) <= high)
                    ticks.push_back(digit * std::pow(10.0, decade));
        return ticks;
    }
    const double rough = (high - low) / 5.0, power = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10.0 * power;
    for (const double digit : {5.0, 2.0, 1.0})
        if (digit * power >= rough)
            step = digit * power;
    for (double tick = std::ceil(low / step) * step; tick <= high + 1e-9 * step; tick += step)
        ticks.push_back(tick);
    return ticks;
}

std::string TickText(double value) {
    char text[32];
    if (value != 0.0 && (std::fabs(value) >= 1e5 || std::fabs(value) < 1e-3)) {
        const int power = static_cast<int>(std::floor(std::log10(std::fabs(value)) + 1e-9));
        std::snprintf(text, sizeof text, "%ge%d", std::round(100.0 * value / std::pow(10.0, power)) / 100.0,
                      power);
    } else {
        std::snprintf(text, sizeof text, "%g", value);
    }
    return text;
}

void DrawMark(Canvas &canvas, bmr_vec2 page, size_t shape, const Colour &colour) {
    constexpr double kRadius = 2.8, kRim = 1.1;
    constexpr size_t kShapes = 4;
    // Marks keep their shape on a stretched panel: they are drawn in the page's units.
    auto corner = [&page](double dx, double dy) { return bmr_vec2_make(page.x + dx, page.y + dy); };
    const bool hollow = shape / kShapes % 2 == 1;
    const Fill fill = {hollow ? Colour{1.0, 1.0, 1.0} : colour, 1.0};
    const Pen rim = {colour, hollow ? kRim : 0.0};
    switch (shape % kShapes) {
    case 0:
        if (hollow)
            canvas.Circle(page, kRadius, fill, rim);
        else
            canvas.Dot(page, kRadius, colour);
        break;
    case 1:
        canvas.Polygon({corner(-kRadius, -kRadius), corner(kRadius, -kRadius), corner(kRadius, kRadius),
                        corner(-kRadius, kRadius)},
                       fill, rim);
        break;
    case 2:
        canvas.Polygon({corner(-kRadius, -kRadius), corner(kRadius, -kRadius), corner(0.0, 1.3 * kRadius)},
                       fill, rim);
        break;
    default:
        canvas.Polygon({corner(0.0, -1.4 * kRadius), corner(1.4 * kRadius, 0.0), corner(0.0, 1.4 * kRadius),
                        corner(-1.4 * kRadius, 0.0)},
                       fill, rim);
    }
}

} // namespace testbed
