// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CONTRACTS_H
#define BOOMERANG_TEST_CONTRACTS_H

#include <climits>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "boomerang/hierarchy.h"
#include "boomerang/pair.h"
#include "boomerang/polygon.h"
#include "failing_allocator.h"

/// @file
/// One row for each function: a call whose arguments name their bad values where they are handed over.
///
///     Row("bmr_compass_create", [](Asked &ask) {
///         bmr_compass *made = Untouched<bmr_compass>();
///         return ask.Says(bmr_compass_create(8, ask.Allocator(), ask.Result("result", &made)));
///     });
///
/// `Row` makes the call with good arguments, and then once for each bad value, which must give the answer of
/// its rule. An error must leave all results as they were. A call that takes `Allocator` is also made once
/// for each of its allocations, which fails.

namespace contracts {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What a call answers: the sentence of its error, or words.
struct Answer {
    Answer(bmr_error error) : text(bmr_error_describe(error)) {}
    Answer(const char *words) : text(words) {}
    Answer(std::string words) : text(std::move(words)) {}
    std::string text;
};
inline const Answer kOk = BMR_OK;

/// Values that all give one answer.
struct Rule {
    std::vector<double> values;
    Answer answer;
};
using Rules = std::vector<Rule>;
inline Rules operator+(Rules a, const Rules &b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}
inline Rules Gives(const Answer &answer, std::vector<double> values) {
    return {{std::move(values), answer}};
}
inline Rules OutOfRange(std::vector<double> values) {
    return Gives(BMR_ERROR_OUT_OF_RANGE, std::move(values));
}
inline const Rules kFinite = Gives(BMR_ERROR_NOT_FINITE, {kNaN, kInfinity, -kInfinity}),
                   kNumber = OutOfRange({kNaN, kInfinity, -kInfinity}),
                   kAboveZero = OutOfRange({0.0, -0.0, -1.0}), kNotBelowZero = OutOfRange({-1e-38, -1.0}),
                   kNotNegative = Gives(BMR_ERROR_NEGATIVE, {-1e-38, -1.0});

/// One call: which of its arguments is bad, and what it must answer then.
class Asked {
public:
    /// @param turn which of the bad values is handed over; SIZE_MAX: none
    explicit Asked(size_t turn, const bmr_allocator *allocator = nullptr, std::string *made = nullptr)
        : m_turn(turn), m_allocator(allocator), m_made(made) {}

    /// One of several values, of which the first is good.
    template <typename T> T Or(const char *name, T good, const std::vector<std::pair<T, Answer>> &others) {
        for (const auto &[bad, answer] : others)
            if (IsTurn(name, answer))
                return bad;
        return good;
    }
    double Number(const char *name, double good, const Rules &rules) {
        for (const Rule &rule : rules)
            for (const double value : rule.values)
                if (IsTurn(std::string(name) + " " + std::to_string(value), rule.answer))
                    return value;
        return good;
    }
    float Float(const char *name, float good, const Rules &rules) {
        return static_cast<float>(Number(name, good, rules));
    }
    template <typename T> T *NotNull(const char *name, T *good) {
        return IsTurn(std::string("no ") + name, BMR_ERROR_NULL_ARGUMENT) ? nullptr : good;
    }
    template <typename T> T *MayBeNull(const char *name, T *good) {
        return IsTurn(std::string("no ") + name, BMR_OK) ? nullptr : good;
    }
    /// A place that must be there, and that an error leaves as it was; the place of an array: its first.
    template <typename T> T *Result(const char *name, T *place) { return NotNull(name, Watched(place)); }
    template <typename T> T *Watched(T *place) {
        const auto *bytes = reinterpret_cast<const unsigned char *>(place);
        m_watched.push_back({bytes, {bytes, bytes + sizeof *place}});
        return place;
    }
    const bmr_allocator *Allocator() {
        allocates = true;
        return m_allocator;
    }
    /// Are there allocations that fail? Then a call may do more.
    bool IsForMemory() const { return m_allocator != nullptr; }
    /// What was made, which must be the same whenever there is memory.
    void Made(const void *bytes, size_t size) const {
        if (m_made != nullptr)
            m_made->append(static_cast<const char *>(bytes), size);
    }
    /// The answer to an error.
    std::string Says(bmr_error error) const {
        const std::string said = Answer(error).text;
        for (const auto &[place, before] : m_watched)
            if (error != BMR_OK && std::memcmp(place, before.data(), before.size()) != 0)
                return said + " - but something is written";
        return said;
    }

    bool allocates = false;
    size_t values = 0; ///< bad ones so far
    std::string with = "all good", expected;

private:
    bool IsTurn(const std::string &name, const Answer &answer) {
        if (values++ != m_turn)
            return false;
        with = name;
        expected = answer.text;
        return true;
    }
    struct Place {
        const unsigned char *bytes;
        std::vector<unsigned char> before;
    };
    size_t m_turn;
    const bmr_allocator *m_allocator;
    std::string *m_made;
    std::vector<Place> m_watched;
};

using Call = std::function<std::string(Asked &)>;

/// Lets allocation 0, 1, 2, ... fail until none is left to fail: each time it is said that there is no
/// memory, nothing is out, and the same call once more, with memory, makes the same.
inline void FailEveryAllocation(const Call &call) {
    test_heap heap;
    const auto attempt = [&](std::string &made) {
        Asked ask(SIZE_MAX, &heap.allocator, &made);
        const std::string said = call(ask);
        CHECK(heap.blocks == 0);
        CHECK(heap.wrong_sizes == 0);
        return said;
    };
    std::string reference;
    test_heap_init(&heap, SIZE_MAX);
    CHECK(attempt(reference) == kOk.text);
    CHECK(!reference.empty());
    const size_t asked = heap.asked;
    CHECK(asked > 0);
    for (size_t failing = 0; failing < asked; ++failing) {
        CAPTURE(failing);
        std::string nothing, again;
        test_heap_init(&heap, failing);
        CHECK(attempt(nothing) == Answer(BMR_ERROR_NO_MEMORY).text);
        CHECK(heap.asked > failing);
        heap.fail_at = SIZE_MAX;
        CHECK(attempt(again) == kOk.text);
        CHECK(again == reference);
    }
}

inline void Row(const char *function, const Call &call, const Answer &good = BMR_OK) {
    CAPTURE(std::string(function));
    Asked well(SIZE_MAX);
    CHECK(call(well) == good.text);
    for (size_t turn = 0; turn < well.values; ++turn) {
        Asked ask(turn);
        const std::string said = call(ask);
        CAPTURE(ask.with);
        CHECK(said == ask.expected);
    }
    if (!well.allocates)
        return;
    FailEveryAllocation(call);
    std::printf("allocates: %s\n", function); // for check_allocators.sh
}

/// What stays as it is where there is an error.
template <typename T> T *Untouched() {
    static T untouched = {};
    return &untouched;
}

inline size_t Count(double value) {
    return value >= 18446744073709551616.0 ? SIZE_MAX : static_cast<size_t>(value);
}
constexpr double kSizeMax = 18446744073709551616.0; ///< stands for SIZE_MAX

inline std::string Word(double value) {
    return std::isnan(value)      ? "NaN"
           : std::isfinite(value) ? "finite"
           : value > 0.0          ? "infinite"
                                  : "minus infinity";
}

// --- good objects, which the calls are made with; a program makes them once ---

/// An ellipse's points, from radius `width` and `height`.
inline std::vector<bmr_vec2> Ellipse(size_t count, double width = 1.0, double height = 1.0) {
    std::vector<bmr_vec2> points;
    for (size_t i = 0; i < count; ++i) {
        const double angle =
            2.0 * 3.14159265358979323846 * static_cast<double>(i) / static_cast<double>(count);
        points.push_back({width * std::cos(angle), height * std::sin(angle)});
    }
    return points;
}
inline bmr_polygon *Polygon(const std::vector<bmr_vec2> &points) {
    bmr_polygon *polygon = nullptr;
    bmr_polygon_create(points.data(), points.size(), nullptr, &polygon);
    return polygon;
}

/// A polygon and its hierarchies.
struct Body {
    bmr_polygon *polygon;
    bmr_compass *compass = nullptr;
    bmr_hierarchy *hierarchies[BMR_HIERARCHY_KIND_COUNT] = {};

    explicit Body(const std::vector<bmr_vec2> &points) : polygon(Polygon(points)) {
        bmr_compass_create(64, nullptr, &compass);
        for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind)
            bmr_hierarchy_build(static_cast<bmr_hierarchy_kind>(kind), polygon, compass, nullptr,
                                &hierarchies[kind]);
    }
    Body(const Body &) = delete;
    Body &operator=(const Body &) = delete;
    ~Body() {
        for (bmr_hierarchy *hierarchy : hierarchies)
            bmr_hierarchy_destroy(hierarchy, nullptr);
        bmr_compass_destroy(compass, nullptr);
        bmr_polygon_destroy(polygon, nullptr);
    }
    bmr_shape Shape() const { return {polygon, {hierarchies[0], hierarchies[1], hierarchies[2]}, {}}; }
};

inline const Body &Square() {
    static const Body square({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    return square;
}
inline const Body &Round() {
    static const Body round(Ellipse(60, 3.0));
    return round;
}

inline std::string VerticesOf(size_t count) {
    return std::to_string(count) + (count == 1 ? " vertex" : " vertices");
}

} // namespace contracts

#endif
