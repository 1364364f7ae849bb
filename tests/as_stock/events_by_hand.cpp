// SPDX-License-Identifier: MIT
// Lives that are played by hand, with every event in its place: two bodies that meet, turn about a corner,
// touch, leave each other and part, for each kind of certificate that a contact may have.
#include "events.h"

using as_stock::Listener;
using forked::Game;
using forked::Run;

namespace {

/// Puts the body there, and looks.
void Put(Game &game, Listener &listener, b2Body *body, b2Vec2 at, const char *what) {
    listener.Say(what);
    body->SetTransform(at, 0.0f);
    body->SetAwake(true);
    body->SetLinearVelocity({0.0f, 0.0f});
    body->SetAngularVelocity(0.0f);
    game.Step();
    listener.CheckContacts(game.world);
}

/// So many that the world has a ledger where there is one: it has none for fewer than 8 contacts.
void AddCrowd(Game &game) {
    for (int i = 0; i < 12; ++i) {
        const float x = 40.0f + 1.1f * static_cast<float>(i);
        game.Box(game.Body(b2_dynamicBody, {x, 0.0f}), 0.5f, 0.5f);
    }
}

/// The lines of a text that tell of events, equal ones in a row counted; and what is broken.
std::string EventsOf(const std::string &text) {
    std::string events, last;
    int count = 0;
    const auto finish = [&] {
        if (count > 0)
            events += (count > 1 ? std::to_string(count) + " x " : "") + last + "\n";
        count = 0;
    };
    for (size_t at = 0; at < text.size();) {
        const size_t end = text.find('\n', at);
        const bool event = text.compare(at, 6, "event ") == 0;
        const std::string line = text.substr(event ? at + 6 : at, end - (event ? at + 6 : at));
        at = end + 1;
        if (!event && line.rfind('!', 0) != 0)
            continue;
        if (line != last)
            finish();
        last = line;
        ++count;
    }
    finish();
    return events;
}

void PlaySmall(Run &run, Listener &listener) {
    Game game(run);
    listener.Watch(&game.world);
    AddCrowd(game);
    game.Step();
    listener.PrintEvents();
    game.Box(game.Body(b2_staticBody, {0.0f, 0.0f}), 1.0f, 1.0f);
    b2Body *body = game.Body(b2_dynamicBody, {5.0f, 0.0f});
    game.Box(body, 0.5f, 0.5f);
    Put(game, listener, body, {1.6f, 0.0f}, "beside it");
    Put(game, listener, body, {1.6f, 0.4f}, "along its side");
    Put(game, listener, body, {1.525f, 0.4f}, "so near that it is looked at in every step");
    Put(game, listener, body, {1.525f, 0.5f}, "along its side");
    Put(game, listener, body, {1.56f, 1.56f}, "at its corner");
    Put(game, listener, body, {1.2f, 1.525f}, "around its corner");
    Put(game, listener, body, {0.0f, 1.6f}, "above it");
    Put(game, listener, body, {0.0f, 1.49f}, "on it");
    game.Stage(game.Touching() == 1, "they touch");
    Put(game, listener, body, {0.0f, 1.49f}, "still");
    Put(game, listener, body, {0.0f, 1.525f}, "off it");
    Put(game, listener, body, {0.0f, 1.6f}, "farther off");
    Put(game, listener, body, {0.0f, 1.49f}, "on it again");
    Put(game, listener, body, {1.6f, 0.0f}, "beside it");
    Put(game, listener, body, {5.0f, 0.0f}, "away");
    Put(game, listener, body, {1.6f, 0.0f}, "back");
    Put(game, listener, body, {5.0f, 0.0f}, "away");
    Put(game, listener, body, {0.0f, 1.49f}, "on it from nowhere");
}

/// Twelve vertices: 4 wide, 0.6 high, so that the disks around two of them part long after the polygons.
void AddBig(Game &game, b2Body *body) {
    b2Vec2 points[12];
    for (int i = 0; i < 12; ++i) {
        const float angle = 2.0f * b2_pi * static_cast<float>(i) / 12.0f;
        points[i] = {2.0f * cosf(angle), 0.3f * sinf(angle)};
    }
    bmr::ConvexShape shape;
    game.Stage(shape.Set(points, 12) == BMR_OK, "a big shape");
    game.Fixture(body, shape);
}

void PlayBig(Run &run, Listener &listener) {
    Game game(run);
    listener.Watch(&game.world);
    AddCrowd(game);
    game.Step();
    listener.PrintEvents();
    AddBig(game, game.Body(b2_staticBody, {0.0f, 0.0f}));
    b2Body *body = game.Body(b2_dynamicBody, {9.0f, 0.0f});
    AddBig(game, body);
    Put(game, listener, body, {4.1f, 0.0f}, "end to end");
    Put(game, listener, body, {4.05f, 0.1f}, "nearer");
    Put(game, listener, body, {0.3f, 0.7f}, "above it");
    Put(game, listener, body, {0.2f, 0.7f}, "along it");
    Put(game, listener, body, {2.6f, 0.5f}, "about its end");
    Put(game, listener, body, {3.4f, 0.4f}, "beyond its end");
    Put(game, listener, body, {3.6f, 0.3f}, "lower");
    Put(game, listener, body, {3.6f, -0.3f}, "beneath its end");
    Put(game, listener, body, {0.0f, -0.7f}, "below it");
    Put(game, listener, body, {0.0f, 0.7f}, "through it");
    Put(game, listener, body, {0.1f, 0.7f}, "along it");
    Put(game, listener, body, {4.1f, 0.0f}, "end to end");
    Put(game, listener, body, {0.0f, 0.7f}, "above it");
    Put(game, listener, body, {0.0f, 0.59f}, "against it");
    game.Stage(game.Touching() == 1, "they touch");
    Put(game, listener, body, {0.0f, 0.7f}, "off it");
    Put(game, listener, body, {0.0f, 0.59f}, "against it");
    Put(game, listener, body, {4.1f, 0.0f}, "end to end");
    Put(game, listener, body, {9.0f, 0.0f}, "away");
    Put(game, listener, body, {0.0f, 0.7f}, "above it, from nowhere");
}

/// A plank of ten boxes on another one that has a post at its end: the hulls overlap where no two boxes do.
void PlayMany(Run &run, Listener &listener) {
    Game game(run);
    listener.Watch(&game.world);
    listener.PrintEvents();
    b2Body *ground = game.Body(b2_kinematicBody, {0.0f, 0.0f}); // of a static one each box is its own
    game.Plank(ground);
    game.Box(ground, 0.1f, 1.0f, {-3.0f, 1.1f});
    b2Body *body = game.Body(b2_dynamicBody, {0.0f, 5.0f});
    game.Plank(body);
    Put(game, listener, body, {0.0f, -0.3f}, "below it");
    game.StagePairs();
    Put(game, listener, body, {0.0f, 0.3f}, "above it");
    Put(game, listener, body, {0.0f, -0.3f}, "below it");
    Put(game, listener, body, {0.0f, 0.19f}, "on it");
    Put(game, listener, body, {0.0f, 0.4f}, "off it");
    Put(game, listener, body, {0.0f, 0.19f}, "on it");
    Put(game, listener, body, {0.0f, -0.3f}, "below it");
}

void PlaySensor(Run &run, Listener &listener) {
    Game game(run);
    listener.Watch(&game.world);
    AddCrowd(game);
    game.Step();
    listener.PrintEvents();
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    game.Fixture(game.Body(b2_staticBody, {0.0f, 0.0f}), box, true);
    b2Body *body = game.Body(b2_dynamicBody, {5.0f, 0.0f});
    game.Box(body, 0.5f, 0.5f);
    Put(game, listener, body, {1.6f, 0.0f}, "beside it");
    Put(game, listener, body, {1.525f, 0.1f}, "nearer");
    Put(game, listener, body, {1.525f, 0.2f}, "along its side");
    Put(game, listener, body, {0.0f, 1.6f}, "above it");
    Put(game, listener, body, {0.0f, 1.0f}, "in it");
    Put(game, listener, body, {0.0f, 0.9f}, "deeper");
    Put(game, listener, body, {0.0f, 1.6f}, "out of it");
    Put(game, listener, body, {5.0f, 0.0f}, "away");
    Put(game, listener, body, {1.6f, 0.0f}, "back");
}

/// Tip to tip: no side of theirs separates the two, and Box2D finds no points. The line between the tips,
/// which the ledger finds, does.
void PlayTips(Run &run, Listener &listener) {
    Game game(run);
    listener.Watch(&game.world);
    AddCrowd(game);
    game.Step();
    listener.PrintEvents();
    b2PolygonShape needle;
    const b2Vec2 toTheRight[3] = {{-2.0f, -0.1f}, {0.0f, 0.0f}, {-2.0f, 0.1f}},
                 toTheLeft[3] = {{0.0f, 0.0f}, {2.0f, -0.1f}, {2.0f, 0.1f}};
    needle.Set(toTheRight, 3);
    game.Fixture(game.Body(b2_staticBody, {0.0f, 0.0f}), needle);
    b2Body *body = game.Body(b2_dynamicBody, {5.0f, 0.0f});
    needle.Set(toTheLeft, 3);
    game.Fixture(body, needle);
    Put(game, listener, body, {0.15f, 0.0f}, "tip to tip");
    game.Stage(game.Touching() == 0, "they do not touch");
    Put(game, listener, body, {0.149f, 0.0f}, "a bit nearer");
    Put(game, listener, body, {0.0f, 0.25f}, "side by side");
}

} // namespace

TEST_CASE("two boxes live as the header says") {
    CHECK(EventsOf(as_stock::Told(PlaySmall)) == "-- beside it\n"
                                                 "contact start -1 0\n"
                                                 "-- along its side\n"
                                                 "-- so near that it is looked at in every step\n"
                                                 "-- along its side\n"
                                                 "-- at its corner\n"
                                                 "-- around its corner\n"
                                                 "contact push 0 0\n"
                                                 "-- above it\n"
                                                 "-- on it\n"
                                                 "contact contact 0 0\n"
                                                 "-- still\n"
                                                 "-- off it\n"
                                                 "contact leave 0 0\n"
                                                 "-- farther off\n"
                                                 "-- on it again\n"
                                                 "contact contact 0 0\n"
                                                 "-- beside it\n"
                                                 "contact leave 0 0\n"
                                                 "-- away\n"
                                                 "-- back\n"
                                                 "contact start -1 0\n"
                                                 "-- away\n"
                                                 "-- on it from nowhere\n"
                                                 "contact contact -1 0\n");
}

TEST_CASE("two big polygons live as the header says") {
    CHECK(EventsOf(as_stock::Told(PlayBig)) == "-- end to end\n"
                                               "contact start -1 -1\n"
                                               "-- nearer\n"
                                               "-- above it\n"
                                               "contact stab -1 0\n"
                                               "-- along it\n"
                                               "-- about its end\n"
                                               "contact push 0 0\n"
                                               "-- beyond its end\n"
                                               "contact push 0 0\n"
                                               "-- lower\n"
                                               "-- beneath its end\n"
                                               "contact push 0 0\n"
                                               "-- below it\n"
                                               "contact push 0 0\n"
                                               "-- through it\n" // which a look does not follow
                                               "contact contact 0 0\n"
                                               "-- along it\n"
                                               "contact leave 0 0\n"
                                               "-- end to end\n"
                                               "contact coarsen 0 -1\n"
                                               "-- above it\n"
                                               "contact stab -1 0\n"
                                               "-- against it\n"
                                               "contact contact 0 0\n"
                                               "-- off it\n"
                                               "contact leave 0 0\n"
                                               "-- against it\n"
                                               "contact contact 0 0\n"
                                               "-- end to end\n"
                                               "contact leave 0 -1\n"
                                               "-- away\n"
                                               "-- above it, from nowhere\n"
                                               "contact start -1 0\n");
}

TEST_CASE("bodies of many fixtures have a structure of their hulls, and one for each contact below it") {
    CHECK(EventsOf(as_stock::Told(PlayMany)) == "-- below it\n"
                                                "hulls start -1 0\n"
                                                "-- above it\n"
                                                "hulls contact 0 0\n"
                                                "28 x contact start -1 0\n"
                                                "-- below it\n"
                                                "hulls leave 0 0\n"
                                                "-- on it\n"
                                                "hulls contact 0 0\n"
                                                "28 x contact contact 0 0\n"
                                                "-- off it\n"
                                                "28 x contact leave 0 0\n"
                                                "-- on it\n"
                                                "28 x contact contact 0 0\n"
                                                "-- below it\n"
                                                "28 x contact leave 0 0\n");
}

TEST_CASE("a sensor's contact lives as the header says" * doctest::skip(!forked::kAhead)) {
    CHECK(EventsOf(as_stock::Told(PlaySensor)) == "-- beside it\n"
                                                  "contact start -1 0\n"
                                                  "-- nearer\n"
                                                  "-- along its side\n"
                                                  "-- above it\n"
                                                  "contact push 0 0\n"
                                                  "-- in it\n"
                                                  "contact contact 0 0\n"
                                                  "-- deeper\n"
                                                  "-- out of it\n"
                                                  "contact leave 0 0\n"
                                                  "-- away\n"
                                                  "-- back\n"
                                                  "contact start -1 0\n");
}

TEST_CASE("what only a line of the ledger keeps apart leaves contact by it" *
          doctest::skip(!forked::kAhead)) {
    CHECK(EventsOf(as_stock::Told(PlayTips)) == "-- tip to tip\n"
                                                "contact contact -1 0\n"
                                                "contact leave 0 0\n"
                                                "-- a bit nearer\n"
                                                "-- side by side\n"
                                                "contact push 0 0\n");
}
