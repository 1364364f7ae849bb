// SPDX-License-Identifier: MIT
// CertifiedSlack is a lower bound of the true distance, in whatever state the pair is.
#include "box2d_shapes.h"
#include "convex_ground.h"
#include "proofs/thresholds.h"

using namespace as_stock;

namespace {

double TrueDistance(const b2Body *a, const b2Body *b) {
    double least = INFINITY;
    for (const b2Fixture *f = a->GetFixtureList(); f != nullptr; f = f->GetNext()) {
        for (const b2Fixture *g = b->GetFixtureList(); g != nullptr; g = g->GetNext())
            least = std::min(
                least, shapes::Measure(*static_cast<const b2PolygonShape *>(f->GetShape()), a->GetTransform(),
                                       *static_cast<const b2PolygonShape *>(g->GetShape()), b->GetTransform())
                           .distance);
    }
    return least;
}

b2Body *RandomBody(Game &game, shapes::Engine &engine, b2Vec2 place) {
    b2Body *body = game.Body(b2_dynamicBody, place, shapes::UniformF(engine, -3.0, 3.0));
    body->SetSleepingAllowed(false);
    for (int i = shapes::Below(engine, 3); i >= 0; --i)
        game.Fixture(body, shapes::RandomPolygon(engine, 1.0));
    body->SetLinearVelocity({shapes::UniformF(engine, -2.0, 2.0), shapes::UniformF(engine, -2.0, 2.0)});
    body->SetAngularVelocity(shapes::UniformF(engine, -2.0, 2.0));
    return body;
}

struct Tally {
    size_t asked = 0, positive = 0, tooLarge = 0, nearlyTooLarge = 0, unlike = 0;

    void Look(const b2Body *a, const b2Body *b) {
        const double slack = double{bmr::CertifiedSlack(a, b)}, distance = TrueDistance(a, b);
        ++asked;
        positive += slack > 0.0;
        tooLarge += slack > distance;
        nearlyTooLarge += slack > 0.0 && slack + 3.0 * bmr::kRoundingMargin > distance;
        unlike += slack != double{bmr::CertifiedSlack(b, a)};
    }
};

} // namespace

AS_STOCK("the certified slack is never above the true distance") {
    shapes::Engine engine(7);
    Tally tally;
    for (size_t world = 0; world < test_scaled(150); ++world) {
        Heard game(run);
        const float range = shapes::UniformF(engine, 0.0, 400.0);
        b2Body *a = RandomBody(game, engine, {range, -range});
        b2Body *b = RandomBody(
            game, engine,
            {range + shapes::UniformF(engine, -2.5, 2.5), shapes::UniformF(engine, -2.5, 2.5) - range});
        if (run.HasPlugin())
            tally.Look(a, b); // before anybody has looked
        for (int step = 0; step < 30; ++step) {
            game.world.Step(1.0f / 60.0f, 8, 3);
            if (run.HasPlugin())
                tally.Look(a, b);
            const b2Vec2 home = b->GetPosition();
            const float angle = b->GetAngle();
            b->SetTransform(home + b2Vec2(shapes::UniformF(engine, -0.2, 0.2), 0.05f), angle + 0.1f);
            if (run.HasPlugin())
                tally.Look(a, b); // moved since the last step
            b->SetTransform(home, angle);
        }
    }
    run.Print("looked");
    run.Expect(tally.asked > 0 && tally.positive > tally.asked / 10, "there is something to check");
    run.Expect(tally.tooLarge == 0, "never above the true distance");
    run.Expect(tally.unlike == 0, "the same from either side");
    run.Expect(tally.nearlyTooLarge > 0, "control: three rounding margins more would be above it");
}

AS_STOCK("bodies of boxes that are a tenth apart have positive slack after a step") {
    shapes::Engine engine(8);
    size_t apart = 0, none = 0, together = 0, some = 0;
    for (size_t world = 0; world < test_scaled(600); ++world) {
        Heard game(run);
        b2Body *bodies[2];
        for (int i = 0; i < 2; ++i) {
            bodies[i] = game.Body(b2_dynamicBody,
                                  {shapes::UniformF(engine, -1.5, 1.5), shapes::UniformF(engine, -1.5, 1.5)},
                                  shapes::UniformF(engine, -3.0, 3.0));
            game.Box(bodies[i], 0.6f, 0.1f, {0.6f, 0.0f});
            if (world % 2 == 0)
                game.Box(bodies[i], 0.3f, 0.2f, {-0.3f, 0.0f});
        }
        game.world.Step(1.0f / 60.0f, 8, 3);
        if (!run.HasPlugin())
            continue;
        const double distance = TrueDistance(bodies[0], bodies[1]);
        const bool positive = bmr::CertifiedSlack(bodies[0], bodies[1]) > 0.0f;
        apart += distance > 0.1;
        none += distance > 0.1 && !positive;
        together += distance <= 0.0;
        some += distance <= 0.0 && positive;
    }
    run.Print("looked");
    run.Expect(apart > 0 && together > 0, "both kinds");
    run.Expect(none == 0, "positive where apart");
    run.Expect(some == 0, "zero where they overlap");
}

AS_STOCK("the certified slack is of the vertices as they are, whatever the normals") {
    size_t asked = 0, tooLarge = 0, positive = 0;
    for (int kind = 0; kind < 5; ++kind) {
        Heard game(run, {0.0f, 0.0f});
        // The corner of one towards the corner of the other, so that their boxes overlap.
        b2Body *a = game.Body(b2_dynamicBody, {0.0f, 0.0f}, 0.5f),
               *b = game.Body(b2_dynamicBody, b2Mul(b2Rot(0.5f), b2Vec2(2.5f, 0.2f)), 0.5f);
        game.Plank(a);
        game.Plank(b, {0.0f, 0.4f});
        game.Box(a, 1.0f, 1.0f);
        game.Box(b, 1.0f, 1.0f);
        game.Step(3);
        for (b2Body *body : {a, b}) {
            auto *shape = static_cast<b2PolygonShape *>(body->GetFixtureList()->GetShape());
            for (int32 i = 0; i < shape->m_count; ++i) {
                b2Vec2 &v = shape->m_vertices[i], &n = shape->m_normals[i];
                if (kind == 1)
                    n *= 3.0f;
                else if (kind == 2)
                    n = b2Mul(b2Rot(0.5f), n);
                else if (kind == 3)
                    v.y *= 0.5f;
                else if (kind == 4)
                    v += 0.15f * b2Vec2(v.y, v.x); // a rhomb that sticks out of the box
            }
        }
        if (!run.HasPlugin())
            continue;
        const double slack = double{bmr::CertifiedSlack(a, b)}, distance = TrueDistance(a, b);
        ++asked;
        tooLarge += slack > distance;
        positive += kind == 0 && slack > 0.0;
    }
    run.Print("looked");
    run.Expect(asked == 5 && positive == 1, "there is something to check");
    run.Expect(tooLarge == 0, "never above the true distance");
}

namespace {

/// Distance of two convex outlines, 0 where they overlap: by all pairs of a vertex and an edge.
double DistanceOfReal(const b2Body *a, const b2Body *b, bool octagons) {
    const b2Body *bodies[2] = {a, b};
    std::vector<shapes::Point> outlines[2];
    for (int i = 0; i < 2; ++i) {
        const auto *shape = static_cast<const bmr::ConvexShape *>(bodies[i]->GetFixtureList()->GetShape());
        const int32 count = octagons ? shape->m_count : shape->GetVertexCount();
        for (int32 k = 0; k < count; ++k)
            outlines[i].push_back(shapes::Place(bodies[i]->GetTransform(),
                                                octagons ? shape->m_vertices[k] : shape->GetVertex(k)));
    }
    double least = INFINITY;
    for (int i = 0; i < 2; ++i) {
        const std::vector<shapes::Point> &own = outlines[i], &other = outlines[1 - i];
        for (size_t k = 0; k < own.size(); ++k)
            for (const shapes::Point &p : other)
                least = std::min(least, shapes::DistanceToSegment(p, own[k], own[(k + 1) % own.size()]));
    }
    return least;
}

} // namespace

AS_STOCK("the certified slack is never above the distance of the real polygons") {
    shapes::Engine engine(13);
    int positive = 0, tooLarge = 0, aboveUnlessOctagon = 0;
    for (int round = 0; round < 150; ++round) {
        Heard game(run);
        const int32 counts[2] = {9 + shapes::Below(engine, 20), 60 + shapes::Below(engine, 60)};
        b2Body *bodies[2];
        for (int i = 0; i < 2; ++i) {
            bodies[i] =
                game.Body(b2_dynamicBody, {1.15f * Real(i), 0.0f}, shapes::UniformF(engine, -3.0, 3.0));
            bodies[i]->SetSleepingAllowed(false);
            game.Fixture(bodies[i], ground::Coin(counts[i], i == 0 ? 0.5f : 0.6f));
            bodies[i]->SetAngularVelocity(shapes::UniformF(engine, -2.0, 2.0));
        }
        for (int step = 0; step < 4; ++step) {
            game.world.Step(1.0f / 60.0f, 8, 3);
            const auto slack = double{bmr::CertifiedSlack(bodies[0], bodies[1])};
            positive += slack > 0.0;
            tooLarge += slack > DistanceOfReal(bodies[0], bodies[1], false);
            aboveUnlessOctagon += slack < DistanceOfReal(bodies[0], bodies[1], true) - 0.01;
        }
    }
    run.Print("%d", tooLarge);
    run.Expect(tooLarge == 0, "never above");
    run.Expect(positive > 300, "positive where there is room");
    run.Expect(aboveUnlessOctagon > 300, "and the octagons' distance would be");
}
