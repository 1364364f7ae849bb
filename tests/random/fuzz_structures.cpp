// SPDX-License-Identifier: MIT
// Every kinetic structure along fuzzed motions of fuzzed polygons, flight plans changed on the way: it says
// apart only where the polygons are, and contact only where they are as near as the margin.
#include <cmath>

#include "boomerang/simulation.h"
#include "harness.h"
#include "kds_driver.h"
#include "motion_pieces.h"
#include "paths.h"
#include "points.h"
#include "polygon_distance.h"

namespace {

constexpr size_t kMost = 24;
constexpr double kEnd = 2.0;
/// What both sides may be wrong by: event times (1e-12) times speeds, and the rounding of double, extents
/// being some units.
constexpr long double kSlop = 1e-9L;

bmr_kds_def ReadDef(fuzz_bytes *bytes) {
    bmr_kds_def def = bmr_default_kds_def();
    const uint8_t how = fuzz_u8(bytes);
    def.margin = std::pow(10.0, -2.0 - how % 5);
    if (how >= 64)
        def.hysteresis = def.margin * fuzz_below(bytes, 100);
    if (how >= 128) {
        def.alpha = fuzz_in(bytes, 0.05, 1.0);
        def.offset_ratio = fuzz_in(bytes, 0.1, 0.95);
        def.root_level = fuzz_below(bytes, 6);
        def.window_part = fuzz_in(bytes, 0.0, 0.95);
    }
    return def;
}

struct World {
    test_kds_body bodies[2];
    bmr_motion *motions[2];
    bmr_simulation *simulation;
    const bmr_kds_info *info;
    bmr_kds_def def;
    fuzz_motion_range ranges[2];
};

void Look(const World &world, double time) {
    size_t first, second;
    const bmr_kds *kds = bmr_simulation_pair(world.simulation, 0, &first, &second);
    bmr_pose poses[2];
    for (int i = 0; i < 2; ++i)
        poses[i] = bmr_motion_pose(world.motions[i], time, nullptr, nullptr);
    const long double gap =
        distance::SignedDistance(distance::Transformed(world.bodies[0].polygon, poses[0]),
                                 distance::Transformed(world.bodies[1].polygon, poses[1]));
    bool contact = bmr_kds_in_contact(kds);
    if (fuzz_control("missed-contact"))
        contact = false;
    if (fuzz_control("false-contact"))
        contact = true;
    FUZZ_CHECK(contact || gap >= world.def.margin - kSlop,
               "%s: apart at %.17g, but the distance is %Lg, margin %g", world.info->name, time, gap,
               world.def.margin);
    FUZZ_CHECK(!contact || gap <= world.def.margin + world.def.hysteresis + kSlop,
               "%s: contact at %.17g, but the distance is %Lg, margin %g", world.info->name, time, gap,
               world.def.margin);
    const bmr_pose relative = bmr_pose_relative(&poses[0], &poses[1]);
    bmr_error audit = bmr_kds_audit(kds, &relative);
    if (fuzz_control("audit"))
        audit = BMR_ERROR_FALSE_CERTIFICATE;
    FUZZ_CHECK(audit == BMR_OK, "%s: audit at %.17g: error %d", world.info->name, time, audit);
}

/// From now on one of the two moves otherwise.
void Replan(World *world, double time, fuzz_bytes *bytes) {
    const size_t body = fuzz_u8(bytes) % 2;
    bmr_motion_piece piece = fuzz_piece(bytes, &world->ranges[body]);
    const bmr_pose pose = bmr_motion_pose(world->motions[body], time, nullptr, nullptr);
    test_piece_begin(&piece, time, pose);
    fuzz_tame(&piece, &world->ranges[body]);
    if (bmr_motion_change(world->motions[body], time, &piece) != BMR_OK)
        return;
    const bmr_error error = bmr_simulation_replan(world->simulation, body);
    FUZZ_CHECK(error == BMR_OK, "%s: replan at %.17g: error %d", world->info->name, time, error);
}

void Run(World *world, fuzz_bytes *bytes) {
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = world->info;
    def.kds = world->def;
    def.contact_step = 0.01;
    const bmr_shape shapes[2] = {world->bodies[0].shape, world->bodies[1].shape};
    const bmr_error made = bmr_simulation_create(&def, shapes, world->motions, 2, 0.0, nullptr, nullptr,
                                                 nullptr, &world->simulation);
    FUZZ_CHECK(made == BMR_OK, "%s: error %d", world->info->name, made);
    double time = 0.0;
    Look(*world, time);
    for (int look = 0; look < 10 && time < kEnd; ++look) {
        time = std::fmin(kEnd, time + (fuzz_done(bytes) ? 0.35 : fuzz_in(bytes, 0.0, 0.5)));
        bmr_error error = bmr_simulation_run(world->simulation, time);
        if (fuzz_control("error"))
            error = BMR_ERROR_NOT_FINITE;
        FUZZ_CHECK(error == BMR_OK, "%s: run to %.17g: error %d", world->info->name, time, error);
        Look(*world, time);
        if (!fuzz_done(bytes) && fuzz_u8(bytes) % 4 == 0)
            Replan(world, time, bytes);
    }
    bmr_simulation_destroy(world->simulation);
}

} // namespace

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_bytes bytes = fuzz_bytes_make(data, size);
    World world = {};
    world.info = bmr_kds_at(fuzz_u8(&bytes) % bmr_kds_count());
    world.def = ReadDef(&bytes);
    const bool point = world.info->domain == BMR_KDS_POINT;
    bmr_polygon *a = fuzz_polygon_of_size(&bytes, kMost, 3);
    bmr_polygon *b = a == nullptr || point ? nullptr : fuzz_polygon_of_size(&bytes, kMost, 2);
    if (a == nullptr || (b == nullptr && !point)) {
        bmr_polygon_destroy(a, nullptr);
        return 0;
    }
    world.bodies[0] = test_kds_body_make(a);
    if (point) {
        const double x = fuzz_in(&bytes, -1.0, 1.0);
        world.bodies[1] = test_kds_point_make(x, fuzz_in(&bytes, -1.0, 1.0));
    } else {
        world.bodies[1] = test_kds_body_make(b);
    }
    const double spin = world.info->domain == BMR_KDS_TRANSLATION ? 0.0 : 12.0;
    const bool roots = fuzz_control("common-root");
    world.ranges[0] = {0.5, 3.0, spin, 0.0, kEnd, false, roots};
    world.ranges[1] = {6.0, 8.0, spin, 0.0, kEnd, false, roots};
    bool moving = true;
    for (int i = 0; i < 2; ++i) {
        world.motions[i] = fuzz_motion(&bytes, &world.ranges[i]);
        moving = moving && world.motions[i] != nullptr;
    }
    if (moving)
        Run(&world, &bytes);
    for (int i = 0; i < 2; ++i) {
        bmr_motion_destroy(world.motions[i]);
        test_kds_body_destroy(&world.bodies[i]);
    }
    return 0;
}
