// SPDX-License-Identifier: MIT
// A pair that is advanced with other shapes than the last time: it may say apart only of the ones it is
// given.
#include "boomerang/pair.h"
#include "cases.h"
#include "hierarchies.h"
#include "kds_driver.h"
#include "motions.h"
#include "polygons.h"

namespace {

bmr_polygon *Hull(const std::vector<bmr_vec2> &points) {
    bmr_polygon *polygon = nullptr;
    REQUIRE(bmr_polygon_create(points.data(), points.size(), nullptr, &polygon) == BMR_OK);
    return polygon;
}

struct Body : test_kds_body {
    explicit Body(const std::vector<bmr_vec2> &points) : test_kds_body(test_kds_body_make(Hull(points))) {}
    Body(const Body &) = delete;
    Body &operator=(const Body &) = delete;
    ~Body() { test_kds_body_destroy(this); }
    /// What the structure names, nothing for the free direction; or one hierarchy in all places.
    bmr_shape Shape(int structure, const bmr_hierarchy *everywhere = nullptr) const {
        bmr_shape named = {polygon, {everywhere, everywhere, everywhere}, {}};
        if (everywhere == nullptr && structure < BMR_FREE_DIRECTION)
            named.hierarchies[structure] = hierarchies[structure];
        return named;
    }
};

std::vector<bmr_vec2> Box(double halfWidth, double halfHeight) {
    std::vector<bmr_vec2> points(4);
    test_box_points(halfWidth, halfHeight, points.data());
    return points;
}

std::vector<bmr_vec2> Regular(int count, double radius, double turn) {
    std::vector<bmr_vec2> points;
    for (int i = 0; i < count; ++i) {
        const double angle = turn + 6.283185307179586 * i / count;
        points.push_back({radius * std::cos(angle), 0.8 * radius * std::sin(angle)});
    }
    return points;
}

bmr_pair NewPair() {
    bmr_pair pair;
    bmr_pair_init(&pair);
    return pair;
}

bmr_pair_def Def(int structure) {
    bmr_pair_def def = bmr_default_pair_def();
    def.structure = static_cast<bmr_structure>(structure);
    return def;
}

/// What is to keep such a pair.
bmr_structure Structure(const bmr_pair_def &def, const bmr_shape &a, const bmr_shape &b) {
    if (def.structure == BMR_TWO_LINES)
        return BMR_TWO_LINES;
    for (const bmr_shape *shape : {&a, &b}) {
        if (static_cast<int>(def.structure) >= BMR_FREE_DIRECTION)
            return BMR_FREE_DIRECTION;
        const bmr_hierarchy *hierarchy = shape->hierarchies[def.structure];
        if (hierarchy == nullptr || bmr_hierarchy_polygon(hierarchy) != shape->polygon ||
            static_cast<int>(bmr_hierarchy_get_kind(hierarchy)) != static_cast<int>(def.structure))
            return BMR_FREE_DIRECTION;
    }
    return def.structure;
}

/// Advances, and looks whether the answer is true, tight and audited. `keeper`: what is to keep the pair.
bmr_answer AdvanceKeptBy(bmr_structure keeper, bmr_pair *pair, const bmr_pair_def &def, const bmr_shape &a,
                         const bmr_shape &b, const bmr_pose &pose, const bmr_observer *observer = nullptr) {
    double gap = -1.0;
    const bool contact = pair->state == BMR_PAIR_CONTACT;
    const bmr_answer answer = bmr_pair_advance(pair, &def, &a, &b, &pose, observer, &gap);
    const double truth = test_distance(a.polygon, b.polygon, &pose);
    const double need = def.margin + (contact ? def.hysteresis : 0.0);
    const double slop = BMR_PAIR_SLOP * (a.polygon->extent + b.polygon->extent) + 1e-6 * need;
    if (answer == BMR_APART) {
        CHECK(gap > def.margin);
        CHECK(gap <= truth * (1.0 + 0x1p-52));
    } else {
        CHECK(gap == 0.0);
        CHECK(truth <= need + slop);
    }
    // A certificate that held is not repaired, and may be another structure's.
    const bool others =
        pair->state == BMR_PAIR_APART && pair->level != BMR_LEVEL_DISKS && pair->structure != keeper;
    CHECK(bmr_pair_audit(pair, &def, &a, &b, &pose) == (others ? BMR_ERROR_INVALID_STRUCTURE : BMR_OK));
    return answer;
}

bmr_answer Advance(bmr_pair *pair, const bmr_pair_def &def, const bmr_shape &a, const bmr_shape &b,
                   const bmr_pose &pose, const bmr_observer *observer = nullptr) {
    return AdvanceKeptBy(Structure(def, a, b), pair, def, a, b, pose, observer);
}

bmr_pose At(double x, double y, double angle) {
    return {{x, y}, std::cos(angle), std::sin(angle)};
}

uint64_t Starts(const bmr_counters &counters) {
    return counters.events[BMR_EVENT_START];
}

} // namespace

namespace {

/// Hands out one place, again and again.
struct OnePlace {
    alignas(64) unsigned char bytes[4096];
    bmr_allocator allocator = {[](void *context, size_t size) -> void * {
                                   return size <= sizeof bytes ? static_cast<OnePlace *>(context)->bytes
                                                               : nullptr;
                               },
                               [](void *context, void *block, size_t) {
                                   // What is freed is gone: reading it later shows.
                                   std::memset(block, 0xff, sizeof static_cast<OnePlace *>(context)->bytes);
                               },
                               this};
};

} // namespace

TEST_CASE("a polygon that was made where another was freed is another, also to kinetic structures") {
    // Its hierarchy is kept: it is one of a polygon that is no more.
    OnePlace place;
    const Body box(Box(0.5, 0.5));
    const std::vector<bmr_vec2> polygons[] = {Regular(60, 0.5, 0.1), Regular(60, 0.5 * (1.0 + 0x1p-48), 0.1),
                                              Regular(60, 4.0, 0.7), Regular(5, 4.0, 0.3)};
    // Apart by a line of the small ones, and of the large ones; by disks; in contact.
    const bmr_pose poses[] = {At(0.1, 1.0, 0.2), At(0.2, 3.9, 0.1), At(9.0, 0.0, 0.4), At(0.2, 0.2, 0.0)};
    size_t lines = 0;
    for (int structure = 0; structure < BMR_STRUCTURE_COUNT; ++structure)
        for (const std::vector<bmr_vec2> &before : polygons)
            for (const std::vector<bmr_vec2> &after : polygons)
                for (const bmr_pose &pose : poses) {
                    CAPTURE(structure);
                    CAPTURE(&before - polygons);
                    CAPTURE(&after - polygons);
                    const bmr_pair_def def = Def(structure);
                    bmr_polygon *made = nullptr;
                    REQUIRE(bmr_polygon_create_raw(before.data(), before.size(), &place.allocator, &made) ==
                            BMR_OK);
                    bmr_shape kept = {made, {}, {}};
                    bmr_hierarchy *hierarchy = nullptr;
                    if (structure < BMR_FREE_DIRECTION)
                        kept.hierarchies[structure] = hierarchy =
                            test_hierarchy(static_cast<bmr_hierarchy_kind>(structure), made);
                    bmr_pair pair = NewPair();
                    Advance(&pair, def, kept, box.Shape(structure), pose);
                    bmr_polygon_destroy(made, &place.allocator);
                    bmr_polygon *again = nullptr;
                    REQUIRE(bmr_polygon_create_raw(after.data(), after.size(), &place.allocator, &again) ==
                            BMR_OK);
                    REQUIRE(again == made); // the same address
                    if (hierarchy !=
                        nullptr) { // it is refused, also where its lines are this one's to rounding
                        const bool same = &before == &after;
                        CHECK(bmr_hierarchy_audit(hierarchy) ==
                              (same ? BMR_OK : BMR_ERROR_INVALID_STRUCTURE));
                        const bmr_shape of_box = box.Shape(structure);
                        const bmr_kds_def of_kds = bmr_default_kds_def();
                        for (const bmr_shape *first : {&std::as_const(kept), &of_box}) {
                            bmr_kds *kds = nullptr;
                            CHECK(bmr_kds_create(
                                      test_structure(structure == 0 ? "lazy-compass" : "lazy-dudley"),
                                      &of_kds, first, first == &of_box ? &kept : &of_box, nullptr,
                                      &kds) == (same ? BMR_OK : BMR_ERROR_WRONG_HIERARCHY));
                            bmr_kds_destroy(kds, nullptr);
                        }
                    }
                    // Made of the same vertices it is the same polygon, and the hierarchy is its own.
                    const bool own = &before == &after || structure == BMR_TWO_LINES;
                    const bmr_structure keeper = own ? def.structure : BMR_FREE_DIRECTION;
                    bmr_pair fresh = NewPair(); // knows neither of them
                    for (bmr_pair *of : {&pair, &fresh})
                        for (const bmr_pose &next : poses) {
                            AdvanceKeptBy(keeper, of, def, kept, box.Shape(structure), next);
                            lines += of->state == BMR_PAIR_APART && of->level != BMR_LEVEL_DISKS;
                        }
                    bmr_hierarchy_destroy(hierarchy, nullptr);
                    bmr_polygon_destroy(again, &place.allocator);
                }
    CHECK(lines > 100);
}

TEST_CASE("a copy of a polygon is the same polygon: nothing starts anew") {
    const Body one(Regular(20, 1.0, 0.2)), other(Box(0.5, 0.5));
    bmr_polygon *copy = nullptr;
    REQUIRE(bmr_polygon_create_raw(one.polygon->vertices, one.polygon->count, nullptr, &copy) == BMR_OK);
    CHECK(copy->stamp == one.polygon->stamp);
    const bmr_pair_def def = Def(BMR_FREE_DIRECTION);
    bmr_pair pair = NewPair();
    bmr_counters counters = {};
    const bmr_observer observer = {&counters, nullptr, nullptr};
    for (int i = 0; i < 300; ++i) {
        const bmr_polygon *const which[] = {one.polygon, copy};
        const bmr_pose pose = At(1.9 * std::cos(0.02 * i), 1.9 * std::sin(0.02 * i), 0.05 * i);
        Advance(&pair, def, {which[i % 2], {}, {}}, {other.polygon, {}, {}}, pose, &observer);
    }
    CHECK(Starts(counters) == 1);
    CHECK(counters.checks == 300);
    bmr_polygon_destroy(copy, nullptr);
}

TEST_CASE("polygons of other vertices have another stamp, and one that was written to is found") {
    const Body box(Box(0.5, 0.5));
    std::vector<uint32_t> stamps;
    const double wholes[] = {-1.0, 1.0, 2.0, 0.5};
    for (const double x : wholes) // signs and exponents alone differ
        for (const double y : wholes) {
            bmr_vec2 points[] = {{x, y}, {16.0 * x + 64.0, y}, {x + 64.0, y + 64.0}};
            bmr_polygon *polygon = nullptr;
            REQUIRE(bmr_polygon_create(points, 3, nullptr, &polygon) == BMR_OK);
            for (const uint32_t stamp : stamps)
                CHECK(stamp != polygon->stamp);
            stamps.push_back(polygon->stamp);
            bmr_polygon_destroy(polygon, nullptr);
        }
    bmr_polygon *written = nullptr;
    REQUIRE(bmr_polygon_create_raw(box.polygon->vertices, box.polygon->count, nullptr, &written) == BMR_OK);
    CHECK(bmr_polygon_audit(written) == BMR_OK);
    written->stamp ^= 1u; // within every other promise
    CHECK(bmr_polygon_audit(written) == BMR_ERROR_INVALID_STRUCTURE);
    written->stamp ^= 1u;
    const_cast<bmr_vec2 *>(written->vertices)[1].x += 1e-12;
    CHECK(bmr_polygon_audit(written) == BMR_ERROR_INVALID_STRUCTURE);
    bmr_polygon_destroy(written, nullptr);
}

namespace {

/// Polygons of 1 to 200 vertices, from small to large.
std::vector<std::unique_ptr<Body>> Bodies(test_random *random) {
    std::vector<std::unique_ptr<Body>> bodies;
    for (const int count : {1, 2, 3, 4, 7, 30, 100})
        for (const double radius : {0.2, 1.0, 3.0})
            bodies.push_back(
                std::make_unique<Body>(Regular(count, radius, test_random_uniform(random, 0.0, 6.0))));
    return bodies;
}

bmr_pose AnyPose(test_random *random, double reach) {
    const double angle = test_random_uniform(random, 0.0, 6.3);
    const double r = reach * test_random_uniform(random, 0.2, 1.6);
    return At(r * std::cos(angle), r * std::sin(angle), test_random_uniform(random, -4.0, 4.0));
}

} // namespace

TEST_CASE("whatever a pair is advanced with next, what it says is true") {
    test_random random = test_random_from(1234);
    const std::vector<std::unique_ptr<Body>> bodies = Bodies(&random);
    const auto any = [&]() -> const Body & {
        return *bodies[test_random_below(&random, static_cast<uint32_t>(bodies.size()))];
    };
    const size_t rounds = test_scaled(20000);
    size_t apart = 0, contact = 0;
    bmr_pair pair = NewPair(), kept = pair;
    const Body *a = &any(), *b = &any();
    bmr_pair_def def = Def(0);
    int hierarchies[2] = {0, 0};
    const bmr_hierarchy *everywhere[2] = {nullptr, nullptr}; // in every place, whosever it is
    bmr_pose pose = At(3.0, 0.0, 0.0);
    for (size_t i = 0; i < rounds; ++i) {
        CAPTURE(i);
        switch (test_random_below(&random, 10)) {
        case 0:
            a = &any();
            break;
        case 1:
            b = &any();
            break;
        case 2:
            std::swap(a, b);
            break;
        case 3:
            def.structure =
                static_cast<bmr_structure>(test_random_below(&random, BMR_STRUCTURE_COUNT + 1)); // or none
            hierarchies[0] = hierarchies[1] = def.structure;
            everywhere[0] = everywhere[1] = nullptr;
            break;
        case 4:
            hierarchies[i % 2] = static_cast<int>(test_random_below(&random, BMR_STRUCTURE_COUNT));
            everywhere[i % 2] = test_random_below(&random, 2) ? nullptr : any().hierarchies[i % 3];
            break;
        case 5:
            kept = pair;
            break;
        case 6:
            pair = kept; // of other shapes, maybe
            break;
        case 7:
            def.margin = i % 3 == 0 ? 0.0 : 0.02;
            break;
        default: // the same shapes, nearly the same pose
            break;
        }
        if (test_random_below(&random, 3) == 0)
            pose = AnyPose(&random, a->polygon->extent + b->polygon->extent);
        pose.position.x += test_random_uniform(&random, -0.01, 0.01);
        const bool found = Advance(&pair, def, a->Shape(hierarchies[0], everywhere[0]),
                                   b->Shape(hierarchies[1], everywhere[1]), pose) == BMR_APART;
        ++(found ? apart : contact);
    }
    CHECK(apart > rounds / 5);
    CHECK(contact > rounds / 20);
}

TEST_CASE("a pair of any bytes reads nothing but its shapes") {
    // What the stamp would let through once in 2^32 times: here it is right, and all the rest anything.
    test_random random = test_random_from(99);
    const std::vector<std::unique_ptr<Body>> bodies = Bodies(&random);
    size_t answers = 0;
    for (size_t i = 0; i < test_scaled(50000); ++i) {
        const Body &a = *bodies[test_random_below(&random, static_cast<uint32_t>(bodies.size()))];
        const Body &b = *bodies[test_random_below(&random, static_cast<uint32_t>(bodies.size()))];
        const int structure = static_cast<int>(test_random_below(&random, BMR_STRUCTURE_COUNT));
        const bmr_pair_def def = Def(structure);
        const bmr_shape of_a = a.Shape(structure), of_b = b.Shape(structure);
        const bmr_pose pose = AnyPose(&random, a.polygon->extent + b.polygon->extent);
        bmr_pair pair = NewPair();
        bmr_pair_advance(&pair, &def, &of_a, &of_b, &pose, nullptr, nullptr);
        const uint32_t stamp = pair.stamp;
        unsigned char bytes[sizeof pair];
        std::memcpy(bytes, &pair, sizeof pair);
        const uint32_t changes = 1 + test_random_below(&random, 24);
        for (uint32_t k = 0; k < changes; ++k) // the certificate's part as well as the indices
            bytes[test_random_below(&random, 2) == 0 ? test_random_below(&random, sizeof bytes)
                                                     : 44 + test_random_below(&random, 16)] =
                static_cast<unsigned char>(test_random_below(&random, 256));
        std::memcpy(&pair, bytes, sizeof pair);
        pair.stamp = stamp;
        for (int step = 0; step < 3; ++step) {
            const bmr_pose next = AnyPose(&random, a.polygon->extent + b.polygon->extent);
            answers += bmr_pair_advance(&pair, &def, &of_a, &of_b, &next, nullptr, nullptr) == BMR_APART;
            bmr_pair_audit(&pair, &def, &of_a, &of_b, &next);
        }
    }
    CHECK(answers > 0);
}
