// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_BYTES_H
#define BOOMERANG_TESTBED_BYTES_H

#include <string>

#include "recording/recording.h"

/// @file
/// Frames as bytes: for a pipe between two programs of the same build, where text would take most of a
/// recording's time. A file is always text.
///
/// A packed frame is one line too: `packed `, then the frame, without a byte that ends lines. An object is
/// the number of a set, whose bit i says whether its field i (fields.h) follows; a field that has its default
/// value does not. Numbers are as in memory, but that counts of a list's elements and of a text's bytes, sets
/// and whole numbers take seven bits to a byte, lowest first, the high bit set in all but the last (whole
/// numbers zigzag-coded before). At last each byte 10 is written as 11 1, and each byte 11 as 11 2.

namespace testbed::recording {

/// The same bits in every field.
bool IsSame(const Proof &a, const Proof &b);

/// One line, without its end. O(size).
std::string Pack(const Frame &frame);
bool IsPacked(const std::string &line);
/// Throws std::runtime_error on a line that is damaged or cut off.
Frame Unpack(const std::string &line);

} // namespace testbed::recording

#endif
