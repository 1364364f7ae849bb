// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_PLUGIN_LOADED_FILE_H
#define BOOMERANG_PLUGIN_LOADED_FILE_H

#include <dlfcn.h>

namespace bmr {

/// Where the program or the shared library begins in memory that this address belongs to; null of others.
/// Equal for what comes from one file.
inline const void *FileOf(const void *address) {
    Dl_info info;
    return dladdr(address, &info) != 0 ? info.dli_fbase : nullptr;
}

} // namespace bmr

#endif
