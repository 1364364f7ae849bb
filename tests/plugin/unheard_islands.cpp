// SPDX-License-Identifier: MIT
// Ahead of the plugin: b2World::Solve is Box2D's own, as in a Box2D whose calls of it are bound inside.
#include <dlfcn.h>

#define SOLVE _ZN7b2World5SolveERK10b2TimeStep
#define NAME_OF(symbol) #symbol
#define NAME(symbol) NAME_OF(symbol)

extern "C" {

__attribute__((visibility("default"))) void SOLVE(void *world, void *step);
void SOLVE(void *world, void *step) {
    using Function = void(void *, void *);
    static auto *const box2d =
        reinterpret_cast<Function *>(dlsym(dlopen("libbox2d.so.2", RTLD_LAZY | RTLD_NOLOAD), NAME(SOLVE)));
    box2d(world, step);
}
}
