// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_THIS_PROCESS_H
#define BOOMERANG_GLUE_THIS_PROCESS_H

namespace bmr {

/// @file
/// A process that forks: the child has all that its parent had, exit handlers too.

/// The system's number of this process.
long ThisProcess();

/// In the child of every fork from here on.
void CallWhenForked(void (*function)());

/// What is said on stderr about what is at work: true for the first who asks, in this process or the one that
/// it was forked from.
bool ClaimAnnouncement();
bool IsAnnounced();

} // namespace bmr

#endif
