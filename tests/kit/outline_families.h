// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_OUTLINE_FAMILIES_H
#define BMR_TEST_OUTLINE_FAMILIES_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "boomerang/outline.h"
#include "polygons.h"

/// @file
/// Outlines for tests: the same from the same seed on every run.

namespace outlines {

struct Outline {
    std::vector<bmr_vec2> points;
    std::vector<uint32_t> counts;

    bmr_rings Rings() const { return {points.data(), counts.data(), static_cast<uint32_t>(counts.size())}; }
    void Add(const std::vector<bmr_vec2> &ring) {
        points.insert(points.end(), ring.begin(), ring.end());
        counts.push_back(static_cast<uint32_t>(ring.size()));
    }
};

/// A region of triangles, grown one by one on a grid of `side` * `side` cells of two triangles each: its
/// rings as a walk with the region on its left meets them, the outer one first. It has holes, and touches
/// itself in points.
class Region {
public:
    Region(test_random *random, uint32_t side, uint32_t triangles, double jitter)
        : m_side(side), m_taken(2 * std::size_t{side} * side), m_banned(m_taken.size()),
          m_rises(m_taken.size() / 2) {
        for (uint32_t y = 0; y <= side; ++y)
            for (uint32_t x = 0; x <= side; ++x)
                m_points.push_back({x + test_random_uniform(random, -0.5, 0.5) * jitter,
                                    y + test_random_uniform(random, -0.5, 0.5) * jitter});
        for (std::size_t i = 0; i < m_rises.size(); ++i)
            m_rises[i] = test_random_below(random, 2) == 1;
        Grow(random, triangles);
    }

    Outline Rings(bool keep_flat) {
        std::vector<std::vector<bmr_vec2>> rings;
        std::vector<bool> walked(3 * m_taken.size());
        for (uint32_t half = 0; half < walked.size(); ++half)
            if (m_taken[half / 3] && !IsTaken(Across(half)) && !walked[half])
                rings.push_back(Walk(half, keep_flat, &walked));
        std::sort(rings.begin(), rings.end(),
                  [](const auto &a, const auto &b) { return TwiceArea(a) > TwiceArea(b); });
        Outline outline;
        for (const auto &ring : rings)
            outline.Add(ring);
        return outline;
    }

private:
    static constexpr uint32_t kNone = UINT32_MAX;

    static double TwiceArea(const std::vector<bmr_vec2> &ring) {
        double sum = 0.0;
        for (std::size_t i = 0; i < ring.size(); ++i)
            sum += bmr_cross(ring[i], ring[(i + 1) % ring.size()]);
        return sum;
    }

    bool IsTaken(uint32_t half) const { return half != kNone && m_taken[half / 3]; }

    /// Corner k of a triangle: of each cell, 0 is the lower and 1 the upper one of its two.
    uint32_t Corner(uint32_t half) const {
        // The corners of a cell counter-clockwise, from the lower left; each triangle begins on the diagonal.
        static constexpr uint32_t kCorners[2][2][3] = {{{3, 0, 1}, {1, 2, 3}}, {{0, 1, 2}, {2, 3, 0}}};
        const uint32_t cell = half / 6;
        const uint32_t corner = kCorners[m_rises[cell] ? 1 : 0][half / 3 % 2][half % 3];
        const uint32_t x = cell % m_side + (corner == 1 || corner == 2 ? 1 : 0),
                       y = cell / m_side + corner / 2;
        return y * (m_side + 1) + x;
    }

    static uint32_t Next(uint32_t half) { return half / 3 * 3 + (half + 1) % 3; }

    /// The other side of a triangle's side, by the two points that it joins; kNone at the border.
    uint32_t Across(uint32_t half) const {
        const uint32_t cell = half / 6, from = Corner(half), to = Corner(Next(half));
        const uint32_t x = cell % m_side, y = cell / m_side;
        const uint32_t cells[5] = {cell, x > 0 ? cell - 1 : kNone, x + 1 < m_side ? cell + 1 : kNone,
                                   y > 0 ? cell - m_side : kNone, y + 1 < m_side ? cell + m_side : kNone};
        for (const uint32_t other : cells)
            for (uint32_t k = 0; other != kNone && k < 6; ++k)
                if (Corner(6 * other + k) == to && Corner(Next(6 * other + k)) == from)
                    return 6 * other + k;
        return kNone;
    }

    void Grow(test_random *random, uint32_t triangles) {
        std::vector<uint32_t> open = {test_random_below(random, static_cast<uint32_t>(m_taken.size()))};
        for (uint32_t count = 0; count < triangles && !open.empty();) {
            const uint32_t at = test_random_below(random, static_cast<uint32_t>(open.size()));
            const uint32_t triangle = open[at];
            open[at] = open.back();
            open.pop_back();
            if (m_taken[triangle] || m_banned[triangle])
                continue;
            // Every tenth one stays out, and may become a hole.
            m_banned[triangle] = count > 0 && test_random_below(random, 10) == 0;
            if (m_banned[triangle])
                continue;
            m_taken[triangle] = true;
            ++count;
            for (uint32_t k = 0; k < 3; ++k) {
                const uint32_t across = Across(3 * triangle + k);
                if (across != kNone && !m_taken[across / 3])
                    open.push_back(across / 3);
            }
        }
    }

    std::vector<bmr_vec2> Walk(uint32_t start, bool keep_flat, std::vector<bool> *walked) const {
        std::vector<bmr_vec2> all, kept;
        uint32_t half = start;
        do {
            (*walked)[half] = true;
            all.push_back(m_points[Corner(half)]);
            half = Next(half);
            for (uint32_t across = Across(half); IsTaken(across); across = Across(half))
                half = Next(across);
        } while (half != start);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const bmr_vec2 before = all[(i + all.size() - 1) % all.size()], after = all[(i + 1) % all.size()];
            if (keep_flat || bmr_cross(bmr_sub(all[i], before), bmr_sub(after, all[i])) != 0.0)
                kept.push_back(all[i]);
        }
        return kept;
    }

    uint32_t m_side;
    std::vector<bmr_vec2> m_points;
    std::vector<bool> m_taken, m_banned, m_rises;
};

/// Rings run either way and begin anywhere, and holes come in any order.
inline Outline Shuffled(test_random *random, const Outline &outline) {
    std::vector<std::vector<bmr_vec2>> rings;
    std::size_t begin = 0;
    for (const uint32_t count : outline.counts) {
        const auto at = outline.points.begin() + static_cast<std::ptrdiff_t>(begin);
        std::vector<bmr_vec2> ring(at, at + count);
        std::rotate(ring.begin(), ring.begin() + test_random_below(random, count), ring.end());
        if (test_random_below(random, 2) == 1)
            std::reverse(ring.begin(), ring.end());
        rings.push_back(ring);
        begin += count;
    }
    for (std::size_t i = rings.size() - 1; i > 1; --i)
        std::swap(rings[i], rings[1 + test_random_below(random, static_cast<uint32_t>(i))]);
    Outline shuffled;
    for (const auto &ring : rings)
        shuffled.Add(ring);
    return shuffled;
}

/// Around a centre, at random distances.
inline Outline Star(test_random *random, uint32_t count) {
    std::vector<bmr_vec2> ring;
    for (uint32_t i = 0; i < count; ++i) {
        const double angle = 2.0 * M_PI * i / count, radius = test_random_uniform(random, 0.3, 1.0);
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    Outline outline;
    outline.Add(ring);
    return outline;
}

/// Teeth of random depths, as thin as a tenth of their gaps, on a bar whose upper side is straight. All
/// coordinates are integers.
inline Outline Comb(test_random *random, uint32_t teeth) {
    std::vector<bmr_vec2> ring;
    for (uint32_t i = 0; i < teeth; ++i) {
        const double x = 11.0 * i, depth = 1.0 + test_random_below(random, 1000);
        ring.push_back({x, 0.0});
        ring.push_back({x, -depth});
        ring.push_back({x + 1.0, -depth});
        ring.push_back({x + 1.0, 0.0});
    }
    for (uint32_t i = teeth; i-- > 0;)
        ring.push_back({11.0 * i + 1.0, 3.0});
    Outline outline;
    outline.Add(ring);
    return outline;
}

/// A band that is wound up.
inline Outline Spiral(uint32_t count) {
    std::vector<bmr_vec2> ring;
    for (uint32_t side = 0; side < 2; ++side)
        for (uint32_t k = 0; k < count / 2; ++k) {
            const uint32_t i = side == 0 ? k : count / 2 - 1 - k;
            const double angle = 0.3 * i, radius = 1.0 + 0.1 * angle + (side == 0 ? 0.0 : 0.2);
            ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
    Outline outline;
    outline.Add(ring);
    return outline;
}

/// `count` points along a ring, at equal distances.
inline std::vector<bmr_vec2> Resampled(const std::vector<bmr_vec2> &ring, uint32_t count) {
    const auto length = [&](std::size_t i) {
        const bmr_vec2 along = bmr_sub(ring[(i + 1) % ring.size()], ring[i]);
        return std::hypot(along.x, along.y);
    };
    double whole = 0.0, before = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        whole += length(i);
    std::vector<bmr_vec2> samples;
    for (std::size_t i = 0; i < ring.size() && samples.size() < count; before += length(i++))
        while (samples.size() < count &&
               whole * static_cast<double>(samples.size()) / count < before + length(i)) {
            const double part = (whole * static_cast<double>(samples.size()) / count - before) / length(i);
            const bmr_vec2 along = bmr_sub(ring[(i + 1) % ring.size()], ring[i]);
            samples.push_back(bmr_add(ring[i], bmr_scale(part, along)));
        }
    return samples;
}

/// What a scanner makes of a body with bays and limbs: a grown region without its holes, its corners cut
/// three times, in steps of equal length, with noise of a thousandth of a cell.
inline Outline Silhouette(test_random *random, uint32_t count) {
    const Outline region = Region(random, 6, 10 + test_random_below(random, 20), 0.4).Rings(true);
    std::vector<bmr_vec2> ring(region.points.begin(), region.points.begin() + region.counts[0]);
    for (int round = 0; round < 3; ++round) {
        std::vector<bmr_vec2> cut;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const bmr_vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
            cut.push_back(bmr_add(bmr_scale(0.75, a), bmr_scale(0.25, b)));
            cut.push_back(bmr_add(bmr_scale(0.25, a), bmr_scale(0.75, b)));
        }
        ring = cut;
    }
    Outline outline;
    outline.Add(Resampled(ring, count));
    for (bmr_vec2 &p : outline.points)
        p = bmr_add(p, {test_random_uniform(random, -1e-3, 1e-3), test_random_uniform(random, -1e-3, 1e-3)});
    return outline;
}

/// Triangles that all touch in one point, in the corner of a square.
inline Outline Fan(uint32_t holes) {
    Outline outline;
    const double far = 4.0 * holes;
    outline.Add({{0.0, 0.0}, {far, 0.0}, {far, far}, {0.0, far}});
    for (uint32_t i = 1; i <= holes; ++i)
        outline.Add({{0.0, 0.0}, {3.0 * i, far - 1.0}, {3.0 * i + 1.0, far - 1.0}});
    return outline;
}

/// Coordinates times powers of two: nothing about the outline changes, but for what arithmetic makes of it.
inline Outline Scaled(const Outline &outline, int exponent_x, int exponent_y) {
    Outline scaled = outline;
    for (bmr_vec2 &p : scaled.points)
        p = {std::ldexp(p.x, exponent_x), std::ldexp(p.y, exponent_y)};
    return scaled;
}

} // namespace outlines

#endif
