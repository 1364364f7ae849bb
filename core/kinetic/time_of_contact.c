// SPDX-License-Identifier: MIT
#include "boomerang/time_of_contact.h"

#include <math.h>

#include "boomerang/simulation.h"

/// The interval is run in so many parts, so that what lies behind the contact is not all computed.
#define PARTS 16

static void note_contact(void *context, const bmr_simulation_event *event) {
    double *time = context;
    if (event->report.kind == BMR_KDS_CONTACT && event->time < *time)
        *time = event->time;
}

static bool have_dudley(const bmr_shape *a, const bmr_shape *b) {
    return a->hierarchies[BMR_HIERARCHY_DUDLEY] && b->hierarchies[BMR_HIERARCHY_DUDLEY];
}

bmr_error bmr_time_of_contact(const bmr_shape *a, const bmr_motion *motion_a, const bmr_shape *b,
                              const bmr_motion *motion_b, double from, double until, double margin,
                              const bmr_allocator *allocator, double *time) {
    if (!a || !motion_a || !b || !motion_b || !time || !a->polygon || !b->polygon)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!isfinite(from) || !isfinite(until))
        return BMR_ERROR_NOT_FINITE;
    if (from > until)
        return BMR_ERROR_OUT_OF_RANGE;
    bmr_simulation_def def = bmr_default_simulation_def();
    bmr_error error = bmr_kds_find(have_dudley(a, b) ? "lazy-dudley" : "hybrid", &def.structure);
    def.kds.margin = margin;
    const bmr_shape shapes[2] = {*a, *b};
    bmr_motion *const motions[2] = {(bmr_motion *)motion_a, (bmr_motion *)motion_b}; // it only reads them
    double contact = INFINITY;
    bmr_simulation *simulation = NULL;
    if (error == BMR_OK)
        error = bmr_simulation_create(&def, shapes, motions, 2, from, note_contact, &contact, allocator,
                                      &simulation);
    for (int part = 1; part <= PARTS && error == BMR_OK && contact == INFINITY; ++part) {
        const double end = part < PARTS ? from + (until - from) * ((double)part / PARTS) : until;
        error = bmr_simulation_run(simulation, fmax(end, bmr_simulation_time(simulation)));
    }
    bmr_simulation_destroy(simulation);
    if (error != BMR_OK && contact == INFINITY)
        return error;
    *time = contact;
    return BMR_OK;
}
