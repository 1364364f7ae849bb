// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONTACT_REGISTER_H
#define BOOMERANG_GLUE_CONTACT_REGISTER_H

#include "boomerang/error.h"

/// @file
/// Box2D's table of who makes contacts between which types of shapes. There is one for the process, so our
/// entries are made in one place. The earlier entry is called for all contacts that are not ours, and each
/// contact is destroyed by the code that made it.

namespace bmr {

/// Contacts of big ConvexShapes with polygons, circles, edges and chains are ours from here on. To be called
/// before the first such shape is handed out; any number of times, from any thread. (A world that another
/// thread steps meanwhile makes its contacts as before or as after.) BMR_ERROR_UNSUPPORTED where the Box2D
/// of this process is none that the glue knows.
bmr_error RegisterConvexContacts();

/// Contacts of two polygons are ours from here on (PolygonContact). Once for a process, by Install, which
/// knows that Box2D is one that the glue knows.
void RegisterPolygonContacts();

/// The same of contacts of edges and chains with polygons (EdgeContact), where Box2DCollidesEdgesAsExact32.
void RegisterEdgeContacts();

/// Why the Box2D of this process must be left alone (recognise.h), found out once for the process, on the
/// first call from any thread.
const char *WhyThisBox2DIsUnknown();

} // namespace bmr

#endif
