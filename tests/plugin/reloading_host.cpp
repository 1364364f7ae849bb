// SPDX-License-Identifier: MIT
// A program without Box2D that opens a game, plays it, closes it and opens the next version of the same file:
// reloading_host FILE VERSION...
//
// A version is copied to FILE before it is opened.
#include <cstdio>
#include <filesystem>

#include <dlfcn.h>

int main(int argc, char **argv) {
    for (int i = 2; i < argc; ++i) {
        std::filesystem::remove(argv[1]); // what may still be loaded is another file, as of a game's compiler
        std::filesystem::copy_file(argv[i], argv[1]);
        void *const game = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
        void *const play = game != nullptr ? dlsym(game, "_Z10PlayModulev") : nullptr;
        if (play == nullptr) {
            const char *const why = dlerror();
            std::fprintf(stderr, "%s\n", why != nullptr ? why : "no game");
            return 1;
        }
        if (reinterpret_cast<int (*)()>(play)() != 0 || dlclose(game) != 0)
            return 1;
    }
    return 0;
}
