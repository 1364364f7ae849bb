// SPDX-License-Identifier: MIT
#include "real.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <link.h>

namespace bmr {

namespace {

const void *FileOf(const void *address) {
    Dl_info info;
    return dladdr(address, &info) != 0 ? info.dli_fbase : nullptr;
}

int AddName(dl_phdr_info *object, size_t, void *names) {
    static_cast<std::vector<std::string> *>(names)->emplace_back(object->dlpi_name);
    return 0;
}

/// In the modules that are out of everybody's search order but their own. The one that has it is never
/// closed: what it defines is remembered.
void *FindInModules(const char *mangled) {
    // Opened only afterwards: the loader must not be asked while it goes through its list.
    std::vector<std::string> names;
    dl_iterate_phdr(AddName, &names);
    for (const std::string &name : names) {
        void *module = name.empty() ? nullptr : dlopen(name.c_str(), RTLD_NOW | RTLD_NOLOAD);
        if (module == nullptr)
            continue;
        void *found = dlsym(module, mangled);
        // (A module that asks for this library finds ours.)
        if (found != nullptr && FileOf(found) != FileOf(reinterpret_cast<const void *>(&FindReal)))
            return found;
        dlclose(module);
    }
    return nullptr;
}

} // namespace

void *FindReal(const char *mangled) {
    void *found = dlsym(RTLD_NEXT, mangled);
    if (found == nullptr)
        found = FindInModules(mangled);
    if (found == nullptr) {
        std::fprintf(stderr, "boomerang: %s is called, but no library but this one has it\n", mangled);
        std::abort();
    }
    return found;
}

} // namespace bmr
