// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_BAD_INPUT_POINTS_H
#define BOOMERANG_TEST_BAD_INPUT_POINTS_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace bad_input {

/// What the tables of points hand over; `count` is what is said, which need not be what is there.
struct Points {
    std::string name;
    std::vector<double> xy; ///< x, y, x, y, ...
    size_t count;
    bool null = false;
};

inline std::vector<double> Circle(size_t count, double radius) {
    std::vector<double> xy;
    for (size_t i = 0; i < count; ++i) {
        const double angle =
            2.0 * 3.14159265358979323846 * static_cast<double>(i) / static_cast<double>(count);
        xy.push_back(radius * std::cos(angle));
        xy.push_back(radius * std::sin(angle));
    }
    return xy;
}

inline std::vector<double> Square(double half) {
    return {-half, -half, half, -half, half, half, -half, half};
}

inline std::vector<double> Clockwise(const std::vector<double> &xy) {
    std::vector<double> reversed;
    for (size_t i = xy.size(); i > 0; i -= 2) {
        reversed.push_back(xy[i - 2]);
        reversed.push_back(xy[i - 1]);
    }
    return reversed;
}

inline std::vector<double> Twice(const std::vector<double> &xy) {
    std::vector<double> doubled;
    for (size_t i = 0; i < xy.size(); i += 2)
        for (int k = 0; k < 2; ++k) {
            doubled.push_back(xy[i]);
            doubled.push_back(xy[i + 1]);
        }
    return doubled;
}

inline std::vector<double> With(std::vector<double> xy, size_t index, double value) {
    xy[index] = value;
    return xy;
}

/// Every second point, then the others: twice around.
inline std::vector<double> TwiceAround(const std::vector<double> &xy) {
    std::vector<double> star;
    const size_t count = xy.size() / 2;
    for (size_t i = 0; i < count; ++i) {
        star.push_back(xy[2 * (2 * i % count)]);
        star.push_back(xy[2 * (2 * i % count) + 1]);
    }
    return star;
}

inline std::vector<double> Grid(size_t count) {
    std::vector<double> xy;
    for (size_t i = 0; i < count; ++i) {
        xy.push_back(static_cast<double>(i % 256));
        xy.push_back(static_cast<double>(i / 256));
    }
    return xy;
}

inline std::vector<Points> AllBadPoints() {
    const double none = std::nan(""), infinite = std::numeric_limits<double>::infinity();
    std::vector<Points> all;
    const auto add = [&all](const char *name, const std::vector<double> &xy) {
        all.push_back({name, xy, xy.size() / 2});
    };
    all.push_back({"`NULL` and a count of 4", {}, 4, true});
    all.push_back({"`NULL` and a count of 0", {}, 0, true});
    add("one point", {1, 2});
    add("two points", {1, 2, 3, 4});
    add("two points that are equal", {1, 2, 1, 2});
    add("three points on a line", {0, 0, 1, 1, 2, 2});
    add("20 points on a line", [] {
        std::vector<double> xy;
        for (int i = 0; i < 20; ++i) {
            xy.push_back(i);
            xy.push_back(2 * i);
        }
        return xy;
    }());
    add("20 points that are equal", std::vector<double>(40, 1.0));
    for (const bool big : {false, true}) {
        const std::vector<double> shape = big ? Circle(20, 1.0) : Square(1.0);
        const std::string what = big ? "a 20-gon" : "a square";
        const auto named = [&](const std::string &name, const std::vector<double> &xy) {
            add(name.c_str(), xy);
        };
        named(what, shape);
        named(what + " with a NaN", With(shape, 3, none));
        named(what + " with an infinity", With(shape, 3, infinite));
        named(what + " with a negative infinity", With(shape, 4, -infinite));
        named(what + " with a coordinate of 1e38", With(shape, 2, 1e38));
        named(what + " with a coordinate of 1e-38", With(shape, 2, 1e-38));
        named(what + ", every point twice", Twice(shape));
        named(what + ", clockwise", Clockwise(shape));
        std::vector<double> exchanged = shape, dent = shape, straight = shape;
        std::swap(exchanged[2], exchanged[4]);
        std::swap(exchanged[3], exchanged[5]);
        named(what + " with two vertices exchanged", exchanged);
        dent[2] = -0.1 * dent[2];
        dent[3] = -0.1 * dent[3];
        named(what + " with a dent", dent);
        straight.insert(straight.begin() + 2, {(shape[0] + shape[2]) / 2, (shape[1] + shape[3]) / 2});
        if (!big) // whose middles are rounded
            named(what + " with a vertex in the middle of a side", straight);
        std::vector<double> tiny = shape, small = shape, large = shape, huge = shape;
        for (size_t i = 0; i < shape.size(); ++i) {
            tiny[i] *= 1e-38;
            small[i] *= 1e-9;
            large[i] *= 1e9;
            huge[i] *= 1e38;
        }
        named(what + " of half width 1e-38", tiny);
        named(what + " of half width 1e-9", small);
        named(what + " of half width 1e9", large);
        named(what + " of half width 1e38", huge);
    }
    add("a pentagram", TwiceAround(Circle(5, 1.0)));
    add("a star of 21 points, twice around", TwiceAround(Circle(21, 1.0)));
    add("65,535 points on a circle", Circle(65535, 1000.0));
    add("65,536 points on a circle", Circle(65536, 1000.0));
    add("65,536 points in a square", Grid(65536));
    all.push_back({"a count of `SIZE_MAX`", Square(1.0), SIZE_MAX});
    return all;
}

/// Of a large circle how many are left depends on how its points were rounded.
inline std::string CountOf(size_t count, const Points &given) {
    if (count > 10000 && count < given.count)
        return "fewer vertices";
    return std::to_string(count) + (count == 1 ? " vertex" : " vertices");
}

inline std::vector<std::string> NamesOf(const std::vector<Points> &all) {
    std::vector<std::string> names;
    for (const Points &points : all)
        names.push_back(points.name);
    return names;
}

} // namespace bad_input

#endif
