// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONTACT_LIFE_H
#define BOOMERANG_GLUE_CONTACT_LIFE_H

#include <cstdint>

namespace bmr {

/// @file
/// A contact of two polygons is a kinetic structure of its own: it keeps a certificate from look to look.
/// This is its life in the paper's words. (With Options::pairsBy the structures of two bodies' hulls live in
/// their place, and core tells their events.)
///
/// A contact's structure has two levels.
/// - Level 0 is the polygons themselves. Of two small ones the certificate is an edge of one, with all of the
///   other beyond it. Where one is big, it is a direction, with the vertices that are farthest along it. Of a
///   sensor's contact it is a direction, too.
/// - Level -1 is what is coarser: the disks around two big polygons.
///
/// | event | it is told when |
/// | --- | --- |
/// | start | the first certificate is made |
/// | push | the certificate fails, and another edge or direction separates the two |
/// | stab | what is coarser fails, and an edge or a direction separates the two |
/// | coarsen | the disks are apart, where an edge or a direction was needed before |
/// | contact | nothing separates the two that is looked for: they are handed over to the exact test |
/// | leave | the two were handed over, and are known to be apart now |
///
/// There is no roll. All vertices of the other polygon are tried at a look, or the farthest is searched:
/// there is no window that the direction could leave. For the same reason any other edge is a push, whichever
/// of the two polygons it belongs to.
///
/// No event: a look at which the certificate holds; a budget that is renewed by its line; the end of a
/// contact. Where the two bodies meet again, the new contact starts
/// anew. (What was handed over may leave by the line that its record in the ledger then gets.)
///
/// So its events are (start (push | stab | coarsen)*)? (contact leave (push | stab | coarsen)*)*, cut
/// off anywhere.

/// The certificate that keeps a contact's polygons apart, as its events name it.
enum class Life : uint8_t {
    Unborn, ///< nothing was found yet
    Coarse, ///< level -1
    Apart,  ///< level 0
    Contact ///< nothing: it is handed over
};

/// The result of a look at a contact.
enum class Held : uint8_t {
    Nothing,    ///< not known to be apart
    ByDisks,    ///< the disks around the two polygons are apart
    Remembered, ///< the certificate of the last look holds
    Another     ///< another one was found
};

} // namespace bmr

#endif
