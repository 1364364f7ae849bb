// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_KINETIC_H
#define BOOMERANG_KINETIC_H

/// @file
/// All of boomerang::kinetic, in the order in which it is best read. It needs boomerang::core, and links the
/// GNU Scientific Library: a program that is distributed with it inside is under the GPL-3. Nothing in
/// boomerang::core needs it.
///
/// Threads: GSL has one error handler for the whole process, and its default aborts. A call that needs the
/// solver switches the handler off, and the last such call to end puts it back. Such calls may run on any
/// number of threads at once. Other code is not protected: a GSL error on another thread in that time goes
/// unreported, and a handler that another thread installs in that time is replaced by the one before it. A
/// program that calls gsl_set_error_handler_off() at its start has neither problem.
#include "boomerang/boomerang.h"

// Rigid motions as functions of time.
#include "boomerang/motion.h"

// When do two moving polygons first touch?
#include "boomerang/time_of_contact.h"

// When does a condition first fail? The events of two bodies, in order.
#include "boomerang/failure.h"
#include "boomerang/simulation.h"

// Thousands of bodies, and answers to their contacts.
#include "boomerang/world.h"

// Experiments: families of motions, and the fewest events that any method needs on them.
#include "boomerang/analysis.h"
#include "boomerang/families.h"

#endif
