// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_WHOLE_FILE_H
#define BOOMERANG_TESTBED_WHOLE_FILE_H

#include <string>

namespace testbed {

/// Throws std::runtime_error, which says why, if a file cannot be written there, as far as that can be known
/// before the work.
void CheckWritable(const std::string &path);

/// Writes a file that is there whole or as it was before: beside its place first, as path.part, which then
/// takes its place. A device or a pipe is written directly, and of a link what it leads to. Throws
/// std::runtime_error.
void WriteWholeFile(const std::string &path, const std::string &content);

} // namespace testbed

#endif
