// SPDX-License-Identifier: MIT
// A polygon with a hole becomes convex pieces; one that crosses itself becomes an error that says where.
// Links boomerang::core alone.
#include <stdio.h>

#include "boomerang/boomerang.h"

int main(void) {
    // A nut: twelve corners outside, every other one a notch, and a hole of four.
    const bmr_vec2 points[16] = {{6, 0},   {4, 2},   {3, 5},    {0, 4},   {-3, 5}, {-4, 2},
                                 {-6, 0},  {-4, -2}, {-3, -5},  {0, -4},  {3, -5}, {4, -2},
                                 {1.5, 0}, {0, 1.5}, {-1.5, 0}, {0, -1.5}};
    const uint32_t counts[2] = {12, 4};
    const bmr_rings rings = {points, counts, 2};
    bmr_outline_pieces *pieces;
    bmr_outline_fault fault;
    bmr_error error = bmr_outline_decompose(&rings, NULL, NULL, &pieces, &fault);
    if (error == BMR_OK) {
        for (uint32_t p = 0; p < pieces->piece_count; ++p) {
            printf("piece %u:", p);
            for (uint32_t e = pieces->first[p]; e < pieces->first[p + 1]; ++e)
                printf(pieces->edges[e].outline != BMR_OUTLINE_NONE ? " %u" : " %u~", pieces->edges[e].point);
            printf("\n");
        }
        bmr_outline_pieces_destroy(pieces, NULL);
    }
    bmr_mass mass;
    if (bmr_outline_mass(&rings, &mass) == BMR_OK)
        printf("area %g, inertia %g\n", mass.area, mass.inertia);

    const bmr_vec2 bow[4] = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
    const uint32_t corners = 4;
    const bmr_rings crossed = {bow, &corners, 1};
    error = bmr_outline_decompose(&crossed, NULL, NULL, &pieces, &fault);
    printf("edges %u and %u, at (%g, %g): %s\n", fault.edge[0], fault.edge[1], fault.where.x, fault.where.y,
           bmr_error_describe(error));
    return 0;
}
