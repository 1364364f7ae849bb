// SPDX-License-Identifier: MIT
// Games that step a world in the midst of a step.
//
//   stepping_game own      a listener steps its own world, which Box2D does not forbid
//   stepping_game round    a listener steps another world, whose listener steps the first one
//   stepping_game pairs    a listener has new contacts looked for
//   stepping_game fibers   two worlds on two stacks of one thread: a listener leaves one step for the
//                          other, and the later one need not end first
//   stepping_game small    on a thread with a stack of 16 KiB
//   stepping_game filters  a filter steps its own world in the midst of the search for new contacts
//   stepping_game ending   a filter ends contacts of bodies that have many
#include <pthread.h>
#include <ucontext.h>

#include <cstdlib>
#include <string>

#include "small_world.h"

namespace {

/// Planks, and bullets and boxes that fall on them at once.
void FillWithShots(b2World &world, int shots, float height) {
    AddBox(world, b2_staticBody, {0.0f, 0.0f}, {10.0f, 0.1f}, 0.0f);
    for (int i = 0; i < shots; ++i) {
        const float x = static_cast<float>(i);
        b2Body *shot = AddBox(world, b2_dynamicBody, {-8.0f + 0.5f * x, height + static_cast<float>(i % 7)},
                              {0.2f, 0.2f}, 0.2f * x);
        shot->SetBullet(i % 2 == 1);
        shot->SetLinearVelocity({3.0f * static_cast<float>(i % 5), -100.0f});
    }
}

/// Calls `Midst` a few times in the midst of a step, but not in the midst of itself.
class Breaker : public b2ContactListener {
public:
    Breaker(b2World *world, int every, int calls) : m_world(world), m_every(every), m_left(calls) {
        world->SetContactListener(this);
    }
    void BeginContact(b2Contact *) override {
        if (m_inside || m_left == 0 || ++m_begun % m_every != 0)
            return;
        m_inside = true;
        --m_left;
        Midst();
        m_inside = false;
    }
    virtual void Midst() = 0;

protected:
    b2World *m_world;

private:
    int m_every, m_left, m_begun = 0;
    bool m_inside = false;
};

class StepsOwn : public Breaker {
public:
    using Breaker::Breaker;
    void Midst() override { m_world->Step(1.0f / 60.0f, 2, 2); }
};

class StepsOther : public Breaker {
public:
    StepsOther(b2World *world, b2World *other, int every, int calls)
        : Breaker(world, every, calls), m_other(other) {}
    void Midst() override { m_other->Step(1.0f / 60.0f, 2, 2); }

private:
    b2World *m_other;
};

class LooksForPairs : public Breaker {
public:
    using Breaker::Breaker;
    void Midst() override { const_cast<b2ContactManager &>(m_world->GetContactManager()).FindNewContacts(); }
};

void PlayOn(b2World &world, int steps, const char *name) {
    Hash hash;
    for (int i = 0; i < steps; i += 10) {
        Step(world, 10, &hash);
        Print(name, hash);
    }
}

void PlayOwn() {
    for (int calls = 1; calls <= 4; ++calls) {
        b2World world(b2Vec2(0.0f, -10.0f));
        FillWithShots(world, 4, 3.0f);
        StepsOwn listener(&world, 1, calls);
        PlayOn(world, 60, "own");
    }
}

void PlayRound() {
    b2World one(b2Vec2(0.0f, -10.0f)), two(b2Vec2(0.0f, -10.0f));
    FillWithShots(one, 4, 3.0f);
    FillWithShots(two, 4, 2.0f);
    StepsOther there(&one, &two, 1, 3), back(&two, &one, 1, 3);
    PlayOn(one, 60, "round, one");
    PlayOn(two, 60, "round, two");
}

void PlayPairs() {
    b2World world(b2Vec2(0.0f, -10.0f));
    FillWithShots(world, 30, 3.0f);
    LooksForPairs listener(&world, 2, 1000000);
    PlayOn(world, 100, "pairs");
}

/// Calls `Midst` at every so many questions, but not in the midst of itself, and prints what it is asked.
class BreakingFilter : public b2ContactFilter {
public:
    BreakingFilter(b2World *world, int every) : m_world(world), m_every(every) {
        world->SetContactFilter(this);
    }
    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override {
        hash.Add(static_cast<uint32_t>(a->GetUserData().pointer));
        hash.Add(static_cast<uint32_t>(b->GetUserData().pointer));
        if (!m_inside && ++m_asked % m_every == 0) {
            m_inside = true;
            Midst();
            m_inside = false;
        }
        return true;
    }
    virtual void Midst() = 0;

    Hash hash;

protected:
    b2World *m_world;

private:
    int m_every, m_asked = 0;
    bool m_inside = false;
};

class FilterSteps : public BreakingFilter {
public:
    using BreakingFilter::BreakingFilter;
    void Midst() override { m_world->Step(1.0f / 60.0f, 2, 2); }
};

/// Contacts end with the proxies of a body that is put out of the world for a moment: each time another's.
class FilterEnds : public BreakingFilter {
public:
    using BreakingFilter::BreakingFilter;
    void Midst() override {
        if (m_world->IsLocked())
            return;
        const int32 number = 7 * ++m_times % m_world->GetBodyCount();
        b2Body *body = m_world->GetBodyList();
        for (int32 i = 0; i < number; ++i)
            body = body->GetNext();
        body->SetEnabled(false);
        body->SetEnabled(true);
    }

private:
    int m_times = 0;
};

/// Heaps of bodies of three boxes each; every twenty steps, more fall on them.
template <typename Filter> void PlayFiltered(const char *name, int every) {
    b2World world(b2Vec2(0.0f, -10.0f));
    Filter filter(&world, every);
    AddBox(world, b2_staticBody, {0.0f, 0.0f}, {20.0f, 0.2f}, 0.0f);
    uintptr_t made = 0;
    for (int round = 0; round < 4; ++round) {
        for (int i = 0; i < 25; ++i) {
            const float x = static_cast<float>(i % 9) - 4.0f, y = 0.4f * static_cast<float>(i % 5);
            b2Body *body = AddBox(world, b2_dynamicBody, {0.9f * x, 0.6f + y}, {0.4f, 0.1f}, 0.4f * x);
            for (const float side : {-0.3f, 0.3f}) {
                b2PolygonShape foot;
                foot.SetAsBox(0.1f, 0.3f, {side, 0.1f}, side);
                body->CreateFixture(&foot, 1.0f);
            }
            for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
                f->GetUserData().pointer = ++made;
        }
        // Whoever came later looks through its contacts: this one has many.
        AddBox(world, b2_staticBody, {0.0f, 3.0f}, {6.0f, 3.0f}, 0.0f, true);
        PlayOn(world, 20, name);
    }
    Print(name, filter.hash);
}

ucontext_t places[2], outside;
int running = 0;
bool over[2] = {false, false};

void Yield() {
    const int mine = running, other = 1 - mine;
    if (over[other])
        return;
    running = other;
    swapcontext(&places[mine], &places[other]);
}

class Yields : public Breaker {
public:
    using Breaker::Breaker;
    void Midst() override { Yield(); }
};

void PlayFiber(int which) {
    {
        b2World world(b2Vec2(0.0f, -10.0f));
        FillWithShots(world, 30, 3.0f + static_cast<float>(which));
        Yields listener(&world, 3 + which, 1000000);
        PlayOn(world, 100, which == 0 ? "first fiber" : "second fiber");
    }
    over[which] = true;
    running = 1 - which;
    setcontext(over[running] ? &outside : &places[running]);
}

void PlayFibers() {
    static char stacks[2][1 << 19];
    for (int i = 0; i < 2; ++i) {
        getcontext(&places[i]);
        places[i].uc_stack.ss_sp = stacks[i];
        places[i].uc_stack.ss_size = sizeof stacks[i];
        makecontext(&places[i], reinterpret_cast<void (*)()>(PlayFiber), 1, i);
    }
    swapcontext(&outside, &places[0]);
}

void *PlaySmall(void *world) {
    Hash hash;
    Step(*static_cast<b2World *>(world), 100, &hash);
    Print("small", hash);
    return nullptr;
}

int PlayOnSmallStack() {
    b2World world(b2Vec2(0.0f, -10.0f));
    FillWithShots(world, 30, 3.0f);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_t thread;
    const bool made = pthread_attr_setstacksize(&attributes, 16 * 1024) == 0 &&
                      pthread_create(&thread, &attributes, PlaySmall, &world) == 0;
    if (made)
        pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    return made ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
    const std::string what = argc == 2 ? argv[1] : "";
    if (what == "own")
        PlayOwn();
    else if (what == "round")
        PlayRound();
    else if (what == "pairs")
        PlayPairs();
    else if (what == "fibers")
        PlayFibers();
    else if (what == "filters")
        PlayFiltered<FilterSteps>("filters", 40);
    else if (what == "ending")
        PlayFiltered<FilterEnds>("ending", 5);
    else
        return what == "small" ? PlayOnSmallStack() : 2;
    return 0;
}
