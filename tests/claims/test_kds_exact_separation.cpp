// SPDX-License-Identifier: MIT
// Every kinetic structure against rational arithmetic: where it says apart, or where all conditions of its
// proof are positive, the exact distance is more than the margin; where it says contact, it is not. At poses
// some units in the last place about the margin, of slivers too, near the origin and far from it.
#include "boomerang/kds.h"
#include "cases.h"
#include "exact_distance.h"
#include "kds_driver.h"
#include "motions.h"

namespace {

using namespace exact;

struct Body {
    test_kds_body body;

    explicit Body(test_kds_body made) : body(made) {}
    Body(const Body &) = delete;
    Body &operator=(const Body &) = delete;
    ~Body() { test_kds_body_destroy(&body); }
};

test_kds_body RandomBody(test_random *random, double shift) {
    const auto family = static_cast<test_family>(test_random_below(random, TEST_FAMILY_COUNT));
    bmr_polygon *polygon = test_polygon(family, 3 + test_random_below(random, 6), random);
    return test_kds_body_make(test_moved_polygon(polygon, 1.0, {shift, shift}));
}

test_kds_body OtherBody(bmr_kds_domain domain, test_random *random, double shift) {
    if (domain == BMR_KDS_POINT)
        return test_kds_point_make(shift + test_random_uniform(random, -1.0, 1.0), shift);
    return RandomBody(random, shift);
}

mpq_class Truth(const Body &a, const Body &b, const bmr_pose &q) {
    return SquaredDistance(PosedOf(a.body.polygon), PosedOf(b.body.polygon, q));
}

double Nudged(double x, test_random *random) {
    const double steps = 3.0 * 0x1p-52 * (std::fabs(x) + 1e-3);
    return x + test_random_uniform(random, -steps, steps);
}

/// The structures are in double: the distance that they find is rounded like the coordinates are.
constexpr double kRounding = 1e-15;

struct Tally {
    std::size_t exactly = 0; ///< said to be apart within the margin by less than that
    std::size_t apart = 0, contact = 0, held = 0, stale = 0;
};

void Check(const bmr_kds_info *info, test_random *random, Tally *tally) {
    const double shifts[] = {0.0, 0.0, 100.0, 10000.0};
    const double shift = shifts[test_random_below(random, 4)];
    const Body a(RandomBody(random, shift)), b(OtherBody(info->domain, random, 0.5 * shift));
    const double extents = a.body.polygon->extent + b.body.polygon->extent;
    bmr_kds_def def = bmr_default_kds_def();
    def.margin = 1e-6 * extents;
    bmr_kds *kds = nullptr;
    REQUIRE(bmr_kds_create(info, &def, &a.body.shape, &b.body.shape, nullptr, &kds) == BMR_OK);
    const double gaps[] = {0.0, 1e-13, 1e-9, 2e-9, 1e-7, 1e-4, 0.1};
    const double gap = def.margin + (test_random_below(random, 2) ? 1.0 : -1.0) * extents *
                                        gaps[test_random_below(random, 7)];
    const bmr_pose q = test_pose_at(a.body.polygon, b.body.polygon, test_random_uniform(random, 0.0, 6.28),
                                    test_random_uniform(random, 0.0, 6.28), gap);
    const bmr_instant now = {q, {0.0, 0.0}, 0.0};
    bmr_kds_report report;
    bmr_kds_start(kds, &now, &report);
    const mpq_class truth = Truth(a, b, q);
    if (report.apart) {
        ++tally->apart;
        CHECK((truth > Square(def.margin - kRounding * extents)));
        tally->exactly += truth <= Square(def.margin);
    } else {
        ++tally->contact;
        CHECK((truth <= Square(def.margin + 1e-9 * extents)));
    }
    // Elsewhere the conditions decide.
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const std::size_t count = bmr_kds_conditions(kds, conditions);
    for (int i = 0; i < 4 && report.apart; ++i) {
        const double way = extents * std::pow(10.0, test_random_uniform(random, -14.0, -3.0)),
                     turn = info->domain == BMR_KDS_RIGID
                                ? std::pow(10.0, test_random_uniform(random, -14.0, -3.0))
                                : 0.0;
        const double angle = std::atan2(q.s, q.c) + (i % 2 ? turn : -turn);
        bmr_pose moved = {{q.position.x + test_random_uniform(random, -way, way),
                           q.position.y + test_random_uniform(random, -way, way)},
                          turn > 0.0 ? std::cos(angle) : q.c,
                          turn > 0.0 ? std::sin(angle) : q.s};
        moved.position.x = Nudged(moved.position.x, random);
        bool holds = true;
        for (std::size_t j = 0; j < count; ++j)
            holds = holds && bmr_condition_value(&conditions[j], &moved) > 0.0;
        const bool lie = Truth(a, b, moved) <= Square(def.margin - kRounding * extents);
        tally->stale += lie; // the control: to believe the start's answer
        tally->held += holds;
        CHECK_FALSE((holds && lie));
    }
    bmr_kds_destroy(kds, nullptr);
}

/// Where contact begins and ends: of extents from tiny to huge, of margins and hystereses from far below them
/// to far above.
struct Border {
    std::size_t contacts = 0, left = 0;
    std::size_t past = 0; ///< in contact beyond 1e-9 of the extents alone: the control
};

void CheckBorder(const bmr_kds_info *info, test_random *random, Border *border) {
    const auto power = [random](double low, double high) {
        return std::pow(10.0, test_random_uniform(random, low, high));
    };
    const double scale = power(-8.0, 6.0);
    const auto scaled = [&](test_family family) {
        bmr_polygon *polygon = test_polygon(family, 3 + test_random_below(random, 6), random);
        return Body(test_kds_body_make(test_moved_polygon(polygon, scale, {0.0, 0.0})));
    };
    const Body a = scaled(TEST_CIRCLE), b = info->domain == BMR_KDS_POINT
                                                ? Body(test_kds_point_make(scale, 0.3 * scale))
                                                : scaled(TEST_LENS);
    const double extents = a.body.polygon->extent + b.body.polygon->extent;
    bmr_kds_def def = bmr_default_kds_def();
    def.margin = extents * power(-6.0, 7.0);
    def.hysteresis = def.margin * power(-3.0, 3.0);
    bmr_kds *kds = nullptr;
    REQUIRE(bmr_kds_create(info, &def, &a.body.shape, &b.body.shape, nullptr, &kds) == BMR_OK);
    const double angle = test_random_uniform(random, 0.0, 6.28);
    const auto place = [&](double gap) {
        const bmr_instant now = {
            test_pose_at(a.body.polygon, b.body.polygon, test_random_uniform(random, 0.0, 6.28), angle, gap),
            {0.0, 0.0},
            0.0};
        bmr_kds_report report;
        const bool before = bmr_kds_in_contact(kds);
        bmr_kds_start(kds, &now, &report);
        const bool after = bmr_kds_in_contact(kds);
        CHECK(report.kind == (after ? BMR_KDS_CONTACT : before ? BMR_KDS_LEAVE : BMR_KDS_START));
        bmr_kds_proof proof;
        CHECK(bmr_kds_get_proof(kds, &proof) == !after);
        CHECK((after || std::fabs(bmr_dot(proof.line.normal, proof.line.normal) - 1.0) < 1e-9));
        return now.pose;
    };
    for (int i = 0; i < 6; ++i) {
        place(i % 2 == 0 ? -0.1 * extents : 2.0 * (def.margin + def.hysteresis + extents));
        const double reach = def.margin + (bmr_kds_in_contact(kds) ? def.hysteresis : 0.0);
        const double rounding = 1e-9 * extents + 2e-8 * reach;
        // Far on either side, and where nothing but the rounding of a large reach can make it contact.
        const double near = 1e-9 * extents + 0x1p-53 * reach;
        const bmr_pose q = place(reach + (i < 4 ? rounding * test_random_uniform(random, -2.0, 2.0) : near));
        const mpq_class truth = Truth(a, b, q);
        if (bmr_kds_in_contact(kds)) {
            ++border->contacts;
            CHECK((truth <= Square(reach + rounding)));
            border->past += truth > Square(reach + 1e-9 * extents);
            CHECK(bmr_kds_audit(kds, &q) == BMR_OK);
        } else {
            ++border->left;
            CHECK((truth > Square(reach - 1e-15 * (extents + reach))));
        }
    }
    bmr_kds_destroy(kds, nullptr);
}

} // namespace

TEST_CASE("contact begins at the margin and ends at margin and hysteresis, up to the derived rounding") {
    test_random random = test_random_from(92);
    const std::size_t rounds = std::max<std::size_t>(test_scaled(120), 12);
    std::size_t past = 0;
    for (std::size_t i = 0; i < bmr_kds_count(); ++i) {
        const bmr_kds_info *info = bmr_kds_at(i);
        const std::string name = info->name;
        CAPTURE(name);
        Border border;
        for (std::size_t round = 0; round < rounds; ++round)
            CheckBorder(info, &random, &border);
        CHECK(border.contacts > 0);
        CHECK(border.left > 0);
        past += border.past;
    }
    MESSAGE("past 1e-9 of the extents: ", past);
    CHECK((past > 0 || rounds < 100));
}

TEST_CASE(
    "no structure is apart, nor its conditions positive, where the exact distance is within the margin") {
    test_random random = test_random_from(91);
    const std::size_t rounds = std::max<std::size_t>(test_scaled(60), 12);
    Tally all;
    for (std::size_t i = 0; i < bmr_kds_count(); ++i) {
        const bmr_kds_info *info = bmr_kds_at(i);
        const std::string name = info->name;
        CAPTURE(name);
        Tally t;
        for (std::size_t round = 0; round < rounds; ++round)
            Check(info, &random, &t);
        CHECK(t.apart > 0);
        if (t.exactly > 0)
            MESSAGE(name, " says apart within the margin by rounding: ", t.exactly);
        all.apart += t.apart;
        all.contact += t.contact;
        all.held += t.held;
        all.stale += t.stale;
    }
    MESSAGE("apart ", all.apart, ", contact ", all.contact, ", held ", all.held, ", stale ", all.stale);
    CHECK(all.contact > 0);
    CHECK(all.held > all.apart);
    CHECK(all.stale > 0);
}
