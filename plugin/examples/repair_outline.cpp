// SPDX-License-Identifier: MIT
// An outline as an editor may hand it over, repaired; and tiles that become one outline.
#include <cstdio>
#include <vector>

#include <box2d/box2d.h>

#include <boomerang/box2d.h>
#include <boomerang/repair.h>

namespace {

/// Within a centimetre points become one, and edges bend to points.
constexpr double kSnap = 0.01;

void Build(b2Body *body, const char *name, const std::vector<bmr::Outline> &outlines) {
    for (const bmr::Outline &outline : outlines) {
        bmr::OutlineShape shape;
        if (shape.Set(outline.GetRings()) == BMR_OK && shape.CreateFixtures(body, 1.0f) == BMR_OK)
            std::printf("%s: %d points, %d holes, %d pieces\n", name, static_cast<int>(outline.points.size()),
                        static_cast<int>(outline.counts.size()) - 1, static_cast<int>(shape.GetPieceCount()));
    }
}

} // namespace

int main() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef def;
    b2Body *body = world.CreateBody(&def);

    // A wall whose window lies along its edge, and that ends in a loop.
    const b2Vec2 wall[] = {{0, 0}, {6, 0}, {6, 3}, {5, 2}, {7, 2}, {0, 3}};
    const b2Vec2 window[] = {{0, 1}, {1, 1}, {1, 2}, {0, 2}};
    bmr::Outline drawn;
    drawn.AddRing(wall, 6);
    drawn.AddRing(window, 4);
    bmr::OutlineShape asDrawn;
    std::printf("as drawn: %s\n", bmr_error_describe(asDrawn.Set(drawn.GetRings())));
    std::vector<bmr::Outline> repaired;
    if (bmr::RepairOutline(drawn, bmr::FillRule::EvenOdd, kSnap, &repaired) == BMR_OK)
        Build(body, "repaired", repaired);

    // Tiles around a pond.
    std::vector<bmr::Outline> tiles;
    for (int x = 0; x < 5; ++x)
        for (int y = 0; y < 4; ++y) {
            if (x == 2 && y == 2)
                continue;
            const float left = static_cast<float>(x), bottom = 10.0f + static_cast<float>(y);
            const b2Vec2 tile[] = {
                {left, bottom}, {left + 1, bottom}, {left + 1, bottom + 1}, {left, bottom + 1}};
            tiles.emplace_back();
            tiles.back().AddRing(tile, 4);
        }
    std::vector<bmr::Outline> merged;
    if (bmr::MergeOutlines(tiles.data(), tiles.size(), bmr::FillRule::NonZero, kSnap, &merged) == BMR_OK)
        Build(body, "merged", merged);
    return repaired.empty() || merged.empty() ? 1 : 0;
}
