// SPDX-License-Identifier: MIT
// A program without Box2D that opens a module for itself, plays it and closes it again, three times:
// module_host MODULE [global]
#include <cstdio>

#include <dlfcn.h>

int main(int argc, char **argv) {
    for (int i = 0; i < 3; ++i) {
        void *module = argc > 1 ? dlopen(argv[1], RTLD_NOW | (argc > 2 ? RTLD_GLOBAL : RTLD_LOCAL)) : nullptr;
        void *play = module != nullptr ? dlsym(module, "_Z10PlayModulev") : nullptr;
        if (play == nullptr) {
            const char *why = dlerror();
            std::fprintf(stderr, "%s\n", why != nullptr ? why : "no module");
            return 1;
        }
        if (reinterpret_cast<int (*)()>(play)() != 0 || dlclose(module) != 0)
            return 1;
    }
    return 0;
}
