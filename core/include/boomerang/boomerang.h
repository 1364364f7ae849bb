// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_BOOMERANG_H
#define BOOMERANG_BOOMERANG_H

/// @file
/// boomerang::core in double precision, in the order in which it is best read: each part needs only those
/// above it. It needs nothing but libm.

// A convex polygon, and where it is: everything begins here.
#include "boomerang/polygon.h"
#include "boomerang/pose.h"

// Its mass.
#include "boomerang/mass.h"

// A polygon that is not convex, with holes: a few convex ones.
#include "boomerang/outline.h"

// How far apart are two of them, or how deep in each other? Asked once, nothing remembered.
#include "boomerang/distance.h"

// Asked step by step: 64 bytes remember a proof that the two are apart and check it at each pose.
#include "boomerang/pair.h"

// Asked of a whole world: how far may two bodies move before their proof has to be checked?
#include "boomerang/budget.h"

// Approximations of a polygon from outside (section 3): with them a proof is coarse if there is room.
#include "boomerang/hierarchy.h"
#include "boomerang/inflated.h"
#include "boomerang/minkowski.h"

// Every structure of the paper, for motions that are known: its conditions and its repairs (sections 4 to 6).
// boomerang/kinetic.h finds the time at which a condition fails.
#include "boomerang/condition.h"
#include "boomerang/kds.h"

#endif
