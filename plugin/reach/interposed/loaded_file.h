// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_REACH_INTERPOSED_LOADED_FILE_H
#define BOOMERANG_REACH_INTERPOSED_LOADED_FILE_H

namespace bmr {

/// The program or the shared library that this address belongs to, as an address that is no other one's; null
/// of addresses that belong to none. Equal for what comes from one file. (dladdr would look for the nearest
/// of all the file's symbols, too, which takes a hundred times as long.)
const void *FileOf(const void *address);

/// Do the read-only parts of that file have these words in them, as it was loaded?
bool FileHolds(const void *address, const char *words);

} // namespace bmr

#endif
