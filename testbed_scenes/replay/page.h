// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PAGE_H
#define BOOMERANG_TESTBED_PAGE_H

#include <string>

#include "replay.h"

namespace testbed::replay {

/// One self-contained HTML page that plays the replay: style, script and data are in it, it asks no network
/// and needs no server. Its files lie in page/ and are embedded at build time.
///
/// Replay::about, as the page reads it (whatever is missing is left out of the page):
///
///     scene, description, structure, prefilter   words
///     stock                                      what the plugin is held against: stock, or off (the plugin
///     off) timeStep                                   seconds margin what a certificate must prove, in
///     lengths boxes                                      false: those of the broad phase were not recorded
///
/// O(size of the replay).
std::string PageOf(const Replay &replay);

} // namespace testbed::replay

#endif
