// SPDX-License-Identifier: MIT
// What is made on a thread that rounds otherwise than to nearest is made as always. (Its steps:
// tests/as_stock/rounding.cpp.)
#include <cfenv>

#include "base/rounding_mode.h"
#include "boomerang/convex_shape.h"
#include "cases.h"

namespace {

constexpr int kModes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

} // namespace

TEST_CASE("polygons of many vertices are the same in whatever mode they are made") {
    b2Vec2 points[20];
    for (int i = 0; i < 20; ++i)
        points[i].Set(0.9f * std::cos(0.31f * static_cast<float>(i)),
                      0.7f * std::sin(0.31f * static_cast<float>(i)));
    const auto text = [&points](int mode, bmr_error (bmr::ConvexShape::*set)(const b2Vec2 *, int32)) {
        bmr::ConvexShape shape;
        std::fesetround(mode);
        const bmr_error error = (shape.*set)(points, 20);
        std::fesetround(FE_TONEAREST);
        REQUIRE(error == BMR_OK);
        b2MassData mass;
        shape.ComputeMass(&mass, 1.0f);
        std::string all = std::to_string(mass.mass) + ' ' + std::to_string(mass.I) + ' ' +
                          std::to_string(mass.center.x) + ' ' + std::to_string(mass.center.y);
        REQUIRE(shape.GetVertexCount() == 20);
        for (int32 i = 0; i < 20; ++i)
            for (const float f :
                 {shape.GetVertex(i).x, shape.GetVertex(i).y, shape.GetNormal(i).x, shape.GetNormal(i).y}) {
                char bits[32];
                std::snprintf(bits, sizeof bits, " %a", double{f});
                all += bits;
            }
        return all;
    };
    for (const auto set : {&bmr::ConvexShape::Set, &bmr::ConvexShape::SetRaw})
        for (const int mode : kModes)
            CHECK(text(mode, set) == text(FE_TONEAREST, set));
    // The control: the modes part over such numbers.
    const auto third = [](int mode) {
        std::fesetround(mode);
        const volatile float one = 1.0f, three = 3.0f;
        volatile float quotient = 0.0f;
        quotient = one / three;
        std::fesetround(FE_TONEAREST);
        return float{quotient};
    };
    CHECK(third(FE_UPWARD) != third(FE_DOWNWARD));
}

TEST_CASE("what rounds to nearest for a while gives the mode back") {
    for (const int mode : kModes) {
        std::fesetround(mode);
        const bool before = bmr::RoundsToNearest();
        bool within = false;
        {
            const bmr::NearestRounding nearest;
            within = bmr::RoundsToNearest();
        }
        const int after = std::fegetround();
        const bool still = !bmr::RoundsToNearest();
        std::fesetround(FE_TONEAREST);
        CHECK_FALSE(before);
        CHECK(within);
        CHECK(after == mode);
        CHECK(still);
    }
    CHECK(bmr::RoundsToNearest());
}

// Proofs have underflows where Box2D has none, and so has the trial of a Box2D.
TEST_CASE("where an underflow ends the program Box2D answers, and nothing is tried with the trap") {
    feenableexcept(FE_UNDERFLOW);
    const bool before = bmr::RoundsToNearest();
    bool within = false;
    {
        const bmr::NearestRounding nearest;
        within = bmr::RoundsToNearest();
        volatile float tiny = std::numeric_limits<float>::min();
        tiny = tiny / std::numeric_limits<float>::max();
    }
    const int after = fegetexcept();
    const bool still = !bmr::RoundsToNearest();
    fedisableexcept(FE_UNDERFLOW);
    CHECK_FALSE(before);
    CHECK(within);
    CHECK(after == FE_UNDERFLOW);
    CHECK(still);
}
