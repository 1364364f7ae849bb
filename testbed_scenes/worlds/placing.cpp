// SPDX-License-Identifier: MIT
#include "worlds/placing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>

#include "worlds/setup.h"

namespace testbed {
namespace {

constexpr int kTries = 3000;
/// Between any two, in their radii: a start that is not yet near.
constexpr double kApart = 1.01;

/// Disks of radii from r up to 2 r, in cells at least 4 r wide.
class Layer {
public:
    Layer(double width, double height, double largest)
        : m_columns(std::max<int64_t>(1, static_cast<int64_t>(width / (2.0 * kApart * largest)))),
          m_rows(std::max<int64_t>(1, static_cast<int64_t>(height / (2.0 * kApart * largest)))),
          m_largest(largest), m_width(width), m_height(height) {}

    void Add(bmr_vec2 at, double radius) { m_cells[KeyOf(at)].push_back({at, radius}); }

    bool IsFree(bmr_vec2 at, double radius, bool periodic) const {
        // Cells as far away as the two radii can reach; each at most once where the box is wrapped.
        const double reach = kApart * (radius + m_largest);
        const Range columns = Around(at.x, reach, m_width, m_columns, periodic),
                    rows = Around(at.y, reach, m_height, m_rows, periodic);
        for (int64_t column = columns.first; column <= columns.last; ++column)
            for (int64_t row = rows.first; row <= rows.last; ++row) {
                const auto cell = m_cells.find(Wrap(column, m_columns) * m_rows + Wrap(row, m_rows));
                if (cell == m_cells.end())
                    continue;
                for (const Disk &disk : cell->second)
                    if (Distance(disk.at, at, periodic) < kApart * (disk.radius + radius))
                        return false;
            }
        return true;
    }

private:
    struct Disk {
        bmr_vec2 at;
        double radius;
    };
    struct Range {
        int64_t first, last;
    };
    static int64_t Wrap(int64_t index, int64_t count) { return ((index % count) + count) % count; }
    static Range Around(double at, double reach, double side, int64_t count, bool periodic) {
        const double cell = side / static_cast<double>(count);
        Range range = {static_cast<int64_t>(std::floor((at - reach) / cell)),
                       static_cast<int64_t>(std::floor((at + reach) / cell))};
        if (!periodic) {
            range.first = std::max<int64_t>(0, range.first);
            range.last = std::min(count - 1, range.last);
        } else if (range.last - range.first >= count) {
            range = {0, count - 1};
        }
        return range;
    }
    int64_t KeyOf(bmr_vec2 at) const {
        const auto column = static_cast<int64_t>(at.x / m_width * static_cast<double>(m_columns));
        const auto row = static_cast<int64_t>(at.y / m_height * static_cast<double>(m_rows));
        return std::clamp<int64_t>(column, 0, m_columns - 1) * m_rows +
               std::clamp<int64_t>(row, 0, m_rows - 1);
    }
    double Distance(bmr_vec2 a, bmr_vec2 b, bool periodic) const {
        double x = std::fabs(a.x - b.x), y = std::fabs(a.y - b.y);
        if (periodic) {
            x = std::min(x, m_width - x);
            y = std::min(y, m_height - y);
        }
        return std::hypot(x, y);
    }

    int64_t m_columns, m_rows;
    double m_largest, m_width, m_height;
    std::map<int64_t, std::vector<Disk>> m_cells;
};

} // namespace

bool PlaceDisks(const std::vector<double> &radii, bmr_vec2 low, bmr_vec2 high, bool periodic, Dice &dice,
                std::vector<bmr_vec2> *places) {
    const bmr_vec2 size = bmr_sub(high, low);
    std::vector<size_t> order(radii.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return radii[a] > radii[b]; });
    places->assign(radii.size(), low);
    std::map<int, Layer> layers; // by the power of two of the radius
    for (const size_t index : order) {
        const double radius = radii[index], border = periodic ? 0.0 : kApart * radius;
        if (2.0 * border >= std::min(size.x, size.y))
            return false;
        bool placed = false;
        for (int i = 0; i < kTries && !placed; ++i) {
            const bmr_vec2 at =
                bmr_vec2_make(dice.Uniform(border, size.x - border), dice.Uniform(border, size.y - border));
            if (!std::all_of(layers.begin(), layers.end(),
                             [&](const auto &layer) { return layer.second.IsFree(at, radius, periodic); }))
                continue;
            int power = 0;
            std::frexp(radius, &power);
            layers.try_emplace(power, size.x, size.y, std::ldexp(1.0, power)).first->second.Add(at, radius);
            (*places)[index] = bmr_add(low, at);
            placed = true;
        }
        if (!placed)
            return false;
    }
    return true;
}

} // namespace testbed
