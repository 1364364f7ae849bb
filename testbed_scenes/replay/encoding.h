// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_ENCODING_H
#define BOOMERANG_TESTBED_ENCODING_H

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "replay.h"

/// @file
/// A replay as the page holds it: columns of whole numbers, deflated, in base64.
///
/// Quantities become whole numbers, by rounding to the nearest multiple of a quantum. The error that makes is
/// half a quantum, and below what a screen shows:
///
///     positions, points of shapes    kPositionQuantum   2^-12 m: at most 0.13 mm off, in x and in y
///     angles                         kAngleQuantum      2^-14: at most 3.1e-5 rad, 0.3 mm on a body of 10 m
///     slack, gaps                    kSlackQuantum      2^-10 m, rounded DOWN: still lower bounds, less than
///                                                       1 mm low; a slack above 0 that would round to 0 is
///                                                       one quantum
///
/// A position farther than kFarthest from the origin is written as if it were that far.
///
/// The bytes, before they are deflated (zlib's format, RFC 1950), in little-endian order:
///
///     "BMRR"  u32 version  u32 number of columns
///     for each column: u8 length of its name, the name, u8 order, u8 bytes, u32 count, u32 size
///     for each column: `size` bytes, which decode to `count` numbers
///
/// A column of order 0 holds its numbers, of order 1 the differences of neighbours, of order 2 the
/// differences of those (what moves evenly becomes zeros); all modulo 2^32, with zeros before the first. Each
/// difference d is zigzag-coded, (d << 1) ^ (d >> 31), and written seven bits to a byte, lowest first, the
/// high bit set in all but the last. `bytes` (1, 2 or 4) is the width of a signed integer that holds every
/// number. The encoder takes the order that deflates to the fewest bytes.

namespace testbed::replay {

constexpr double kPositionQuantum = 1.0 / 4096.0;
constexpr double kAngleQuantum = 1.0 / 16384.0;
constexpr double kSlackQuantum = 1.0 / 1024.0;
constexpr double kFarthest = 400000.0;
constexpr uint32_t kEncodingVersion = 1;

struct Column {
    std::string name;
    std::vector<int32_t> values;
};

/// The columns of a replay; what each holds is said where it is filled. O(size).
std::vector<Column> ColumnsOf(const Replay &replay);

/// The bytes described above. O(size).
std::string Pack(const std::vector<Column> &columns);

/// As zlib's compress, RFC 1950. Throws std::runtime_error where it fails.
std::string Deflate(std::string_view bytes);

/// RFC 4648, with padding.
std::string Base64(std::string_view bytes);

/// The nearest multiple of a quantum; the value is clamped to +-limit first, and NaN counts as 0.
int32_t Quantise(double value, double quantum, double limit);
/// The greatest multiple that is not above, but 1 for what is above 0. Negative: -1.
int32_t QuantiseSlack(double slack);

/// One self-contained HTML page that plays the replay: style, script and data are in it, it asks no network
/// and needs no server. Its files lie in page/ and are embedded at build time.
///
/// Replay::about, as the page reads it (whatever is missing is left out of the page):
///
///     scene, description, structure: words
///     stock      what the plugin is held against: stock, or off (the plugin off)
///     timeStep   seconds
///     margin     what a certificate must prove, in lengths
///     boxes      false: those of the broad phase were not recorded
///
/// O(size of the replay).
std::string PageOf(const Replay &replay);

} // namespace testbed::replay

#endif
