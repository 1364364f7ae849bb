// SPDX-License-Identifier: MIT
//
// What replays become: whole numbers whose error is bounded, columns that decode to what went in, a page that
// is one file. The page's own decoder is tested in a browser (tests/front).
#include <zlib.h>

#include "cases.h"
#include "replay/encoding.h"

using namespace testbed::replay;

namespace {

/// The reader that encoding.h describes.
class Reader {
public:
    explicit Reader(std::string bytes) : m_bytes(std::move(bytes)) {}
    uint32_t Byte() { return static_cast<uint8_t>(m_bytes.at(m_at++)); }
    uint32_t Number() {
        uint32_t value = 0;
        for (int shift = 0; shift < 32; shift += 8)
            value |= Byte() << shift;
        return value;
    }
    std::string Text(size_t length) {
        m_at += length;
        return m_bytes.substr(m_at - length, length);
    }
    uint32_t Zigzag() {
        uint32_t coded = 0, byte = 0x80;
        for (int shift = 0; byte >= 0x80; shift += 7) {
            byte = Byte();
            coded |= (byte & 0x7f) << shift;
        }
        return coded >> 1 ^ (0U - (coded & 1));
    }
    size_t At() const { return m_at; }
    bool IsAtEnd() const { return m_at == m_bytes.size(); }

private:
    std::string m_bytes;
    size_t m_at = 0;
};

struct Head {
    std::string name;
    uint32_t order, width, count, size;
};

std::vector<Column> Unpack(const std::string &bytes, std::vector<Head> *headsOut = nullptr) {
    Reader reader(bytes);
    REQUIRE(reader.Text(4) == "BMRR");
    REQUIRE(reader.Number() == kEncodingVersion);
    std::vector<Head> heads(reader.Number());
    for (Head &head : heads) {
        head.name = reader.Text(reader.Byte());
        head.order = reader.Byte();
        head.width = reader.Byte();
        head.count = reader.Number();
        head.size = reader.Number();
    }
    std::vector<Column> columns;
    for (const Head &head : heads) {
        Column column{head.name, {}};
        const size_t start = reader.At();
        uint32_t last = 0, beforeLast = 0;
        for (uint32_t i = 0; i < head.count; ++i) {
            const uint32_t predicted = head.order == 0 ? 0 : head.order == 1 ? last : 2 * last - beforeLast;
            beforeLast = last;
            last = predicted + reader.Zigzag();
            column.values.push_back(static_cast<int32_t>(last));
        }
        CHECK(reader.At() - start == head.size);
        columns.push_back(column);
    }
    CHECK(reader.IsAtEnd());
    if (headsOut != nullptr)
        *headsOut = heads;
    return columns;
}

Column Evenly(int32_t from, int32_t by, int32_t count) {
    Column column{"evenly", {}};
    for (int32_t i = 0; i < count; ++i)
        column.values.push_back(from + by * i);
    return column;
}

} // namespace

TEST_CASE("quantities are at most half a quantum off, and what is out of range is clamped") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> values(-3000.0, 3000.0);
    for (int i = 0; i < 10000; ++i) {
        const double value = values(random);
        CHECK(std::fabs(Quantise(value, kPositionQuantum, kFarthest) * kPositionQuantum - value) <=
              kPositionQuantum / 2);
    }
    CHECK(Quantise(1e300, kPositionQuantum, kFarthest) == kFarthest / kPositionQuantum);
    CHECK(Quantise(-1e300, kPositionQuantum, kFarthest) == -kFarthest / kPositionQuantum);
    CHECK(Quantise(std::numeric_limits<double>::quiet_NaN(), kPositionQuantum, kFarthest) == 0);
}

TEST_CASE("a slack stays a lower bound, and proved stays proved") {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> values(kSlackQuantum, 30.0);
    for (int i = 0; i < 10000; ++i) {
        const double slack = values(random), kept = QuantiseSlack(slack) * kSlackQuantum;
        CHECK(kept <= slack);
        CHECK(kept > slack - kSlackQuantum);
    }
    CHECK(QuantiseSlack(kSlackQuantum / 3) == 1);
    CHECK(QuantiseSlack(0.0) == 0);
    CHECK(QuantiseSlack(-1.0) == -1);
    CHECK(QuantiseSlack(std::numeric_limits<double>::quiet_NaN()) == -1);
}

TEST_CASE("columns decode to what was packed, extremes too") {
    std::mt19937 random(3);
    std::vector<Column> columns = {{"empty", {}}, Evenly(-7, 3, 1000)};
    for (const int bits : {3, 9, 20, 31}) {
        Column column{"bits " + std::to_string(bits), {}};
        for (int i = 0; i < 500; ++i)
            column.values.push_back(static_cast<int32_t>(random()) >> (31 - bits));
        columns.push_back(column);
    }
    columns.push_back({"extremes", {INT32_MAX, INT32_MIN, 0, INT32_MIN, INT32_MAX, -1, 1}});
    std::vector<Head> heads;
    const std::vector<Column> back = Unpack(Pack(columns), &heads);
    REQUIRE(back.size() == columns.size());
    for (size_t i = 0; i < columns.size(); ++i) {
        CHECK(back[i].name == columns[i].name);
        CHECK(back[i].values == columns[i].values);
    }
    CHECK(heads[0].width == 1);
    CHECK(heads[2].width == 1);
    CHECK(heads[3].width == 2);
    CHECK(heads[4].width == 4);
    CHECK(heads.back().width == 4);
}

TEST_CASE("control: another bit in the bytes gives other numbers") {
    std::string bytes = Pack({Evenly(5, 1, 100)});
    bytes[bytes.size() - 50] = static_cast<char>(bytes[bytes.size() - 50] ^ 2);
    CHECK(Unpack(bytes)[0].values != Evenly(5, 1, 100).values);
}

TEST_CASE("what moves evenly costs next to nothing") {
    const std::string even = Deflate(Pack({Evenly(1000, 77, 100000)}));
    Column noise = Evenly(1000, 77, 100000);
    std::mt19937 random(4);
    for (int32_t &value : noise.values)
        value += static_cast<int32_t>(random() % 1000);
    CHECK(even.size() < 1000);
    CHECK(Deflate(Pack({noise})).size() > 100 * even.size()); // control
}

TEST_CASE("zlib reads what Deflate writes") {
    const std::string bytes = Pack({Evenly(0, 1, 5000)}), deflated = Deflate(bytes);
    std::string back(bytes.size(), '\0');
    uLongf size = back.size();
    REQUIRE(uncompress(reinterpret_cast<Bytef *>(back.data()), &size,
                       reinterpret_cast<const Bytef *>(deflated.data()), deflated.size()) == Z_OK);
    CHECK(back == bytes);
}

TEST_CASE("base64 is RFC 4648's") {
    const char *const plain[] = {"", "f", "fo", "foo", "foob", "fooba", "foobar"};
    const char *const coded[] = {"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
    for (size_t i = 0; i < 7; ++i)
        CHECK(Base64(plain[i]) == coded[i]);
    CHECK(Base64(std::string("\xff\xfe\x00\x80", 4)) == "//4AgA==");
}

TEST_CASE("a page is one file that asks nothing of the network, whatever a scene is called") {
    Replay replay;
    replay.stepCount = 1;
    replay.about = {{"scene", "</script><b>bold"}, {"timeStep", 1.0 / 60.0}};
    const std::string page = PageOf(replay);
    CHECK(page.find("</script><b>bold") == std::string::npos);
    for (const char *asking :
         {"http://", "https://", "src=", "@import", "fetch(", "XMLHttpRequest", "/*@", "@about@", "@data@"})
        CHECK_MESSAGE(page.find(asking) == std::string::npos, std::string(asking));
    CHECK(page.find("<canvas") != std::string::npos); // control: the search finds what is there
}
