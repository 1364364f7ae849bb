// SPDX-License-Identifier: MIT
#include "reach/interposed/real.h"

#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <link.h>

namespace bmr {

namespace {

/// The name of one loaded object.
struct Name {
    size_t left;         ///< objects before it
    uint64_t changes;    ///< objects that have come and gone by then
    char text[PATH_MAX]; ///< empty where it has none that can be opened
};

int FindName(dl_phdr_info *object, size_t, void *context) {
    auto *name = static_cast<Name *>(context);
    name->changes = object->dlpi_adds + object->dlpi_subs;
    if (name->left-- > 0)
        return 0;
    const int length = std::snprintf(name->text, sizeof name->text, "%s", object->dlpi_name);
    if (length < 0 || static_cast<size_t>(length) >= sizeof name->text)
        name->text[0] = '\0';
    return 1;
}

/// In the modules that are in no search order but their own. The one that has it is never closed, because its
/// function is remembered. `*changes` is of the list that was gone through.
void *FindInModules(const char *mangled, uint64_t *changes) {
    // Opened only afterwards: the loader must not be asked while it goes through its list. And by one name at
    // a time, without memory: this may be in the middle of a step, which nothing may throw through.
    Name name;
    name.changes = 0;
    for (size_t i = 0; name.left = i, dl_iterate_phdr(FindName, &name) != 0; ++i) {
        void *module = name.text[0] == '\0' ? nullptr : dlopen(name.text, RTLD_NOW | RTLD_NOLOAD);
        if (module == nullptr)
            continue;
        if (void *found = dlsym(module, mangled))
            return found;
        dlclose(module);
    }
    *changes = name.changes;
    return nullptr;
}

/// Once more where other threads opened or closed modules meanwhile: their places were others.
void *FindInModules(const char *mangled) {
    uint64_t before, after = 0;
    void *found;
    do {
        before = after;
        found = FindInModules(mangled, &after);
    } while (found == nullptr && after != before);
    return found;
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
