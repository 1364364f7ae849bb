// SPDX-License-Identifier: MIT
#include "gsl_guard.h"

#include <pthread.h>

#include <gsl/gsl_errno.h>

// The library's only mutable globals, because GSL's handler is one: without the count, two calls at once
// could end with the handler off for ever, or on while one of them still runs.
static pthread_mutex_t guard_lock = PTHREAD_MUTEX_INITIALIZER;
static unsigned guard_inside = 0;
static gsl_error_handler_t *guard_outer = NULL;

void bmr_gsl_guard_enter(void) {
    pthread_mutex_lock(&guard_lock);
    if (guard_inside++ == 0)
        guard_outer = gsl_set_error_handler_off();
    pthread_mutex_unlock(&guard_lock);
}

void bmr_gsl_guard_leave(void) {
    pthread_mutex_lock(&guard_lock);
    if (--guard_inside == 0)
        gsl_set_error_handler(guard_outer);
    pthread_mutex_unlock(&guard_lock);
}
