// SPDX-License-Identifier: MIT
// Every structure, and the one of CONTRIBUTING.md, simulated along random motions of every kind, against code
// that shares nothing with core: a separating-axis test over all edges and vertices in long double. Whenever
// a structure says "apart", the polygons are; whenever they overlap, it says "contact".
//
// BMR_TEST_SCALE=400 is the campaign of 100,000 motions for each structure.
#include "boomerang/simulation.h"
#include "cases.h"
#include "kds_driver.h"
#include "polygon_distance.h"
#include "test_scale.h"

extern "C" const bmr_kds_info *test_own_structure(void); // kit/own_structure.c

namespace {

constexpr size_t kMotions = 250;
/// Looks at each run, at random times.
constexpr int kLooks = 12;
constexpr double kMargin = 1e-5;
/// What both sides may be wrong by: event times (1e-12) times speeds, and the rounding of double.
constexpr long double kSlop = 1e-9L;

using distance::Point;
using distance::Points;
using distance::SignedDistance;
using distance::Transformed;

/// Where a motion of B passes: by, near, into or through A, which stays around the origin.
bmr_motion *RandomMotion(test_random *random, bool rotates, bool isB) {
    const auto in = [random](double low, double high) { return test_random_uniform(random, low, high); };
    bmr_motion *motion = nullptr;
    const auto pose = [&](double reach, double angle) {
        return bmr_pose{bmr_vec2_make(in(-reach, reach), in(-reach, reach)), std::cos(angle),
                        std::sin(angle)};
    };
    const double reach = isB ? 5.0 : 0.5;
    const uint32_t kind = test_random_below(random, 4);
    if (kind == 0) { // one screw
        const bmr_motion_piece piece =
            bmr_piece_screw(0.0, pose(reach, in(-3.0, 3.0)), bmr_vec2_make(in(-7.0, 7.0), in(-7.0, 7.0)),
                            rotates ? in(-12.0, 12.0) : 0.0);
        REQUIRE(bmr_motion_create(&piece, nullptr, &motion) == BMR_OK);
    } else if (kind == 1) { // algebraic
        bmr_motion_piece piece = {};
        piece.kind = BMR_PIECE_ALGEBRAIC;
        piece.origin = 0.5;
        bmr_algebraic_piece &algebraic = piece.as.algebraic;
        algebraic.degree = 1 + test_random_below(random, 4);
        for (size_t i = 0; i <= algebraic.degree; ++i) {
            algebraic.x[i] = in(-reach, reach);
            algebraic.y[i] = in(-reach, reach);
        }
        algebraic.a[0] = 1.0;
        if (rotates) {
            algebraic.rotation_degree = 1 + test_random_below(random, 2);
            for (size_t i = 0; i <= algebraic.rotation_degree; ++i) {
                algebraic.a[i] = in(-2.0, 2.0);
                algebraic.b[i] = in(-2.0, 2.0);
            }
        }
        const double angle = in(-3.0, 3.0);
        algebraic.start_c = std::cos(angle);
        algebraic.start_s = std::sin(angle);
        REQUIRE(bmr_motion_create(&piece, nullptr, &motion) == BMR_OK);
    } else if (kind == 2) { // samples: a walk
        std::vector<double> times;
        std::vector<bmr_pose> poses;
        const double angle = in(-3.0, 3.0);
        for (int i = 0; i <= 8; ++i) {
            times.push_back(i / 8.0);
            poses.push_back(pose(reach, rotates ? in(-3.0, 3.0) : angle));
        }
        REQUIRE(bmr_motion_create_sampled(times.data(), poses.data(), times.size(), nullptr, &motion) ==
                BMR_OK);
    } else { // two plans, the second of which goes on from where the first was
        const double spin = rotates ? in(-6.0, 6.0) : 0.0, change = in(0.2, 0.8);
        const bmr_motion_piece first = bmr_piece_screw(0.0, pose(reach, in(-3.0, 3.0)),
                                                       bmr_vec2_make(in(-7.0, 7.0), in(-7.0, 7.0)), spin);
        REQUIRE(bmr_motion_create(&first, nullptr, &motion) == BMR_OK);
        const bmr_pose at = bmr_motion_pose(motion, change, nullptr, nullptr);
        const bmr_motion_piece second = bmr_piece_screw(
            change, at, bmr_vec2_make(in(-7.0, 7.0), in(-7.0, 7.0)), rotates ? in(-6.0, 6.0) : 0.0);
        REQUIRE(bmr_motion_change(motion, change, &second) == BMR_OK);
    }
    return motion;
}

struct Tally {
    size_t motions = 0, looks = 0, apart = 0, contacts = 0;
    size_t falseClaims = 0, missedContacts = 0, falseContacts = 0, errors = 0;
};

/// What a look finds. `said` is the structure's word.
void Judge(long double gap, bool saysContact, Tally &tally) {
    ++tally.looks;
    tally.apart += saysContact ? 0 : 1;
    tally.contacts += saysContact ? 1 : 0;
    if (!saysContact && gap < kMargin - kSlop)
        ++(gap <= 0.0L ? tally.missedContacts : tally.falseClaims);
    if (saysContact && gap > kMargin + kSlop)
        ++tally.falseContacts;
}

void RunOne(const bmr_kds_info &info, uint64_t seed, Tally &tally) {
    test_random random = {seed};
    const auto any = [&random]() {
        return test_polygon(static_cast<test_family>(test_random_below(&random, TEST_FAMILY_COUNT)),
                            3 + test_random_below(&random, 30), &random);
    };
    test_kds_body a = test_kds_body_make(any());
    test_kds_body b =
        info.domain == BMR_KDS_POINT ? test_kds_point_make(0.1, -0.2) : test_kds_body_make(any());
    const bool rotates = info.domain != BMR_KDS_TRANSLATION;
    bmr_motion *motions[2] = {RandomMotion(&random, rotates, false), RandomMotion(&random, rotates, true)};
    const bmr_shape shapes[2] = {a.shape, b.shape};
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = &info;
    def.kds.margin = kMargin;
    def.contact_step = 0.01;
    bmr_simulation *simulation = nullptr;
    bmr_error error =
        bmr_simulation_create(&def, shapes, motions, 2, 0.0, nullptr, nullptr, nullptr, &simulation);
    double time = 0.0;
    for (int look = 0; look < kLooks && error == BMR_OK; ++look) {
        time += test_random_uniform(&random, 0.0, 2.0 / kLooks);
        error = bmr_simulation_run(simulation, time);
        const bmr_pose poseA = bmr_motion_pose(motions[0], time, nullptr, nullptr),
                       poseB = bmr_motion_pose(motions[1], time, nullptr, nullptr);
        size_t first, second;
        const bmr_kds *kds = bmr_simulation_pair(simulation, 0, &first, &second);
        if (error == BMR_OK)
            Judge(SignedDistance(Transformed(a.polygon, poseA), Transformed(b.polygon, poseB)),
                  bmr_kds_in_contact(kds), tally);
    }
    if (error != BMR_OK) {
        ++tally.errors;
        MESSAGE(std::string(info.name)
                << ", seed " << seed << ": " << std::string(bmr_error_describe(error)));
    }
    ++tally.motions;
    bmr_simulation_destroy(simulation);
    for (bmr_motion *motion : motions)
        bmr_motion_destroy(motion);
    test_kds_body_destroy(&a);
    test_kds_body_destroy(&b);
}

} // namespace

TEST_CASE("no structure claims a false separation or misses a contact on random motions") {
    for (size_t i = 0; i <= bmr_kds_count(); ++i) {
        const bmr_kds_info &info = i < bmr_kds_count() ? *bmr_kds_at(i) : *test_own_structure();
        Tally tally;
        for (size_t motion = 0; motion < test_scaled(kMotions); ++motion) {
            const Tally before = tally;
            RunOne(info, 1000003u * (i + 1) + motion, tally);
            if (tally.falseClaims + tally.missedContacts + tally.falseContacts >
                before.falseClaims + before.missedContacts + before.falseContacts)
                MESSAGE(std::string(info.name) << ", seed " << 1000003u * (i + 1) + motion);
        }
        const std::string name = info.name;
        CAPTURE(name);
        MESSAGE(name << ": " << tally.motions << " motions, " << tally.looks << " looks, " << tally.apart
                     << " apart, " << tally.contacts << " in contact");
        CHECK(tally.falseClaims == 0);
        CHECK(tally.missedContacts == 0);
        CHECK(tally.falseContacts == 0);
        CHECK(tally.errors == 0);
        // A test in which nothing ever happens shows nothing.
        if (tally.motions >= kMotions) {
            CHECK(tally.apart > tally.looks / 10);
            CHECK(tally.contacts > tally.looks / 200);
        }
    }
}

TEST_CASE("control: the reference finds what is wrong") {
    const Points square = {{-1.0L, -1.0L}, {1.0L, -1.0L}, {1.0L, 1.0L}, {-1.0L, 1.0L}};
    const auto moved = [&square](long double x, long double y) {
        Points points = square;
        for (Point &point : points) {
            point.x += x;
            point.y += y;
        }
        return points;
    };
    CHECK(std::fabs(static_cast<double>(SignedDistance(square, moved(5.0L, 6.0L))) - 5.0) < 1e-15);
    CHECK(std::fabs(static_cast<double>(SignedDistance(square, moved(1.5L, 0.25L))) + 0.5) < 1e-15);
    CHECK(std::fabs(static_cast<double>(SignedDistance(square, {{3.0L, 0.0L}})) - 2.0) < 1e-15);
    Tally tally;
    Judge(0.5L * kMargin, false, tally); // a false claim
    Judge(-0.1L, false, tally);          // a missed contact
    Judge(2.0L * kMargin, true, tally);  // a false contact
    Judge(2.0L * kMargin, false, tally); // right
    Judge(-0.1L, true, tally);           // right
    CHECK(tally.falseClaims == 1);
    CHECK(tally.missedContacts == 1);
    CHECK(tally.falseContacts == 1);
}
