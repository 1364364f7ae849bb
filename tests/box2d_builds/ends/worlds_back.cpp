// SPDX-License-Identifier: MIT
//
//   worlds_back           exit status 0 where a world whose memory was put back plays as the first time
//   worlds_back forgets   the same where the library's number is not put back, and bmr::Forget is called
//
// A game with rollback: b2World and all that Box2D allocates lie in an arena, which is copied and put back.
// A line for each way back; another run, with BOOMERANG=off, must print the same.
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

#include <boomerang/box2d.h>

#include "../../kit/random.h"
#include "../../kit/small_world.h"

extern "C" {
void *__wrap__Z15b2Alloc_Defaulti(int32 bytes);
void __wrap__Z14b2Free_DefaultPv(void *block);
}

namespace {

constexpr size_t kClass = 64, kClasses = 4096;

/// Blocks that were given back are handed out again, as malloc's are.
struct Arena {
    size_t used;
    void *freed[kClasses]; ///< by size; the first bytes of each lead to the next
    alignas(b2World) unsigned char world[sizeof(b2World)];
    alignas(64) unsigned char memory[size_t{1} << 21];
};
Arena arena;

b2World &World() {
    return *std::launder(reinterpret_cast<b2World *>(arena.world));
}

} // namespace

/// b2Alloc_Default.
void *__wrap__Z15b2Alloc_Defaulti(int32 bytes) {
    const size_t size = (static_cast<size_t>(bytes) + 2 * kClass - 1) / kClass;
    void *&freed = arena.freed[size < kClasses ? size : 0];
    if (size < kClasses && freed != nullptr) {
        void *const block = freed;
        std::memcpy(&freed, block, sizeof freed);
        return block;
    }
    if (arena.used + size * kClass > sizeof arena.memory)
        std::abort();
    unsigned char *const block = arena.memory + arena.used + kClass;
    std::memcpy(block - sizeof size, &size, sizeof size);
    arena.used += size * kClass;
    return block;
}

/// b2Free_Default.
void __wrap__Z14b2Free_DefaultPv(void *block) {
    if (block == nullptr)
        return;
    size_t size;
    std::memcpy(&size, static_cast<unsigned char *>(block) - sizeof size, sizeof size);
    std::memcpy(block, &arena.freed[size], sizeof(void *));
    arena.freed[size] = block;
}

namespace {

class Saved {
public:
    Saved() : m_copy(new Arena(arena)) {}
    void PutBack() const { std::memcpy(&arena, m_copy.get(), sizeof arena); }

private:
    std::unique_ptr<Arena> m_copy;
};

/// Boxes that fly about in a closed yard: pairs meet and part all the time, and most are apart.
void Make(uint32_t seed) {
    b2World *const world = new (arena.world) b2World(b2Vec2(0.0f, 0.0f));
    for (int side = 0; side < 4; ++side) {
        const b2Rot turned(0.5f * b2_pi * static_cast<float>(side));
        AddBox(*world, b2_staticBody, 14.0f * turned.GetXAxis(), {0.5f, 16.0f}, turned.GetAngle());
    }
    test_random random = {seed};
    const auto angle = [&random] { return static_cast<float>(test_random_uniform(&random, -b2_pi, b2_pi)); };
    for (int i = 0; i < 100; ++i) {
        b2Body *const body =
            AddBox(*world, b2_dynamicBody,
                   {2.4f * static_cast<float>(i % 10) - 11.0f, 2.4f * static_cast<float>(i / 10) - 11.0f},
                   {0.9f, 0.3f}, angle());
        const b2Rot direction(angle());
        body->SetLinearVelocity(4.0f * direction.GetXAxis());
        body->SetAngularVelocity(direction.s);
        body->GetFixtureList()->SetRestitution(1.0f);
        body->GetFixtureList()->GetUserData().pointer = static_cast<uintptr_t>(i);
    }
}

uint64_t Play(int steps) {
    Hash hash;
    Step(World(), steps, &hash);
    return hash.Value();
}

void Push(float strength) {
    for (b2Body *body = World().GetBodyList(); body != nullptr; body = body->GetNext())
        body->ApplyLinearImpulseToCenter({strength, 0.5f * strength}, true);
}

bool forgets = false;
int runs = 0, differ = 0;

/// The bytes behind m_allowSleep, up to the next pointer: the library's number is in them.
unsigned char *NumberOf(b2World *world) {
    static size_t at = 0;
    const std::vector<unsigned char> before(arena.world, arena.world + sizeof arena.world);
    world->SetAllowSleeping(!world->GetAllowSleeping());
    while (at == 0 || arena.world[at - 1] == before[at - 1])
        ++at;
    std::memcpy(arena.world, before.data(), before.size());
    return arena.world + at;
}

void GoBack(const Saved &saved) {
    if (!forgets)
        return saved.PutBack();
    unsigned char number[sizeof(void *) - 1];
    std::memcpy(number, NumberOf(&World()), sizeof number);
    saved.PutBack();
    std::memcpy(NumberOf(&World()), number, sizeof number);
    bmr::Forget(&World());
}

void Compare(const char *what, int number, uint64_t first, uint64_t again) {
    ++runs;
    differ += first == again ? 0 : 1;
    std::printf("%s %d: %016" PRIx64 "%s\n", what, number, first,
                first == again ? "" : ", other bits the second time");
}

/// From step 20 on `steps` steps, back, and the same again.
void GoBackBy(int steps, uint32_t seed) {
    Make(seed);
    Play(20);
    const Saved saved;
    const uint64_t first = Play(steps), then = Play(30);
    GoBack(saved);
    Compare("steps back", steps, first, Play(steps));
    Compare("and on from there", steps, then, Play(30));
}

/// Two futures of one past, each with as many steps, and as many before and after.
void Branch(int steps, uint32_t seed) {
    Make(seed);
    Play(10);
    const Saved past;
    Play(steps);
    const Saved one;
    const uint64_t first = Play(60);
    GoBack(past);
    Push(0.7f);
    Play(steps);
    const Saved other;
    const uint64_t second = Play(60);
    GoBack(one);
    Compare("one branch", steps, first, Play(60));
    GoBack(other);
    Compare("the other", steps, second, Play(60));
}

/// No step between the end of some bodies, and the return to when they were.
void BringBack(int ended, uint32_t seed) {
    Make(seed);
    Play(50);
    const Saved saved;
    const uint64_t first = Play(60);
    GoBack(saved);
    for (int i = 0; i < ended; ++i)
        World().DestroyBody(World().GetBodyList());
    GoBack(saved);
    Compare("bodies brought back", ended, first, Play(60));
}

/// A level in the memory of another one, which never ended.
void Replace(uint32_t seed) {
    const auto play = [](uint32_t which) {
        arena.used = 0;
        std::memset(arena.freed, 0, sizeof arena.freed);
        Make(which);
        return Play(120);
    };
    const uint64_t first = play(seed);
    play(seed + 1);
    Compare("a level again", static_cast<int>(seed), first, play(seed));
}

} // namespace

int main(int argc, char **argv) {
    forgets = argc > 1 && std::strcmp(argv[1], "forgets") == 0;
    const Saved empty;
    const auto anew = [&empty] { empty.PutBack(); };
    uint32_t seed = 0;
    for (const int steps : {1, 2, 3, 7, 20, 255, 256, 257, 1000}) {
        anew();
        GoBackBy(steps, ++seed);
    }
    for (const int steps : {1, 10, 20, 40, 255, 256, 257}) {
        anew();
        Branch(steps, ++seed);
    }
    for (const int ended : {1, 2, 10, 40, 80, 100}) {
        anew();
        BringBack(ended, ++seed);
    }
    for (int i = 0; i < 6; ++i)
        Replace(++seed);
    std::printf("%d times back, %d differ\n", runs, differ);
    return differ == 0 ? 0 : 1;
}
