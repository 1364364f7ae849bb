// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CONTRACTS_MOVING_STAGE_H
#define BOOMERANG_TEST_CONTRACTS_MOVING_STAGE_H

#include "boomerang/motion.h"
#include "every_allocation.h"
#include "stage.h"

/// @file
/// Good motions, which the calls of boomerang::kinetic are made with.

namespace contracts {

const bmr_pose kSlanted = {{10, 0}, 0.8, 0.6};

/// Two 12-gons, 10 apart, that come together at a speed of 1.
struct MovingPair {
    bmr_polygon *polygon = Polygon(Ellipse(12));
    bmr_motion *rest = nullptr, *comes = nullptr, *other = nullptr;

    MovingPair() {
        const bmr_motion_piece still = bmr_piece_rest({{0, 0}, 1, 0}), far = bmr_piece_rest({{-10, 0}, 1, 0});
        const bmr_motion_piece moves = bmr_piece_screw(0.0, {{10, 0}, 1, 0}, {-1, 0}, 0.0);
        bmr_motion_create(&still, nullptr, &rest);
        bmr_motion_create(&moves, nullptr, &comes);
        bmr_motion_create(&far, nullptr, &other);
    }
    MovingPair(const MovingPair &) = delete;
    MovingPair &operator=(const MovingPair &) = delete;
    ~MovingPair() {
        for (bmr_motion *motion : {rest, comes, other})
            bmr_motion_destroy(motion);
        bmr_polygon_destroy(polygon, nullptr);
    }
};

inline const MovingPair &ThePair() {
    static const MovingPair pair;
    return pair;
}

inline void HashMotion(const Given &given, const bmr_motion *motion) {
    for (int i = -5; i <= 30; ++i) {
        const bmr_pose pose = bmr_motion_pose(motion, i, nullptr, nullptr);
        given.Made(&pose, sizeof pose);
    }
}

/// What a maker of a motion says, which starts from a result of NULL.
inline std::string MadeMotion(const Given &given, bmr_error error, bmr_motion *made) {
    if (error != BMR_OK)
        return Said(error, made != nullptr);
    HashMotion(given, made);
    bmr_motion_destroy(made);
    return Said(error);
}

} // namespace contracts

#endif
