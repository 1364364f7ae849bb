// SPDX-License-Identifier: MIT
// Ahead of the plugin: one function of Box2D's, SYMBOL, is Box2D's own, as in a Box2D whose calls of it are
// bound inside. LATE: only once passes run, as where some of the calls are bound and others are not. So
// contacts end, or are made, without a word.
#include <boomerang/box2d_glue.h>
#include <dlfcn.h>

#define NAME_OF(symbol) #symbol
#define NAME(symbol) NAME_OF(symbol)

namespace {

using Function = void(void *, void *);

Function *Plugins() {
    return reinterpret_cast<Function *>(dlvsym(RTLD_NEXT, NAME(SYMBOL), "BOOMERANG_HOOKS"));
}

bool PassesRun() {
    using Asked = bmr::Presence();
    auto *const ask = reinterpret_cast<Asked *>(dlsym(RTLD_DEFAULT, "_ZN3bmr11GetPresenceEv"));
    return ask != nullptr && ask().passesRun;
}

} // namespace

extern "C" {

__attribute__((visibility("default"))) void SYMBOL(void *object, void *argument);
// (One of them has no argument.)
void SYMBOL(void *object, void *argument) {
    static Function *const plugins = Plugins();
    static auto *const box2d =
        reinterpret_cast<Function *>(dlsym(dlopen("libbox2d.so.2", RTLD_LAZY | RTLD_NOLOAD), NAME(SYMBOL)));
    (LATE && plugins != nullptr && !PassesRun() ? plugins : box2d)(object, argument);
}
}
