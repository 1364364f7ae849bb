// SPDX-License-Identifier: MIT
// Shapes of more than 8 vertices and pieces of outlines whose vertices a game changes in place, between steps
// and in the middle of them, on a ground of merged tiles and beside repaired outlines: edited_game. Prints
// what became of the bodies; a status of 1: mode verify found differences, or an edit changed nothing.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

#include <box2d/box2d.h>

#include <boomerang/box2d.h>
#if defined(WITH_REPAIR)
#    include <boomerang/repair.h>
#endif

namespace {

uint64_t Mix(uint64_t hash, float value) {
    uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return (hash ^ bits) * 0x100000001b3u;
}

b2PolygonShape *ShownBy(b2Fixture *fixture) {
    return static_cast<b2PolygonShape *>(fixture->GetShape());
}

/// Makes boxes of shapes, moves one vertex, and halves all, by turns.
void Edit(b2Body *body, int kind) {
    for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
        b2PolygonShape *shape = ShownBy(f);
        switch (kind % 3) {
        case 0:
            shape->SetAsBox(0.6f, 0.2f, shape->m_centroid, 0.3f);
            break;
        case 1:
            shape->m_vertices[0] = shape->m_centroid + 1.25f * (shape->m_vertices[0] - shape->m_centroid);
            shape->Set(shape->m_vertices, shape->m_count);
            break;
        default:
            for (int32 i = 0; i < shape->m_count; ++i)
                shape->m_vertices[i] = shape->m_centroid + 0.7f * (shape->m_vertices[i] - shape->m_centroid);
        }
    }
    body->SetAwake(true);
}

/// Edits the first body that it hears of in some steps, in their middle.
struct Meddler : b2ContactListener {
    int step = 0;
    bool done = false;
    void PreSolve(b2Contact *contact, const b2Manifold *) override {
        b2Body *body = contact->GetFixtureB()->GetBody();
        if (done || step % 40 != 25 || body->GetType() != b2_dynamicBody)
            return;
        done = true;
        b2PolygonShape *shape = ShownBy(contact->GetFixtureB());
        for (int32 i = 0; i < shape->m_count; ++i)
            shape->m_vertices[i] = shape->m_centroid + 0.9f * (shape->m_vertices[i] - shape->m_centroid);
    }
};

#if defined(WITH_REPAIR)
void AddOutlines(b2Body *body, const std::vector<bmr::Outline> &outlines) {
    for (const bmr::Outline &outline : outlines) {
        bmr::OutlineShape shape;
        if (shape.Set(outline.GetRings()) == BMR_OK)
            shape.CreateFixtures(body, 1.0f);
    }
}

/// Steps of tiles on the ground, and a bow that crosses itself above them.
void AddRepaired(b2World &world, b2Body *ground, float away, std::vector<b2Body *> *bodies) {
    std::vector<bmr::Outline> tiles(30), merged;
    for (size_t i = 0; i < tiles.size(); ++i) {
        const float left = 0.5f * static_cast<float>(i) - 7.0f, top = 0.1f * static_cast<float>(i / 5 % 3);
        const b2Vec2 tile[] = {{left, -0.1f}, {left + 0.499f, -0.1f}, {left + 0.499f, top}, {left, top}};
        tiles[i].AddRing(tile, 4);
    }
    if (MergeOutlines(tiles.data(), tiles.size(), bmr::FillRule::NonZero, 0.01, &merged) == BMR_OK)
        AddOutlines(ground, merged);
    const b2Vec2 bow[] = {{-0.5f, -0.5f}, {0.5f, 0.5f}, {0.5f, -0.5f}, {-0.5f, 0.5f}};
    bmr::Outline drawn;
    drawn.AddRing(bow, 4);
    if (RepairOutline(drawn, bmr::FillRule::EvenOdd, 0.01, &merged) != BMR_OK)
        return;
    b2BodyDef def;
    def.type = b2_dynamicBody;
    for (int i = 0; i < 4; ++i) {
        def.position.Set(away + 1.5f * static_cast<float>(i) - 3.0f, 6.0f);
        bodies->push_back(world.CreateBody(&def));
        AddOutlines(bodies->back(), merged);
    }
}
#endif

uint64_t Play(float away, bool edited) {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef def;
    def.position.Set(away, 0.0f);
    b2Body *ground = world.CreateBody(&def);
    b2PolygonShape floor;
    floor.SetAsBox(30.0f, 1.0f, b2Vec2(0.0f, -1.0f), 0.0f);
    ground->CreateFixture(&floor, 0.0f);
    bmr::ConvexShape coin;
    coin.SetRegular(64, 0.4f);
    const b2Vec2 elbow[] = {{-0.6f, -0.6f}, {0.6f, -0.6f}, {0.6f, 0.0f},
                            {0.0f, 0.0f},   {0.0f, 0.6f},  {-0.6f, 0.6f}};
    bmr::OutlineShape outline;
    outline.Set(elbow, 6);
    std::vector<b2Body *> bodies;
    def.type = b2_dynamicBody;
    for (int i = 0; i < 24; ++i) {
        def.position.Set(away + 1.3f * static_cast<float>(i % 8) - 5.0f,
                         1.0f + 1.5f * static_cast<float>(i / 8));
        def.bullet = i % 5 == 0;
        b2Body *body = world.CreateBody(&def);
        if (i % 2 == 0)
            body->CreateFixture(&coin, 1.0f);
        else
            outline.CreateFixtures(body, 1.0f);
        bodies.push_back(body);
    }
#if defined(WITH_REPAIR)
    AddRepaired(world, ground, away, &bodies);
#endif
    Meddler meddler;
    if (edited)
        world.SetContactListener(&meddler);
    uint64_t hash = 0xcbf29ce484222325u;
    for (int step = 0; step < 240; ++step) {
        meddler.step = step;
        meddler.done = false;
        if (edited && step % 20 == 10)
            Edit(bodies[static_cast<size_t>(step / 10 * 7) % bodies.size()], step / 20);
        world.Step(1.0f / 60.0f, 8, 3);
        for (const b2Body *body : bodies) {
            hash = Mix(hash, body->GetPosition().x);
            hash = Mix(hash, body->GetPosition().y);
            hash = Mix(hash, body->GetAngle());
        }
    }
    return hash;
}

} // namespace

int main() {
    bmr::Install();
    bool effective = true;
    for (const float away : {10.0f, 1000.0f, 8000.0f}) {
        const uint64_t plain = Play(away, false), edited = Play(away, true);
        effective = effective && plain != edited;
        std::printf("%g m: %016llx %016llx\n", static_cast<double>(away),
                    static_cast<unsigned long long>(plain), static_cast<unsigned long long>(edited));
    }
    return effective && bmr::GetStatistics().differences == 0 ? 0 : 1;
}
