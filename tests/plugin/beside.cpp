// SPDX-License-Identifier: MIT
// What stands beside a game and its Box2D. The part is named by what is defined.
#if defined(OTHER_SIZES)

// Preloaded ahead of Box2D: its register of contacts, larger than 2.4.1's.
extern "C" char registers[1024] __asm__("_ZN9b2Contact11s_registersE");
char registers[1024];

#elif defined(OWN_MEMORY)

// A game takes two of Box2D's functions for its own, and so has one b2Alloc_Default and Box2D's library
// another. What the one made the other cannot free.
#    include <cstdlib>

#    include <box2d/b2_settings.h>

void *b2Alloc_Default(int32 size) {
    return static_cast<char *>(std::malloc(static_cast<std::size_t>(size) + 64)) + 64;
}

void b2Free_Default(void *memory) {
    std::free(memory == nullptr ? nullptr : static_cast<char *>(memory) - 64);
}

#elif defined(UNHEARD_PAIRS)

// Ahead of the plugin: b2ContactManager::FindNewContacts is Box2D's own, as in a Box2D whose calls of it are
// bound inside.
#    include <dlfcn.h>

extern "C" __attribute__((visibility("default"))) void
_ZN16b2ContactManager15FindNewContactsEv(void *manager);
void _ZN16b2ContactManager15FindNewContactsEv(void *manager) {
    using Function = void(void *);
    static auto *const box2d = reinterpret_cast<Function *>(
        dlsym(dlopen("libbox2d.so.2", RTLD_LAZY | RTLD_NOLOAD), "_ZN16b2ContactManager15FindNewContactsEv"));
    box2d(manager);
}

#elif defined(CALLS_INSTALL)

// The line of a game's that puts Boomerang to work.
#    include <boomerang/box2d.h>

[[maybe_unused]] const bool installed = bmr::Install();

#else

// A program that never heard of Box2D.
#    include <cstdio>

int main() {
    std::puts("no game");
    return 7;
}

#endif
