// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CONTRACTS_VERTEX_ARRAYS_H
#define BOOMERANG_TEST_CONTRACTS_VERTEX_ARRAYS_H

#include <algorithm>

#include "stage.h"

namespace contracts {

enum Maker { kHull, kRaw, kFloatHull, kFloatRaw, kShape, kShapeRaw, kMakerCount };

/// A bad vertex array; `count` is what is said, which need not be what is there.
struct Vertices {
    std::string name;
    std::vector<bmr_vec2> points;
    size_t count;
    std::vector<Answer> answers; ///< of each maker
    bool null = false;
};

/// Points in rows of 256: a square of 4 vertices, or of 5 where the last row is short.
inline std::vector<bmr_vec2> Grid(size_t count) {
    std::vector<bmr_vec2> points;
    for (size_t i = 0; i < count; ++i)
        points.push_back({static_cast<double>(i % 256), static_cast<double>(i / 256)});
    return points;
}

/// Every second point, then the others.
inline std::vector<bmr_vec2> TwiceAround(const std::vector<bmr_vec2> &points) {
    std::vector<bmr_vec2> star;
    for (size_t i = 0; i < points.size(); ++i)
        star.push_back(points[2 * i % points.size()]);
    return star;
}

inline std::string CountOf(size_t count) {
    return std::to_string(count) + (count == 1 ? " vertex" : " vertices");
}
/// Of a large circle how many vertices are left depends on how its points were rounded.
inline std::string CountOf(size_t count, size_t given) {
    return count > 10000 && count < given ? "fewer vertices" : CountOf(count);
}

inline std::vector<Vertices> BadVertexArrays() {
    using Points = std::vector<bmr_vec2>;
    const Answer few = BMR_ERROR_TOO_FEW_POINTS, many = BMR_ERROR_TOO_MANY_POINTS,
                 dented = BMR_ERROR_NOT_CONVEX, far = BMR_ERROR_OUT_OF_RANGE, none = BMR_ERROR_NO_POINTS,
                 nan = BMR_ERROR_NOT_FINITE, null = BMR_ERROR_NULL_ARGUMENT, close = BMR_ERROR_TOO_CLOSE;
    const auto made = [](size_t count) { return Answer(CountOf(count)); };
    const auto audited = [](size_t count) {
        return Answer(CountOf(count) + ", audit: " + Answer(BMR_ERROR_NOT_CONVEX).text);
    };
    const Points square = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    std::vector<Vertices> all = {{"NULL and a count of 4", {}, 4, {null, null, null, null, null, null}, true},
                                 {"NULL and a count of 0", {}, 0, {none, none, few, few, null, null}, true}};
    const auto add = [&all](const std::string &name, const Points &points, std::vector<Answer> answers) {
        all.push_back({name, points, points.size(), std::move(answers)});
    };
    Points line;
    for (int i = 0; i < 20; ++i)
        line.push_back({1.0 * i, 2.0 * i});
    add("one point", {{1, 2}}, {made(1), made(1), few, few, few, few});
    add("two points", {{1, 2}, {3, 4}}, {made(2), made(2), few, few, few, few});
    add("two equal points", {{1, 2}, {1, 2}}, {made(1), far, few, few, few, few});
    add("3 points on a line", {{0, 0}, {1, 1}, {2, 2}}, {made(2), audited(3), few, dented, few, few});
    add("20 points on a line", line, {made(2), audited(20), few, dented, few, dented});
    add("20 equal points", Points(20, {1, 1}), {made(1), far, few, far, few, far});
    for (const size_t n : {size_t{4}, size_t{20}}) {
        const Points shape = n == 20 ? Ellipse(20) : square;
        const auto changed = [&](const char *how, std::vector<Answer> answers,
                                 const std::function<void(Points &)> &change) {
            Points points = shape;
            change(points);
            add("a polygon of " + std::to_string(n) + how, points, std::move(answers));
        };
        const auto scaled = [&](const char *how, double factor, std::vector<Answer> answers) {
            changed(how, std::move(answers), [factor](Points &p) {
                for (bmr_vec2 &point : p)
                    point = {point.x * factor, point.y * factor};
            });
        };
        // What only the raw makers refuse; a shape of up to 8 points welds and turns as Box2D does.
        const bool small = n == 4;
        const auto hull = [&](size_t left, size_t raw, const Answer &shapeRaw) {
            return std::vector<Answer>{made(left), audited(raw), made(left), dented, made(left), shapeRaw};
        };
        const std::vector<Answer> whole(kMakerCount, made(n)), finite(kMakerCount, nan),
            range(kMakerCount, far);
        changed(" with a NaN", finite, [](Points &p) { p[1].y = kNaN; });
        changed(" with an infinity", finite, [](Points &p) { p[1].y = kInfinity; });
        changed(" with a negative infinity", finite, [](Points &p) { p[2].x = -kInfinity; });
        changed(" with a coordinate of 1e38", range, [](Points &p) { p[1].x = 1e38; });
        // (A shape of up to 8 points takes what Box2D takes.)
        changed(" with a coordinate beyond 1e9",
                small ? std::vector<Answer>{far, far, far, far, made(4), dented} : range,
                [](Points &p) { p[2].y = -1.0000001e9; });
        changed(" with a coordinate of 1e-38", small ? whole : hull(19, 20, dented),
                [](Points &p) { p[1].x = 1e-38; });
        changed(", every point twice", hull(n, 2 * n, small ? close : dented), [](Points &p) {
            for (size_t i = 0; i < p.size(); i += 2)
                p.insert(p.begin() + static_cast<ptrdiff_t>(i), Points::value_type(p[i]));
        });
        changed(", clockwise", hull(n, n, dented), [](Points &p) { std::reverse(p.begin(), p.end()); });
        changed(" with two vertices exchanged", hull(n, n, dented), [](Points &p) { std::swap(p[1], p[2]); });
        changed(" with a dent", hull(n - 1, n, dented), [](Points &p) {
            p[1] = {-0.1 * p[1].x, -0.1 * p[1].y};
        });
        if (small) // the middles of the other's sides are rounded
            changed(" with a vertex in the middle of a side", hull(4, 5, dented), [](Points &p) {
                p.insert(p.begin() + 1, {(p[0].x + p[1].x) / 2, (p[0].y + p[1].y) / 2});
            });
        const Answer ofShape = small ? close : far;
        scaled(", as it is", 1.0, whole);
        scaled(" of half width 1e-38", 1e-38, {far, far, far, far, ofShape, ofShape});
        scaled(" of half width 4e-10", 4e-10, {far, far, far, far, ofShape, ofShape});
        scaled(" of half width 1e-9", 1e-9, {made(n), made(n), made(n), made(n), ofShape, ofShape});
        scaled(" of half width 1e9", 1e9, whole);
        scaled(" of half width 1e38", 1e38, range);
    }
    const Answer fewer = "fewer vertices";
    add("a pentagram", TwiceAround(Ellipse(5)), {made(5), audited(5), made(5), dented, made(5), dented});
    add("a star of 21 points, twice around", TwiceAround(Ellipse(21)),
        {made(21), audited(21), made(21), dented, made(21), dented});
    add("65,535 points on a circle", Ellipse(65535, 1000, 1000),
        {made(65535), made(65535), fewer, dented, fewer, dented});
    add("65,536 points on a circle", Ellipse(65536, 1000, 1000), {many, many, fewer, many, fewer, many});
    add("65,536 points in a square", Grid(65536), {many, many, made(4), many, made(4), many});
    all.push_back({"a count of SIZE_MAX", square, SIZE_MAX, {many, many, many, many, "-", "-"}});
    return all;
}

/// What a maker says to each bad array.
inline void CheckVertexArrays(Maker maker, const std::function<std::string(const Vertices &)> &make) {
    static const std::vector<Vertices> all = BadVertexArrays();
    for (const Vertices &vertices : all) {
        CAPTURE(vertices.name);
        CAPTURE(int(maker));
        CHECK(make(vertices) == vertices.answers[maker].text);
    }
}

} // namespace contracts

#endif
