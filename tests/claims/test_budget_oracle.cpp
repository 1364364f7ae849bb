// SPDX-License-Identifier: MIT
// Budgets against rational arithmetic: no point goes farther than is counted, no pair that is not due is
// nearer than its threshold, no line claims a gap that is not there, and no sweep leaves its bound.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "boomerang/budget.h"
#include "exact_motion.h"
#include "polygons.h"
#include "test_scale.h"

namespace {

using exact::At;
using exact::AtMost;
using exact::IsAtMost;
using exact::IsMoreThan;
using exact::LeastAlong;
using exact::LeastSquare;
using exact::Place;
using exact::Places;
using exact::Square;
using exact::Way;

/// Some must always run, or the controls may see nothing.
std::size_t rounds(std::size_t count) {
    return std::max<std::size_t>(test_scaled(count), 1500);
}

/// A world: units a length, and how long its largest length is, in units; up to what is known at all.
struct World {
    test_random *random;
    double units, unit;

    explicit World(test_random *r) : random(r) {
        const double all[] = {65536.0, 1.0, 1000.0, 3e5, 0x1p-20, 0x1p100, 1e-100, 1e140};
        units = all[test_random_below(r, 8)];
        unit = 1.0 / units;
    }
    double in(double low, double high) const { return test_random_uniform(random, low, high); }
    std::uint32_t below(std::uint32_t bound) const { return test_random_below(random, bound); }
    /// Up to 2^most units, of any order of magnitude.
    double length(double most) const { return std::exp2(in(-4.0, most)) * unit * (below(2) ? 1.0 : -1.0); }
};

struct Body {
    std::vector<bmr_vec2> points; // in its own frame
    bmr_pose pose;
    bmr_mover mover;

    /// Points about a pivot, at most `size` away.
    Body(const World &world, bmr_vec2 pivot, double size, const bmr_pose &at) : pose(at) {
        for (std::uint32_t i = 1 + world.below(3); i > 0; --i) {
            const double angle = world.in(0.0, 6.3),
                         radius = world.below(2) ? size : size * world.in(0.0, 1.0);
            points.push_back({pivot.x + radius * std::cos(angle), pivot.y + radius * std::sin(angle)});
        }
        bmr_mover_start(&mover, &pose, pivot, exact::ReachOf(points, pivot), world.units);
        // Sums that are about to wrap, in every way.
        mover.moved =
            world.below(2) ? static_cast<std::uint32_t>(test_random_next(world.random)) : -world.below(100);
        mover.turned = static_cast<std::uint32_t>(test_random_next(world.random));
    }
    std::uint32_t go(const World &world, const bmr_pose &to) {
        pose = to;
        return bmr_mover_look(&mover, &pose, world.units);
    }
    Places places() const { return At(pose, points); }
};

bmr_pose Turned(const bmr_pose &pose, double angle) {
    bmr_pose turned = pose;
    turned.c = pose.c * std::cos(angle) - pose.s * std::sin(angle);
    turned.s = pose.s * std::cos(angle) + pose.c * std::sin(angle);
    return turned;
}

/// A pose up to 2^far units away, of a rotation that scales by 2^-scales to 2^scales.
bmr_pose AnyPose(const World &world, double far, double scales) {
    const double scale = world.below(2) ? 1.0 : std::exp2(world.in(-scales, scales));
    return Turned({{world.length(far), world.length(far)}, scale, 0.0}, world.in(-3.2, 3.2));
}

double Nudged(const World &world, double x) {
    for (std::uint32_t i = world.below(4); i > 0; --i)
        x = std::nextafter(x, world.below(2) ? INFINITY : -INFINITY);
    return x;
}

/// What a body may do from one look to the next: nothing, a hair, a way, a turn, or all of these.
bmr_pose Next(const World &world, const bmr_pose &pose, double far) {
    bmr_pose next = pose;
    const std::uint32_t how = world.below(8);
    if (how == 0)
        return {{Nudged(world, pose.position.x), Nudged(world, pose.position.y)},
                Nudged(world, pose.c),
                Nudged(world, pose.s)};
    if (how % 2)
        next = Turned(next, world.below(2) ? world.in(-1.0, 1.0) : std::exp2(world.in(-40.0, 1.5)));
    if (how / 2 % 2)
        next.position.x += world.length(far);
    if (how / 4)
        next.position.y += world.length(far);
    return next;
}

/// In units, squared.
mpq_class InUnits(const World &world, const mpq_class &square) {
    return square * Square(mpq_class(world.units));
}

const mpq_class kPlacing(1, 16); ///< two places of a pivot, each off by less than 1/32 of a unit

} // namespace

TEST_CASE("no point within reach goes farther than is counted, and the count is hardly more") {
    test_random random = {1};
    std::size_t rounded_down = 0, unturned = 0, unplaced = 0, counted = 0;
    for (std::size_t round = 0; round < rounds(12000); ++round) {
        const World world(&random);
        const bool centered = world.below(2);
        const double far = world.below(2) ? 44.0 : 20.0;
        const bmr_vec2 pivot =
            centered ? bmr_vec2{0.0, 0.0} : bmr_vec2{world.length(far - 2.0), world.length(far - 2.0)};
        const bmr_pose from = AnyPose(world, far, 1.0), to = Next(world, from, 26.0);
        Body body(world, pivot, std::fabs(world.length(26.0)), from);
        const double reach = body.mover.reach;
        const bmr_mover before = body.mover;
        const std::uint32_t moved = body.go(world, to);
        REQUIRE(body.mover.moved - before.moved == moved);
        if (moved == BMR_BUDGET_MARK)
            continue;
        ++counted;
        // The point that turning takes along with the pivot: the worst one.
        const double dc = to.c - from.c, ds = to.s - from.s;
        const double wx = body.mover.center.x - before.center.x, wy = body.mover.center.y - before.center.y;
        const double length =
            std::hypot(dc, ds) * std::hypot(wx * world.units, wy * world.units) * world.unit;
        if (length > 0.0) {
            const double k = reach / length * (1.0 - 0x1p-49);
            const bmr_vec2 worst = {pivot.x + (dc * wx + ds * wy) * k, pivot.y + (dc * wy - ds * wx) * k};
            if (IsAtMost(Square(Way(exact::PlaceOf(pivot), exact::PlaceOf(worst))), reach))
                body.points.push_back(worst);
        }
        const mpq_class most = mpq_class(moved) + (centered ? mpq_class(0) : kPlacing);
        const mpq_class turned = body.mover.turned - before.turned;
        for (const bmr_vec2 &point : body.points) {
            const mpq_class square = InUnits(world, Square(Way(At(from, point), At(to, point))));
            REQUIRE(IsAtMost(square, most));
            const Place arm = Way(exact::PlaceOf(pivot), exact::PlaceOf(point));
            const Place turn =
                exact::Turned(mpq_class(to.c) - mpq_class(from.c), mpq_class(to.s) - mpq_class(from.s), arm);
            REQUIRE(IsAtMost(InUnits(world, Square(turn)), turned));
            // The controls: to round down, to forget the turning, to think that pivots are placed exactly.
            rounded_down += moved > 0 && IsMoreThan(square, mpq_class(moved) - 1);
            const double way = std::hypot(wx * world.units, wy * world.units);
            unturned += IsMoreThan(square, mpq_class(std::floor(way + 2.0)));
            unplaced += IsMoreThan(square, moved);
        }
        const double turning = reach * std::hypot(dc, ds) * world.units;
        REQUIRE(moved <=
                std::hypot(wx * world.units, wy * world.units) * (1 + 1e-12) + turning * (1 + 1e-12) + 1.0);
        REQUIRE((turned <= turning * (1 + 1e-12) + 1.0));
    }
    MESSAGE("counted ", counted, ", lies when rounded down ", rounded_down, ", without turning ", unturned,
            ", without placing ", unplaced);
    CHECK(counted > 1000);
    CHECK(rounded_down > 100);
    CHECK(unturned > 100);
    CHECK(unplaced > 0);
}

TEST_CASE("sums lose nothing, over many looks of hairs and leaps") {
    test_random random = {2};
    std::size_t float_lies = 0, walks = 0;
    for (std::size_t round = 0; round < rounds(1500) / 15; ++round) {
        const World world(&random);
        Body body(world, {world.length(20.0), world.length(20.0)}, std::fabs(world.length(20.0)),
                  AnyPose(world, 40.0, 1.0));
        const Places start = body.places();
        const std::uint32_t begin = body.mover.moved;
        bool marked = false;    // a leap too far for any sum
        float floats = 0x1p24f; // of a sum that has gone on for a while
        const bmr_vec2 drift = {0.3 * world.unit, 0.2 * world.unit};
        for (int look = 0; look < 200; ++look) {
            bmr_pose next = look % 50 == 49 ? Next(world, body.pose, 10.0) : body.pose;
            next.position = bmr_add(next.position, drift);
            const bmr_vec2 was = body.mover.center;
            const bmr_mover before = body.mover;
            marked |= body.go(world, next) == BMR_BUDGET_MARK;
            if (before.turned == body.mover.turned)
                floats += static_cast<float>(
                    std::hypot(was.x - body.mover.center.x, was.y - body.mover.center.y) * world.units);
            else
                floats += static_cast<float>(body.mover.moved - before.moved);
        }
        if (marked)
            continue;
        ++walks;
        const mpq_class most = mpq_class(body.mover.moved - begin) + kPlacing;
        const Places end = body.places();
        for (std::size_t i = 0; i < end.size(); ++i) {
            const mpq_class square = InUnits(world, Square(Way(start[i], end[i])));
            REQUIRE(IsAtMost(square, most));
            float_lies += IsMoreThan(square, mpq_class(floats - 0x1p24f) + 1);
        }
    }
    MESSAGE("walks ", walks, ", lies of sums in float ", float_lies);
    CHECK(walks > 30);
    CHECK(float_lies > 10);
}

TEST_CASE("a pair that is not due is farther apart than its threshold") {
    test_random random = {3};
    std::size_t apart = 0, close = 0, late = 0, unturned = 0;
    for (std::size_t round = 0; round < rounds(3000) / 5; ++round) {
        const World world(&random);
        const bool far = world.below(2);
        const bmr_vec2 place = {far ? world.length(44.0) : 0.0, far ? world.length(44.0) : 0.0};
        bmr_pose poses[2] = {AnyPose(world, 16.0, 1.0), AnyPose(world, 16.0, 1.0)};
        for (bmr_pose &pose : poses)
            pose.position = bmr_add(pose.position, place);
        const double size = std::fabs(world.length(14.0));
        Body a(world, {world.length(10.0), 0.0}, size, poses[0]), b(world, {0.0, 0.0}, size, poses[1]);
        const double threshold = world.below(2) ? 0.0 : std::fabs(world.length(10.0));
        std::uint32_t deadline = 0, deadline_turns = 0;
        bool known = false;
        const auto know = [&] {
            const double slack = AtMost(mpq_class(exact::RootAtMost(LeastSquare(a.places(), b.places()))) -
                                        mpq_class(threshold));
            deadline = bmr_budget_deadline(slack, a.mover.moved, b.mover.moved, world.units);
            deadline_turns = bmr_budget_deadline(slack, a.mover.moved - a.mover.turned,
                                                 b.mover.moved - b.mover.turned, world.units);
            known = true;
        };
        for (int step = 0; step < 24; ++step) {
            const Places pa = a.places(), pb = b.places();
            const mpq_class square = LeastSquare(pa, pb);
            // The control's pair counts ways alone.
            const std::uint32_t ways_a = a.mover.moved - a.mover.turned,
                                ways_b = b.mover.moved - b.mover.turned;
            if (known) {
                const bool under = IsAtMost(square, threshold);
                late += under && !bmr_budget_is_due(deadline + 3, a.mover.moved, b.mover.moved);
                unturned += under && !bmr_budget_is_due(deadline_turns, ways_a, ways_b);
                if (!bmr_budget_is_due(deadline, a.mover.moved, b.mover.moved)) {
                    REQUIRE(!under);
                    ++apart;
                    close += IsAtMost(square, mpq_class(threshold) + 4 * mpq_class(world.unit));
                }
            }
            if (!known || bmr_budget_is_due(deadline, a.mover.moved, b.mover.moved))
                know();
            // A point of a straight at one of b, by what is left and a little less or more; or a turn that
            // takes a point of a to where one of b has gone meanwhile, and b is known to be there; or
            // anything.
            const double left = bmr_budget_left(deadline, a.mover.moved, b.mover.moved);
            bmr_pose next = a.pose;
            const std::uint32_t how = world.below(4);
            if (how < 2) {
                const mpq_class least = LeastSquare(pa, pb);
                for (const Place &p : pa)
                    for (const Place &q : pb)
                        if (least > 0 && Square(Way(p, q)) == least) {
                            const Place way = Way(p, q);
                            const double by =
                                (left + world.in(-3.0, 3.0)) * world.unit / exact::RootAtMost(least);
                            next.position =
                                bmr_add(a.pose.position, {way.x.get_d() * by, way.y.get_d() * by});
                        }
            } else if (how == 2 && known) {
                next = Turned(a.pose, world.in(-1.0, 1.0));
                bmr_pose there = b.pose;
                there.position = bmr_sub(bmr_transform(&next, a.points[0]), bmr_rotate(&b.pose, b.points[0]));
                b.go(world, there);
                know();
            } else {
                next = Next(world, a.pose, 14.0);
            }
            a.go(world, next);
            if (world.below(4) == 0)
                b.go(world, Next(world, b.pose, 12.0));
        }
    }
    MESSAGE("apart ", apart, ", of these close ", close, ", lies of three units more ", late,
            ", without turning ", unturned);
    CHECK(apart > 500);
    CHECK(close > 20);
    CHECK(late > 20);
    CHECK(unturned > 20);
}

TEST_CASE("a line's gap is one that is there") {
    test_random random = {4};
    std::size_t proofs = 0, two_more = 0, unturned = 0, none = 0;
    for (std::size_t round = 0; round < rounds(4000); ++round) {
        const World world(&random);
        // Wide: the pivots are as far apart as they may be, and nearly at right angles to the line.
        const bool wide = world.below(2);
        const double angle = world.in(-3.2, 3.2), lean = std::exp2(world.in(-30.0, -20.0));
        const bmr_vec2 n = wide ? bmr_vec2{1.0 + lean, 1.0} : bmr_vec2{std::cos(angle), std::sin(angle)};
        const double size = std::fabs(world.length(24.0));
        bmr_pose poses[2] = {AnyPose(world, 24.0, 10.0), AnyPose(world, 24.0, 10.0)};
        if (wide) {
            const double far = world.in(0x1p43, 0x1p44) * world.unit;
            poses[0].position = bmr_add(poses[0].position, {far, -far});
            poses[1].position = bmr_add(poses[1].position, {-far, far});
        }
        Body a(world, {world.length(24.0), 0.0}, size, poses[0]), b(world, {0.0, 0.0}, size, poses[1]);
        const double k = std::exp2(world.in(-100.0, 100.0));
        const bmr_vec2 d = world.below(2) ? n : bmr_vec2{n.x * k, n.y * k};
        const double gap = AtMost(LeastAlong(exact::PlaceOf(d), a.places(), b.places()));
        const bmr_budget_line line = bmr_budget_line_make(d, gap, &a.mover, &b.mover, world.units);
        const Place normal = {mpq_class(line.normal[0]), mpq_class(line.normal[1])};
        REQUIRE((Square(normal) <= 1));
        if (Square(normal) == 0) {
            ++none;
            continue;
        }
        REQUIRE((Square(normal) > mpq_class(1) - mpq_class(1, 1000000)));
        const std::uint32_t turned = a.mover.turned + b.mover.turned;
        for (int step = 0; step < 6; ++step) {
            const Places pa = a.places(), pb = b.places();
            const double claim = bmr_budget_line_gap(&line, &a.mover, &b.mover, world.units);
            const mpq_class truth = LeastAlong(normal, pa, pb);
            if (claim > 0.0) {
                ++proofs;
                REQUIRE((truth >= mpq_class(claim)));
                REQUIRE((LeastSquare(pa, pb) >= Square(mpq_class(claim))));
            }
            // The controls: a claim of two units more, and one to which turning is nothing.
            const mpq_class more = mpq_class(claim) + 2 * mpq_class(world.unit);
            two_more += more > 0 && truth < more;
            const mpq_class still =
                mpq_class(claim) + (a.mover.turned + b.mover.turned - turned) * mpq_class(world.unit);
            unturned += still > 0 && truth < still;
            if (step == 0) { // what it costs to be sure
                const double reaches = (a.mover.reach * std::hypot(a.pose.c, a.pose.s) +
                                        b.mover.reach * std::hypot(b.pose.c, b.pose.s)) *
                                       world.units;
                const double lost = (truth.get_d() - claim) * world.units;
                REQUIRE(lost <= 0x1p-22 * (std::fabs(claim) * world.units + 2.0 * reaches) + 3.0);
            }
            Body &mover = world.below(2) ? a : b;
            mover.go(world, Next(world, mover.pose, 18.0));
        }
    }
    MESSAGE("proofs ", proofs, ", lies of two units more ", two_more, ", without turning ", unturned,
            ", none ", none);
    CHECK(proofs > 1000);
    CHECK(two_more > 100);
    CHECK(unturned > 100);
}

TEST_CASE("nothing in a sweep is farther from where the body was than the sweep's bound") {
    test_random random = {5};
    std::size_t rounded_down = 0, ends = 0, unturned = 0, apart = 0;
    for (std::size_t round = 0; round < rounds(3000); ++round) {
        const World world(&random);
        const bmr_vec2 pivot = {world.below(2) ? 0.0 : world.length(20.0), 0.0};
        Body body(world, pivot, std::fabs(world.length(24.0)), AnyPose(world, 24.0, 10.0));
        const bmr_mover &mover = body.mover;
        const bmr_vec2 from =
            world.below(2) ? mover.center : bmr_add(mover.center, {world.length(20.0), 0.0});
        const bmr_vec2 to = bmr_add(mover.center, {world.length(24.0), world.length(24.0)});
        const double half =
            world.in(-1.0, 1.0) * (world.below(2) ? 1.0 : 0x1p-20); // tangent of half the turn
        const double turn = 2.0 * std::atan(half) * (1.0 + 0x1p-50);
        const std::uint32_t bound = bmr_mover_sweep(&mover, from, to, turn, world.units);
        const std::uint32_t straight = bmr_mover_sweep(&mover, from, to, 0.0, world.units);
        if (bound == BMR_BUDGET_MARK)
            continue;
        // Another body in the way: a point, at a threshold's distance from where the sweep takes the first.
        const double threshold = std::fabs(world.length(10.0));
        const Places start = body.places();
        const Place other = {mpq_class(to.x) + mpq_class(world.length(26.0)), mpq_class(to.y)};
        const double slack =
            AtMost(mpq_class(exact::RootAtMost(LeastSquare(start, {other}))) - mpq_class(threshold));
        const std::uint32_t deadline = bmr_budget_deadline(slack, mover.moved, 0, world.units);
        const bool safe = !bmr_budget_is_due(deadline, mover.moved + bound, 0);
        apart += safe;
        for (int sample = 0; sample < 4; ++sample) {
            const mpq_class t = sample < 2 ? mpq_class(sample) : mpq_class(world.in(0.0, 1.0));
            const mpq_class q =
                mpq_class(half) * (sample % 2 ? mpq_class(1) : mpq_class(world.in(-1.0, 1.0)));
            const mpq_class c = (1 - q * q) / (1 + q * q), s = 2 * q / (1 + q * q);
            const mpq_class x = mpq_class(from.x) + t * (mpq_class(to.x) - mpq_class(from.x));
            const mpq_class y = mpq_class(from.y) + t * (mpq_class(to.y) - mpq_class(from.y));
            for (std::size_t i = 0; i < start.size(); ++i) {
                const Place arm = Way(exact::PlaceOf(pivot), exact::PlaceOf(body.points[i]));
                const Place turned =
                    exact::Turned(c, s, exact::Turned(mpq_class(body.pose.c), mpq_class(body.pose.s), arm));
                const Place there = {x + turned.x, y + turned.y};
                const mpq_class square = InUnits(world, Square(Way(start[i], there)));
                REQUIRE(IsAtMost(square, mpq_class(bound) + kPlacing / 2));
                rounded_down += IsMoreThan(square, mpq_class(bound) - 1);
                unturned += IsMoreThan(square, straight);
                ends += sample == 1 && IsMoreThan(square, mpq_class(bound) * mpq_class(9, 10));
                if (safe)
                    REQUIRE(IsMoreThan(Square(Way(there, other)), threshold));
            }
        }
    }
    MESSAGE("near the bound at the end ", ends, ", lies when rounded down ", rounded_down,
            ", without turning ", unturned, ", apart all the way ", apart);
    CHECK(ends > 50);
    CHECK(rounded_down > 50);
    CHECK(unturned > 100);
    CHECK(apart > 100);
}
