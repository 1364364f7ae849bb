// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_VERIFY_H
#define BOOMERANG_GLUE_VERIFY_H

#include "base/compiler.h"

struct b2Manifold;
struct b2TOIOutput;
class b2Fixture;

/// @file
/// Mode::Verify. If Verifying() (settings.h), code that answers in Box2D's place computes its own answer,
/// asks Box2D too, calls one of these with both, and goes on with Box2D's. Each counts a comparison; the
/// first difference of the process is described in one line on stderr, the others are counted. From any
/// thread. Fixtures name the two in that line; nullptr where the caller does not know them.

namespace bmr {

/// Two manifolds are the same where both have no points, or all fields that have a meaning agree to the bit
/// (zeros of either sign are equal, and so are numbers that are none).
void VerifyManifold(const b2Fixture *fixtureA, const b2Fixture *fixtureB, const b2Manifold &ours,
                    const b2Manifold &box2d);

/// Two times of impact are the same where both touch at the same time, to the bit, or neither touches: of all
/// other states SolveTOI makes no difference.
void VerifyImpact(const b2Fixture *fixtureA, const b2Fixture *fixtureB, const b2TOIOutput &ours,
                  const b2TOIOutput &box2d);

void VerifyOverlap(const b2Fixture *fixtureA, const b2Fixture *fixtureB, bool ours, bool box2d);

/// For everything else: `door` is what was answered ("pair finding"), `format` says what differs, as printf
/// does. Not called where the two agree: CountVerified() alone then.
BMR_FORMAT(4, 5)
void ReportDifference(const char *door, const b2Fixture *fixtureA, const b2Fixture *fixtureB,
                      const char *format, ...);
void CountVerified();

/// When the process ends (by exit, or by returning from main), one line on stderr says how many answers were
/// compared and how many differed, also where none was. Called once, by Install. Of a program that forks,
/// each process that has compared any says how many it did itself.
void SayVerifiedAtExit();

} // namespace bmr

#endif
