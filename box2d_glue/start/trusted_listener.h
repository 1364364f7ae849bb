// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_TRUSTED_LISTENER_H
#define BOOMERANG_GLUE_TRUSTED_LISTENER_H

#include "boomerang/box2d_glue.h"

class b2ContactListener;

namespace bmr {

namespace internal {

/// bmr::ContactRecorder calls this for each recorder that begins (`change` 1) or ends (-1), with the table of
/// virtual functions of its class. Another class may come to lie in the place of that table when the library
/// that it is in was unloaded: so it is known for as long as a recorder lives. Of two tables, where a program
/// has the class twice, the first is known alone. On any thread.
BMR_BOX2D_API void TrustListener(const void *table, int change);

} // namespace internal

/// Is it a bmr::ContactRecorder? It is called while contacts are updated, reads them, their fixtures and
/// bodies, and changes nothing.
bool IsRecorder(const b2ContactListener &listener);

} // namespace bmr

#endif
