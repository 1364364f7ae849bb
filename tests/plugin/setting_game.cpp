// SPDX-License-Identifier: MIT
//
//   setting_game made|passed|pending|settled|met|replaced|halved|woken|geared
//
// Games that change what a world is set to, or who listens, in the midst of its own step. Prints a line for
// each step: how often the listeners were told of something, and a hash of all bodies and contacts. A plain
// program of Box2D's: with the plugin preloaded it prints the same.
//
// Shots hit bodies that lean on others. Whether Box2D looks for these impacts, and whether it moves the other
// bodies, too, is a matter of who is a bullet by then, and of the islands that contacts and bodies say they
// are in. Most become bullets when the search for impacts has begun, which left them out.
//
//   made      a listener makes bullets of those that lean
//   passed    a listener makes bullets of the shots, and disables the contact that it is told of: Box2D goes
//             on at once
//   pending   a listener disables contacts whose impacts Box2D has found and not come to; their shots are
//             bullets no more when the world is stepped in the midst of another world's search
//   settled   a listener steps the world, which is not to look for impacts in that step
//   met       a listener has bodies meet in a step of no time, which lean on each other when their islands
//             are built
//   replaced  a listener puts another one in its place
//   halved    a listener has the step end with the first impact (sub-stepping); between steps it is over
//   woken     hundreds of bodies sleep. A filter wakes those that lean on each other, and steps the world,
//             which is not to look for impacts in that step
//   geared    between steps, gear joints are made whose definitions name bodies that the joints do not join:
//             a filter is asked about these
#include <cstdlib>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "small_world.h"

namespace {

/// Does what is to be done at the first begin; counts all that it is told.
class Listener final : public b2ContactListener {
public:
    std::function<void(b2Contact *)> begin;
    void BeginContact(b2Contact *contact) override {
        ++told;
        if (begin)
            std::exchange(begin, nullptr)(contact);
    }
    void PreSolve(b2Contact *, const b2Manifold *) override { ++told; }
    std::function<void()> solved;
    void PostSolve(b2Contact *, const b2ContactImpulse *) override {
        ++told;
        if (solved)
            std::exchange(solved, nullptr)();
    }
    void EndContact(b2Contact *) override { ++told; }
    int told = 0;
};

const b2Vec2 kHalf(0.5f, 0.5f);

/// Leaning pairs in a crowd, each with a shot at it that still lies; far off, a post with a shot at it.
struct Range {
    static constexpr int kPairs = 8, kCrowd = 12;
    b2World world{b2Vec2(0.0f, 0.0f)};
    Listener listener, other;
    Hash hash;
    b2Body *first = nullptr; ///< hits the post
    std::vector<b2Body *> crowd, shots, leaning;

    Range() {
        for (int i = 0; i < kCrowd * kCrowd; ++i) // near each other: most pairs are of bodies like these
            crowd.push_back(
                Add({1.05f * static_cast<float>(i % kCrowd), 40.0f + 1.05f * static_cast<float>(i / kCrowd)},
                    kHalf));
        for (int i = 0; i < kPairs; ++i) {
            const float y = 4.0f * static_cast<float>(i);
            leaning.push_back(Add({0.0f, y}, kHalf));
            Add({0.995f, y}, kHalf);
            shots.push_back(Add({-2.5f, y}, {0.1f, 0.1f}));
        }
        AddBox(world, b2_staticBody, {0.0f, -30.0f}, {0.05f, 1.0f}, 0.0f);
        first = Add({-2.0f, -30.0f}, {0.1f, 0.1f});
        world.SetContactListener(&listener);
        Play(2);
        // From the first impact on nobody has anything to forget of those that are left out.
        Add({2.5f, -30.0f}, {0.1f, 0.1f})->SetLinearVelocity({-240.0f, 0.0f});
        Play(4);
    }
    b2Body *Add(b2Vec2 at, b2Vec2 half) {
        b2Body *body = AddBox(world, b2_dynamicBody, at, half, 0.0f);
        body->SetSleepingAllowed(false);
        return body;
    }
    void Throw(float at, float at_post) {
        first->SetLinearVelocity({at_post, 0.0f});
        for (b2Body *shot : shots)
            shot->SetLinearVelocity({at, 0.0f});
    }
    void Shoot(float at, float at_post) {
        MakeBullets(shots);
        Throw(at, at_post);
    }
    static void MakeBullets(const std::vector<b2Body *> &bodies) {
        for (b2Body *body : bodies)
            body->SetBullet(true);
    }
    void Play(int steps) {
        for (int i = 0; i < steps; ++i) {
            Step(world, 1, &hash);
            std::printf("%d told, ", listener.told + other.told);
            Print("", hash);
        }
    }
};

void PlayMade() {
    Range range;
    range.Shoot(180.0f, 240.0f);
    range.listener.begin = [&range](b2Contact *) { Range::MakeBullets(range.leaning); };
    range.Play(4);
}

void PlayPassed() {
    Range range;
    range.Throw(180.0f, 240.0f);
    range.listener.begin = [&range](b2Contact *contact) {
        contact->SetEnabled(false);
        Range::MakeBullets(range.shots);
    };
    range.Play(4);
}

void PlayPending() {
    Range range;
    range.Throw(180.0f, 240.0f);
    range.listener.begin = [&range](b2Contact *) {
        Range::MakeBullets(range.shots);
        range.listener.begin = [&range](b2Contact *hit) {
            for (b2Body *body : range.leaning)
                for (b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next)
                    if (edge->contact != hit && edge->other->IsBullet())
                        edge->contact->SetEnabled(false);
        };
    };
    range.Play(1);
    for (b2Body *shot : range.shots) {
        shot->SetBullet(false);
        shot->SetLinearVelocity({0.0f, 0.0f});
        shot->SetTransform({-0.75f, shot->GetPosition().y}, 0.0f);
    }
    // In the midst of another world's search.
    b2World world(b2Vec2(0.0f, 0.0f));
    Listener listener;
    for (int i = 0; i < 60; ++i)
        AddBox(world, b2_dynamicBody, {1.05f * static_cast<float>(i), 10.0f}, kHalf, 0.0f);
    AddBox(world, b2_staticBody, {0.0f, 0.0f}, {0.05f, 1.0f}, 0.0f);
    b2Body *const bullet = AddBox(world, b2_dynamicBody, {-2.0f, 0.0f}, {0.1f, 0.1f}, 0.0f);
    Step(world, 4, &range.hash);
    bullet->SetLinearVelocity({240.0f, 0.0f});
    world.SetContactListener(&listener);
    listener.begin = [&range](b2Contact *) {
        range.first->SetTransform({-2.0f, -30.0f}, 0.0f);
        range.Throw(30.0f, 240.0f);
        range.Play(1);
    };
    Step(world, 1, &range.hash);
    range.Play(2);
}

void PlaySettled() {
    Range range;
    range.Shoot(0.0f, 240.0f);
    range.listener.begin = [&range](b2Contact *) {
        Range::MakeBullets(range.leaning);
        range.Shoot(240.0f, 0.0f);
        range.world.SetContinuousPhysics(false);
        range.world.Step(1.0f / 60.0f, 8, 3);
        range.world.SetContinuousPhysics(true);
    };
    range.Play(4);
}

void PlayMet() {
    Range range;
    for (const float x : {60.0f, 60.995f}) // the newest: their island is the first
        range.Add({x, 0.0f}, kHalf);
    range.Play(1);
    for (b2Body *body : range.leaning)
        body->SetTransform({-0.05f, body->GetPosition().y}, 0.0f);
    range.listener.solved = [&range] {
        range.world.Step(0.0f, 1, 1); // unlocks it
        for (b2Body *body : range.leaning) {
            body->SetTransform({0.0f, body->GetPosition().y}, 0.0f);
            body->SetLinearVelocity({1.0f, 0.0f});
        }
        range.world.Step(0.0f, 1, 1);
    };
    range.Play(3);
}

void PlayReplaced() {
    Range range;
    range.Shoot(180.0f, 240.0f);
    range.listener.begin = [&range](b2Contact *) { range.world.SetContactListener(&range.other); };
    range.other.begin = [&range](b2Contact *) { Range::MakeBullets(range.leaning); };
    range.Play(4);
}

void PlayHalved() {
    Range range;
    range.Shoot(180.0f, 240.0f);
    range.listener.begin = [&range](b2Contact *) { range.world.SetSubStepping(true); };
    range.Play(1);
    range.world.SetSubStepping(false);
    Range::MakeBullets(range.leaning);
    range.Play(4);
}

/// Does what is to be done when it is first asked.
class Filter final : public b2ContactFilter {
public:
    std::function<void()> asked;
    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override {
        if (asked)
            std::exchange(asked, nullptr)();
        return b2ContactFilter::ShouldCollide(a, b);
    }
};

void PlayWoken() {
    constexpr int kSleepers = 400, kPairs = 8;
    b2World world(b2Vec2(0.0f, 0.0f));
    Filter filter;
    Hash hash;
    const auto play = [&world, &hash](int steps) {
        for (int i = 0; i < steps; ++i) {
            Step(world, 1, &hash);
            Print("woken", hash);
        }
    };
    const auto add = [&world](b2Vec2 at, b2Vec2 half) {
        return AddBox(world, b2_dynamicBody, at, half, 0.0f);
    };
    std::vector<b2Body *> leaning, shots, sleepers;
    for (int i = 0; i < kSleepers; ++i)
        sleepers.push_back(
            add({1.05f * static_cast<float>(i % 20), 60.0f + 1.05f * static_cast<float>(i / 20)}, kHalf));
    for (int i = 0; i < kPairs; ++i) {
        const float y = 4.0f * static_cast<float>(i);
        leaning.push_back(add({0.0f, y}, kHalf));
        leaning.push_back(add({0.995f, y}, kHalf));
        for (size_t k = leaning.size() - 2; k < leaning.size(); ++k) {
            leaning[k]->SetBullet(true);
            sleepers.push_back(leaning[k]);
        }
        shots.push_back(add({-2.5f, y}, {0.1f, 0.1f}));
        shots.back()->SetBullet(true);
    }
    AddBox(world, b2_staticBody, {0.0f, -30.0f}, {0.05f, 1.0f}, 0.0f);
    b2Body *const coming = add({-3.0f, -30.0f}, {0.1f, 0.1f});
    world.SetContactFilter(&filter);
    play(2);
    for (b2Body *body : sleepers)
        body->SetAwake(false);
    Step(world, 40, &hash); // until it is seen that hardly anybody is awake
    filter.asked = [&] {
        for (b2Body *body : leaning)
            body->SetAwake(true);
        world.SetContinuousPhysics(false);
        world.Step(1.0f / 60.0f, 8, 3);
        world.SetContinuousPhysics(true);
    };
    coming->SetLinearVelocity({30.0f, 0.0f});
    for (b2Body *shot : shots)
        shot->SetLinearVelocity({70.0f, 0.0f});
    play(4);
}

/// Lets nobody collide, and counts.
class Refusing final : public b2ContactFilter {
public:
    int asked = 0;
    bool ShouldCollide(b2Fixture *, b2Fixture *) override {
        ++asked;
        return false;
    }
};

void PlayGeared() {
    Range range;
    Refusing filter;
    const b2BodyDef def;
    b2Body *const anchor = range.world.CreateBody(&def);
    const auto hinge = [&range, anchor](b2Body *body) {
        b2RevoluteJointDef joint;
        joint.Initialize(anchor, body, body->GetPosition());
        return range.world.CreateJoint(&joint);
    };
    b2GearJointDef gear;
    gear.joint1 = hinge(range.shots[0]);
    gear.joint2 = hinge(range.shots[1]);
    range.world.SetContactFilter(&filter);
    for (size_t i = 0; i < Range::kCrowd; ++i) {
        gear.bodyA = range.crowd[i];
        gear.bodyB = range.crowd[i + Range::kCrowd];
        range.world.CreateJoint(&gear);
        range.Play(1);
        std::printf("%d asked, %d contacts\n", filter.asked, static_cast<int>(range.world.GetContactCount()));
    }
}

} // namespace

int main(int argc, char **argv) {
    const std::string what = argc == 2 ? argv[1] : "";
    if (what == "made") {
        PlayMade();
    } else if (what == "passed") {
        PlayPassed();
    } else if (what == "pending") {
        PlayPending();
    } else if (what == "woken") {
        PlayWoken();
    } else if (what == "settled") {
        PlaySettled();
    } else if (what == "met") {
        PlayMet();
    } else if (what == "replaced") {
        PlayReplaced();
    } else if (what == "halved") {
        PlayHalved();
    } else if (what == "geared") {
        PlayGeared();
    } else {
        std::fputs("usage: setting_game made|passed|pending|settled|met|replaced|halved|woken|geared\n",
                   stderr);
        return 2;
    }
    return 0;
}
