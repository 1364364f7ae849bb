// SPDX-License-Identifier: MIT
// bmr::ContactRecorder: what is recorded is what is recorded on stock Box2D.
#include <boomerang/contact_recorder.h>

#include "as_stock.h"

using namespace as_stock;

namespace {

void Add(Hash *hash, const bmr::ContactSide &side) {
    hash->Add(static_cast<uint32_t>(side.userData.pointer));
    hash->Add(static_cast<uint32_t>(side.child));
}

/// All events, in their order.
void Add(Hash *hash, const bmr::ContactEvents &events) {
    for (const auto *list : {&events.begins, &events.ends})
        for (const bmr::ContactTouchEvent &e : *list) {
            Add(hash, e.a);
            Add(hash, e.b);
            hash->Add(static_cast<uint32_t>(e.mayBeGone));
        }
    for (const auto *list : {&events.sensorBegins, &events.sensorEnds})
        for (const bmr::SensorTouchEvent &e : *list) {
            Add(hash, e.sensor);
            Add(hash, e.visitor);
        }
    for (const bmr::ContactHitEvent &e : events.hits) {
        Add(hash, e.a);
        Add(hash, e.b);
        for (const float value : {e.point.x, e.point.y, e.normal.x, e.normal.y, e.impulse})
            hash->Add(value);
    }
}

struct Recorded : Game {
    explicit Recorded(Run &run) : Game(run, {0.0f, -10.0f}), m_run(run) {
        FillWithBoxes(world);
        Wheel({0.0f, 20.0f}, 12, 1.5f);
        const b2Vec2 links[] = {{-30.0f, -7.0f}, {-5.0f, -9.0f}, {5.0f, -9.0f}, {30.0f, -7.0f}};
        b2ChainShape chain;
        chain.CreateChain(links, 4, {-40.0f, -7.0f}, {40.0f, -7.0f});
        b2BodyDef def;
        world.CreateBody(&def)->CreateFixture(&chain, 0.0f);
        recorder.SetHitThreshold(0.1f);
        world.SetContactListener(&recorder);
    }
    ~Recorded() { world.SetContactListener(nullptr); }

    void Play() {
        for (int step = 0; step < 200; ++step) {
            Step();
            if (step > 60 && step % 10 == 0)
                world.DestroyBody(world.GetBodyList()->GetNext());
            const bmr::ContactEvents events = recorder.Take();
            Add(&hash, events);
            hits += events.hits.count;
            m_run.Print("%d begins, %d hits", static_cast<int>(events.begins.count),
                        static_cast<int>(events.hits.count));
        }
        Stage(hits >= 1000, "many hits are recorded");
    }

    bmr::ContactRecorder recorder;
    int hits = 0;

private:
    Run &m_run;
};

} // namespace

AS_STOCK("recorded: what a recorder is told, in worlds without a filter and with one") {
    for (const bool filters : {false, true}) {
        Recorded game(run);
        if (filters)
            game.Ask();
        game.Play();
    }
}

// A listener of the game's that comes for every third step disables contacts, also those that are apart.
AS_STOCK("taking turns: a recorder and a listener of the game's") {
    Recorded game(run);
    int disabled = 0, recorded = 0;
    game.listener.begin = [&game, &disabled] {
        for (b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext()) {
            c->SetEnabled(false);
            ++disabled;
        }
    };
    for (int step = 0; step < 150; ++step) {
        if (step % 3 == 0)
            game.Listen();
        else
            game.world.SetContactListener(&game.recorder);
        game.Step();
        const bmr::ContactEvents events = game.recorder.Take();
        Add(&game.hash, events);
        recorded += static_cast<int>(events.begins.count);
    }
    game.WriteDown();
    game.TookPlace(disabled, "the game's listener disables contacts");
    game.TookPlace(recorded, "the recorder is told of beginnings");
}
