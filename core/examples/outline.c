// SPDX-License-Identifier: MIT
// A polygon with a hole, as an editor saves it, becomes convex pieces; one that crosses itself becomes an
// error that says where. Links boomerang::core alone.
//
//   example_outline FILE   cuts the outline in the file: a point `x y` (or `x,y`) a line, an empty line
//                          between rings, first the outer one, then the holes; # begins a remark. The
//                          pieces are printed in the same form, which gnuplot draws, too.
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "boomerang/boomerang.h"

enum { most_points = 65535 };
static bmr_vec2 file_points[most_points];
static uint32_t file_counts[most_points];
static unsigned file_lines[most_points];

// Fills the arrays; returns the number of rings, and 0 where the file is none of an outline.
static uint32_t read_outline(const char *path, FILE *file) {
    char text[256];
    uint32_t count = 0, rings = 0;
    bool in_ring = false;
    for (unsigned line = 1; fgets(text, sizeof text, file) != NULL; ++line) {
        char *remark = strchr(text, '#');
        if (remark != NULL)
            *remark = '\0';
        bmr_vec2 point;
        char rest;
        const int read = sscanf(text, "%lf%*[ \t,]%lf %c", &point.x, &point.y, &rest);
        if (read == EOF) { // nothing but a remark ends no ring
            in_ring = in_ring && remark != NULL;
            continue;
        }
        if (read != 2 || count == most_points) {
            fprintf(stderr,
                    read != 2 ? "%s:%u: not a point, which is two numbers\n" : "%s:%u: too many points\n",
                    path, line);
            return 0;
        }
        if (!in_ring)
            file_counts[rings++] = 0;
        in_ring = true;
        ++file_counts[rings - 1];
        file_lines[count] = line;
        file_points[count++] = point;
    }
    if (rings == 0)
        fprintf(stderr, "%s has no points (a point `x y` a line)\n", path);
    return rings;
}

static int cut_file(const char *path) {
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        perror(path);
        return 2;
    }
    const bmr_rings rings = {file_points, file_counts, read_outline(path, file)};
    fclose(file);
    if (rings.ring_count == 0)
        return 2;
    bmr_outline_pieces *pieces;
    bmr_outline_fault fault;
    const bmr_error error = bmr_outline_decompose(&rings, NULL, NULL, &pieces, &fault);
    if (error != BMR_OK) {
        fprintf(stderr, "%s: %s", path, bmr_error_describe(error));
        for (int i = 0; i < 2 && fault.error != BMR_OK; ++i)
            if (fault.edge[i] != BMR_OUTLINE_NONE)
                fprintf(stderr, "; the edge from line %u", file_lines[fault.edge[i]]);
        fprintf(stderr, fault.error != BMR_OK ? "; near %g %g\n" : "\n", fault.where.x, fault.where.y);
        return 2;
    }
    printf("# %u rings, %u notches: %u convex pieces\n", rings.ring_count, pieces->notch_count,
           pieces->piece_count);
    for (uint32_t p = 0; p < pieces->piece_count; ++p) {
        for (uint32_t e = pieces->first[p]; e < pieces->first[p + 1]; ++e)
            printf("%.17g %.17g\n", pieces->points[pieces->edges[e].point].x,
                   pieces->points[pieces->edges[e].point].y);
        printf("\n");
    }
    bmr_outline_pieces_destroy(pieces, NULL);
    return 0;
}

int main(int argc, char **argv) {
    if (argc > 1)
        return cut_file(argv[1]);
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
