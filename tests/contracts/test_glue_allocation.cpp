// SPDX-License-Identifier: MIT
// Memory that fails for the glue, and for this program's own code: shapes and the recorder answer and stay as
// they were, and all else ends the program with a sentence.
#include <atomic>
#include <csignal>
#include <new>

#include "as_stock.h"
#include "base/columns.h"
#include "boomerang/contact_recorder.h"
#include "boomerang/convex_shape.h"
#include "box2d_shapes.h"

// --- Memory that fails for the code that this is linked with: every call of malloc and of operator new in
// there comes by here (the linker's --wrap). What Box2D and the C++ runtime ask for themselves does not. ---

// NOLINTBEGIN(bugprone-reserved-identifier): the linker's names
extern "C" {
void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *block, size_t size);
void __real_free(void *block);
void *__real__Znwm(size_t size);
void __real__ZdlPv(void *block);

void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *block, size_t size);
void __wrap_free(void *block);
void *__wrap__Znwm(size_t size);
void *__wrap__ZnwmRKSt9nothrow_t(size_t size, const std::nothrow_t &);
void __wrap__ZdlPv(void *block);
void __wrap__ZdlPvm(void *block, size_t size);
}

namespace {

std::atomic<uint64_t> failAt{UINT64_MAX};
std::atomic<uint64_t> asked{0}, failed{0};
std::atomic<int64_t> out{0};

/// Is this allocation to fail? Counts it.
bool Fails() {
    const uint64_t number = asked.fetch_add(1);
    const bool fails = number == failAt;
    failed += fails;
    return fails;
}

void *Counted(void *block) {
    out += block != nullptr;
    return block;
}

} // namespace

extern "C" {

void *__wrap_malloc(size_t size) {
    return Fails() ? nullptr : Counted(__real_malloc(size));
}

void *__wrap_calloc(size_t count, size_t size) {
    return Fails() ? nullptr : Counted(__real_calloc(count, size));
}

/// (Nobody here asks for none.) A block that grows stays one block.
void *__wrap_realloc(void *block, size_t size) {
    if (Fails())
        return nullptr;
    void *const grown = __real_realloc(block, size);
    return block == nullptr ? Counted(grown) : grown;
}

void __wrap_free(void *block) {
    out -= block != nullptr;
    __real_free(block);
}

void *__wrap__Znwm(size_t size) {
    if (Fails())
        throw std::bad_alloc();
    return Counted(__real__Znwm(size));
}

void *__wrap__ZnwmRKSt9nothrow_t(size_t size, const std::nothrow_t &) {
    return Fails() ? nullptr : Counted(__real__Znwm(size));
}

void __wrap__ZdlPv(void *block) {
    out -= block != nullptr;
    __real__ZdlPv(block);
}

void __wrap__ZdlPvm(void *block, size_t) {
    __wrap__ZdlPv(block);
}

} // extern "C"
// NOLINTEND(bugprone-reserved-identifier)

namespace failing_malloc {

/// Allocation `number` from now on fails; UINT64_MAX: none.
void FailAt(uint64_t number) {
    asked = failed = 0;
    failAt = number;
}

/// Since then.
uint64_t Failed() {
    return failed;
}

/// Blocks that are out now.
int64_t Out() {
    return out;
}

} // namespace failing_malloc

using bmr::ConvexShape;
using namespace as_stock;

namespace {

constexpr uint64_t kNoFailure = UINT64_MAX;

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
            const int64_t outBefore = failing_malloc::Out();
            failing_malloc::FailAt(failures);
            error = maker.make(&shape, points);
            const bool failedOnce = failing_malloc::Failed() > 0;
            failing_malloc::FailAt(kNoFailure);
            CHECK(error == (failedOnce ? BMR_ERROR_NO_MEMORY : BMR_OK));
            if (error == BMR_OK)
                continue;
            std::memcpy(after, static_cast<const void *>(&shape), sizeof shape);
            CHECK(std::memcmp(before, after, sizeof shape) == 0);
            CHECK(failing_malloc::Out() == outBefore);
            CHECK(shape.GetVertexCount() == 30);
            CHECK(maker.make(&shape, points) == BMR_OK);
        }
        if (std::strcmp(maker.name, "a copy") == 0)
            CHECK(failures == 1); // it asks for none
        else
            CHECK(failures > 1);
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
    bmr::DrawConvexShapes(world, all, bmr::DrawAs::Whole);
    failing_malloc::FailAt(0);
    bmr::DrawConvexShapes(world, less, bmr::DrawAs::Whole);
    failing_malloc::FailAt(kNoFailure);
    CHECK(all.polygons == 2);
    CHECK(less.polygons == 1 + 8); // 48 triangles, six to a piece
}

TEST_CASE("without memory for its own tables the program ends with a sentence") {
    std::string end;
    const std::string said = StderrOf([&end] {
        end = as_stock::InChild([](as_stock::Run &) {
            std::signal(SIGABRT, SIG_DFL); // else doctest's report of a crash
            bmr::Column<int> column;
            failing_malloc::FailAt(0);
            column.Reserve(100);
        });
    });
    CHECK(end == "!child was ended by signal " + std::to_string(SIGABRT) + "\n");
    CHECK(said == "boomerang: there is no memory\n");
}

TEST_CASE("a recorder without memory loses events, and says how many") {
    const auto play = [](uint64_t fail, int32 *lost) {
        failing_malloc::FailAt(fail);
        int32 taken = 0;
        {
            bmr::ContactRecorder recorder;
            recorder.SetHitThreshold(0.0f);
            b2World world({0.0f, -10.0f});
            world.SetContactListener(&recorder);
            FillWithBoxes(world);
            for (int step = 0; step < 60; ++step) {
                world.Step(1.0f / 60.0f, 8, 3);
                const bmr::ContactEvents events = recorder.Take();
                taken += events.begins.count + events.ends.count + events.sensorBegins.count +
                         events.sensorEnds.count + events.hits.count + events.lost;
                *lost += events.lost;
            }
            world.SetContactListener(nullptr);
        }
        failing_malloc::FailAt(kNoFailure);
        return taken;
    };
    int32 lost = 0;
    const int32 all = play(kNoFailure, &lost);
    REQUIRE(all > 100);
    REQUIRE(lost == 0);
    const uint64_t allAsked = 12; // two rooms, and lists that grow
    for (uint64_t fail = 0; fail < allAsked; ++fail) {
        CAPTURE(fail);
        const int64_t outBefore = failing_malloc::Out();
        lost = 0;
        CHECK(play(fail, &lost) == all);
        CHECK(lost > 0);
        CHECK(failing_malloc::Out() == outBefore);
    }
}
