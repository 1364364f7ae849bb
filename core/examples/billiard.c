// SPDX-License-Identifier: MIT
// A billiard of polygons: one comes fast, eight rest, four walls are around them. Every collision is elastic,
// at its own time; the first ones are printed, and what is left of the energy at the end. Links
// boomerang::kinetic, and so GSL.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "boomerang/kinetic.h"

enum { BALLS = 9, CORNERS = 6, PRINTED = 8 };
static const double TURN = 6.28318530717958648;

static void require(bmr_error error) {
    if (error == BMR_OK)
        return;
    fprintf(stderr, "%s\n", bmr_error_describe(error));
    exit(1);
}

static void name(bmr_body body) {
    if (bmr_is_wall(body))
        printf("wall %d", (int)(body - BMR_WALL(0)));
    else
        printf("ball %d", (int)body);
}

// What is to be done at a contact: here always the same. The world has it done after this returns.
static bmr_response collide(void *context, bmr_world *world, const bmr_contact *contact) {
    int *const count = context;
    (void)world;
    if (++*count <= PRINTED) {
        printf("%.4f ", contact->time);
        name(contact->a);
        printf(" meets ");
        name(contact->b);
        printf(" at (%.2f, %.2f), approaching by %.2f\n", contact->points[0].x, contact->points[0].y,
               -contact->approach[0]);
    }
    return (bmr_response){BMR_RESPONSE_IMPULSE, 1.0};
}

int main(void) {
    bmr_vec2 corners[CORNERS];
    for (int i = 0; i < CORNERS; ++i)
        corners[i] = bmr_vec2_make(0.5 * cos(TURN * i / CORNERS), 0.5 * sin(TURN * i / CORNERS));
    bmr_polygon *polygon;
    require(bmr_polygon_create(corners, CORNERS, NULL, &polygon));
    const bmr_shape shape = {.polygon = polygon};

    int collisions = 0;
    bmr_world_def def = bmr_default_world_def();
    def.boundary = BMR_WALLED;
    def.low = bmr_vec2_make(0.0, 0.0);
    def.high = bmr_vec2_make(12.0, 6.0);
    def.contact = collide;
    def.context = &collisions;
    bmr_world *world;
    require(bmr_world_create(&def, 0.0, NULL, &world));
    for (int i = 0; i < BALLS; ++i) {
        const int column = (i - 1) / 3, row = (i - 1) % 3;
        const bmr_vec2 place =
            i == 0 ? bmr_vec2_make(2.0, 2.9) : bmr_vec2_make(6.0 + 1.2 * column, 1.8 + 1.2 * row);
        const bmr_motion_piece piece = bmr_piece_screw(0.0, bmr_pose_from_angle(place, 0.1 * i),
                                                       bmr_vec2_make(i == 0 ? 5.0 : 0.0, 0.0), 0.0);
        bmr_motion *motion;
        require(bmr_motion_create(&piece, NULL, &motion));
        const bmr_body_def ball = bmr_default_body_def(&shape, motion); // its mass is its area
        bmr_body number;
        require(bmr_world_add(world, &ball, &number));
        bmr_motion_destroy(motion);
    }
    const double before = bmr_world_get_totals(world).energy;
    require(bmr_world_advance(world, 2.0));
    printf("%d collisions, %.9f of the energy left\n", collisions,
           bmr_world_get_totals(world).energy / before);
    bmr_world_destroy(world);
    bmr_polygon_destroy(polygon, NULL);
    return 0;
}
