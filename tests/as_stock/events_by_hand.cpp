// SPDX-License-Identifier: MIT
// Lives that are played by hand, with every event in its place: two bodies that meet, turn about a corner,
// touch, leave each other and part, for each kind of certificate that a contact may have.
#include "events.h"

using namespace as_stock;

namespace {

/// The body is put there, and looked at; then these events are told.
struct Look {
    b2Vec2 at;
    const char *what, *events = "";
    int touching = -1; ///< contacts, where it is said
};
using Life = std::vector<Look>;

void Live(Game &game, Witness &witness, b2Body *body, const Life &life) {
    for (const Look &look : life) {
        witness.Say(look.what);
        body->SetTransform(look.at, 0.0f);
        body->SetAwake(true);
        body->SetLinearVelocity({0.0f, 0.0f});
        body->SetAngularVelocity(0.0f);
        game.Step();
        witness.CheckContacts(game.world);
        game.Stage(look.touching < 0 || game.Touching() == look.touching, look.what);
    }
}

std::string TextOf(const Life &life) {
    std::string text;
    for (const Look &look : life)
        text += std::string("-- ") + look.what + "\n" + look.events;
    return text;
}

/// So many boxes that the world has a ledger where there is one: it has none for fewer than 8 contacts.
struct Crowded : Heard {
    Crowded(Run &run, Witness &witness) : Heard(run) {
        witness.Watch(&world);
        for (int i = 0; i < 12; ++i)
            Box(Body(b2_dynamicBody, {40.0f + 1.1f * Real(i), 0.0f}), 0.5f, 0.5f);
        Step();
        witness.PrintEvents();
    }
};

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

const Life kSmall = {
    {{1.6f, 0.0f}, "beside it", "contact start -1 0\n"},
    {{1.6f, 0.4f}, "along its side"},
    {{1.525f, 0.4f}, "so near that it is looked at in every step"},
    {{1.525f, 0.5f}, "along its side"},
    {{1.56f, 1.56f}, "at its corner"},
    {{1.2f, 1.525f}, "around its corner", "contact push 0 0\n"},
    {{0.0f, 1.6f}, "above it"},
    {{0.0f, 1.49f}, "on it", "contact contact 0 0\n", 1},
    {{0.0f, 1.49f}, "still"},
    {{0.0f, 1.525f}, "off it", "contact leave 0 0\n"},
    {{0.0f, 1.6f}, "farther off"},
    {{0.0f, 1.49f}, "on it again", "contact contact 0 0\n"},
    {{1.6f, 0.0f}, "beside it", "contact leave 0 0\n"},
    {{5.0f, 0.0f}, "away"},
    {{1.6f, 0.0f}, "back", "contact start -1 0\n"},
    {{5.0f, 0.0f}, "away"},
    {{0.0f, 1.49f}, "on it from nowhere", "contact contact -1 0\n"},
};
void PlaySmall(Run &run, Witness &witness) {
    Crowded game(run, witness);
    game.Wall({0.0f, 0.0f}, {1.0f, 1.0f});
    b2Body *body = game.Box({5.0f, 0.0f});
    Live(game, witness, body, kSmall);
}

/// Twelve vertices: 4 wide, 0.6 high, so that the disks around two of them part long after the polygons.
void AddBig(Game &game, b2Body *body) {
    b2Vec2 points[12];
    for (int i = 0; i < 12; ++i) {
        const float angle = 2.0f * b2_pi * Real(i) / 12.0f;
        points[i] = {2.0f * cosf(angle), 0.3f * sinf(angle)};
    }
    bmr::ConvexShape shape;
    game.Stage(shape.Set(points, 12) == BMR_OK, "a big shape");
    game.Fixture(body, shape);
}

const Life kBig = {
    {{4.1f, 0.0f}, "end to end", "contact start -1 -1\n"},
    {{4.05f, 0.1f}, "nearer"},
    {{0.3f, 0.7f}, "above it", "contact stab -1 0\n"},
    {{0.2f, 0.7f}, "along it"},
    {{2.6f, 0.5f}, "about its end", "contact push 0 0\n"},
    {{3.4f, 0.4f}, "beyond its end", "contact push 0 0\n"},
    {{3.6f, 0.3f}, "lower"},
    {{3.6f, -0.3f}, "beneath its end", "contact push 0 0\n"},
    {{0.0f, -0.7f}, "below it", "contact push 0 0\n"},
    // A look does not follow so far; the proof that comes next starts anew.
    {{0.0f, 0.7f}, "through it", "contact contact 0 0\ncontact leave 0 0\n"},
    {{0.1f, 0.7f}, "along it"},
    {{4.1f, 0.0f}, "end to end", "contact coarsen 0 -1\n"},
    {{0.0f, 0.7f}, "above it", "contact stab -1 0\n"},
    {{0.0f, 0.59f}, "against it", "contact contact 0 0\n", 1},
    {{0.0f, 0.7f}, "off it", "contact leave 0 0\n"},
    {{0.0f, 0.59f}, "against it", "contact contact 0 0\n"},
    {{4.1f, 0.0f}, "end to end", "contact leave 0 -1\n"},
    {{9.0f, 0.0f}, "away"},
    {{0.0f, 0.7f}, "above it, from nowhere", "contact start -1 0\n"},
};
void PlayBig(Run &run, Witness &witness) {
    Crowded game(run, witness);
    AddBig(game, game.Body(b2_staticBody, {0.0f, 0.0f}));
    b2Body *body = game.Body(b2_dynamicBody, {9.0f, 0.0f});
    AddBig(game, body);
    Live(game, witness, body, kBig);
}

/// With Options::pairsBy: a plank of ten boxes on another one that has a post at its end. The hulls overlap
/// where no two boxes do, and are far apart beneath.
const Life kMany = {
    {{0.0f, -0.3f}, "below it", "hulls start -1 0\n"},
    {{0.0f, 0.3f}, "above it", "hulls contact 0 0\n"},
    {{0.0f, -0.3f}, "below it", "hulls leave 0 0\n"},
    {{0.0f, 0.19f}, "on it", "hulls contact 0 0\n"},
    {{0.0f, 0.4f}, "off it"},
    {{0.0f, 0.19f}, "on it"},
    {{0.0f, -0.3f}, "below it"}, // what touched is asked of Box2D, whose answer gives each contact a line
};
void PlayMany(Run &run, Witness &witness) {
    Heard game(run);
    witness.Watch(&game.world);
    witness.PrintEvents();
    b2Body *ground = game.Body(b2_kinematicBody, {0.0f, 0.0f}); // of a static one each box is its own
    game.Plank(ground);
    game.Box(ground, 0.1f, 1.0f, {-3.0f, 1.1f});
    b2Body *body = game.Body(b2_dynamicBody, {0.0f, 5.0f});
    game.Plank(body);
    Live(game, witness, body, kMany);
    game.StagePairs();
}

const Life kSensor = {
    {{1.6f, 0.0f}, "beside it", "contact start -1 0\n"},
    {{1.525f, 0.1f}, "nearer"},
    {{1.525f, 0.2f}, "along its side"},
    {{0.0f, 1.6f}, "above it", "contact push 0 0\n"},
    {{0.0f, 1.0f}, "in it", "contact contact 0 0\n"},
    {{0.0f, 0.9f}, "deeper"},
    {{0.0f, 1.6f}, "out of it", "contact leave 0 0\n"},
    {{5.0f, 0.0f}, "away"},
    {{1.6f, 0.0f}, "back", "contact start -1 0\n"},
};
void PlaySensor(Run &run, Witness &witness) {
    Crowded game(run, witness);
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    game.Fixture(game.Body(b2_staticBody, {0.0f, 0.0f}), box, true);
    b2Body *body = game.Box({5.0f, 0.0f});
    Live(game, witness, body, kSensor);
}

/// Tip to tip: no side of theirs separates the two, and Box2D finds no points. The line between the tips,
/// which the ledger finds, does.
const Life kTips = {
    {{0.15f, 0.0f}, "tip to tip", "contact contact -1 0\ncontact leave 0 0\n", 0},
    {{0.149f, 0.0f}, "a bit nearer"},
    {{0.0f, 0.25f}, "side by side", "contact push 0 0\n"},
};
void PlayTips(Run &run, Witness &witness) {
    Crowded game(run, witness);
    b2PolygonShape needle;
    const b2Vec2 toTheRight[3] = {{-2.0f, -0.1f}, {0.0f, 0.0f}, {-2.0f, 0.1f}},
                 toTheLeft[3] = {{0.0f, 0.0f}, {2.0f, -0.1f}, {2.0f, 0.1f}};
    needle.Set(toTheRight, 3);
    game.Fixture(game.Body(b2_staticBody, {0.0f, 0.0f}), needle);
    b2Body *body = game.Body(b2_dynamicBody, {5.0f, 0.0f});
    needle.Set(toTheLeft, 3);
    game.Fixture(body, needle);
    Live(game, witness, body, kTips);
}

} // namespace

TEST_CASE("two boxes live as the header says") {
    CHECK(EventsOf(Told(PlaySmall)) == TextOf(kSmall));
}

TEST_CASE("two big polygons live as the header says") {
    CHECK(EventsOf(Told(PlayBig)) == TextOf(kBig));
}

TEST_CASE("with a structure of the paper two bodies have one, of their hulls") {
    const PairsBy by("free-direction");
    CHECK(EventsOf(Told(PlayMany)) == TextOf(kMany));
}

TEST_CASE("a sensor's contact lives as the header says") {
    CHECK(EventsOf(Told(PlaySensor)) == TextOf(kSensor));
}

TEST_CASE("what only a line of the ledger keeps apart leaves contact by it") {
    CHECK(EventsOf(Told(PlayTips)) == TextOf(kTips));
}
