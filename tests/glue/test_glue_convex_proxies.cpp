// SPDX-License-Identifier: MIT
// Proxies of big polygons, by hand: who is known by the mark, and Box2D's questions asked of them.
#include <box2d/b2_time_of_impact.h>

#include "boomerang/convex_shape.h"
#include "cases.h"
#include "glue/proofs/convex_distance.h"

namespace {

/// A wheel of 20 corners that flies past or into a box within a step.
struct Flight {
    bmr::ConvexShape wheel;
    b2PolygonShape box;
    b2TOIInput input;

    explicit Flight(float speed) {
        REQUIRE(wheel.SetRegular(20, 1.0f) == BMR_OK);
        box.SetAsBox(0.5f, 0.5f);
        REQUIRE(bmr::SetBigProxy(&input.proxyA, wheel));
        input.proxyB.Set(&box, 0);
        input.sweepA = input.sweepB = b2Sweep();
        input.sweepB.c0.Set(4.0f, 0.0f);
        input.sweepB.c.Set(4.0f - speed, 0.0f);
        input.tMax = 1.0f;
    }
    b2TOIOutput Ask() const {
        b2TOIOutput output;
        output.state = b2TOIOutput::e_unknown;
        REQUIRE(bmr::BigImpact(&output, input));
        return output;
    }
};

} // namespace

TEST_CASE("impacts are told by all of their states") {
    CHECK(Flight(1.0f).Ask().state == b2TOIOutput::e_separated);
    const b2TOIOutput touching = Flight(4.0f).Ask();
    CHECK(touching.state == b2TOIOutput::e_touching);
    CHECK(std::fabs(touching.t - 2.5f / 4.0f) < 0.01f);
    Flight within(1.0f);
    within.input.sweepB.c0.SetZero();
    CHECK(within.Ask().state == b2TOIOutput::e_overlapped);
}

TEST_CASE("sweeps go on beyond their end; before their beginning only the beginning is looked at") {
    Flight flight(1.0f);
    flight.input.tMax = 2.0f;
    CHECK(flight.Ask().state == b2TOIOutput::e_separated);
    CHECK(flight.Ask().t == 2.0f);
    flight.input.tMax = 4.0f;
    CHECK(flight.Ask().state == b2TOIOutput::e_touching);
    CHECK(std::fabs(flight.Ask().t - 2.5f) < 0.01f);
    // Whether a direction is remembered or not.
    Flight back(-1.0f);
    back.input.tMax = -4.0f;
    CHECK(back.Ask().state == b2TOIOutput::e_separated);
    CHECK(back.Ask().t == -4.0f);
    back.input.tMax = 1.0f;
    CHECK(back.Ask().state == b2TOIOutput::e_separated);
    back.input.tMax = -0.5f;
    CHECK(back.Ask().state == b2TOIOutput::e_separated);
    CHECK(back.Ask().t == -0.5f);
}

TEST_CASE("what is nowhere has no time of impact") {
    Flight flight(1.0f);
    for (float *number : {&flight.input.sweepB.c0.x, &flight.input.sweepA.c0.y, &flight.input.sweepB.a0}) {
        const float before = *number;
        *number = NAN;
        CHECK(flight.Ask().state == b2TOIOutput::e_failed);
        *number = before;
    }
    CHECK(flight.Ask().state == b2TOIOutput::e_separated);
}

TEST_CASE("a mark counts for the vertices that it was made with") {
    Flight flight(1.0f);
    CHECK(bmr::IsBig(flight.input.proxyA));
    CHECK_FALSE(bmr::IsBig(flight.input.proxyB));
    b2DistanceProxy other = flight.input.proxyA;
    other.m_vertices = flight.box.m_vertices;
    CHECK_FALSE(bmr::IsBig(other));
    const b2DistanceProxy kept = flight.input.proxyA;
    REQUIRE(flight.wheel.SetRegular(30, 1.0f) == BMR_OK); // the polygon of 20 is gone
    CHECK_FALSE(bmr::IsBig(kept));
    CHECK_FALSE(bmr::SetBigProxy(&other, flight.box));
    b2TOIInput plain = flight.input;
    plain.proxyA.Set(&flight.box, 0);
    b2TOIOutput output;
    CHECK_FALSE(bmr::BigImpact(&output, plain));
}
