// SPDX-License-Identifier: MIT
#include "interposed/real.h"

#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <link.h>

namespace bmr {

/// One of this library's own references to Box2D: at no address where no Box2D was in search order when it
/// was loaded.
extern const char boundReference[] asm("_ZN9b2Contact11s_registersE") __attribute__((weak));

namespace {

/// The name of one loaded object.
struct Name {
    size_t left;         ///< objects before it
    char text[PATH_MAX]; ///< empty where it has none that can be opened
};

int FindName(dl_phdr_info *object, size_t, void *context) {
    auto *name = static_cast<Name *>(context);
    if (name->left-- > 0)
        return 0;
    const int length = std::snprintf(name->text, sizeof name->text, "%s", object->dlpi_name);
    if (length < 0 || static_cast<size_t>(length) >= sizeof name->text)
        name->text[0] = '\0';
    return 1;
}

/// Files that were loaded and closed so far, together.
uint64_t ChangesOfLoader() {
    uint64_t changes = 0;
    const auto read = [](dl_phdr_info *object, size_t, void *to) {
        *static_cast<uint64_t *>(to) = object->dlpi_adds + object->dlpi_subs;
        return 1;
    };
    dl_iterate_phdr(read, &changes);
    return changes;
}

/// In the modules that are in no search order but their own. Once more where other threads opened or closed
/// modules meanwhile: their places were others.
void *FindInModules(const char *mangled) {
    // Opened only afterwards: the loader must not be asked while it goes through its list. And by one name at
    // a time, without memory: this may be in the middle of a step, which nothing may throw through.
    Name name;
    uint64_t before;
    do {
        before = ChangesOfLoader();
        for (size_t i = 0; name.left = i, dl_iterate_phdr(FindName, &name) != 0; ++i) {
            void *module = name.text[0] == '\0' ? nullptr : dlopen(name.text, RTLD_NOW | RTLD_NOLOAD);
            if (module == nullptr)
                continue;
            void *const found = dlsym(module, mangled);
            dlclose(module);
            if (found != nullptr)
                return found;
        }
    } while (before != ChangesOfLoader());
    return nullptr;
}

} // namespace

bool Box2DStays() {
    return boundReference != nullptr;
}

void *FoundFunction::Find() {
    const uint64_t changes = ChangesOfLoader();
    if (m_guard.try_lock()) {
        void *const known = m_changes == changes ? m_found : nullptr;
        m_guard.unlock();
        if (known != nullptr)
            return known;
    }
    void *found = dlsym(RTLD_NEXT, m_name);
    if (found == nullptr)
        found = FindInModules(m_name);
    if (found == nullptr) {
        std::fprintf(stderr, "boomerang: %s is called, but no library but this one has it\n", m_name);
        std::abort();
    }
    if (m_guard.try_lock()) {
        m_found = found;
        m_changes = changes;
        m_guard.unlock();
    }
    return found;
}

} // namespace bmr
