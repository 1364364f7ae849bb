// SPDX-License-Identifier: MIT
// A game that opens a library in the middle of its run, when it has a world with contacts: opening_game
// [LIBRARY]. It tries to close it again, too.
#include <dlfcn.h>

#include "../kit/small_world.h"

namespace {

/// The library's own environment says on, but Box2D is ahead of it.
bool Open(const char *library) {
    void *opened = dlopen(library, RTLD_NOW);
    if (opened == nullptr) {
        std::printf("%s\n", dlerror());
        return false;
    }
    const auto isInstalled = reinterpret_cast<bool (*)()>(dlsym(opened, "_ZN3bmr11IsInstalledEv"));
    const bool installed = isInstalled != nullptr && isInstalled();
    return dlclose(opened) == 0 && !installed;
}

} // namespace

int main(int argc, char **argv) {
    b2World world(b2Vec2(0.0f, -10.0f));
    FillWithBoxes(world);
    AddWheel(world, {0.0f, 16.0f}, 16, 1.0f);
    AddWheel(world, {0.4f, 18.5f}, 16, 1.0f);
    Hash hash;
    Step(world, 100, &hash);
    if (argc > 1 && !Open(argv[1]))
        return 1;
    FillWithBoxes(world);
    AddWheel(world, {0.0f, 20.0f}, 16, 1.0f);
    Step(world, 100, &hash);
    b2World another(b2Vec2(0.0f, -10.0f));
    FillWithBoxes(another);
    Step(another, 100, &hash);
    Print("opened", hash);
    return 0;
}
