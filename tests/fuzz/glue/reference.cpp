// SPDX-License-Identifier: MIT
// One run of a script in a link namespace of its own, with Box2D's own functions. It runs first, and finds
// out how far Box2D lets a script go: an assertion of Box2D's ends the run, not the process.
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "script.h"

#if defined(BOOMERANG_FUZZ_OTHER)
#    include <boomerang/box2d.h>

#    include "hooks/stepping.h"
#    include "ledger/ledgers.h"
#    include "start/current_step.h"
#endif

#define FUZZ_SHOWN __attribute__((visibility("default")))

namespace {

std::jmp_buf asserted;
const char *assertion;
alignas(fuzz::Script) unsigned char room[sizeof(fuzz::Script)];

/// What Box2D has from the heap, in a ring: a run that ends in an assertion leaves it all behind.
struct alignas(16) Header {
    Header *next, *previous;
};
Header heap = {&heap, &heap};

void FreeBlock(Header *block) {
    block->previous->next = block->next;
    block->next->previous = block->previous;
    std::free(block);
}

void InstallOther() {
#if defined(BOOMERANG_FUZZ_OTHER)
    clearenv(); // this namespace's own: the environment is for the plugin that is tested
    bmr::Options options;
    options.structure = BMR_LAZY_COMPASS;
    options.prefilter = false;
    if (!bmr::IsInstalled() && !bmr::Install(options))
        std::abort();
#endif
}

} // namespace

// Ahead of Box2D's and of libc's.
FUZZ_SHOWN void *b2Alloc_Default(int32 size);
FUZZ_SHOWN void b2Free_Default(void *memory);

void *b2Alloc_Default(int32 size) {
    Header *block = static_cast<Header *>(std::malloc(sizeof(Header) + static_cast<size_t>(size)));
    if (block == nullptr)
        std::abort();
    block->next = heap.next;
    block->previous = &heap;
    heap.next->previous = block;
    heap.next = block;
    return block + 1;
}

void b2Free_Default(void *memory) {
    if (memory != nullptr)
        FreeBlock(static_cast<Header *>(memory) - 1);
}

extern "C" FUZZ_SHOWN void __assert_fail(const char *text, const char *, unsigned, const char *) noexcept {
    assertion = text;
    std::longjmp(asserted, 1);
}

extern "C" FUZZ_SHOWN void fuzz_glue_run(const fuzz::RunRequest *request, fuzz::RunResult *result);

extern "C" void fuzz_glue_run(const fuzz::RunRequest *request, fuzz::RunResult *result) {
    static bool installed = false;
    if (!installed)
        InstallOther();
    installed = true;
    // Outlives the jump: what is in it by then is how far it came.
    static fuzz::Script *volatile script;
    if (setjmp(asserted) == 0) {
        script = new (room) fuzz::Script(*request);
        *result = script->Run();
        script->~Script();
    } else {
        *result = script->Result();
        result->ending = fuzz::Ending::Asserted;
        std::snprintf(result->assertion, sizeof result->assertion, "%s", assertion);
#if defined(BOOMERANG_FUZZ_OTHER)
        // No step has ended, and what the thread keeps for one lies in frames that are gone.
        bmr::hooks::stepping = {};
        bmr::CurrentStep() = 0;
        // Nobody ends the worlds, and the next ones are made in their place, and out of the same memory.
        script->VisitWorlds([](b2World &world) { bmr::DropLedger(&world.GetContactManager()); });
#endif
        while (heap.next != &heap)
            FreeBlock(heap.next);
    }
}
