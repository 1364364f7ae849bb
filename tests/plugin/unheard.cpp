// SPDX-License-Identifier: MIT
// Ahead of the plugin: one function of b2ContactManager's, SYMBOL, is Box2D's own, as in a Box2D whose calls
// of it are bound inside. So contacts end, or are made, without a word.
#include <dlfcn.h>

class b2ContactManager;
class b2Contact;

#define NAME_OF(symbol) #symbol
#define NAME(symbol) NAME_OF(symbol)

extern "C" {

__attribute__((visibility("default"))) void SYMBOL(b2ContactManager *manager, b2Contact *contact);
// (One of them has no second argument.)
void SYMBOL(b2ContactManager *manager, b2Contact *contact) {
    using Function = void(b2ContactManager *, b2Contact *);
    static auto *const box2d =
        reinterpret_cast<Function *>(dlsym(dlopen("libbox2d.so.2", RTLD_LAZY | RTLD_NOLOAD), NAME(SYMBOL)));
    box2d(manager, contact);
}
}
