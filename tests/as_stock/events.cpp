// SPDX-License-Identifier: MIT
// Lives that are played by hand, with every event in its place: two bodies that meet, turn about a corner,
// touch, leave each other and part, for each kind of certificate that a contact may have. A witness holds
// each event against what the headers say of it.
#include <map>

#include "as_stock.h"
#include "boomerang/convex_shape.h"

using namespace as_stock;

namespace {

class Witness {
public:
    Witness(Run &run, const b2World *world) : m_run(run), m_world(world) {}

    void Say(const char *what) { m_run.Print("event -- %s", what); }
    void OnEvent(const b2Body *a, const b2Body *b, const bmr_event &event);
    void OnAnswer(const b2Contact &contact, bmr::Answer answer);
    void CheckCounts();
    bool prints = false; ///< a line for each event

private:
    using Key = std::pair<const b2Body *, const b2Body *>;
    static Key KeyOf(const b2Body *a, const b2Body *b) { return a < b ? Key(a, b) : Key(b, a); }
    void CheckCertificate(const bmr_event &event);

    Run &m_run;
    const b2World *m_world;
    std::map<Key, bool> m_inContact; ///< so says the last event of two bodies' contact; they have one
    uint64_t m_counts[BMR_EVENT_KIND_COUNT] = {}, m_answers[5] = {};
};

using Play = void (*)(Run &);

Witness *listening = nullptr; // Options are the process's, and so is who listens

bool IsOfHulls(const bmr_event &event) {
    return event.pair != nullptr;
}

void Witness::CheckCertificate(const bmr_event &event) {
    if (!IsOfHulls(event)) {
        m_run.Expect(event.pose == nullptr && event.gap == 0.0, "a contact's event shows no certificate");
        return;
    }
    double gap = 0.0;
    if (event.kind == BMR_EVENT_CONTACT) {
        m_run.Expect(event.pair->state == BMR_PAIR_CONTACT && event.gap == 0.0,
                     "in contact nothing is proved");
        return;
    }
    m_run.Expect(event.gap > 0.0, "something is proved");
    m_run.Expect(bmr_pair_check(event.pair, event.pose, 0.0, &gap), "the certificate holds at the pose");
}

void Witness::OnEvent(const b2Body *a, const b2Body *b, const bmr_event &event) {
    ++m_counts[event.kind];
    m_run.Expect(a->GetWorld() == m_world && b->GetWorld() == m_world, "events are of this world");
    CheckCertificate(event);
    const bool hulls = IsOfHulls(event);
    const b2Vec2 between = b2MulT(a->GetTransform(), b->GetTransform()).p;
    m_run.Expect(event.pose == nullptr || (std::fabs(event.pose->position.x - double{between.x}) < 1e-3 &&
                                           std::fabs(event.pose->position.y - double{between.y}) < 1e-3),
                 "the pose is of the two bodies as they are given");
    if (prints)
        m_run.Print("event %s %s %d %d", hulls ? "hulls" : "contact", bmr_event_name(event.kind),
                    event.level_before, event.level_after);
    if (!hulls)
        m_inContact[KeyOf(a, b)] = event.kind == BMR_EVENT_CONTACT;
}

void Witness::OnAnswer(const b2Contact &contact, bmr::Answer answer) {
    ++m_answers[static_cast<int>(answer)];
    if (!m_run.RemembersEdges() || contact.GetFixtureA()->IsSensor() || contact.GetFixtureB()->IsSensor())
        return;
    const bool inContact =
        m_inContact[KeyOf(contact.GetFixtureA()->GetBody(), contact.GetFixtureB()->GetBody())];
    m_run.Expect(answer != bmr::Answer::ApartByPair, "no structure of hulls answers unasked");
    if (answer == bmr::Answer::ApartByEdge || answer == bmr::Answer::ApartBySearch)
        m_run.Expect(!inContact, "apart by a certificate of its own");
    else
        m_run.Expect(inContact || contact.GetManifold()->pointCount == 0, "what touches is in contact");
}

void Witness::CheckCounts() {
    const bmr::Counted s = bmr::internal::ReadCounts();
    for (int kind = 0; kind < BMR_EVENT_KIND_COUNT; ++kind)
        m_run.Expect(m_counts[kind] == s.events[kind], "every event is counted");
    uint64_t answers = 0;
    for (const uint64_t count : m_answers)
        answers += count;
    const uint64_t touching = m_answers[static_cast<int>(bmr::Answer::Touching)];
    m_run.Expect(answers == s.evaluations, "every evaluation has an answer");
    m_run.Expect(touching == s.handedOverTouching, "what touched is counted");
    m_run.Expect(m_answers[static_cast<int>(bmr::Answer::HandedOver)] + touching == s.handedOver,
                 "and so is all that is handed over");
}

/// Plays a scenario with a witness, in a child; what it printed.
std::string Printed(Play play, bmr::Options options = bmr::Options()) {
    static Play chosen;
    chosen = play;
    options.onEvent = [](void *, const b2Body *a, const b2Body *b, const bmr_event &event) {
        listening->OnEvent(a, b, event);
    };
    bmr::internal::ObserveAnswers(
        [](const b2Contact &contact, bmr::Answer answer) { listening->OnAnswer(contact, answer); });
    std::string printed = InChild([](Run &run) { chosen(run); }, &options);
    bmr::internal::ObserveAnswers(nullptr);
    return printed;
}

/// The body is put there, and the world steps: these events follow.
struct Moment {
    b2Vec2 at;
    const char *what, *events = "";
    int touching = -1; ///< contacts, where it is said
};
using Life = std::vector<Moment>;

void Live(Game &game, b2Body *body, const Life &life) {
    for (const Moment &moment : life) {
        listening->Say(moment.what);
        body->SetTransform(moment.at, 0.0f);
        body->SetAwake(true);
        body->SetLinearVelocity({0.0f, 0.0f});
        body->SetAngularVelocity(0.0f);
        game.Step();
        game.Stage(moment.touching < 0 || game.Touching() == moment.touching, moment.what);
    }
    listening->CheckCounts();
}

std::string TextOf(const Life &life) {
    std::string text;
    for (const Moment &moment : life)
        text += std::string("-- ") + moment.what + "\n" + moment.events;
    return text;
}

struct Watched : Heard {
    explicit Watched(Run &run) : Heard(run), witness(run, &world) { listening = &witness; }
    Witness witness;
};

/// So many boxes that the world has a table of pairs where there is one: it has none for fewer than 8
/// contacts.
struct Crowded : Watched {
    explicit Crowded(Run &run) : Watched(run) {
        for (int i = 0; i < 12; ++i)
            Box(Body(b2_dynamicBody, {40.0f + 1.1f * Real(i), 0.0f}), 0.5f, 0.5f);
        Step();
        witness.prints = true;
    }
};

/// The lines of a text that are events, equal ones in a row counted; and what is broken.
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
    {{1.525f, 0.4f}, "so near that it is updated in every step"},
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
void PlaySmall(Run &run) {
    Crowded game(run);
    game.Wall({0.0f, 0.0f}, {1.0f, 1.0f});
    b2Body *body = game.Box({5.0f, 0.0f});
    Live(game, body, kSmall);
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
    // An update does not follow so far; the proof that comes next starts anew.
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
void PlayBig(Run &run) {
    Crowded game(run);
    AddBig(game, game.Body(b2_staticBody, {0.0f, 0.0f}));
    b2Body *body = game.Body(b2_dynamicBody, {9.0f, 0.0f});
    AddBig(game, body);
    Live(game, body, kBig);
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
void PlayMany(Run &run) {
    Watched game(run);
    game.witness.prints = true;
    b2Body *ground = game.Body(b2_kinematicBody, {0.0f, 0.0f}); // of a static one each box is its own
    game.Plank(ground);
    game.Box(ground, 0.1f, 1.0f, {-3.0f, 1.1f});
    b2Body *body = game.Body(b2_dynamicBody, {0.0f, 5.0f});
    game.Plank(body);
    Live(game, body, kMany);
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
void PlaySensor(Run &run) {
    Crowded game(run);
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    game.Fixture(game.Body(b2_staticBody, {0.0f, 0.0f}), box, true);
    b2Body *body = game.Box({5.0f, 0.0f});
    Live(game, body, kSensor);
}

/// Tip to tip: no side of theirs separates the two, and Box2D finds no points. The line between the tips,
/// which the table finds, does.
const Life kTips = {
    {{0.15f, 0.0f}, "tip to tip", "contact contact -1 0\ncontact leave 0 0\n", 0},
    {{0.149f, 0.0f}, "a bit nearer"},
    {{0.0f, 0.25f}, "side by side", "contact push 0 0\n"},
};
void PlayTips(Run &run) {
    Crowded game(run);
    b2PolygonShape needle;
    const b2Vec2 toTheRight[3] = {{-2.0f, -0.1f}, {0.0f, 0.0f}, {-2.0f, 0.1f}},
                 toTheLeft[3] = {{0.0f, 0.0f}, {2.0f, -0.1f}, {2.0f, 0.1f}};
    needle.Set(toTheRight, 3);
    game.Fixture(game.Body(b2_staticBody, {0.0f, 0.0f}), needle);
    b2Body *body = game.Body(b2_dynamicBody, {5.0f, 0.0f});
    needle.Set(toTheLeft, 3);
    game.Fixture(body, needle);
    Live(game, body, kTips);
}

} // namespace

TEST_CASE("two boxes live as the header says") {
    CHECK(EventsOf(Printed(PlaySmall)) == TextOf(kSmall));
}

TEST_CASE("two big polygons live as the header says") {
    CHECK(EventsOf(Printed(PlayBig)) == TextOf(kBig));
}

TEST_CASE("with a structure of the paper two bodies have one, of their hulls") {
    const PairsBy by("free-direction");
    CHECK(EventsOf(Printed(PlayMany)) == TextOf(kMany));
}

TEST_CASE("a sensor's contact lives as the header says") {
    CHECK(EventsOf(Printed(PlaySensor)) == TextOf(kSensor));
}

TEST_CASE("what only a line of the table keeps apart leaves contact by it") {
    CHECK(EventsOf(Printed(PlayTips)) == TextOf(kTips));
}
