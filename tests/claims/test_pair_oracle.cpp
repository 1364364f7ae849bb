// SPDX-License-Identifier: MIT
// Pairs against rational arithmetic: no certificate claims a separation that is not there, and no contact is
// missed.
#include "boomerang/pair.h"
#include "cases.h"
#include "exact_distance.h"
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
    const mpq_class nx(double{k.normal[0]}), ny(double{k.normal[1]});
    const mpq_class c(q.c), s(q.s);
    const Place normal = owner == 0 ? Place{nx, ny} : Place{-(c * nx - s * ny), -(s * nx + c * ny)};
    const mpq_class along = LeastAlong(normal, a, b);
    return along > 0 && along * along >= Square(gap) * Square(normal);
}

} // namespace

TEST_CASE("no pair claims a gap that rational arithmetic denies, and none misses a contact") {
    test_random random = test_random_from(77);
    std::size_t apart = 0, contact = 0, bare_lies = 0, stale_lies = 0, disks = 0;
    for (int structure = 0; structure < BMR_STRUCTURE_COUNT; ++structure)
        for (std::size_t round = 0; round < rounds(300); ++round) {
            OraclePair t(static_cast<bmr_structure>(structure), round, &random);
            const Posed here = PosedOf(t.shape[0].polygon);
            const Places a = PlacesOf(here);
            bmr_pair stale;
            bmr_pair_init(&stale);
            for (int step = 0; step < 20; ++step) {
                const bmr_pose q = test_motion_next(&t.motion, &random);
                double gap;
                const bmr_answer answer = test_pair_advance(&t, &q, &gap);
                const Posed there = PosedOf(t.shape[1].polygon, q);
                const mpq_class truth = SquaredDistance(here, there);
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
                const Places b = PlacesOf(there);
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
            const Posed here = PosedOf(t.shape[0].polygon);
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
                const mpq_class truth = SquaredDistance(here, PosedOf(t.shape[1].polygon, q));
                if (apart)
                    REQUIRE(truth > Square(t.def.margin));
                else
                    REQUIRE(truth <= Square(t.def.margin + slop));
            }
        }
}

namespace {

/// Do the normals of some edge separate the two, closed as they are? (For points and segments, only where
/// they are not in line.)
bool SomeEdgeSeparates(const Places &a, const Places &b) {
    for (int turn = 0; turn < 2; ++turn) {
        const Places &own = turn ? b : a;
        for (size_t i = 0; i < own.size(); ++i) {
            const Place e = Way(own[i], own[(i + 1) % own.size()]);
            if (LeastAlong(turn ? Place{-e.y, e.x} : Place{e.y, -e.x}, a, b) > 0)
                return true;
        }
    }
    return false;
}

mpq_class Cross(const Place &a, const Place &b) {
    return a.x * b.y - a.y * b.x;
}

/// Of a point and a segment, which may be a point.
mpq_class SquareToSegment(const Place &p, const Place &from, const Place &to) {
    const Place e = Way(from, to), w = Way(from, p);
    const mpq_class along = Product(e, w), length = Square(e), across = Cross(e, w);
    if (along <= 0)
        return Square(w);
    return along >= length ? Square(Way(to, p)) : mpq_class(across * across / length);
}

/// The squared distance by all corners and all sides, without a filter; 0 where they touch or overlap.
mpq_class SquareOfAll(const Places &a, const Places &b) {
    const bool separated = SomeEdgeSeparates(a, b);
    if ((a.size() > 2 || b.size() > 2) && !separated)
        return 0;
    mpq_class best(-1);
    for (size_t i = 0; i < a.size(); ++i)
        for (size_t j = 0; j < b.size(); ++j) {
            const Place &a_next = a[(i + 1) % a.size()], &b_next = b[(j + 1) % b.size()];
            for (const mpq_class &d :
                 {SquareToSegment(a[i], b[j], b_next), SquareToSegment(b[j], a[i], a_next)})
                if (best < 0 || d < best)
                    best = d;
            // Two segments that are not in line, and neither of whose lines separates them, cross.
            if (!separated && Cross(Way(a[i], a_next), Way(b[j], b_next)) != 0)
                return 0;
        }
    return best;
}

/// The square of the least depth over all normals of edges, of two that overlap.
mpq_class SquaredDepth(const Places &a, const Places &b) {
    mpq_class best(-1);
    for (int turn = 0; turn < 2; ++turn) {
        const Places &own = turn ? b : a;
        for (size_t i = 0; i < own.size() && own.size() > 1; ++i) {
            const Place e = Way(own[i], own[(i + 1) % own.size()]);
            const mpq_class along = LeastAlong(turn ? Place{-e.y, e.x} : Place{e.y, -e.x}, a, b),
                            square = along * along / Square(e);
            if (best < 0 || square < best)
                best = square;
        }
    }
    return best;
}

} // namespace

TEST_CASE("the oracle of distance says what all corners and all sides say") {
    test_random random = test_random_from(79);
    std::size_t overlapping = 0, apart = 0, touching = 0;
    for (std::size_t round = 0; round < rounds(2000); ++round) {
        bmr_polygon *const a = test_any_polygon(12, &random), *const b = test_any_polygon(12, &random);
        test_motion motion = test_motion_make(TEST_MOTION_JUMP, a, b, &random);
        bmr_pose q = test_motion_next(&motion, &random);
        if (round % 8 == 0) // sides that are parallel, corners that touch
            q = {bmr_sub(a->vertices[0], b->vertices[b->count / 2]), 1.0, 0.0};
        const Posed here = PosedOf(a), there = PosedOf(b, q);
        const Places p = PlacesOf(here), r = PlacesOf(there);
        const Gap gap = GapOf(here, there);
        const mpq_class truth = SquareOfAll(p, r);
        CHECK((gap.overlap || Square(gap.way) == truth));
        CHECK((!gap.overlap || (truth == 0 && Square(gap.way) == SquaredDepth(p, r))));
        const long double distance = std::sqrt(static_cast<long double>(truth.get_d()));
        CHECK(std::fabs(test_distance(a, b, &q) - distance) <= 0x1p-51L * distance);
        const double way = test_random_uniform(&random, -4.0, 4.0);
        const bmr_vec2 d = {std::cos(way), std::sin(way)};
        const double along = LeastAlong(PlaceOf(d), p, r).get_d() / std::hypot(d.x, d.y);
        CHECK(std::fabs(SeparationAlong(d, here, there) - along) <= 0x1p-50 * std::fabs(along));
        const double rounding = 1e-15 * (a->extent + b->extent + std::hypot(q.position.x, q.position.y));
        CHECK(std::fabs(NearDistance(here, there) - distance) <= rounding);
        overlapping += gap.overlap;
        touching += !gap.overlap && truth == 0;
        apart += truth > 0;
        bmr_polygon_destroy(a, nullptr);
        bmr_polygon_destroy(b, nullptr);
    }
    CHECK(overlapping > 5);
    CHECK(touching > 5);
    CHECK(apart > 30);
}
