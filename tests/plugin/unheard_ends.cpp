// SPDX-License-Identifier: MIT
// Ahead of the plugin: b2ContactManager::Destroy is Box2D's own, as in a Box2D whose calls of it are bound
// inside. So contacts end without a word.
#include <dlfcn.h>

class b2ContactManager;
class b2Contact;

extern "C" {

#define DESTROY _ZN16b2ContactManager7DestroyEP9b2Contact
#define NAME_OF(symbol) #symbol
#define NAME(symbol) NAME_OF(symbol)

__attribute__((visibility("default"))) void DESTROY(b2ContactManager *manager, b2Contact *contact);
void DESTROY(b2ContactManager *manager, b2Contact *contact) {
    using Function = void(b2ContactManager *, b2Contact *);
    static auto *const box2d =
        reinterpret_cast<Function *>(dlsym(dlopen("libbox2d.so.2", RTLD_LAZY | RTLD_NOLOAD), NAME(DESTROY)));
    box2d(manager, contact);
}
}
