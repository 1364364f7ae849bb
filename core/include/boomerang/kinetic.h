// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_KINETIC_H
#define BOOMERANG_KINETIC_H

/// @file
/// All of boomerang::kinetic, in the order in which it is best read. It needs boomerang::core, and links the
/// GNU Scientific Library: a program distributed with it inside is under the GPL-3. Nothing in
/// boomerang::core needs it.
///
/// Threads: GSL has one error handler for the whole process, and its default aborts. Failure times switch it
/// off while a call that needs the solver runs, and the last such call to end puts it back; such calls may
/// run on any number of threads at once. What cannot be protected are others: a GSL error on another thread
/// in that time goes unreported, and a handler installed by another thread in that time is replaced by the
/// one before it. A program that calls gsl_set_error_handler_off() at its start has neither problem.
#include "boomerang/boomerang.h"

// Rigid motions as functions of time.
#include "boomerang/motion.h"

// When do two moving polygons first touch?
#include "boomerang/time_of_contact.h"

// When does a condition fail for the first time, and what happens then to any number of bodies?
#include "boomerang/failure.h"
#include "boomerang/simulation.h"

// Thousands of bodies, whose contacts are answered.
#include "boomerang/world.h"

// Experiments: families of motions, and what any method would need on them.
#include "boomerang/analysis.h"
#include "boomerang/families.h"

#endif
