// SPDX-License-Identifier: MIT
//
// Packed frames: what comes back is what went in, to the bit; a frame is one line; damage is told, not read.
#include <stdexcept>

#include "cases.h"
#include "recording/bytes.h"

using namespace testbed::recording;

namespace {

/// A frame with something in every kind of object, in which the bytes that end lines occur often.
Frame RandomFrame(std::mt19937 &random) {
    const auto whole = [&random](int most) {
        return static_cast<int>(random() % static_cast<unsigned>(most));
    };
    const auto real = [&] {
        return whole(3) == 0 ? 0.0f : std::ldexp(static_cast<float>(whole(1 << 20)), -10) - 99.0f;
    };
    const auto vec = [&] { return Vec{real(), real()}; };
    Frame frame;
    frame.step = whole(20);
    for (int i = whole(20); i > 0; --i) {
        frame.bodies.push_back(
            {whole(20), whole(2) == 0 ? "static" : "dynamic", {vec(), real(), real()}, whole(2) == 0});
        frame.fixtures.push_back({whole(20),
                                  whole(20),
                                  "polygon",
                                  {vec(), vec(), vec()},
                                  real(),
                                  whole(2) == 0,
                                  std::vector<int>(static_cast<size_t>(whole(3)), whole(3))});
        frame.gone.push_back({whole(20), whole(20)});
        frame.boxes.push_back({whole(20), whole(20), whole(20), real(), real(), real(), real()});
        frame.joints.push_back({whole(20), "rope", {whole(20), whole(20)}, {vec(), vec()}, {{vec(), vec()}}});
        frame.touching.push_back({{whole(20), whole(20)}, {whole(20), whole(20)}, vec(), {{vec(), real()}}});
        frame.outlines.push_back({whole(20), whole(20), {vec(), vec()}});
        frame.events.push_back(
            {whole(20), "push", whole(20), whole(20), whole(20) - 10, whole(20) - 10, real()});
        Pair pair;
        pair.a = 10 + whole(2);
        pair.b = 1 << whole(30);
        pair.slack = real();
        pair.calls.toi = int64_t{1} << whole(62);
        pair.asked = whole(300);
        pair.proofs.resize(static_cast<size_t>(whole(3)));
        for (Proof &proof : pair.proofs)
            proof.normal = vec();
        frame.pairs.push_back(pair);
    }
    return frame;
}

/// Whether a line is taken for a frame; everything else must be an error of its own kind.
bool Reads(const std::string &line) {
    try {
        Unpack(line);
        return true;
    } catch (const std::runtime_error &) {
        return false;
    }
}

TEST_CASE("a packed frame is one line and reads back to the same") {
    std::mt19937 random(1);
    int marked = 0;
    for (int i = 0; i < 100; ++i) {
        const Frame frame = RandomFrame(random);
        const std::string line = Pack(frame);
        REQUIRE(line.find('\n') == std::string::npos);
        REQUIRE(IsFrame(line));
        REQUIRE(Print(ParseFrame(line)) == Print(frame));
        marked += line.find('\v') != std::string::npos;
    }
    CHECK(marked > 50); // control: there was something to mark
}

TEST_CASE("floats that text does not tell apart come back to the bit") {
    Frame frame;
    frame.pairs.resize(1);
    frame.pairs[0].slack = -0.0f;
    frame.pairs[0].distance = std::nanf("5");
    const Pair back = Unpack(Pack(frame)).pairs.at(0);
    CHECK(std::signbit(back.slack));
    CHECK(std::isnan(back.distance));
}

TEST_CASE("a frame that is cut off or damaged is no frame") {
    std::mt19937 random(2);
    Frame frame = RandomFrame(random);
    while (frame.pairs.size() < 3)
        frame = RandomFrame(random);
    const std::string line = Pack(frame);
    REQUIRE(Reads(line));
    for (size_t length = std::string("packed ").size(); length < line.size(); ++length)
        REQUIRE_FALSE(Reads(line.substr(0, length)));
    CHECK_FALSE(Reads(line + "x"));
    int read = 0;
    constexpr int kDamaged = 2000;
    for (int i = 0; i < kDamaged; ++i) { // some are frames all the same; none may do harm
        std::string damaged = line;
        damaged[7 + random() % (line.size() - 7)] = static_cast<char>(random());
        read += Reads(damaged);
    }
    CHECK(read < kDamaged);
    CHECK_FALSE(Reads(std::string("packed \x80\x01\xff\xff\xff\xff\x7f"))); // a list longer than the line
}

} // namespace
