// SPDX-License-Identifier: MIT
// Every kinetic structure along fuzzed motions of fuzzed polygons, flight plans changed on the way: at every
// event and between them it says apart only where the polygons are, and contact only where they are as near
// as the margin. Some polygons are aligned, and move by whole numbers: conditions fail at the same time, or
// are zero for ever.
#include <cmath>
#include <cstring>

#include "boomerang/simulation.h"
#include "exact_distance.h"
#include "harness.h"
#include "kds_driver.h"
#include "motions.h"
#include "paths.h"
#include "points.h"

namespace {

constexpr size_t kMost = 24;
constexpr double kEnd = 2.0;
/// What both sides may be wrong by: event times (1e-12) times speeds, and the rounding of double, extents
/// being some units.
constexpr long double kSlop = 1e-9L;
/// By how much the distance may be larger than what is asked for: parts of the extents and of itself (kds.h).
constexpr long double kOfExtents = 1e-9L, kOfReach = 2e-8L;

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
    double last;  ///< event
    bool touched; ///< since the last check
};

bmr_pose PoseAt(const World &world, double time) {
    const bmr_pose a = bmr_motion_pose(world.motions[0], time, nullptr, nullptr),
                   b = bmr_motion_pose(world.motions[1], time, nullptr, nullptr);
    return bmr_pose_relative(&a, &b);
}

long double GapAt(const World &world, const bmr_pose &b_in_a) {
    return exact::SignedDistance(exact::PosedOf(world.bodies[0].polygon),
                                 exact::PosedOf(world.bodies[1].polygon, b_in_a));
}

void Check(const World &world, const bmr_kds *kds, double time, const bmr_pose &relative) {
    const long double gap = GapAt(world, relative);
    bool contact = bmr_kds_in_contact(kds);
    if (fuzz_control("missed-contact"))
        contact = false;
    if (fuzz_control("false-contact"))
        contact = true;
    FUZZ_CHECK(contact || gap >= world.def.margin - kSlop,
               "%s: apart at %.17g, but the distance is %.20Lg, margin %.17g", world.info->name, time, gap,
               world.def.margin);
    const long double reach = world.def.margin + world.def.hysteresis;
    const long double extents = world.bodies[0].polygon->extent + world.bodies[1].polygon->extent;
    FUZZ_CHECK(!contact || gap <= reach + kOfReach * reach + kOfExtents * extents + kSlop,
               "%s: contact at %.17g, but the distance is %.20Lg, margin %.17g", world.info->name, time, gap,
               world.def.margin);
    bmr_error audit = bmr_kds_audit(kds, &relative);
    if (fuzz_control("audit"))
        audit = BMR_ERROR_FALSE_CERTIFICATE;
    FUZZ_CHECK(audit == BMR_OK, "%s: audit at %.17g: %s", world.info->name, time, bmr_error_describe(audit));
}

void Observe(void *context, const bmr_simulation_event *event) {
    World *const world = static_cast<World *>(context);
    FUZZ_CHECK(event->time >= (fuzz_control("order") ? world->last + 1e-9 : world->last),
               "%s: an event at %.17g after one at %.17g", world->info->name, event->time, world->last);
    world->last = event->time;
    world->touched = world->touched || bmr_kds_in_contact(event->kds);
    Check(*world, event->kds, event->time, event->pose);
}

/// Where the pair was said to be apart since the check before.
void CheckBetween(const World &world, double from, double to) {
    for (int i = 1; i < 16; ++i) {
        const double time = from + (to - from) * i / 16.0;
        const long double gap = GapAt(world, PoseAt(world, time));
        FUZZ_CHECK(gap >= world.def.margin - kSlop, "%s: passed by at %.17g, %.20Lg apart, margin %.17g",
                   world.info->name, time, gap, world.def.margin);
    }
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
    const bmr_error error = bmr_simulation_replan(world->simulation);
    FUZZ_CHECK(error == BMR_OK, "%s: replan at %.17g: %s", world->info->name, time,
               bmr_error_describe(error));
}

void Run(World *world, fuzz_bytes *bytes) {
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = world->info;
    def.kds = world->def;
    def.contact_step = 0.01;
    const bmr_shape shapes[2] = {world->bodies[0].shape, world->bodies[1].shape};
    const bmr_error made =
        bmr_simulation_create(&def, shapes, world->motions, 0.0, Observe, world, nullptr, &world->simulation);
    FUZZ_CHECK(made == BMR_OK, "%s: %s", world->info->name, bmr_error_describe(made));
    const bmr_kds *const kds = bmr_simulation_kds(world->simulation);
    double time = 0.0;
    Check(*world, kds, time, PoseAt(*world, time));
    for (int step = 0; step < 10 && time < kEnd; ++step) {
        const double before = time;
        world->touched = bmr_kds_in_contact(kds);
        time = std::fmin(kEnd, time + (fuzz_done(bytes) ? 0.35 : fuzz_in(bytes, 0.0, 0.5)));
        bmr_error error = bmr_simulation_run(world->simulation, time);
        if (fuzz_control("error"))
            error = BMR_ERROR_NOT_FINITE;
        FUZZ_CHECK(error == BMR_OK, "%s: run to %.17g: %s", world->info->name, time,
                   bmr_error_describe(error));
        Check(*world, kds, time, PoseAt(*world, time));
        if (!world->touched || fuzz_control("passed-by"))
            CheckBetween(*world, before, time);
        if (!fuzz_done(bytes) && fuzz_u8(bytes) % 4 == 0)
            Replan(world, time, bytes);
    }
    bmr_simulation_destroy(world->simulation);
}

/// Boxes and octagons on a grid at quarter turns, with whole velocities and spins: parallel edges, and
/// corners that meet corners.
bmr_motion *ReadAligned(fuzz_bytes *bytes, const bmr_kds_info *info, test_kds_body *body) {
    static const test_family families[] = {TEST_BOX, TEST_OCTAGON, TEST_TURNED_BOX};
    static const double cosines[] = {1.0, 0.0, -1.0, 0.0};
    const uint32_t what = fuzz_u8(bytes), quarter = what / 4 % 4;
    test_random random = {fuzz_u8(bytes)};
    *body = test_kds_body_make(test_polygon(families[what % 3], 8, &random));
    const double x = fuzz_below(bytes, 9) - 4.0, y = fuzz_below(bytes, 9) - 4.0;
    const double vx = fuzz_below(bytes, 5) - 2.0, vy = fuzz_below(bytes, 5) - 2.0;
    const double spin = info->domain == BMR_KDS_RIGID ? fuzz_below(bytes, 3) - 1.0 : 0.0;
    const bmr_pose pose = {{x, y}, cosines[quarter], cosines[(quarter + 3) % 4]};
    const bmr_motion_piece piece = bmr_piece_screw(0.0, pose, {vx, vy}, spin);
    bmr_motion *motion = nullptr;
    return bmr_motion_create(&piece, nullptr, &motion) == BMR_OK ? motion : nullptr;
}

void RunAligned(World *world, fuzz_bytes *bytes) {
    for (int i = 0; i < 2; ++i) {
        world->ranges[i] = {6.0, 8.0, 0.0, 0.0, kEnd, false, false};
        world->motions[i] = ReadAligned(bytes, world->info, &world->bodies[i]);
    }
    if (world->motions[0] != nullptr && world->motions[1] != nullptr)
        Run(world, bytes);
    for (int i = 0; i < 2; ++i) {
        bmr_motion_destroy(world->motions[i]);
        test_kds_body_destroy(&world->bodies[i]);
    }
}

/// Each byte has a structure: the one whose name and byte have the largest hash. So another row of the table,
/// or one fewer, leaves nearly all inputs theirs.
const bmr_kds_info *StructureOf(uint8_t byte) {
    const bmr_kds_info *chosen = nullptr;
    uint32_t largest = 0;
    for (size_t i = 0; i < bmr_kds_count(); ++i) {
        uint32_t hash = 2166136261u ^ byte; // FNV-1a
        for (const char *c = bmr_kds_at(i)->name; *c != '\0'; ++c)
            hash = (hash ^ static_cast<unsigned char>(*c)) * 16777619u;
        if (chosen == nullptr || hash > largest) {
            largest = hash;
            chosen = bmr_kds_at(i);
        }
    }
    return chosen;
}

/// An input of the corpus that names structures reaches one of those.
void CheckReached(const bmr_kds_info *reached) {
    for (size_t i = 0; i < bmr_kds_count(); ++i)
        if (std::strstr(fuzz_input_name, bmr_kds_at(i)->name) != nullptr)
            FUZZ_CHECK(std::strstr(fuzz_input_name, reached->name) != nullptr,
                       "%s reaches %s: another first byte leads to what it is named after", fuzz_input_name,
                       reached->name);
}

} // namespace

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_bytes bytes = fuzz_bytes_make(data, size);
    World world = {};
    const uint8_t which = fuzz_u8(&bytes);
    world.info = StructureOf(which);
    CheckReached(world.info);
    world.def = ReadDef(&bytes);
    const bool point = world.info->domain == BMR_KDS_POINT;
    if (which >= 192 && !point) {
        RunAligned(&world, &bytes);
        return 0;
    }
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
