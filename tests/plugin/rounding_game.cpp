// SPDX-License-Identifier: MIT
// A game that rounds in another direction than to the nearest, as libraries for intervals leave a thread.
//
//   rounding_game MODE WHEN
//
// MODE is upward, downward or toward-zero. WHEN is before (the first step), later, in-turn (every third step)
// or listening (a listener changes it, and it stays).
#include <cfenv>
#include <string>

#include "small_world.h"

namespace {

class Turner : public b2ContactListener {
public:
    explicit Turner(int mode) : m_mode(mode) {}
    void BeginContact(b2Contact *) override { std::fesetround(++m_calls % 2 == 0 ? m_mode : FE_TONEAREST); }

private:
    int m_mode, m_calls = 0;
};

/// Boxes that are an ulp too wide are seen nowhere else.
void AddBoxes(const b2World &world, Hash *hash) {
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        for (const b2Fixture *fixture = body->GetFixtureList(); fixture != nullptr;
             fixture = fixture->GetNext()) {
            const b2AABB &box = fixture->GetAABB(0);
            for (const float value : {box.lowerBound.x, box.lowerBound.y, box.upperBound.x, box.upperBound.y})
                hash->Add(value);
        }
}

int ModeOf(const std::string &name) {
    return name == "upward" ? FE_UPWARD : name == "downward" ? FE_DOWNWARD : FE_TOWARDZERO;
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 3)
        return 2;
    const int mode = ModeOf(argv[1]);
    const std::string when = argv[2];
    if (when == "before")
        std::fesetround(mode);
    b2World world(b2Vec2(0.0f, -10.0f));
    FillWithBoxes(world);
    AddWheel(world, {-3.0f, 20.0f}, 24, 1.5f);
    AddWheel(world, {-2.0f, 24.0f}, 24, 1.5f);
    Turner turner(mode);
    if (when == "listening")
        world.SetContactListener(&turner);
    Hash hash;
    for (int step = 0; step < 150; ++step) {
        if (when == "later" && step == 40)
            std::fesetround(mode);
        if (when == "in-turn")
            std::fesetround(step % 3 == 2 ? mode : FE_TONEAREST);
        Step(world, 1, &hash);
        AddBoxes(world, &hash);
        if (step % 25 == 24)
            Print(argv[2], hash);
    }
    return 0;
}
