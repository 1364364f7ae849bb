// SPDX-License-Identifier: MIT
// Worlds that are stepped in the midst of a step. (A step of no time unlocks the world that is being stepped:
// from then on Box2D allows in a callback whatever may be done between steps.)
#include <pthread.h>
#include <ucontext.h>

#include "as_stock.h"

using namespace as_stock;

namespace {

/// A plank, and bullets and boxes that fall on it at once.
void AddShots(Game &game, int shots, float height) {
    game.Wall({0.0f, 0.0f}, {10.0f, 0.1f});
    for (int i = 0; i < shots; ++i) {
        b2Body *shot = game.Box({-8.0f + 0.5f * Real(i), height + Real(i % 7)}, {0.2f, 0.2f}, 0.2f * Real(i));
        shot->SetBullet(i % 2 == 1);
        shot->SetLinearVelocity({3.0f * Real(i % 5), -100.0f});
    }
}

/// `what` is done at every so many calls, so many times.
template <typename What> auto Every(int every, int times, What what) {
    return [=, count = 0]() mutable {
        if (++count % every == 0 && count <= every * times)
            what();
    };
}
constexpr int kAlways = 1000000;

/// A long bar, apart from a box above it, whose contact is the oldest; then, turn by turn, pairs that touch,
/// and boxes apart from the bar below it.
struct Bar : Game {
    static constexpr float kGap = 0.12f;
    explicit Bar(Run &run) : Game(run) {
        bar = Awake({0.0f, 0.0f}, {40.0f, 0.1f});
        Awake({0.0f, 0.2f + kGap}, {0.1f, 0.1f});
        Step();
        for (int i = -12; i < 12; ++i) {
            Leaning({4.5f * Real(i), 60.0f});
            for (const float side : {-0.3f, 0.3f})
                Awake({3.0f * Real(i) + side, -0.2f - kGap}, {0.1f, 0.1f});
            Step();
        }
        Step(10);
        Listen();
    }
    b2Body *bar;
};

} // namespace

AS_STOCK("own: a listener steps its own world") {
    for (int calls = 1; calls <= 4; ++calls) {
        Game game(run, {0.0f, -10.0f});
        AddShots(game, 4, 3.0f);
        game.Listen();
        game.listener.begin = Every(1, calls, [&game] { game.StepWithin(1.0f / 60.0f, 2); });
        game.Step(60);
    }
}

// Without a search for impacts Box2D leaves its marks at the contacts until the next step.
AS_STOCK("another world: a listener makes the first step of a world of many contacts, which then goes on by "
         "itself") {
    Game outer(run), inner(run);
    inner.world.SetContinuousPhysics(false);
    for (int i = 0; i < 60; ++i)
        inner.Leaning({3.0f * Real(i), 0.0f});
    inner.Listen();
    outer.Leaning({0.0f, 0.0f});
    outer.Listen();
    int within = 0, solved = 0;
    outer.listener.begin = [&inner, &within] {
        ++within;
        inner.world.Step(1.0f / 60.0f, 8, 3);
    };
    outer.Step();
    inner.listener.postSolve = [&solved] { ++solved; };
    inner.Step(20);
    outer.TookPlace(within, "a listener steps another world");
    inner.TookPlace(solved, "its contacts are solved afterwards");
}

/// Box2D calls nothing more of a contact after its PreSolve, nor after a sensor's BeginContact.
AS_STOCK("ended: a listener ends the very contact that it is called for") {
    for (const bool ofSensors : {true, false}) {
        Bar game(run);
        b2PolygonShape square;
        square.SetAsBox(0.5f, 0.5f);
        for (int i = -12; i < 12; ++i) {
            game.Fixture(game.Body(b2_dynamicBody, {4.5f * Real(i), 80.0f}), square, true);
            game.Awake({4.5f * Real(i) + 0.3f, 80.0f});
            game.Leaning({4.5f * Real(i), 90.0f});
        }
        int ended = 0, calls = 0;
        auto &called = ofSensors ? game.listener.begin : game.listener.preSolve;
        called = [&](b2Contact *contact) {
            const bool isSensor = contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor();
            if (isSensor != ofSensors || ++calls % 3 != 0)
                return;
            run.BreaksRules();
            ++ended;
            const_cast<b2ContactManager &>(game.world.GetContactManager()).Destroy(contact);
        };
        game.Step(20);
        game.TookPlace(ended, "a contact ends in its own call");
    }
}

namespace {

ucontext_t places[2], outside;
int running = 0, yielded = 0;
bool over[2] = {false, false};
Run *runOfFibers = nullptr;

void Yield() {
    const int mine = running, other = 1 - mine;
    if (over[other])
        return;
    ++yielded;
    running = other;
    swapcontext(&places[mine], &places[other]);
}

void PlayFiber(int which) {
    {
        Game game(*runOfFibers, {0.0f, -10.0f});
        AddShots(game, 30, 3.0f + Real(which));
        game.Listen();
        game.listener.begin = Every(3 + which, kAlways, Yield);
        game.Step(100);
    }
    over[which] = true;
    running = 1 - which;
    setcontext(over[running] ? &outside : &places[running]);
}

} // namespace

AS_STOCK("fibers: a listener leaves one step for another on a second stack, and the later one need not end "
         "first") {
    static char stacks[2][1 << 19];
    runOfFibers = &run;
    for (int i = 0; i < 2; ++i) {
        getcontext(&places[i]);
        places[i].uc_stack.ss_sp = stacks[i];
        places[i].uc_stack.ss_size = sizeof stacks[i];
        makecontext(&places[i], reinterpret_cast<void (*)()>(PlayFiber), 1, i);
    }
    swapcontext(&outside, &places[0]);
    run.Stage(yielded > 0, "a step is left for another");
}

#if defined(IN_CHILD_ASAN)
constexpr size_t kSmallStack = 256 * 1024; // the sanitizer's redzones take room
#else
constexpr size_t kSmallStack = 16 * 1024;
#endif

AS_STOCK("small: a thread with a stack of 16 KiB steps") {
    Game game(run, {0.0f, -10.0f});
    AddShots(game, 30, 3.0f);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_t thread;
    const auto step = [](void *on) -> void * {
        Game &small = *static_cast<Game *>(on);
        for (int i = 0; i < 100; ++i) {
            small.world.Step(1.0f / 60.0f, 8, 3);
            small.hash.Add(small.world);
        }
        return nullptr;
    };
    if (pthread_attr_setstacksize(&attributes, kSmallStack) != 0 ||
        pthread_create(&thread, &attributes, step, &game) != 0)
        run.Print("!no thread");
    else
        pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    game.WriteDown();
    game.TookPlace(game.world.GetContactCount(), "the thread's steps make contacts");
}

AS_STOCK("thrown: a body's shape is changed again and again, and each time an exception ends a step in the "
         "midst of a step") {
    struct Thrown {};
    for (const int calls : {4, 18, 24}) {
        Bar game(run);
        int call = 0;
        const auto size = [&game](float half) { PolygonOf(game.bar)->SetAsBox(40.0f, half); };
        std::function<void()> outer = [&] {
            if (++call > calls)
                return;
            size(call == calls ? 0.1f + Bar::kGap : call % 2 == 0 ? 0.1f : 0.095f);
            if (call == calls)
                return;
            game.listener.preSolve = [] { throw Thrown(); };
            try {
                game.StepWithin();
            } catch (const Thrown &) {
            }
            game.listener.preSolve = outer;
        };
        game.listener.preSolve = outer;
        game.Step();
        game.listener.preSolve = nullptr;
        game.Step(2);
    }
}

// The table counts each change of a shape as a long motion, until its sums wrap. The loop over contacts
// passed the newest pair before the listener changed anything.
AS_STOCK(
    "grown: a body's shape is changed again and again in one loop over contacts, until it touches others") {
    for (const int calls : {4, 18, 24}) {
        Bar game(run);
        game.world.SetContinuousPhysics(calls != 24); // a search for impacts asks for sums, too
        const b2Body *const newest = game.Awake({38.0f, 0.2f + Bar::kGap}, {0.1f, 0.1f});
        game.Step(2);
        int call = 0;
        game.listener.preSolve = [&] {
            if (++call <= calls)
                PolygonOf(game.bar)->SetAsBox(40.0f, call == calls   ? 0.1f + Bar::kGap
                                                     : call % 2 == 0 ? 0.1f
                                                                     : 0.095f);
        };
        game.Step();
        game.listener.preSolve = nullptr;
        game.Step();
        game.TookPlace(newest->GetContactList()->contact->IsTouching(), "the bar touches boxes");
        game.Step(2);
    }
}

// Islands to come hold joints with bodies that are made where others were, which touched.
AS_STOCK(
    "gone: PostSolve steps its world, and destroys bodies that touch; the next one makes others, and ties "
    "them to what is in islands to come") {
    Game game(run);
    std::vector<b2Body *> gone, kept;
    for (int i = 0; i < 80; ++i)
        game.Near({3.0f * Real(i), 50.0f});
    for (int i = 0; i < 10; ++i)
        kept.push_back(game.Awake({4.0f * Real(i), 20.0f}));
    game.Tie(game.Awake({0.0f, 30.0f}), game.Awake({9.0f, 30.0f})); // Box2D has room for as many joints
    for (int i = 0; i < 10; ++i)
        for (const float x : {0.0f, 0.995f})
            gone.push_back(game.Awake({4.0f * Real(i) + x, 0.0f}));
    for (int i = 0; i < 2; ++i)
        game.Leaning({4.0f * Real(i), 90.0f}); // in the first two islands
    game.Step(5);
    game.Listen();
    game.listener.postSolve.Once([&] {
        game.StepWithin();
        for (b2Body *body : gone)
            game.world.DestroyBody(body);
        game.listener.postSolve.Once([&] {
            for (b2Body *body : kept)
                game.Tie(game.Body(b2_dynamicBody, {0.0f, 40.0f}), body);
        });
    });
    const int bodies = game.world.GetBodyCount();
    game.Step();
    game.TookPlace(bodies - game.world.GetBodyCount(), "bodies are destroyed");
    for (int i = 0; i < 40; ++i)
        game.Awake({4.0f * Real(i), 10.0f});
    game.Step(5);
}
