// SPDX-License-Identifier: MIT
// What a world's table remembers of pairs that are apart, seen from outside: updates that are spared, and
// taken up again when something changes; memory that is asked for when contacts begin, and given back. With
// the glue alone there is no table: there the same scenes show that nothing depends on it.
#include <new>

#include "as_stock.h"

using namespace as_stock;

namespace {

struct Updates {
    uint64_t watched, updates, renewals, impacts;
};

/// What the pairs of the game's world cost while `something` is done.
Updates Spent(const std::function<void()> &something) {
    const bmr::Counted before = bmr::internal::ReadCounts();
    something();
    const bmr::Counted after = bmr::internal::ReadCounts();
    return {after.pairs - before.pairs, after.updates - before.updates, after.renewals - before.renewals,
            after.toiAnswered - before.toiAnswered};
}

/// Slanted needles one beside the other, whose boxes overlap and who never meet: each glides along itself,
/// all at the same speed, or rests. No body pushes the first one, so that Box2D updates for impacts.
class Needles {
public:
    static constexpr int kCount = 12;
    explicit Needles(Run &run, float along = 0.0f) : game(run), m_run(run) {
        game.Listen();
        for (int i = 0; i < kCount; ++i) {
            needles.push_back(game.Body(i == 0 ? b2_kinematicBody : b2_dynamicBody, PlaceOf(i), kSlant));
            game.Box(needles[static_cast<size_t>(i)], 3.0f, 0.05f);
            needles[static_cast<size_t>(i)]->SetSleepingAllowed(false);
            needles[static_cast<size_t>(i)]->SetLinearVelocity(Slanted(along, 0.0f));
        }
        game.Step(8);
        game.Stage(game.world.GetContactCount() > 3 * kCount && game.Touching() == 0,
                   "many pairs, all apart");
    }
    static b2Vec2 PlaceOf(int i) { return Slanted(0.0f, 0.3f * Real(i)); }

    /// In `steps` steps the plugin updates at most one in `most` of the pairs.
    void ExpectQuiet(int steps, uint64_t most) {
        const Updates spent = Spent([&] { game.Step(steps); });
        m_run.ExpectCounted(spent.watched > 100 && spent.updates * most <= spent.watched &&
                                spent.impacts * most <= spent.watched,
                            "updates are spared, and times of impact");
    }
    /// After this the plugin updates the pairs of one needle, and no others.
    void ExpectUpdates(const std::function<void(b2Body *)> &change, const char *what) {
        b2Body *const needle = needles[kCount / 2];
        const Updates spent = Spent([&] {
            change(needle);
            game.Step();
        });
        uint64_t pairs = 0;
        for (const b2ContactEdge *edge = needle->GetContactList(); edge != nullptr; edge = edge->next)
            ++pairs;
        m_run.ExpectCounted(spent.updates + spent.renewals > 0 && spent.updates + spent.renewals <= pairs,
                            what);
        game.Step(40); // until proofs that were put off are sought again
    }

    Game game;
    std::vector<b2Body *> needles;

private:
    Run &m_run;
};

} // namespace

AS_STOCK("a pair that stays apart is not updated") {
    Needles(run).ExpectQuiet(60, 50);
    Needles(run, 0.2f).ExpectQuiet(60, 5);
}

AS_STOCK("updates are resumed after each kind of change, at the pairs that it concerns") {
    Needles world(run);
    world.game.Step(40);
    world.ExpectQuiet(10, 50);
    world.ExpectUpdates(
        [](b2Body *needle) { needle->SetTransform(needle->GetPosition() + Slanted(0.0f, 0.15f), kSlant); },
        "a body that was put elsewhere");
    world.ExpectUpdates([](b2Body *needle) { needle->SetTransform(needle->GetPosition(), kSlant + 0.05f); },
                        "a body that was turned");
    world.ExpectQuiet(10, 50);
    world.ExpectUpdates([](b2Body *needle) { PolygonOf(needle->GetFixtureList())->m_radius *= 1.5f; },
                        "a skin that was changed in place");
    world.ExpectUpdates([&](b2Body *needle) { PolygonOf(needle->GetFixtureList())->SetAsBox(2.9f, 0.05f); },
                        "vertices that were changed in place");
    world.ExpectQuiet(10, 50);
    world.ExpectUpdates([](b2Body *needle) { needle->GetFixtureList()->SetSensor(true); }, "a sensor");
    world.ExpectUpdates([](b2Body *needle) { needle->GetFixtureList()->SetSensor(false); }, "solid again");
    world.ExpectUpdates([](b2Body *needle) { needle->GetFixtureList()->Refilter(); }, "filtered anew");
    world.ExpectUpdates(
        [](b2Body *needle) {
            b2MassData mass;
            needle->GetMassData(&mass);
            mass.center.Set(0.5f, 0.0f);
            mass.I += mass.mass;
            needle->SetMassData(&mass);
        },
        "another centre of mass");
    world.ExpectQuiet(10, 50);
}

AS_STOCK("pairs of bodies that wake are updated, those of bodies that fall asleep no more") {
    Needles world(run);
    for (b2Body *needle : world.needles)
        needle->SetSleepingAllowed(true);
    world.game.Step(60);
    world.game.Stage(!world.needles[0]->IsAwake(), "all sleep");
    const Updates asleep = Spent([&] { world.game.Step(20); });
    run.ExpectCounted(asleep.updates == 0, "nobody updates at sleeping pairs");
    for (int i = 2; i < 8; i += 3) {
        world.needles[static_cast<size_t>(i)]->SetAwake(true);
        world.needles[static_cast<size_t>(i)]->SetLinearVelocity(Slanted(0.0f, 1.0f));
        world.game.Step(20);
    }
    world.game.Stage(world.game.Touching() > 0, "a collision");
    world.game.Step(60);
}

AS_STOCK("sleepers that were moved meet in the very step in which one of them is woken by a hit") {
    for (const int hits : {1, 4, 16}) {
        Game game(run); // a listener would have all pairs updated again
        std::vector<b2Body *> sleepers, moved, shots;
        for (int i = 0; i < 16; ++i) {
            const b2Vec2 place(6.0f * Real(i), 0.0f);
            sleepers.push_back(game.Box(place));
            moved.push_back(game.Box(place + b2Vec2(1.1f, 0.0f)));
        }
        game.Step(60);
        game.Stage(!sleepers[0]->IsAwake() && game.world.GetContactCount() >= 16, "pairs sleep, apart");
        for (const float there :
             {0.3f, -0.3f}) { // after each move the pair is due, and both of its bodies sleep
            for (b2Body *body : moved)
                body->SetTransform(body->GetPosition() + b2Vec2(0.0f, there), 0.0f);
            game.Step();
        }
        for (int i = 0; i < hits; ++i) {
            shots.push_back(
                game.Awake(sleepers[static_cast<size_t>(i)]->GetPosition() + b2Vec2(-1.05f, 0.0f)));
        }
        game.Step(2); // their contacts are the newest
        for (b2Body *body : moved)
            body->SetTransform(body->GetPosition() - b2Vec2(0.15f, 0.0f), 0.0f);
        for (b2Body *shot : shots)
            shot->SetTransform(shot->GetPosition() + b2Vec2(0.1f, 0.0f), 0.0f);
        game.Stage(!sleepers[0]->IsAwake() && game.Touching() == 0, "nobody is woken by that");
        game.Step();
        game.Stage(game.Touching() == 2 * hits, "those who were hit meet the others at once");
        game.Step(10);
    }
}

AS_STOCK("contacts that were disabled between steps are enabled where impacts are looked for") {
    for (const bool partial : {false, true}) {
        Game game(run);
        game.world.SetSubStepping(partial);
        game.Wall({0.0f, 0.0f}, {0.05f, 6.0f});
        std::vector<b2Body *> shots;
        for (int i = 0; i < 12; ++i)
            shots.push_back(game.Awake({-0.3f, Real(i) - 5.5f}, {0.2f, 0.2f}));
        game.Step(30);
        for (b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext())
            c->SetEnabled(false);
        for (b2Body *shot : shots)
            shot->SetLinearVelocity({200.0f, 0.0f});
        game.Step(partial ? 20 : 4);
        game.Stage(Game::LeftOf(0.0f, shots) == 12, "nobody comes through");
        game.TookPlace(game.world.GetContactCount(), "contacts are disabled");
    }
}

AS_STOCK("contacts that a listener disables are enabled in the step after it, in which nobody is called") {
    Game game(run);
    // Their contact is the oldest: the others are updated ahead of it.
    b2Body *const left = game.Awake({50.0f, 0.0f}), *const right = game.Awake({50.99f, 0.0f});
    game.Step();
    game.Wall({0.0f, 0.0f}, {0.05f, 6.0f});
    for (int i = 0; i < 12; ++i)
        game.Awake({-0.3f, Real(i) - 5.5f}, {0.2f, 0.2f});
    game.Step(30);
    game.Listen();
    int disabled = 0;
    game.listener.end.Once([&game, &disabled] {
        for (b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext(), ++disabled)
            c->SetEnabled(false);
    });
    left->SetLinearVelocity({-1.0f, 0.0f});
    right->SetLinearVelocity({1.0f, 0.0f});
    for (int step = 0; step < 6; ++step) {
        game.Step();
        for (const b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext())
            game.hash.Field("enabled", static_cast<uint32_t>(c->IsEnabled()));
    }
    game.WriteDown();
    game.TookPlace(disabled - 10, "contacts are disabled");
}

AS_STOCK("a loop over contacts that a listener's exception ends is none") {
    struct Thrown {};
    struct Throwing final : b2ContactListener {
        void BeginContact(b2Contact *) override { throw Thrown(); }
    };
    Needles world(run);
    Game &game = world.game;
    // Two that meet, and whose contact is the newest: the loop begins with it.
    b2Body *const left = game.Body(b2_dynamicBody, {30.0f, 0.0f}), *const right = game.Body(b2_dynamicBody,
                                                                                            {31.05f, 0.0f});
    for (b2Body *body : {left, right})
        game.Box(body, 0.5f, 0.5f);
    game.Step(40);
    game.Stage(game.Touching() == 0, "all apart");
    right->SetTransform({30.95f, 0.0f}, 0.0f);
    // An older pair is due in the same step, because the game changes its shape.
    auto &thin = static_cast<b2PolygonShape &>(*world.needles[3]->GetFixtureList()->GetShape());
    thin.SetAsBox(3.0f, 0.3f);
    Throwing listener;
    game.world.SetContactListener(&listener);
    bool thrown = false;
    try {
        game.world.Step(1.0f / 60.0f, 8, 3);
    } catch (const Thrown &) {
        thrown = true;
    }
    game.world.SetContactListener(nullptr);
    game.Stage(thrown && game.Touching() <= 1, "the loop ends with the first contact");
    game.Step(3);
    game.Stage(game.Touching() > 1, "needles touch");
}

TEST_CASE("more than 65,536 fixtures, each with a pair of its own") {
    const Scenario pairs = [](Run &run) {
        constexpr int kPairs = 33000;
        b2World world({0.0f, 0.0f});
        std::vector<b2Body *> movers;
        b2PolygonShape box;
        box.SetAsBox(0.4f, 0.4f);
        for (int i = 0; i < kPairs; ++i) {
            b2BodyDef def;
            const b2Vec2 place(4.0f * Real(i % 200 - 100), 4.0f * Real(i / 200 - 82));
            def.position = place;
            world.CreateBody(&def)->CreateFixture(&box, 0.0f);
            def.type = b2_dynamicBody;
            def.allowSleep = false;
            def.position = place + b2Vec2(0.87f, 0.0f);
            movers.push_back(world.CreateBody(&def));
            movers.back()->CreateFixture(&box, 1.0f);
        }
        const auto print = [&] {
            int32 touching = 0;
            for (const b2Contact *c = world.GetContactList(); c != nullptr; c = c->GetNext())
                touching += c->IsTouching();
            run.Print("%d contacts, %d touching", world.GetContactCount(), touching);
        };
        for (int step = 0; step < 6; ++step) {
            if (step == 3) // the last pairs made, and with them rows of the highest numbers
                for (size_t i = movers.size() - 40; i < movers.size(); i += 2)
                    movers[i]->SetTransform(movers[i]->GetPosition() - b2Vec2(0.07f, 0.0f), 0.0f);
            const Updates spent = Spent([&] { world.Step(1.0f / 60.0f, 1, 1); });
            if (run.Counts() && step > 1)
                run.Expect(spent.watched == kPairs && spent.updates <= 20, "updates are spared");
            print();
        }
    };
    bmr::Options options; // in one form: it takes a while
    options.statistics = true;
    const std::string stock = InChild(pairs);
    CHECK(stock.size() > 0);
    CHECK(Difference(stock, InChild(pairs, &options)) == "");
}

AS_STOCK("nothing is allocated for pairs that stay apart") {
    Needles world(run, 0.2f);
    world.game.Step(30);
    const int32 contacts = world.game.world.GetContactCount();
    const size_t before = BytesInUse();
    world.game.Step(100);
    world.game.Stage(world.game.world.GetContactCount() == contacts, "no pair comes or goes");
    run.Expect(BytesInUse() == before, "nothing was kept");
}

AS_STOCK(
    "a contact that is apart is asked for its points at other poses, and has none behind the next step") {
    Game game(run);
    for (int i = 0; i < 60; ++i)
        game.Near({3.0f * Real(i), 0.0f});
    game.Step(6);
    b2Contact *const contact = game.world.GetContactList();
    const b2Transform &a = contact->GetFixtureA()->GetBody()->GetTransform();
    b2Transform beside = contact->GetFixtureB()->GetBody()->GetTransform();
    beside.p -= 0.2f * (beside.p - a.p);
    contact->Evaluate(contact->GetManifold(), a, beside);
    game.TookPlace(contact->GetManifold()->pointCount, "there are points");
    game.Step(2);
}

// Each at another address: a table that stayed would be found by the next world at its own.
AS_STOCK("a world of a class that is derived from b2World gives its table back") {
    constexpr int kPairs = 60;
    struct Derived : b2World {
        using b2World::b2World;
    };
    struct Place {
        alignas(Derived) unsigned char bytes[sizeof(Derived)];
    };
    std::vector<Place> places(16);
    size_t worlds = 0;
    int32 contacts = 0;
    const auto live = [&] {
        auto *const world = new (&places[worlds++]) Derived(b2Vec2(0.0f, 0.0f));
        for (int i = 0; i < kPairs; ++i)
            for (const float x : {0.0f, 0.9f})
                AddBox(*world, b2_dynamicBody, {3.0f * Real(i) + x, 0.0f}, {0.4f, 0.4f}, 0.0f);
        for (int i = 0; i < 3; ++i)
            world->Step(1.0f / 60.0f, 8, 3);
        contacts = world->GetContactCount();
        world->~Derived();
    };
    while (worlds < 10) // until malloc keeps as much at hand as it will
        live();
    const bool nothing = LeavesNothing(kPairs, live);
    run.Print("%d contacts", static_cast<int>(contacts));
    run.Stage(contacts == kPairs, "worlds with tables end");
    run.Expect(nothing, "nothing was kept");
}

TEST_CASE("verify notices a contact that a step passes over and that Box2D would change") {
    bmr::Options options;
    options.mode = bmr::Mode::Verify;
    const std::string said = InChild(
        [](Run &run) {
            Needles needles(run);
            needles.game.Step(20);
            const bmr::Counted before = bmr::internal::ReadCounts();
            const_cast<b2Contact *>(needles.game.world.GetContactList())->GetManifold()->pointCount = 1;
            const std::string line = StderrOf([&] { needles.game.Step(); });
            const bmr::Counted after = bmr::internal::ReadCounts();
            run.Print("%d before, %d then", int(before.differences), int(after.differences));
            run.Print("%s", line.substr(0, line.find(',')).c_str());
            run.Expect(before.verified > 100, "contacts are compared in every step");
        },
        &options);
    CHECK(said.find("0 before, 1 then\nboomerang: first difference from Box2D\n") != std::string::npos);
    CHECK(said.find('!') == std::string::npos);
}
