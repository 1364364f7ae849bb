// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GSL_GUARD_H
#define BOOMERANG_GSL_GUARD_H

/// GSL reports some errors through a handler that is global to the process and aborts by default; core never
/// aborts. Between enter and leave the handler is off; errors then come back as codes. Any number of threads
/// may be inside at once: the first switches the handler off, the last puts back what the first found.
void bmr_gsl_guard_enter(void);
void bmr_gsl_guard_leave(void);

#endif
