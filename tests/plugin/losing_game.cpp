// SPDX-License-Identifier: MIT
//
//   losing_game sums|thrown|resumed|numbers|returning|proxies|twice|rounded|disabled|filters|islands
//
// Worlds in which whoever remembers pairs of fixtures may lose track of them. Prints a line for each step, or
// for a few of them: a hash of all bodies and contacts. A plain program of Box2D's: with the plugin preloaded
// it prints the same.
//
//   sums       a listener moves one body far away and back again and again, in the midst of one loop over
//              contacts, and then onto another one
//   thrown     a listener changes one body's shape again and again, and each time begins a step that another
//              listener's exception ends
//   resumed    a shape is changed between steps; a listener steps the world when the loop over contacts has
//              seen that, and has not come by its contacts
//   numbers    a listener steps the world while a contact ends, when most contacts have ended before
//   returning  a filter puts a body out of the world that is about to get contacts; it comes back with them
//   proxies    a body is put out of the world; while its contacts end, another one gets its places in the
//              tree
//   twice      a filter steps the world while it is asked about a new pair, which so gets two contacts; one
//              of them ends
//   rounded    a listener rounds otherwise for the steps that it makes in the midst of a step
//   disabled   contacts are disabled whose bodies sleep, and are woken when the loop has passed the contacts
//   filters    a filter puts to sleep, wakes, moves, changes and ends those that it is asked about
//   islands    a listener steps the world from PostSolve, while Box2D builds its islands
#include <cfenv>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "small_world.h"

namespace {

/// What is to happen in a callback; never in one within it.
class Listener final : public b2ContactListener {
public:
    std::function<void()> preSolve, postSolve, end, inner;
    void PreSolve(b2Contact *, const b2Manifold *) override { Call(preSolve); }
    void PostSolve(b2Contact *, const b2ContactImpulse *) override { Call(postSolve); }
    void EndContact(b2Contact *) override { Call(end); }

private:
    void Call(const std::function<void()> &what) {
        if (!what)
            return;
        if (m_inside) {
            if (inner)
                inner();
            return;
        }
        m_inside = true;
        what();
        m_inside = false;
    }
    bool m_inside = false;
};

b2Body *AddAwake(b2World &world, b2Vec2 at, b2Vec2 half) {
    b2Body *body = AddBox(world, b2_dynamicBody, at, half, 0.0f);
    body->SetSleepingAllowed(false);
    return body;
}

/// Two boxes that touch and rest: their contact has a PreSolve in every step.
void AddTouching(b2World &world, b2Vec2 at) {
    AddAwake(world, at, {0.5f, 0.5f});
    AddAwake(world, {at.x + 0.995f, at.y}, {0.5f, 0.5f});
}

void PlayOn(b2World &world, int steps, const char *name, Hash *hash) {
    for (int i = 0; i < steps; ++i) {
        Step(world, 1, hash);
        Print(name, *hash);
    }
}

/// A long bar, apart from a box above it, whose contact is the oldest; then, turn by turn, pairs that touch,
/// and boxes apart from the bar below it.
struct BarAndPairs {
    static constexpr int kPairs = 24;
    static constexpr float kGap = 0.12f;
    b2World world{b2Vec2(0.0f, 0.0f)};
    Listener listener;
    b2Body *bar, *above;
    Hash hash;

    BarAndPairs() {
        bar = AddAwake(world, {0.0f, 0.0f}, {40.0f, 0.1f});
        above = AddAwake(world, {0.0f, 0.2f + kGap}, {0.1f, 0.1f});
        Step(world, 1, &hash);
        for (int i = 0; i < kPairs; ++i) {
            const float x = 1.5f * static_cast<float>(i - kPairs / 2);
            AddTouching(world, {3.0f * x, 60.0f});
            for (const float side : {-0.3f, 0.3f})
                AddAwake(world, {2.0f * x + side, -0.2f - kGap}, {0.1f, 0.1f});
            Step(world, 1, &hash);
        }
        Step(world, 10, &hash);
        Print("built", hash);
        world.SetContactListener(&listener);
    }
};

/// Each time the bar is home again, in another fat box. A step of no time unlocks the world.
void PlaySums() {
    for (const int calls : {4, 10, 18, 24}) {
        BarAndPairs game;
        int told = 0;
        game.listener.preSolve = [&game, &told, calls] {
            if (++told == 1) {
                game.world.Step(0.0f, 1, 1);
            } else if (told < calls) {
                game.bar->SetTransform({1000.0f, 0.0f}, 0.0f);
                game.bar->SetTransform({0.0f, told % 2 == 0 ? 0.03f : -0.03f}, 0.0f);
                game.bar->SetTransform({0.0f, 0.0f}, 0.0f);
            } else if (told == calls) {
                game.bar->SetTransform({0.0f, BarAndPairs::kGap + 0.01f}, 0.0f);
            }
        };
        PlayOn(game.world, 3, "sums", &game.hash);
    }
}

struct Told {};

void PlayThrown() {
    for (const int calls : {4, 18, 24}) {
        BarAndPairs game;
        int told = 0;
        const auto sizeBar = [&game](float half) {
            static_cast<b2PolygonShape *>(game.bar->GetFixtureList()->GetShape())->SetAsBox(40.0f, half);
        };
        game.listener.preSolve = [&game, &told, &sizeBar, calls] {
            if (++told > calls)
                return;
            sizeBar(told == calls ? 0.1f + BarAndPairs::kGap : told % 2 == 0 ? 0.1f : 0.095f);
            if (told == calls)
                return;
            try {
                game.world.Step(0.0f, 1, 1);
            } catch (const Told &) {
            }
        };
        game.listener.inner = [] { throw Told(); };
        PlayOn(game.world, 1, "thrown", &game.hash);
        game.listener.preSolve = nullptr;
        PlayOn(game.world, 2, "thrown", &game.hash);
    }
}

void PlayResumed() {
    BarAndPairs game;
    bool stepped = false;
    game.listener.preSolve = [&game, &stepped] {
        if (!stepped)
            game.world.Step(0.0f, 1, 1);
        stepped = true;
    };
    static_cast<b2PolygonShape *>(game.bar->GetFixtureList()->GetShape())
        ->SetAsBox(40.0f, 0.1f + BarAndPairs::kGap);
    PlayOn(game.world, 3, "resumed", &game.hash);
}

/// Two boxes near each other, but for `gap`.
void AddNear(b2World &world, b2Vec2 at, float gap) {
    AddAwake(world, at, {0.4f, 0.4f});
    AddAwake(world, {at.x + 0.8f + gap, at.y}, {0.4f, 0.4f});
}

/// The newest contact ends by a change of type. What its listener's step does to the records of all others
/// must not touch its own: or the next contact, which gets its place in memory, is taken for it.
void PlayNumbers() {
    b2World world(b2Vec2(0.0f, 0.0f));
    Hash hash;
    std::vector<b2Body *> many;
    for (int i = 0; i < 12; ++i)
        AddNear(world, {3.0f * static_cast<float>(i), 20.0f}, 0.1f);
    for (int i = 0; i < 250; ++i) {
        AddNear(world, {3.0f * static_cast<float>(i), 0.0f}, 0.1f);
        many.push_back(world.GetBodyList());
    }
    b2Body *left = AddAwake(world, {-50.0f, 0.0f}, {0.3f, 0.3f}),
           *right = AddAwake(world, {-55.0f, 0.0f}, {0.3f, 0.3f});
    AddBox(world, b2_staticBody, {-90.0f, 0.0f}, {0.5f, 0.5f}, 0.0f);
    Step(world, 10, &hash);
    b2Body *turned = AddAwake(world, {-90.995f, 0.0f}, {0.5f, 0.5f}); // its contact is the newest
    Step(world, 3, &hash);
    Print("numbers", hash);
    for (b2Body *body : many)
        world.DestroyBody(body);
    Listener listener;
    world.SetContactListener(&listener);
    listener.end = [&world] { world.Step(0.0f, 1, 1); };
    turned->SetType(b2_kinematicBody);
    listener.end = nullptr;
    turned->SetTransform({-93.0f, 0.0f}, 0.0f);
    right->SetTransform({-50.75f, 0.0f}, 0.0f); // a new contact, apart
    PlayOn(world, 5, "numbers", &hash);
    right->SetLinearVelocity({1.0f, 0.0f});
    left->SetLinearVelocity({-1.0f, 0.0f});
    PlayOn(world, 20, "numbers", &hash);
}

/// The floor is a long bar aslant. What comes lies in the corner of its box, metres away from the bar itself.
void PlayReturning() {
    b2World world(b2Vec2(0.0f, 0.0f));
    PutsOut filter;
    world.SetContactFilter(&filter);
    Hash hash;
    for (int i = 0; i < 60; ++i)
        AddNear(world, {3.0f * static_cast<float>(i), 50.0f}, 0.1f);
    AddBox(world, b2_staticBody, {0.0f, 0.0f}, {10.0f, 0.1f}, 0.25f * b2_pi);
    Step(world, 3, &hash);
    for (int round = 0; round < 4; ++round) {
        b2Body *wheel = AddWheel(world, {5.0f, -5.0f}, 7, 0.4f);
        wheel->SetSleepingAllowed(false);
        filter.victim = wheel;
        PlayOn(world, 1, "out", &hash);
        wheel->SetEnabled(true);
        if (round % 2 == 0) // what was there is not to be made once more
            PlayOn(world, 1, "back, asleep", &hash);
        wheel->SetAwake(true);
        PlayOn(world, 3, "back", &hash);
        wheel->SetLinearVelocity({6.0f, 0.0f}); // out of the bar's box
        PlayOn(world, 30, "away", &hash);
        world.DestroyBody(wheel);
    }
}

/// Nobody may take a contact that is about to end for that of the one that came later.
void PlayProxies() {
    for (const bool again : {false, true}) {
        b2World world(b2Vec2(0.0f, 0.0f));
        Listener listener;
        Hash hash;
        for (int i = 0; i < 60; ++i)
            AddNear(world, {3.0f * static_cast<float>(i), 50.0f}, 0.1f);
        // In the box of the bar, and on a post that came later.
        AddBox(world, b2_staticBody, {0.0f, 0.0f}, {10.0f, 0.1f}, 0.25f * b2_pi);
        b2Body *out = AddBox(world, b2_dynamicBody, {5.0f, -5.0f}, {0.5f, 0.5f}, 0.0f);
        Step(world, 3, &hash);
        AddBox(world, b2_staticBody, {5.995f, -5.0f}, {0.5f, 0.5f}, 0.0f);
        Step(world, 3, &hash);
        out->SetAwake(false);
        world.SetContactListener(&listener);
        b2Body *come = nullptr;
        listener.end = [&world, &come] {
            if (come != nullptr)
                return;
            come = AddAwake(world, {3.0f, -5.0f}, {0.3f, 0.3f});
            world.Step(0.0f, 1, 1);
        };
        out->SetEnabled(false);
        PlayOn(world, 3, "out", &hash);
        if (again) {
            out->SetEnabled(true);
            PlayOn(world, 3, "back", &hash);
        }
        for (int i = 0; i < 20; ++i) {
            come->SetTransform({3.0f - 0.3f * static_cast<float>(i), -5.0f}, 0.0f);
            PlayOn(world, 1, "moved", &hash);
        }
    }
}

/// Answers yes unless it refuses, but not before `before` was done to the two.
class Meddler final : public b2ContactFilter {
public:
    std::function<void(b2Body *, b2Body *)> before;
    bool refuses = false;
    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override {
        if (before && !m_inside) {
            m_inside = true;
            before(a->GetBody(), b->GetBody());
            m_inside = false;
        }
        return !refuses && b2ContactFilter::ShouldCollide(a, b);
    }

private:
    bool m_inside = false;
};

/// `which`: of the two contacts of a pair, the one that is refused later, as they are asked for.
void PlayTwice(int which) {
    b2World world(b2Vec2(0.0f, 0.0f));
    Meddler filter;
    Hash hash;
    for (int i = 0; i < 60; ++i)
        AddNear(world, {3.0f * static_cast<float>(i), 50.0f}, 0.1f);
    Step(world, 3, &hash);
    world.SetContactFilter(&filter);
    AddNear(world, {0.0f, 0.0f}, 0.1f);
    b2Body *const near = world.GetBodyList();
    filter.before = [&world](b2Body *, b2Body *) { world.Step(0.0f, 1, 1); };
    PlayOn(world, 1, "made", &hash);
    std::printf("%d contacts\n", static_cast<int>(world.GetContactCount()));
    int asked = 0;
    filter.before = [&](b2Body *, b2Body *) { filter.refuses = asked++ == which; };
    near->GetFixtureList()->Refilter();
    PlayOn(world, 1, "refused", &hash);
    filter.before = nullptr;
    filter.refuses = false;
    std::printf("%d contacts\n", static_cast<int>(world.GetContactCount()));
    for (int i = 0; i < 4; ++i) {
        const b2Vec2 home = near->GetPosition();
        near->SetTransform({900.0f, 0.0f}, 0.0f);
        near->SetTransform({home.x - 0.01f, home.y}, 0.0f); // its box is a new one, and searched about
        PlayOn(world, 1, "moved", &hash);
        std::printf("%d contacts\n", static_cast<int>(world.GetContactCount()));
    }
}

/// The oldest pair touches. By the time that its turn comes, the loop has passed pairs that fly at each
/// other, and that come to touch in the steps that its listener makes then.
void PlayRounded() {
    b2World world(b2Vec2(0.0f, 0.0f));
    Listener listener;
    Hash hash;
    AddTouching(world, {0.0f, 50.0f});
    Step(world, 1, &hash);
    for (int i = 0; i < 60; ++i) {
        AddNear(world, {3.0f * static_cast<float>(i), 0.0f}, 0.15f);
        if (i % 4 == 0)
            world.GetBodyList()->SetLinearVelocity({-0.6f - 0.1f * static_cast<float>(i), 0.1f});
    }
    Step(world, 1, &hash);
    world.SetContactListener(&listener);
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_TOWARDZERO}) {
        listener.preSolve = [&world, mode] {
            std::fesetround(mode);
            world.Step(1.0f / 60.0f, 2, 2);
            world.Step(1.0f / 60.0f, 2, 2);
            std::fesetround(FE_TONEAREST);
        };
        PlayOn(world, 1, "rounded", &hash);
        listener.preSolve = nullptr;
        PlayOn(world, 2, "nearest", &hash);
    }
}

/// Box2D enables what it updates, and that is nothing that sleeps when its turn comes. Nobody listens, but
/// somebody filters.
void PlayDisabled() {
    b2World world(b2Vec2(0.0f, 0.0f));
    b2ContactFilter filter;
    world.SetContactFilter(&filter);
    Hash hash;
    std::vector<b2Body *> sleepers;
    for (int i = 0; i < 40; ++i) {
        const b2Vec2 at(4.0f * static_cast<float>(i), 0.0f);
        sleepers.push_back(AddBox(world, b2_dynamicBody, at, {0.5f, 0.5f}, 0.0f));
        AddAwake(world, {at.x - 1.1f, 0.0f}, {0.5f, 0.5f})
            ->SetLinearVelocity({0.3f + 0.05f * static_cast<float>(i), 0.0f});
    }
    Step(world, 1, &hash); // who comes has the older contact
    for (int i = 0; i < 40; ++i)
        sleepers.push_back(
            AddBox(world, b2_dynamicBody, {4.0f * static_cast<float>(i) + 0.995f, 0.0f}, {0.5f, 0.5f}, 0.0f));
    Step(world, 1, &hash);
    for (b2Body *body : sleepers) {
        body->SetLinearVelocity({0.0f, 0.0f});
        body->SetAwake(false);
    }
    for (int step = 0; step < 20; ++step) {
        for (b2Contact *contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext())
            if (contact->IsTouching())
                contact->SetEnabled(false);
        PlayOn(world, 1, "disabled", &hash);
    }
}

/// Pairs of boxes, of which every fifth touches, and one box of each.
struct FilteredPairs {
    b2World world{b2Vec2(0.0f, 0.0f)};
    Meddler filter;
    Hash hash;
    std::vector<b2Body *> ones;

    FilteredPairs() {
        for (int i = 0; i < 60; ++i) {
            AddNear(world, {3.0f * static_cast<float>(i), 0.0f}, i % 5 == 0 ? -0.005f : 0.1f);
            ones.push_back(world.GetBodyList());
        }
        world.SetContactFilter(&filter);
        Step(world, 10, &hash);
    }
};

/// `locked`: while the loop goes over contacts. Else a step of no time has unlocked the world.
void PlayFilters(bool locked) {
    enum What { kSleep, kWake, kThrow, kGrow, kTurnSensor, kMoveOnto, kMoveAway, kCount };
    for (int what = 0; what < (locked ? kMoveOnto : kCount); ++what) {
        FilteredPairs game;
        b2World &world = game.world;
        Meddler &filter = game.filter;
        Hash &hash = game.hash;
        const std::vector<b2Body *> &ones = game.ones;
        bool first = true;
        int times = 0;
        filter.before = [&](b2Body *a, b2Body *b) {
            if (!locked && first) {
                first = false;
                world.Step(0.0f, 1, 1); // asks for all of them
                for (b2Body *body : ones)
                    body->GetFixtureList()->Refilter();
            }
            if (++times % 3 == 0)
                return;
            switch (what) {
            case kSleep:
                a->SetAwake(false);
                b->SetAwake(false);
                break;
            case kWake:
                a->SetAwake(true);
                break;
            case kThrow:
                b->SetLinearVelocity({-3.0f, 0.0f});
                b->SetBullet(true);
                break;
            case kGrow:
                static_cast<b2PolygonShape *>(b->GetFixtureList()->GetShape())->SetAsBox(0.55f, 0.4f);
                break;
            case kTurnSensor:
                b->GetFixtureList()->SetSensor(!b->GetFixtureList()->IsSensor());
                break;
            case kMoveOnto:
                b->SetTransform(0.3f * a->GetPosition() + 0.7f * b->GetPosition(), 0.1f);
                break;
            default:
                b->SetTransform(b->GetPosition() + b2Vec2(0.0f, 9.0f), 0.0f);
            }
        };
        for (int step = 0; step < 6; ++step) {
            for (size_t i = static_cast<size_t>(step) % 2; i < ones.size(); i += 2) {
                if (what == kWake && i % 4 == 0)
                    for (b2ContactEdge *edge = ones[i]->GetContactList(); edge != nullptr;
                         edge = edge->next) {
                        edge->other->SetAwake(false);
                        ones[i]->SetAwake(false);
                    }
                ones[i]->GetFixtureList()->Refilter();
            }
            first = true;
            PlayOn(world, 1, locked ? "filters" : "filters, unlocked", &hash);
        }
        filter.before = nullptr;
        PlayOn(world, 3, "filters, on", &hash);
    }
}

/// The outer step goes on to build islands by the flags that the inner one left at contacts and bodies.
void PlayIslands() {
    b2World world(b2Vec2(0.0f, 0.0f));
    Listener listener;
    Hash hash;
    world.SetContactListener(&listener);
    for (int i = 0; i < 90; ++i) // neighbours whose boxes overlap, and that do not touch
        AddAwake(world, {1.08f * static_cast<float>(i % 10), 1.08f * static_cast<float>(i / 10)},
                 {0.5f, 0.5f});
    for (int i = 0; i < 30; ++i) { // pairs that lean on each other
        b2Body *const body =
            AddAwake(world, {40.0f + 0.99f * static_cast<float>(i % 2), 1.5f * static_cast<float>(i / 2)},
                     {0.5f, 0.5f});
        body->SetLinearVelocity({i % 2 == 0 ? 0.3f : -0.3f, 0.01f * static_cast<float>(i)});
    }
    for (int round = 0; round < 6; ++round) {
        int solved = 0;
        listener.postSolve = [&world, &solved] {
            if (solved++ == 3)
                world.Step(1.0f / 120.0f, 2, 1);
        };
        PlayOn(world, 1, "islands", &hash);
        listener.postSolve = nullptr;
        PlayOn(world, 15, "islands, on", &hash);
    }
}

/// In the midst of a look at a contact, which finds it apart, it is flagged for filtering; or, when a step of
/// no time has unlocked the world, it ends with its two bodies.
void PlayParted(bool ends) {
    b2World world(b2Vec2(0.0f, 0.0f));
    Meddler filter;
    Listener listener;
    Hash hash;
    for (int i = 0; i < 60; ++i)
        AddNear(world, {3.0f * static_cast<float>(i), 0.0f}, i == 59 ? -0.005f : 0.1f);
    b2Body *const one = world.GetBodyList(), *const other = one->GetNext();
    world.SetContactFilter(&filter);
    world.SetContactListener(&listener);
    Step(world, 10, &hash);
    listener.end = [&world, one, other, ends] {
        if (!ends) {
            one->GetFixtureList()->Refilter();
            return;
        }
        world.Step(0.0f, 1, 1);
        world.DestroyBody(one);
        world.DestroyBody(other);
    };
    filter.refuses = true;
    one->SetTransform(one->GetPosition() + b2Vec2(0.12f, 0.0f), 0.0f);
    PlayOn(world, 4, "parted", &hash);
}

/// A filter makes the two static that it is asked about, which ends their contact, and lets them collide.
/// Box2D goes on with the contact, whose memory is as it was, and finds that nobody moves.
void PlayEnded() {
    FilteredPairs game;
    b2World &world = game.world;
    Meddler &filter = game.filter;
    Hash &hash = game.hash;
    const std::vector<b2Body *> &ones = game.ones;
    int asked = 0;
    filter.before = [&world, &ones, &asked](b2Body *a, b2Body *b) {
        if (asked++ == 0) {
            world.Step(0.0f, 1, 1); // unlocks it, and asks for all of them
            for (b2Body *body : ones)
                body->GetFixtureList()->Refilter();
        }
        if (asked % 3 != 0 || world.IsLocked())
            return;
        a->SetType(b2_staticBody);
        b->SetType(b2_staticBody);
    };
    for (int step = 0; step < 4; ++step) {
        for (size_t i = static_cast<size_t>(step) % 2; i < ones.size(); i += 2)
            ones[i]->GetFixtureList()->Refilter();
        asked = 0;
        PlayOn(world, 2, "ended", &hash);
    }
    filter.before = nullptr;
    for (int i = 0; i < 40; ++i) // others in their place
        AddNear(world, {3.0f * static_cast<float>(i), 9.0f}, 0.1f);
    Step(world, 2, &hash);
    for (b2Body *body : ones)
        body->SetLinearVelocity({-1.5f, 0.0f});
    PlayOn(world, 10, "ended, on", &hash);
}

} // namespace

int main(int argc, char **argv) {
    const std::string what = argc == 2 ? argv[1] : "";
    if (what == "sums") {
        PlaySums();
    } else if (what == "thrown") {
        PlayThrown();
    } else if (what == "resumed") {
        PlayResumed();
    } else if (what == "numbers") {
        PlayNumbers();
    } else if (what == "returning") {
        PlayReturning();
    } else if (what == "proxies") {
        PlayProxies();
    } else if (what == "twice") {
        PlayTwice(0);
        PlayTwice(1);
    } else if (what == "rounded") {
        PlayRounded();
    } else if (what == "disabled") {
        PlayDisabled();
    } else if (what == "filters") {
        PlayFilters(true);
        PlayFilters(false);
        PlayParted(false);
        PlayParted(true);
        PlayEnded();
    } else if (what == "islands") {
        PlayIslands();
    } else {
        std::fputs("usage: losing_game "
                   "sums|thrown|resumed|numbers|returning|proxies|twice|rounded|disabled|filters|islands\n",
                   stderr);
        return 2;
    }
    return 0;
}
