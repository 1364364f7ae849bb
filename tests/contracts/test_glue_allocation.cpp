// SPDX-License-Identifier: MIT
// Every allocation of the glue fails once: worlds keep stock's bits, shapes stay as they were, and nothing is
// lost. (All of this program is linked with memory that fails, its own code too: what fails while a world
// steps must be the glue's.)
#include <sys/mman.h>
#include <sys/wait.h>

#include "as_stock.h"
#include "base/column.h"
#include "boomerang/contact_recorder.h"
#include "boomerang/convex_shape.h"
#include "boomerang/inspect.h"
#include "box2d_shapes.h"
#include "failing_malloc.h"

using bmr::ConvexShape;
using namespace as_stock;

namespace {

constexpr uint64_t kNoFailure = UINT64_MAX;
/// What the next child does; fork hands it on.
uint64_t failAt = kNoFailure;
bmr::Options options;

/// What the last child found.
struct Found {
    uint64_t asked, failed;
    int64_t left;
};
Found *const found = static_cast<Found *>(
    mmap(nullptr, sizeof(Found), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));

int64_t outAtBegin = 0;

void Begin(const Run &run, uint64_t fail) {
    outAtBegin = failing_malloc::Out();
    failing_malloc::FailAt(run.HasPlugin() ? fail : kNoFailure);
}

void End() {
    *found = {failing_malloc::Asked(), failing_malloc::Failed(), failing_malloc::Out() - outAtBegin};
    failing_malloc::FailAt(kNoFailure);
}

/// Small polygons in bodies of many fixtures, whose hulls come, change and go. The plugin is installed with
/// memory that fails, too.
void PlayPlanks(Run &run) {
    Begin(run, failAt);
    if (run.HasPlugin())
        bmr::Install(options);
    {
        Game game(run, {0.0f, -10.0f});
        game.Plank(game.Body(b2_staticBody, {0.0f, 0.0f}));
        b2Body *above = game.Body(b2_dynamicBody, {0.3f, 0.6f}, 0.1f);
        game.Plank(above);
        b2Body *high = game.Body(b2_dynamicBody, {-0.3f, 1.2f});
        game.Plank(high);
        game.Step(20);
        auto *shape = static_cast<b2PolygonShape *>(above->GetFixtureList()->GetShape());
        shape->m_vertices[0] *= 1.01f;
        game.Step(10);
        game.Fixture(game.Body(b2_staticBody, {0.0f, 1.0f}), *shape, true);
        game.Step(10);
        game.world.DestroyBody(above);
        game.Step(20);
    }
    End();
}

/// Big polygons, several in a body; made before memory fails.
void PlayCoins(Run &run) {
    if (run.HasPlugin())
        bmr::Install(options);
    ConvexShape coin, plate;
    if (coin.SetRegular(100, 0.4f) != BMR_OK || plate.SetRounded(3.0f, 0.2f, 0.1f, 20) != BMR_OK) {
        run.Print("!no shapes");
        return;
    }
    Begin(run, failAt);
    {
        Game game(run, {0.0f, -10.0f});
        game.Fixture(game.Body(b2_staticBody, {0.0f, 0.0f}), plate);
        for (int i = 0; i < 4; ++i) {
            b2Body *body = game.Body(b2_dynamicBody, {1.5f * Real(i) - 2.2f, 0.8f});
            game.Fixture(body, coin);
            for (int k = 0; k < 9; ++k)
                game.Box(body, 0.1f, 0.1f, {0.1f * Real(k), 0.0f});
        }
        game.Step(40);
    }
    End();
}

void CheckEveryFailure(Scenario scenario, bool likeStock, int64_t stays) {
    failAt = kNoFailure;
    const std::string reference = InChild(scenario, likeStock ? nullptr : &options, Installed::ByPlay);
    const std::string whole = InChild(scenario, &options, Installed::ByPlay);
    REQUIRE(reference.size() > 1000);
    REQUIRE(Difference(reference, whole) == "");
    const Found complete = *found;
    REQUIRE(complete.asked > 5);
    REQUIRE(complete.failed == 0);
    CHECK(complete.left <= stays);
    // The first ones all, the others in steps that leave none of their kind out.
    const uint64_t most = test_scaled(30);
    for (failAt = 0; failAt < complete.asked; failAt += failAt < 20 ? 1 : complete.asked / most + 1) {
        CAPTURE(failAt);
        const std::string failing = InChild(scenario, &options, Installed::ByPlay);
        CHECK(Difference(reference, failing) == "");
        CHECK(found->failed == 1);
        CHECK(found->left <= complete.left);
    }
}

struct CountingDraw : IdleDraw {
    int polygons = 0;
    void DrawSolidPolygon(const b2Vec2 *, int32, const b2Color &) override { ++polygons; }
};

} // namespace

TEST_CASE("a shape without memory says so, stays as it was, and can be set once there is some") {
    std::vector<b2Vec2> points;
    {
        ConvexShape ellipse; // up to 8 vertices: no memory, so that the first one below is the first of all
        REQUIRE(ellipse.SetEllipse(8, 1.0f, 1.0f) == BMR_OK);
        for (int i = 0; i < 60; ++i) {
            const b2Rot rotation(0.1f * Real(i));
            points.push_back(2.0f * rotation.GetXAxis());
        }
    }
    using Make = bmr_error (*)(ConvexShape *, const std::vector<b2Vec2> &);
    const struct {
        const char *name;
        Make make;
    } makers[] = {
        {"Set", [](ConvexShape *shape,
                   const std::vector<b2Vec2> &p) { return shape->Set(p.data(), int32(p.size())); }},
        {"SetRaw", [](ConvexShape *shape,
                      const std::vector<b2Vec2> &p) { return shape->SetRaw(p.data(), int32(p.size())); }},
        {"SetRegular",
         [](ConvexShape *shape, const std::vector<b2Vec2> &) { return shape->SetRegular(64, 1.0f); }},
        {"SetRegular of 5",
         [](ConvexShape *shape, const std::vector<b2Vec2> &) { return shape->SetRegular(5, 1.0f); }},
        {"SetEllipse",
         [](ConvexShape *shape, const std::vector<b2Vec2> &) { return shape->SetEllipse(64, 1.0f, 2.0f); }},
        {"SetRounded", [](ConvexShape *shape,
                          const std::vector<b2Vec2> &) { return shape->SetRounded(1.0f, 2.0f, 0.5f, 9); }},
        {"Simplify", [](ConvexShape *shape, const std::vector<b2Vec2> &) { return shape->Simplify(0.05f); }},
        {"a copy",
         [](ConvexShape *shape, const std::vector<b2Vec2> &) {
             const ConvexShape copy = *shape;
             *shape = copy;
             return BMR_OK;
         }},
    };
    for (const auto &maker : makers) {
        CAPTURE(std::string(maker.name));
        uint64_t failures = 0;
        for (bmr_error error = BMR_ERROR_NO_MEMORY; error != BMR_OK; ++failures) {
            REQUIRE(failures < 100);
            ConvexShape shape;
            // Without the first big polygon of all (which makes the registry's first chunk) there is no
            // other.
            const int64_t none = failing_malloc::Out();
            failing_malloc::FailAt(std::strcmp(maker.name, "Set") == 0 ? failures : kNoFailure);
            error = shape.SetRegular(30, 3.0f);
            failing_malloc::FailAt(kNoFailure);
            if (error != BMR_OK) {
                CHECK(error == BMR_ERROR_NO_MEMORY);
                CHECK(shape.GetVertexCount() == 0);
                CHECK(failing_malloc::Out() == none);
                continue;
            }
            unsigned char before[sizeof shape], after[sizeof shape];
            std::memcpy(before, static_cast<const void *>(&shape), sizeof shape);
            const int64_t out = failing_malloc::Out();
            failing_malloc::FailAt(failures);
            error = maker.make(&shape, points);
            const bool failed = failing_malloc::Failed() > 0;
            failing_malloc::FailAt(kNoFailure);
            CHECK(error == (failed ? BMR_ERROR_NO_MEMORY : BMR_OK));
            if (error == BMR_OK)
                continue;
            std::memcpy(after, static_cast<const void *>(&shape), sizeof shape);
            CHECK(std::memcmp(before, after, sizeof shape) == 0);
            CHECK(failing_malloc::Out() == out);
            CHECK(shape.GetVertexCount() == 30);
            CHECK(maker.make(&shape, points) == BMR_OK);
        }
        if (std::strcmp(maker.name, "a copy") == 0)
            CHECK(failures == 1); // it asks for none
        else
            CHECK(failures > 1);
    }
}

TEST_CASE("a world of small polygons plays as stock, whatever allocation fails") {
    for (const char *structure : {"", "free-direction", "lazy-dudley", "lazy-compass"}) {
        const std::string name = structure;
        CAPTURE(name);
        options = bmr::Options();
        const PairsBy by(name.empty() ? nullptr : structure);
        // The compass table is the process's.
        CheckEveryFailure(PlayPlanks, true, name == "lazy-compass" ? 1 : 0);
    }
}

TEST_CASE("a world of big polygons plays as with memory, whatever allocation fails") {
    for (const bmr_structure structure : {BMR_FREE_DIRECTION, BMR_LAZY_DUDLEY}) {
        options = bmr::Options();
        const PairsBy by(structure);
        CheckEveryFailure(PlayCoins, false, 0);
    }
}

TEST_CASE("what cannot be drawn whole for want of memory is drawn in pieces") {
    b2World world({0.0f, 0.0f});
    ConvexShape shape;
    REQUIRE(shape.SetRegular(50, 1.0f) == BMR_OK);
    b2BodyDef def;
    for (int i = 0; i < 2; ++i)
        world.CreateBody(&def)->CreateFixture(&shape, 1.0f);
    CountingDraw all, less;
    failing_malloc::FailAt(kNoFailure);
    bmr::DrawConvexShapes(world, all, bmr::Outlines::Whole);
    failing_malloc::FailAt(0);
    bmr::DrawConvexShapes(world, less, bmr::Outlines::Whole);
    failing_malloc::FailAt(kNoFailure);
    CHECK(all.polygons == 2);
    CHECK(less.polygons == 1 + 8); // 48 triangles, six to a piece
}

TEST_CASE("without memory for a step the program ends with a sentence") {
    const std::string said = StderrOf([] {
        const pid_t child = fork();
        if (child == 0) {
            bmr::Column<int> column;
            failing_malloc::FailAt(0);
            column.Reserve(100);
            test_leave(0);
        }
        int status = 0;
        waitpid(child, &status, 0);
        CHECK(WIFSIGNALED(status));
        CHECK(WTERMSIG(status) == SIGABRT);
    });
    CHECK(said == "boomerang: there is no memory for a step of Box2D\n");
}

TEST_CASE("Install without memory for its table is refused, and says so") {
    // Which Box2D this is may be known already: then the table is the first that is asked for, else the
    // second.
    static uint64_t at;
    int refused = 0;
    for (at = 0; at < 2; ++at)
        refused += InChild([](Run &run) {
                       const PairsBy by(BMR_LAZY_COMPASS);
                       bool done = true;
                       const std::string said = StderrOf([&] {
                           failing_malloc::FailAt(at);
                           done = bmr::Install();
                           failing_malloc::FailAt(UINT64_MAX);
                       });
                       run.Print("%d %d %s", done, bmr::IsInstalled(), said.c_str());
                   }) == "0 0 boomerang: not at work, Box2D runs as it is: there is no memory\n\n";
    CHECK(refused == 1);
}

TEST_CASE("a recorder without memory loses events, and says how many") {
    const auto play = [](uint64_t fail, int32 *lost) {
        failing_malloc::FailAt(fail);
        int32 told = 0;
        {
            bmr::ContactRecorder recorder;
            recorder.SetHitThreshold(0.0f);
            b2World world({0.0f, -10.0f});
            world.SetContactListener(&recorder);
            FillWithBoxes(world);
            for (int step = 0; step < 60; ++step) {
                world.Step(1.0f / 60.0f, 8, 3);
                const bmr::ContactEvents events = recorder.Take();
                told += events.begins.count + events.ends.count + events.sensorBegins.count +
                        events.sensorEnds.count + events.hits.count + events.lost;
                *lost += events.lost;
            }
            world.SetContactListener(nullptr);
        }
        failing_malloc::FailAt(kNoFailure);
        return told;
    };
    int32 lost = 0;
    const int32 all = play(kNoFailure, &lost);
    REQUIRE(all > 100);
    REQUIRE(lost == 0);
    const uint64_t asked = 12; // two rooms, and lists that grow
    for (uint64_t fail = 0; fail < asked; ++fail) {
        CAPTURE(fail);
        const int64_t out = failing_malloc::Out();
        lost = 0;
        CHECK(play(fail, &lost) == all);
        CHECK(lost > 0);
        CHECK(failing_malloc::Out() == out);
    }
}
