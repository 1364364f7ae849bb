// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CONTRACTS_BAD_VERTEX_ARRAYS_H
#define BOOMERANG_TEST_CONTRACTS_BAD_VERTEX_ARRAYS_H

#include <algorithm>

#include "stage.h"

namespace contracts {

/// A bad vertex array; `count` is what is said, which need not be what is there.
struct Vertices {
    std::string name;
    std::vector<bmr_vec2> points;
    size_t count;
    bool null = false;
};

/// Every second point, then the others.
inline std::vector<bmr_vec2> TwiceAround(const std::vector<bmr_vec2> &points) {
    std::vector<bmr_vec2> star;
    for (size_t i = 0; i < points.size(); ++i)
        star.push_back(points[2 * i % points.size()]);
    return star;
}

/// Points in rows of 256: a square of 4 vertices, or of 5 where the last row is short.
inline std::vector<bmr_vec2> Grid(size_t count) {
    std::vector<bmr_vec2> points;
    for (size_t i = 0; i < count; ++i)
        points.push_back({static_cast<double>(i % 256), static_cast<double>(i / 256)});
    return points;
}

inline std::vector<Vertices> BadVertexArrays() {
    using Points = std::vector<bmr_vec2>;
    const Points square = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    std::vector<Vertices> all = {{"`NULL` and a count of 4", {}, 4, true},
                                 {"`NULL` and a count of 0", {}, 0, true}};
    const auto add = [&all](const std::string &name, const Points &points) {
        all.push_back({name, points, points.size()});
    };
    add("one point", {{1, 2}});
    add("two points", {{1, 2}, {3, 4}});
    add("two points that are equal", {{1, 2}, {1, 2}});
    add("three points on a line", {{0, 0}, {1, 1}, {2, 2}});
    Points line;
    for (int i = 0; i < 20; ++i)
        line.push_back({1.0 * i, 2.0 * i});
    add("20 points on a line", line);
    add("20 points that are equal", Points(20, {1, 1}));
    for (const bool big : {false, true}) {
        const std::string what = big ? "a 20-gon" : "a square";
        const Points shape = big ? Ellipse(20) : square;
        const auto changed = [&](const char *how, const std::function<void(Points &)> &change) {
            Points points = shape;
            change(points);
            add(what + how, points);
        };
        const auto scaled = [&](const char *how, double factor) {
            changed(how, [factor](Points &p) {
                for (bmr_vec2 &point : p)
                    point = {point.x * factor, point.y * factor};
            });
        };
        add(what, shape);
        changed(" with a NaN", [](Points &p) { p[1].y = kNaN; });
        changed(" with an infinity", [](Points &p) { p[1].y = kInfinity; });
        changed(" with a negative infinity", [](Points &p) { p[2].x = -kInfinity; });
        changed(" with a coordinate of 1e38", [](Points &p) { p[1].x = 1e38; });
        changed(" with a coordinate of 1e-38", [](Points &p) { p[1].x = 1e-38; });
        changed(", every point twice", [](Points &p) {
            for (size_t i = 0; i < p.size(); i += 2)
                p.insert(p.begin() + static_cast<ptrdiff_t>(i), Points::value_type(p[i]));
        });
        changed(", clockwise", [](Points &p) { std::reverse(p.begin(), p.end()); });
        changed(" with two vertices exchanged", [](Points &p) { std::swap(p[1], p[2]); });
        changed(" with a dent", [](Points &p) { p[1] = {-0.1 * p[1].x, -0.1 * p[1].y}; });
        if (!big) // whose middles are rounded
            changed(" with a vertex in the middle of a side", [](Points &p) {
                p.insert(p.begin() + 1, {(p[0].x + p[1].x) / 2, (p[0].y + p[1].y) / 2});
            });
        scaled(" of half width 1e-38", 1e-38);
        scaled(" of half width 1e-9", 1e-9);
        scaled(" of half width 1e9", 1e9);
        scaled(" of half width 1e38", 1e38);
    }
    add("a pentagram", TwiceAround(Ellipse(5)));
    add("a star of 21 points, twice around", TwiceAround(Ellipse(21)));
    add("65,535 points on a circle", Ellipse(65535, 1000, 1000));
    add("65,536 points on a circle", Ellipse(65536, 1000, 1000));
    add("65,536 points in a square", Grid(65536));
    all.push_back({"a count of `SIZE_MAX`", square, SIZE_MAX});
    return all;
}

/// Of a large circle how many vertices are left depends on how its points were rounded.
inline std::string CountOf(size_t count, size_t given) {
    if (count > 10000 && count < given)
        return "fewer vertices";
    return std::to_string(count) + (count == 1 ? " vertex" : " vertices");
}

/// The table of what these calls say to bad vertex arrays.
inline Matrix
VertexArrayTable(std::vector<std::pair<const char *, std::function<std::string(const Vertices &)>>> calls) {
    static const std::vector<Vertices> all = BadVertexArrays();
    Matrix matrix;
    for (const auto &call : calls)
        matrix.columns.emplace_back(call.first);
    for (const Vertices &vertices : all)
        matrix.rows.push_back(vertices.name);
    matrix.answer = [calls](size_t row, size_t column) { return calls[column].second(all[row]); };
    return matrix;
}

} // namespace contracts

#endif
