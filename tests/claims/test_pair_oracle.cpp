// SPDX-License-Identifier: MIT
// Pairs against rational arithmetic: no certificate claims a separation that is not there, and no contact is
// missed.
#include "boomerang/pair.h"
#include "cases.h"
#include "exact_polygons.h"
#include "motions.h"
#include "polygons.h"

namespace {

using namespace exact;

/// A few motions must always run, or the controls may see nothing.
std::size_t rounds(std::size_t count) {
    return std::max<std::size_t>(test_scaled(count), 64);
}

struct Couple {
    test_body body[2];
    bmr_shape shape[2];
    bmr_pair_def def;
    bmr_pair pair;
    test_motion motion;

    Couple(bmr_structure structure, std::size_t round, test_random *random) : def(bmr_default_pair_def()) {
        for (int side = 0; side < 2; ++side) {
            const auto family = static_cast<test_family>(test_random_below(random, TEST_FAMILY_COUNT));
            bmr_polygon *polygon = test_polygon(family, 3 + test_random_below(random, 5), random);
            body[side] = test_body_make(polygon, structure);
            shape[side] = test_body_shape(&body[side]);
        }
        def.structure = structure;
        if (round % 2)
            def.margin = test_random_uniform(random, 0.0, 0.05);
        bmr_pair_init(&pair);
        const auto kind = static_cast<test_motion_kind>(round % TEST_MOTION_KIND_COUNT);
        motion = test_motion_make(kind, shape[0].polygon, shape[1].polygon, random);
    }
    Couple(const Couple &) = delete;
    Couple &operator=(const Couple &) = delete;
    ~Couple() {
        test_body_destroy(&body[0]);
        test_body_destroy(&body[1]);
    }
    double extents() const { return shape[0].polygon->extent + shape[1].polygon->extent; }
};

/// What a certificate proves at a pose, exactly: the gap along its normal as it is in floats, over the
/// normal's length. Says whether that is at least `gap`.
bool proves(const bmr_certificate &k, int owner, const Places &a, const Places &b, const bmr_pose &q,
            double gap) {
    const Number nx(double{k.normal[0]}), ny(double{k.normal[1]});
    const Number c(q.c), s(q.s);
    const Place normal = owner == 0 ? Place{nx, ny} : Place{-(c * nx - s * ny), -(s * nx + c * ny)};
    const Number along = LeastAlong(normal, a, b);
    return along > 0 && along * along >= Square(gap) * Square(normal);
}

} // namespace

TEST_CASE("no pair claims a gap that rational arithmetic denies, and none misses a contact") {
    test_random random = {77};
    std::size_t apart = 0, contact = 0, bare_lies = 0, stale_lies = 0, disks = 0;
    for (int structure = 0; structure < BMR_STRUCTURE_COUNT; ++structure)
        for (std::size_t round = 0; round < rounds(300); ++round) {
            Couple t(static_cast<bmr_structure>(structure), round, &random);
            const Places a = PlacesOf(t.shape[0].polygon);
            bmr_pair stale;
            bmr_pair_init(&stale);
            for (int step = 0; step < 20; ++step) {
                const bmr_pose q = test_motion_next(&t.motion, &random);
                double gap;
                const bmr_answer answer =
                    bmr_pair_advance(&t.pair, &t.def, &t.shape[0], &t.shape[1], &q, nullptr, &gap);
                const Places b = PlacesAt(t.shape[1].polygon, q);
                const Number truth = SquaredDistance(a, b);
                // The control: to believe the last step's answer.
                stale_lies += stale.state == BMR_PAIR_APART && truth <= Square(t.def.margin);
                stale = t.pair;
                if (answer == BMR_STAB_POLYGON) {
                    ++contact;
                    const double need = t.def.margin * (1.0 + 1e-6) + BMR_PAIR_SLOP * t.extents();
                    REQUIRE(truth <= Square(need));
                    continue;
                }
                ++apart;
                REQUIRE(gap > t.def.margin);
                REQUIRE(truth >= Square(gap)); // so: more than the margin apart, and not touching
                if (t.pair.level == BMR_LEVEL_DISKS) {
                    ++disks;
                    continue;
                }
                const bmr_certificate &k = t.pair.certificate;
                REQUIRE(proves(k, t.pair.owner, a, b, q, gap));
                // The control: the same line without its roundings claims more than there is.
                bmr_certificate bare = k;
                const bmr_polygon *own = t.shape[t.pair.owner].polygon;
                double support = -INFINITY;
                for (std::uint32_t i = 0; i < own->count; ++i)
                    support = std::max(support, double{k.normal[0]} * own->vertices[i].x +
                                                    double{k.normal[1]} * own->vertices[i].y);
                bare.offset = static_cast<float>(support);
                double bare_gap;
                bmr_certificate_check_pair(&bare, &q, t.pair.owner, 0.0, &bare_gap);
                bare_lies += bare_gap > 0.0 && !proves(k, t.pair.owner, a, b, q, bare_gap);
            }
        }
    MESSAGE("apart ", apart, " (disks ", disks, "), contact ", contact, ", lies without rounding ",
            bare_lies);
    CHECK(apart > 1000);
    CHECK(contact > 30);
    CHECK(disks > 10);
    CHECK(bare_lies > 30);
    CHECK(stale_lies > 30);
}

TEST_CASE("at distances near the margin the answer changes where it should, to within the stated slop") {
    test_random random = {78};
    for (int structure = 0; structure < BMR_STRUCTURE_COUNT; ++structure)
        for (std::size_t round = 0; round < rounds(40); ++round) {
            Couple t(static_cast<bmr_structure>(structure), 1, &random);
            const Places a = PlacesOf(t.shape[0].polygon);
            const double way = test_random_uniform(&random, 0.0, 6.28),
                         turn = test_random_uniform(&random, 0.0, 6.28);
            const double slop = t.def.margin * 1e-6 + BMR_PAIR_SLOP * t.extents();
            for (int step = -8; step <= 8; ++step) {
                const bmr_pose q = test_pose_at(t.shape[0].polygon, t.shape[1].polygon, way, turn,
                                                t.def.margin + step * slop / 2.0);
                bmr_pair_init(&t.pair);
                bmr_counters counters = {};
                const bmr_observer observer = {&counters, nullptr, nullptr};
                const bool apart = bmr_pair_advance(&t.pair, &t.def, &t.shape[0], &t.shape[1], &q, &observer,
                                                    nullptr) == BMR_APART;
                REQUIRE(counters.events[BMR_EVENT_START] ==
                        (apart ? 1 : 0)); // whichever of its proofs is taken
                const Number truth = SquaredDistance(a, PlacesAt(t.shape[1].polygon, q));
                if (apart)
                    REQUIRE(truth > Square(t.def.margin));
                else
                    REQUIRE(truth <= Square(t.def.margin + slop));
            }
        }
}

namespace {

/// One in ten a point or a segment, one in four of another size and far from its frame's origin.
bmr_polygon *AnyPolygon(test_random *random) {
    bmr_vec2 points[24];
    std::size_t count = 1 + test_random_below(random, 20);
    const auto family = static_cast<test_family>(test_random_below(random, TEST_FAMILY_COUNT));
    if (count > 2)
        count = test_points(family, 3 + test_random_below(random, 9), random, points);
    else
        for (std::size_t i = 0; i < count; ++i)
            points[i] = {test_random_uniform(random, -1.0, 1.0), test_random_uniform(random, -1.0, 1.0)};
    const bool moved = test_random_below(random, 4) == 0;
    const double scale = moved ? std::pow(10.0, test_random_uniform(random, -3.0, 3.0)) : 1.0;
    const double away = moved ? scale * test_random_uniform(random, 0.0, 10.0) : 0.0;
    for (std::size_t i = 0; i < count; ++i)
        points[i] = {scale * points[i].x + away, scale * points[i].y - away};
    bmr_polygon *polygon = nullptr;
    REQUIRE(bmr_polygon_create(points, count, nullptr, &polygon) == BMR_OK);
    return polygon;
}

} // namespace

TEST_CASE("the brute-force distance of the other tests is the exact one up to double rounding") {
    test_random random = {79};
    std::size_t overlapping = 0, apart = 0;
    for (std::size_t round = 0; round < rounds(2000); ++round) {
        bmr_polygon *const a = AnyPolygon(&random), *const b = AnyPolygon(&random);
        test_motion motion = test_motion_make(TEST_MOTION_JUMP, a, b, &random);
        const bmr_pose q = test_motion_next(&motion, &random);
        const double distance = test_distance(a, b, &q);
        const double exact = std::sqrt(SquaredDistance(PlacesOf(a), PlacesAt(b, q)).get_d());
        const double tolerance = 1e-13 * (a->extent + b->extent + exact);
        CHECK(std::abs(distance - exact) <= tolerance);
        overlapping += exact == 0.0;
        apart += exact > tolerance;
        bmr_polygon_destroy(a, nullptr);
        bmr_polygon_destroy(b, nullptr);
    }
    CHECK(overlapping > 5);
    CHECK(apart > 30);
}
