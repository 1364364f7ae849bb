// SPDX-License-Identifier: MIT
// What bmr::ConvexShape says to bad points and sizes, beside Box2D's own polygon.
#include <climits>
#include <cmath>
#include <cstring>

#include <box2d/box2d.h>

#include "boomerang/convex_shape.h"
#include "error_name.h"
#include "points.h"
#include "table.h"

using namespace bad_input;

namespace {

const float kNone = std::nanf(""), kInfinite = INFINITY;

std::vector<b2Vec2> Vectors(const Points &points) {
    std::vector<b2Vec2> made;
    for (size_t i = 0; i + 1 < points.xy.size(); i += 2)
        made.emplace_back(static_cast<float>(points.xy[i]), static_cast<float>(points.xy[i + 1]));
    return made;
}

/// What a setter says to a shape that holds something, and whether an error left that as it was.
template <typename Setter> std::string Answer(const Setter &set, const Points *given = nullptr) {
    bmr::ConvexShape shape;
    if (shape.SetRegular(12, 3.0f) != BMR_OK)
        return "no shape to begin with";
    unsigned char before[sizeof shape];
    std::memcpy(before, static_cast<const void *>(&shape), sizeof shape);
    const bmr_error error = set(shape);
    if (error != BMR_OK)
        return NameOf(error) + (std::memcmp(before, static_cast<const void *>(&shape), sizeof shape) == 0
                                    ? ""
                                    : ", and the shape has changed");
    const auto count = static_cast<size_t>(shape.GetVertexCount());
    return given != nullptr ? CountOf(count, *given) : std::to_string(count) + " vertices";
}

std::string Shape(const Points &points, size_t column) {
    const std::vector<b2Vec2> given = Vectors(points);
    const b2Vec2 *data = points.null ? nullptr : given.data();
    const int32 count = points.count > INT_MAX ? INT_MAX : static_cast<int32>(points.count);
    return Answer(
        [&](bmr::ConvexShape &shape) {
            return column == 0 ? shape.Set(data, count) : shape.SetRaw(data, count);
        },
        &points);
}

/// One number at a time is bad.
struct Size {
    const char *name;
    float value;
};
const Size kSizes[] = {{"NaN", kNone},
                       {"infinite", kInfinite},
                       {"minus infinity", -kInfinite},
                       {"zero", 0.0f},
                       {"minus zero", -0.0f},
                       {"negative", -1.0f},
                       {"1e-38", 1e-38f},
                       {"1e-9", 1e-9f},
                       {"1e9", 1e9f},
                       {"1e38", 1e38f},
                       {"the largest float", FLT_MAX}};

const std::vector<std::string> kSizeColumns = {
    "`SetAsBox`, width",    "`SetAsBox`, centre",  "`SetAsBox`, angle",    "`SetRegular`, radius",
    "`SetEllipse`, height", "`SetRounded`, width", "`SetRounded`, corner", "`Simplify`, tolerance"};

std::string SizeAnswer(float value, size_t column) {
    return Answer([value, column](bmr::ConvexShape &shape) {
        switch (column) {
        case 0:
            return shape.SetAsBox(value, 1.0f);
        case 1:
            return shape.SetAsBox(1.0f, 1.0f, {0.0f, value}, 0.0f);
        case 2:
            return shape.SetAsBox(1.0f, 1.0f, {0.0f, 0.0f}, value);
        case 3:
            return shape.SetRegular(20, value);
        case 4:
            return shape.SetEllipse(20, 1.0f, value);
        case 5:
            return shape.SetRounded(value, 1.0f, 0.5f, 4);
        case 6:
            return shape.SetRounded(2.0f, 1.0f, value, 4);
        default:
            return shape.Simplify(value);
        }
    });
}

const int32 kCounts[] = {INT_MIN, -1, 0, 1, 2, 3, 16383, 16384, 65535, 65536, INT_MAX};
const std::vector<std::string> kCountColumns = {"`Set`", "`SetRaw`", "`SetRegular`", "`SetEllipse`",
                                                "`SetRounded`, of a corner"};

std::string CountAnswer(int32 count, size_t column) {
    if (column == 0 && count == INT_MAX)
        return "-"; // all of them would be looked at
    Points circle = {"", {}, 0};
    circle.count = static_cast<size_t>(std::max(count, 0)) * (column == 4 ? 4 : 1);
    std::vector<b2Vec2> given;
    given.reserve(1); // there is an array, of no points
    for (int32 i = 0; i < std::min(count, 65536) && column < 2; ++i)
        given.emplace_back(static_cast<float>(i % 256),
                           static_cast<float>(i / 256)); // a square of 4 vertices
    return Answer(
        [&](bmr::ConvexShape &shape) {
            switch (column) {
            case 0:
                return shape.Set(given.data(), count);
            case 1:
                return shape.SetRaw(given.data(), count);
            case 2:
                return shape.SetRegular(count, 1000.0f);
            case 3:
                return shape.SetEllipse(count, 1000.0f, 500.0f);
            default:
                return shape.SetRounded(1000.0f, 500.0f, 500.0f, count);
            }
        },
        &circle);
}

std::vector<std::string> SizeNames() {
    std::vector<std::string> names;
    for (const Size &size : kSizes)
        names.emplace_back(size.name);
    return names;
}

std::vector<std::string> CountNames() {
    std::vector<std::string> names;
    for (const int32 count : kCounts)
        names.push_back(std::to_string(count));
    return names;
}

} // namespace

int main(int argc, char **argv) {
    std::vector<Points> all = AllBadPoints();
    all.pop_back(); // a count that int32 does not have
    return Main(argc, argv,
                {{"points in a shape",
                  {"`ConvexShape::Set`", "`ConvexShape::SetRaw`"},
                  NamesOf(all),
                  [&all](size_t row, size_t column) { return Shape(all[row], column); }},
                 {"sizes of a shape", kSizeColumns, SizeNames(),
                  [](size_t row, size_t column) { return SizeAnswer(kSizes[row].value, column); }},
                 {"counts of a shape", kCountColumns, CountNames(),
                  [](size_t row, size_t column) { return CountAnswer(kCounts[row], column); }}});
}
