// SPDX-License-Identifier: MIT
// Motions, failure times, times of contact.
#include "boomerang/failure.h"
#include "boomerang/time_of_contact.h"
#include "kinetic/first_root.h"
#include "moving_stage.h"

using namespace contracts;

namespace {

std::string CreateAlgebraic(const Given &g) {
    bmr_motion_piece piece = {};
    piece.kind = BMR_PIECE_ALGEBRAIC;
    piece.as.algebraic.degree = g.Count(0);
    piece.as.algebraic.rotation_degree = g.Count(1);
    piece.as.algebraic.x[1] = g[2];
    piece.as.algebraic.a[0] = g[3];
    piece.as.algebraic.start_c = 1.0;
    bmr_motion *made = nullptr;
    const bmr_error error = bmr_motion_create(&piece, nullptr, &made);
    return MadeMotion(g, error, made);
}

std::string CreateSampled(const Given &g) {
    const double times[] = {0, g[1] == 1e-38 ? 1e-38 : g[1], 2, 3, 4};
    bmr_pose poses[5];
    for (int i = 0; i < 5; ++i)
        poses[i] = {{i == 1 ? g[2] : i * i, 0.0}, 0.8, 0.6};
    if (g[1] == 1e-38)
        poses[1].position.x = 1e308;
    bmr_motion *made = nullptr;
    const bmr_error error = bmr_motion_create_sampled(times, poses, g.Count(0), g.allocator, &made);
    return MadeMotion(g, error, made);
}

/// A motion that is not changed is as it was, and can be changed once there is memory.
std::string Change(const Given &g) {
    const Given freely = {{}, g.allocator, g.bits};
    const bmr_motion_piece piece = bmr_piece_screw(0.0, kSlanted, {-1.0, 0.1}, 0.3);
    bmr_motion *made = nullptr;
    bmr_error error = bmr_motion_create(&piece, g.allocator, &made);
    for (int i = 0; i < (g.allocator != nullptr ? 20 : 1) && error == BMR_OK; ++i) {
        const bmr_motion_piece change = bmr_piece_screw(i, kSlanted, {1.0 * i, 1.0}, 0.0);
        const double time = g.allocator != nullptr ? i : g[1];
        uint64_t before = TEST_HASH_START, after = TEST_HASH_START;
        HashMotion({{}, nullptr, &before}, made);
        error = bmr_motion_change(made, time, g.values.empty() ? &change : g.Or(0, &change));
        if (error == BMR_OK)
            continue;
        HashMotion({{}, nullptr, &after}, made);
        if (after != before || bmr_motion_change(made, i, &change) != BMR_OK)
            error = BMR_ERROR_COUNT;
    }
    if (error == BMR_OK)
        return MadeMotion(freely, error, made);
    bmr_motion_destroy(made);
    return Said(error);
}

const Table kMotions("boomerang/motion.h", [] {
    Makes(
        "bmr_motion_create",
        {{"piece", kNotNull},
         {"result", kNotNull},
         {"x", kFinite},
         {"velocity", kFinite},
         {"spin", kFinite},
         {"origin", kFinite},
         {"cosine", kFinite + Says("OUT_OF_RANGE", {2, 0})},
         {"sine", 0, kFinite}},
        [](const Given &g) {
            const bmr_motion_piece piece = bmr_piece_screw(g[5], {{g[2], 0}, g[6], g[7]}, {0.5, g[3]}, g[4]);
            bmr_motion *made = nullptr;
            const bmr_error error = bmr_motion_create(g.Or(0, &piece), g.allocator, g.Or(1, &made));
            return MadeMotion(g, error, made);
        });
    Refuses("bmr_motion_create, algebraic",
            {{"degree", Says("OUT_OF_RANGE", {9, kSizeMax})},
             {"degree of the rotation", 0, Says("OUT_OF_RANGE", {9, kSizeMax})},
             {"coefficient", kFinite},
             {"a, where b is 0", kFinite + Says("OUT_OF_RANGE", {0})}},
            CreateAlgebraic);
    Makes("bmr_motion_create_sampled",
          {{"count", 5, Says("NO_POINTS", {0})},
           {"time", kFinite + Says("OUT_OF_RANGE", {0, -1, 2, {"1e-38, 1e308 away", 1e-38}})},
           {"x", kFinite}},
          CreateSampled);
    Makes("bmr_motion_change", {{"piece", kNotNull}, {"time", 0, kFinite + Says("OK", {1e308})}}, Change);
    Refuses("bmr_motion_destroy", {{"motion", kMayBeNull}}, [](const Given &g) {
        bmr_motion *made = nullptr;
        const bmr_motion_piece piece = bmr_piece_rest(kSlanted);
        if (g[0] != kNull)
            bmr_motion_create(&piece, nullptr, &made);
        bmr_motion_destroy(made);
        return "OK";
    });
    Answers("bmr_motion_pose", "finite",
            {{"time", Says("NaN", {kNaN}) + Says("minus infinity", {kInfinity})}}, [](const Given &g) {
                return Said(bmr_motion_pose(ThePair().comes, g[0], nullptr, nullptr).position.x);
            });
    Answers("bmr_motion_piece_speed", "finite", {{"degree", Says("infinite", {9, kSizeMax})}},
            [](const Given &g) {
                bmr_motion_piece piece = {};
                piece.kind = BMR_PIECE_ALGEBRAIC;
                piece.as.algebraic.degree = g.Count(0);
                piece.as.algebraic.a[0] = 1.0;
                return Said(bmr_motion_piece_speed(&piece, 0.0, 1.0, 1.0));
            });
    Answers("bmr_screw_motion_pose", "finite", {{"time", Says("NaN", {kNaN, kInfinity})}},
            [](const Given &g) {
                const bmr_screw_motion motion = {kSlanted, {1, 0}, 1.0};
                return Said(bmr_screw_motion_pose(&motion, g[0]).c);
            });
});

std::string FirstRoot(const Given &g) {
    std::vector<double> coefficients(50, 0.0);
    coefficients[0] = 1.0;
    coefficients[1] = g[0] == 1e308 ? -1e308 : -g[0];
    if (g[0] == 1e308) {
        coefficients[0] = coefficients[3] = 1e308;
        coefficients[2] = 1e-308;
    }
    const size_t degree = g[0] == 1e308 ? 3 : g.Count(1);
    double root = -77.0;
    const bmr_error error = bmr_polynomial_first_root(g.Or(4, coefficients.data()), degree, g[2],
                                                      g[0] == 1e308 ? 1e9 : g[3], g.Or(5, &root));
    return error != BMR_OK ? Said(error, root != -77.0) : Said(root);
}

std::string FailureTime(const Given &g) {
    bmr_condition condition = bmr_condition_beyond(0, {g[3], 0}, 5.0, {0, 0}, 0);
    if (g[4] == 77.0)
        condition.kind = 77;
    bmr_failure_options options = bmr_default_failure_options();
    options.tolerance = g[2];
    double time = -77.0;
    const bmr_error error =
        bmr_failure_time(&condition, ThePair().rest, ThePair().comes, g[0], g[1], &options, &time);
    return error != BMR_OK ? Said(error, time != -77.0) : std::isinf(time) ? "never" : "a time";
}

std::string TimeOfContact(const Given &g) {
    const MovingPair &pair = ThePair();
    const bmr_shape a = {g.Or(0, pair.polygon), {}, {}}, b = {g.Or(1, pair.polygon), {}, {}};
    double time = -77.0;
    const bmr_error error = bmr_time_of_contact(&a, g.Or(2, pair.rest), &b, g.Or(3, pair.comes), g[5], g[6],
                                                g[7], g.allocator, g.Or(4, &time));
    g.Made(&time, sizeof time);
    return Said(error, time != -77.0);
}

const Table kTimes("boomerang/failure.h", [] {
    Answers("bmr_polynomial_first_root", "finite",
            {{"coefficient", 2, kFinite + Says("infinite", {{"1e308, others 1e-308", 1e308}})},
             {"degree", 1, Says("OUT_OF_RANGE", {49, kSizeMax})},
             {"from", 0, kFinite + Says("OUT_OF_RANGE", {2})},
             {"to", 1, kFinite},
             {"coefficients", kNotNull},
             {"result", kNotNull}},
            FirstRoot);
    Answers("bmr_failure_time", "a time",
            {{"after", 0, kFinite + Says("OUT_OF_RANGE", {101})},
             {"until", 100, kFinite + Says("a time", {1e308})},
             {"tolerance", 1e-12, kAboveZero + Says("NOT_FINITE", {kNaN})},
             {"normal", 1, kFinite},
             {"kind of condition", 1, Says("OUT_OF_RANGE", {{"none", 77}})}},
            FailureTime);
    Makes("bmr_time_of_contact",
          {{"polygon of a", kNotNull},
           {"polygon of b", kNotNull},
           {"motion of a", kNotNull},
           {"motion of b", kNotNull},
           {"result", kNotNull},
           {"from", 0, kFinite + Says("OUT_OF_RANGE", {21})},
           {"until", 20, kFinite},
           {"margin", 1e-6, kNumber + kAboveZero}},
          TimeOfContact);
});

} // namespace
