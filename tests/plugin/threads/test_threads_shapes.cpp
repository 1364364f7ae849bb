// SPDX-License-Identifier: MIT
// Polygons of any size that threads share, make and free: their shapes, and the questions about distance in
// front of which the library stands. Above all for the thread sanitizer.
#include <atomic>

#include <boomerang/box2d.h>
#include <box2d/b2_distance.h>

#include "cases.h"

namespace {

constexpr int kThreads = 4;

void InParallel(const std::function<void(int)> &work) {
    std::vector<std::thread> crew;
    for (int i = 0; i < kThreads; ++i)
        crew.emplace_back(work, i);
    for (std::thread &member : crew)
        member.join();
}

/// Counts, and brings no order into what the threads do: else the sanitizer would take them for well behaved.
class Wrong {
public:
    void operator+=(bool is) { m_count.fetch_add(is, std::memory_order_relaxed); }
    size_t Count() const { return m_count; }

private:
    std::atomic<size_t> m_count{0};
};

/// Of two proxies side by side, `apart` between their middles.
float Distance(const b2DistanceProxy &a, const b2DistanceProxy &b, float apart) {
    b2DistanceInput input;
    input.proxyA = a;
    input.proxyB = b;
    input.transformA.SetIdentity();
    input.transformB.Set({apart, 0.0f}, 0.0f);
    input.useRadii = false;
    b2SimplexCache cache;
    cache.count = 0;
    b2DistanceOutput output;
    b2Distance(&output, &cache, &input);
    return output.distance;
}

} // namespace

TEST_CASE("shapes that are set to boxes, to polygons and to each other on many threads stay what they are") {
    const size_t rounds = test_scaled(3000);
    Wrong wrong;
    bmr::ConvexShape shared;
    REQUIRE(shared.SetRegular(50, 2.0f) == BMR_OK);
    InParallel([&](int member) {
        bmr::ConvexShape mine[3];
        for (size_t k = 0; k < rounds; ++k) {
            bmr::ConvexShape &shape = mine[k % 3];
            const auto count = static_cast<int32>(9 + (k + static_cast<size_t>(member)) % 30);
            switch ((k / 3) % 5) {
            case 0:
                wrong += shape.SetRegular(count, 1.0f) != BMR_OK || shape.GetVertexCount() != count;
                break;
            case 1:
                wrong += shape.SetAsBox(1.0f, 0.5f) != BMR_OK || shape.GetVertexCount() != 4;
                break;
            case 2:
                shape = shared;
                wrong += shape.GetVertices() != shared.GetVertices();
                break;
            case 3:
                wrong += shape.Simplify(0.05f) != BMR_OK || shape.GetVertexCount() >= 50;
                break;
            default:
                shape = mine[(k + 1) % 3];
            }
            b2MassData mass;
            shared.ComputeMass(&mass, 1.0f);
            wrong += !(std::fabs(mass.center.x) < 1e-5f);
        }
    });
    CHECK(wrong.Count() == 0);
}

TEST_CASE("the last of the threads that share a polygon frees it, whichever that is") {
    const size_t rounds = test_scaled(300);
    Wrong wrong;
    for (size_t k = 0; k < rounds; ++k) {
        std::vector<bmr::ConvexShape> copies(kThreads);
        REQUIRE(copies[0].SetRegular(12, 1.0f) == BMR_OK);
        for (bmr::ConvexShape &copy : copies)
            copy = copies[0];
        InParallel([&](int member) {
            bmr::ConvexShape last = copies[static_cast<size_t>(member)];
            copies[static_cast<size_t>(member)] = bmr::ConvexShape();
            wrong += last.GetVertexCount() != 12 || last.GetVertex(0).x != 1.0f;
        });
    }
    CHECK(wrong.Count() == 0);
}

TEST_CASE("a shape that is handed from thread to thread is the one that was sent") {
    const size_t rounds = test_scaled(2000);
    std::atomic<bmr::ConvexShape *> sent{nullptr};
    Wrong wrong;
    std::thread receiver([&] {
        for (size_t k = 0; k < rounds;) {
            bmr::ConvexShape *shape = sent.exchange(nullptr, std::memory_order_acquire);
            if (shape == nullptr) {
                std::this_thread::yield();
                continue;
            }
            wrong += shape->GetVertexCount() != static_cast<int32>(9 + k % 20);
            b2DistanceProxy proxy;
            proxy.Set(shape, 0);
            wrong += !(std::fabs(Distance(proxy, proxy, 4.0f) - 2.0f) < 0.2f);
            delete shape;
            ++k;
        }
    });
    for (size_t k = 0; k < rounds; ++k) {
        auto *shape = new bmr::ConvexShape();
        wrong += shape->SetRegular(static_cast<int32>(9 + k % 20), 1.0f) != BMR_OK;
        bmr::ConvexShape *expected = nullptr;
        while (!sent.compare_exchange_weak(expected, shape, std::memory_order_release)) {
            expected = nullptr;
            std::this_thread::yield();
        }
    }
    receiver.join();
    CHECK(wrong.Count() == 0);
}

// A proxy of ours carries a mark in memory that Box2D's own leave as it was: a game's proxy of many points
// may stand where one of ours stood, with the mark of a polygon that another thread is just freeing.
TEST_CASE("a mark that was left in a proxy of a game's own points leads to nobody's polygon") {
    const size_t rounds = test_scaled(2000);
    std::vector<b2Vec2> points;
    for (int i = 0; i < 12; ++i)
        points.push_back({3.0f * std::cos(static_cast<float>(i) * b2_pi / 6.0f),
                          3.0f * std::sin(static_cast<float>(i) * b2_pi / 6.0f)});
    Wrong wrong;
    // What was in the mark: the proxy's buffer, in a word a time.
    std::atomic<uint64_t> left[2] = {{0}, {0}};
    std::atomic<bool> done{false};
    std::thread maker([&] {
        for (size_t k = 0; k < rounds; ++k) {
            bmr::ConvexShape shape;
            wrong += shape.SetRegular(12, 1.0f) != BMR_OK;
            b2DistanceProxy proxy;
            proxy.Set(&shape, 0);
            uint64_t words[2];
            std::memcpy(words, proxy.m_buffer, sizeof words);
            left[0].store(words[0], std::memory_order_relaxed);
            left[1].store(words[1], std::memory_order_relaxed);
            std::this_thread::yield();
        }
        done = true;
    });
    while (!done) {
        b2DistanceProxy proxy;
        proxy.m_vertices = points.data();
        proxy.m_count = static_cast<int32>(points.size());
        proxy.m_radius = 0.0f;
        const uint64_t words[2] = {left[0].load(std::memory_order_relaxed),
                                   left[1].load(std::memory_order_relaxed)};
        std::memcpy(static_cast<void *>(proxy.m_buffer), words, sizeof words);
        wrong += !(std::fabs(Distance(proxy, proxy, 10.0f) - 4.0f) < 0.2f);
    }
    maker.join();
    CHECK(wrong.Count() == 0);
}
