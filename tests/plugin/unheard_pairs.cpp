// SPDX-License-Identifier: MIT
// Ahead of the plugin: b2ContactManager::FindNewContacts is Box2D's own, as in a Box2D whose calls of it are
// bound inside.
#include <dlfcn.h>

#define FIND _ZN16b2ContactManager15FindNewContactsEv
#define NAME_OF(symbol) #symbol
#define NAME(symbol) NAME_OF(symbol)

extern "C" {

__attribute__((visibility("default"))) void FIND(void *manager);
void FIND(void *manager) {
    using Function = void(void *);
    static auto *const box2d =
        reinterpret_cast<Function *>(dlsym(dlopen("libbox2d.so.2", RTLD_LAZY | RTLD_NOLOAD), NAME(FIND)));
    box2d(manager);
}
}
