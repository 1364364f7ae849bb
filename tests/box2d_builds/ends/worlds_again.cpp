// SPDX-License-Identifier: MIT
//
//   worlds_again        exit status 0 where a level that is played again plays as it did
//
// A game that never ends a world: it makes the next one in the memory of the last, and all that Box2D
// allocates comes from an arena, which is set back to its beginning. So the contacts of a level are where
// those of the level before were, and are other pairs.
#include <cstdlib>
#include <new>
#include <vector>

#include "../../kit/small_world.h"

extern "C" {
void *__real_malloc(size_t bytes);
void __real_free(void *block);
void *__wrap_malloc(size_t bytes);
void __wrap_free(void *block);
}

namespace {

constexpr size_t kArena = size_t{1} << 24, kSmall = 1024;
alignas(64) char arena[kArena];
size_t used = 0;
alignas(b2World) unsigned char place[sizeof(b2World)];

} // namespace

/// (Small blocks are others', too.)
void *__wrap_malloc(size_t bytes) {
    if (bytes < kSmall || used + bytes + 64 > kArena)
        return __real_malloc(bytes);
    void *const block = arena + used;
    used += (bytes + 63) & ~size_t{63};
    return block;
}

void __wrap_free(void *block) {
    if (block < arena || block >= arena + kArena)
        __real_free(block);
}

namespace {

constexpr int kPairs = 80, kStay = 20;

/// Boxes apart from their neighbours, which are others in every other level. Of the pairs the oldest stay,
/// and their boxes meet.
uint64_t Play(bool even) {
    used = 0;
    auto *const world = new (place) b2World(b2Vec2(0.0f, 0.0f));
    Hash hash;
    std::vector<b2Body *> left;
    for (int i = 0; i < kPairs; ++i)
        for (const bool right : {false, true}) {
            const int at = right && !even ? (i + kPairs - 1) % kPairs : i;
            b2Body *const body =
                AddBox(*world, b2_dynamicBody, {3.0f * static_cast<float>(at) + (right ? 1.1f : 0.0f), 0.0f},
                       {0.5f, 0.5f}, 0.0f);
            body->SetSleepingAllowed(false);
            if (!right)
                left.push_back(body);
        }
    Step(*world, 8, &hash);
    std::vector<b2Contact *> contacts;
    for (b2Contact *contact = world->GetContactList(); contact != nullptr; contact = contact->GetNext())
        contacts.push_back(contact);
    for (size_t i = 0; i + kStay < contacts.size(); ++i)
        contacts[i]->GetFixtureA()->GetBody()->SetTransform({3.0f * static_cast<float>(i), 500.0f}, 0.0f);
    Step(*world, 4, &hash);
    for (b2Body *body : left)
        if (body->GetPosition().y == 0.0f)
            body->SetLinearVelocity({1.0f, 0.0f});
    Step(*world, 30, &hash);
    std::printf("%d contacts, ", static_cast<int>(world->GetContactCount()));
    Print(even ? "even" : "odd", hash);
    return hash.Value();
}

} // namespace

int main() {
    setenv("BOOMERANG_EVERYWHERE", "on", 1); // also where most pairs touch
    const uint64_t even = Play(true), odd = Play(false);
    bool same = even != odd;
    for (int round = 0; round < 2; ++round)
        same = Play(true) == even && Play(false) == odd && same;
    return same ? 0 : 1;
}
