// SPDX-License-Identifier: MIT
// A program without Box2D that opens a module, plays it and closes it again:
//
//   host MODULE [global]            three times; `global`: for all to see
//   host as FILE VERSION...         each version of a game, copied to FILE
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <thread>

#include <dlfcn.h>

namespace {

bool Play(const char *file, int scope) {
    void *const module = dlopen(file, RTLD_NOW | scope);
    void *const play = module != nullptr ? dlsym(module, "_Z10PlayModulev") : nullptr;
    if (play == nullptr) {
        const char *const why = dlerror();
        std::fprintf(stderr, "%s\n", why != nullptr ? why : "no module");
        return false;
    }
    const bool played = reinterpret_cast<int (*)()>(play)() == 0;
    // `boomerang try` samples what is loaded.
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return played && dlclose(module) == 0;
}

} // namespace

int main(int argc, char **argv) {
    bool played = argc > 1;
    const bool copies = argc > 3 && std::strcmp(argv[1], "as") == 0;
    for (int i = 0; played && !copies && i < 3; ++i)
        played = Play(argv[1], argc > 2 ? RTLD_GLOBAL : RTLD_LOCAL);
    for (int i = 3; played && copies && i < argc; ++i) {
        std::filesystem::remove(argv[2]); // what may still be loaded is another file, as of a game's compiler
        std::filesystem::copy_file(argv[i], argv[2]);
        played = Play(argv[2], RTLD_LOCAL);
    }
    return played ? 0 : 1;
}
