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

struct OraclePair : test_pair {
    test_motion motion;

    OraclePair(bmr_structure structure, std::size_t round, test_random *random)
        : test_pair(Make(structure, random)) {
        if (round % 2)
            def.margin = test_random_uniform(random, 0.0, 0.05);
        const auto kind = static_cast<test_motion_kind>(round % TEST_MOTION_KIND_COUNT);
        motion = test_motion_make(kind, shape[0].polygon, shape[1].polygon, random);
    }
    OraclePair(const OraclePair &) = delete;
    OraclePair &operator=(const OraclePair &) = delete;
    ~OraclePair() { test_pair_destroy(this); }
    double extents() const { return shape[0].polygon->extent + shape[1].polygon->extent; }

private:
    static test_pair Make(bmr_structure structure, test_random *random) {
        bmr_polygon *body[2];
        for (bmr_polygon *&polygon : body) {
            const auto family = static_cast<test_family>(test_random_below(random, TEST_FAMILY_COUNT));
            polygon = test_polygon(family, 3 + test_random_below(random, 5), random);
        }
        return test_pair_make(structure, body[0], body[1]);
    }
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
    test_random random = test_random_from(77);
    std::size_t apart = 0, contact = 0, bare_lies = 0, stale_lies = 0, disks = 0;
    for (int structure = 0; structure < BMR_STRUCTURE_COUNT; ++structure)
        for (std::size_t round = 0; round < rounds(300); ++round) {
            OraclePair t(static_cast<bmr_structure>(structure), round, &random);
            const Places a = PlacesOf(t.shape[0].polygon);
            bmr_pair stale;
            bmr_pair_init(&stale);
            for (int step = 0; step < 20; ++step) {
                const bmr_pose q = test_motion_next(&t.motion, &random);
                double gap;
                const bmr_answer answer = test_pair_advance(&t, &q, &gap);
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
    test_random random = test_random_from(78);
    for (int structure = 0; structure < BMR_STRUCTURE_COUNT; ++structure)
        for (std::size_t round = 0; round < rounds(40); ++round) {
            OraclePair t(static_cast<bmr_structure>(structure), 1, &random);
            const Places a = PlacesOf(t.shape[0].polygon);
            const double way = test_random_uniform(&random, 0.0, 6.28),
                         turn = test_random_uniform(&random, 0.0, 6.28);
            const double slop = t.def.margin * 1e-6 + BMR_PAIR_SLOP * t.extents();
            for (int step = -8; step <= 8; ++step) {
                const bmr_pose q = test_pose_at(t.shape[0].polygon, t.shape[1].polygon, way, turn,
                                                t.def.margin + step * slop / 2.0);
                bmr_pair_init(&t.pair);
                t.counters = {};
                const bool apart = test_pair_advance(&t, &q, nullptr) == BMR_APART;
                REQUIRE(t.counters.events[BMR_EVENT_START] ==
                        (apart ? 1 : 0)); // whichever of its proofs is taken
                const Number truth = SquaredDistance(a, PlacesAt(t.shape[1].polygon, q));
                if (apart)
                    REQUIRE(truth > Square(t.def.margin));
                else
                    REQUIRE(truth <= Square(t.def.margin + slop));
            }
        }
}

TEST_CASE("the brute-force distance of the other tests is the exact one up to double rounding") {
    test_random random = test_random_from(79);
    std::size_t overlapping = 0, apart = 0;
    for (std::size_t round = 0; round < rounds(2000); ++round) {
        bmr_polygon *const a = test_any_polygon(12, &random), *const b = test_any_polygon(12, &random);
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
