// SPDX-License-Identifier: MIT
#include "recording/recording.h"

#include <limits>
#include <stdexcept>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "recording/bytes.h"
#include "recording/fields.h"

namespace testbed::recording {
namespace {

// With floats for its numbers, so that 0.1f is written as 0.1.
using Json =
    nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, float>;

constexpr char kHead[] = "recording ", kFrame[] = "frame ";

/// How a value becomes JSON and comes back: an object with the fields above, unless it is one of those below.
template <typename Value, typename = void> struct Codec {
    static Json Write(const Value &value) {
        static const Value usual;
        Json json = Json::object();
        Fields(&value, [&](const char *name, auto member) {
            using Member = Codec<std::decay_t<decltype(value.*member)>>;
            Json written = Member::Write(value.*member);
            if (written != Member::Write(usual.*member))
                json.emplace(name, std::move(written));
        });
        return json;
    }
    static Value Read(const Json &json) {
        if (!json.is_object())
            throw std::runtime_error("an object was expected, not " + json.dump());
        Value value;
        Fields(&value, [&](const char *name, auto member) {
            using Member = Codec<std::decay_t<decltype(value.*member)>>;
            if (const auto found = json.find(name); found != json.end())
                value.*member = Member::Read(*found);
        });
        return value;
    }
};

template <typename Value> struct Codec<Value, std::enable_if_t<std::is_integral_v<Value>>> {
    static Json Write(Value value) { return value; }
    static Value Read(const Json &json) { return json.get<Value>(); }
};
template <> struct Codec<float> {
    static Json Write(float value) { return value; }
    // JSON has no name for what is no number.
    static float Read(const Json &json) {
        return json.is_null() ? std::numeric_limits<float>::quiet_NaN() : json.get<float>();
    }
};
template <> struct Codec<std::string> {
    static Json Write(const std::string &value) { return value; }
    static std::string Read(const Json &json) { return json.get<std::string>(); }
};
template <std::size_t N> std::array<float, N> ReadFloats(const Json &json) {
    return Codec<std::array<float, N>>::Read(json);
}
template <> struct Codec<Vec> {
    static Json Write(const Vec &v) { return {v.x, v.y}; }
    static Vec Read(const Json &json) {
        const auto [x, y] = ReadFloats<2>(json);
        return {x, y};
    }
};
template <> struct Codec<Pose> {
    static Json Write(const Pose &pose) { return {pose.position.x, pose.position.y, pose.c, pose.s}; }
    static Pose Read(const Json &json) {
        const auto [x, y, c, s] = ReadFloats<4>(json);
        return {{x, y}, c, s};
    }
};
template <> struct Codec<Box> {
    static Json Write(const Box &box) {
        return {box.body, box.fixture, box.child, box.left, box.bottom, box.right, box.top};
    }
    static Box Read(const Json &json) {
        return {json.at(0).get<int>(),          json.at(1).get<int>(),
                json.at(2).get<int>(),          Codec<float>::Read(json.at(3)),
                Codec<float>::Read(json.at(4)), Codec<float>::Read(json.at(5)),
                Codec<float>::Read(json.at(6))};
    }
};

template <typename Element> struct Codec<std::vector<Element>> {
    static Json Write(const std::vector<Element> &list) {
        Json json = Json::array();
        for (const Element &element : list)
            json.push_back(Codec<Element>::Write(element));
        return json;
    }
    static std::vector<Element> Read(const Json &json) {
        std::vector<Element> list;
        list.reserve(json.size());
        for (const Json &element : json)
            list.push_back(Codec<Element>::Read(element));
        return list;
    }
};
template <typename Element, std::size_t N> struct Codec<std::array<Element, N>> {
    static Json Write(const std::array<Element, N> &list) {
        Json json = Json::array();
        for (const Element &element : list)
            json.push_back(Codec<Element>::Write(element));
        return json;
    }
    static std::array<Element, N> Read(const Json &json) {
        if (!json.is_array() || json.size() != N)
            throw std::runtime_error(std::to_string(N) + " values were expected, not " + json.dump());
        std::array<Element, N> list;
        for (std::size_t i = 0; i < N; ++i)
            list[i] = Codec<Element>::Read(json[i]);
        return list;
    }
};

bool BeginsWith(const std::string &line, const char *head) {
    return line.rfind(head, 0) == 0;
}

template <typename Value> Value Parse(const std::string &line, const std::string &head) {
    try {
        if (!BeginsWith(line, head.c_str()))
            throw std::runtime_error("it does not begin with \"" + head + "\"");
        return Codec<Value>::Read(
            Json::parse(line.begin() + static_cast<std::ptrdiff_t>(head.size()), line.end()));
    } catch (const std::exception &error) {
        throw std::runtime_error("a line of a recording cannot be read: " + std::string(error.what()));
    }
}

} // namespace

Vec Transform(const Pose &pose, const Vec &point) {
    const Vec turned = Rotate(pose, point);
    return {pose.position.x + turned.x, pose.position.y + turned.y};
}

Vec Rotate(const Pose &pose, const Vec &direction) {
    return {pose.c * direction.x - pose.s * direction.y, pose.s * direction.x + pose.c * direction.y};
}

std::string Print(const Head &head) {
    Head ours = head;
    ours.version = kVersion;
    return kHead + Codec<Head>::Write(ours).dump();
}

std::string Print(const Frame &frame) {
    return kFrame + Codec<Frame>::Write(frame).dump();
}

bool IsHead(const std::string &line) {
    return BeginsWith(line, kHead);
}

bool IsFrame(const std::string &line) {
    return BeginsWith(line, kFrame) || IsPacked(line);
}

Head ParseHead(const std::string &line) {
    const Head head = Parse<Head>(line, kHead);
    if (head.version != kVersion)
        throw std::runtime_error("a recording of version " + std::to_string(head.version) + ", not " +
                                 std::to_string(kVersion));
    return head;
}

Frame ParseFrame(const std::string &line) {
    return IsPacked(line) ? Unpack(line) : Parse<Frame>(line, kFrame);
}

void Gathered::Add(const Frame &frame) {
    for (const std::array<int, 2> &gone : frame.gone)
        fixtures.erase({gone[0], gone[1]});
    for (const Fixture &fixture : frame.fixtures)
        fixtures[{fixture.body, fixture.number}] = fixture;
    for (const Outline &outline : frame.outlines)
        outlines[outline.id] = outline;
}

} // namespace testbed::recording
