// SPDX-License-Identifier: MIT
#include "encoding.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <zlib.h>

#include "page_files.h"

namespace testbed::replay {
namespace {

constexpr std::string_view kMagic = "BMRR";
constexpr uint8_t kHighestOrder = 2;
/// zlib's level. Its highest, 9, makes a page 3 % smaller and takes five times as long, a fifth of a replay's
/// time.
constexpr int kLevel = 7;

void WriteNumber(std::string &out, uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8)
        out.push_back(static_cast<char>(value >> shift & 0xff));
}

void WriteByte(std::string &out, size_t value) {
    out.push_back(static_cast<char>(value & 0xff));
}

void WriteZigzag(std::string &out, uint32_t difference) {
    uint32_t rest = difference << 1 ^ (difference >> 31 != 0 ? 0xffffffffU : 0U);
    for (; rest >= 0x80; rest >>= 7)
        WriteByte(out, rest | 0x80);
    WriteByte(out, rest);
}

/// The values as differences of that order, as bytes.
std::string Differences(const std::vector<int32_t> &values, uint8_t order) {
    std::string bytes;
    bytes.reserve(values.size());
    uint32_t last = 0, beforeLast = 0;
    for (const int32_t signedValue : values) {
        const auto value = static_cast<uint32_t>(signedValue);
        const uint32_t predicted = order == 0 ? 0 : order == 1 ? last : 2 * last - beforeLast;
        WriteZigzag(bytes, value - predicted);
        beforeLast = last;
        last = value;
    }
    return bytes;
}

size_t WidthOf(const std::vector<int32_t> &values) {
    if (values.empty())
        return 1;
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    if (*least >= INT8_MIN && *greatest <= INT8_MAX)
        return 1;
    return *least >= INT16_MIN && *greatest <= INT16_MAX ? 2 : 4;
}

/// Deflated sizes decide, not raw ones: a column of equal numbers takes as many raw bytes in any order.
size_t DeflatedSize(const std::string &bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::string room(size, '\0');
    const int status = compress2(reinterpret_cast<Bytef *>(room.data()), &size,
                                 reinterpret_cast<const Bytef *>(bytes.data()),
                                 static_cast<uLong>(bytes.size()), Z_BEST_SPEED);
    return status == Z_OK ? size : bytes.size();
}

} // namespace

std::string Pack(const std::vector<Column> &columns) {
    std::string head(kMagic), body;
    WriteNumber(head, kEncodingVersion);
    WriteNumber(head, static_cast<uint32_t>(columns.size()));
    for (const Column &column : columns) {
        std::string best = Differences(column.values, 0);
        size_t least = DeflatedSize(best);
        uint8_t bestOrder = 0;
        for (uint8_t order = 1; order <= kHighestOrder; ++order) {
            std::string bytes = Differences(column.values, order);
            const size_t size = DeflatedSize(bytes);
            if (size < least) {
                least = size;
                best = std::move(bytes);
                bestOrder = order;
            }
        }
        WriteByte(head, column.name.size());
        head += column.name;
        WriteByte(head, bestOrder);
        WriteByte(head, WidthOf(column.values));
        WriteNumber(head, static_cast<uint32_t>(column.values.size()));
        WriteNumber(head, static_cast<uint32_t>(best.size()));
        body += best;
    }
    return head + body;
}

std::string Deflate(std::string_view bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::string out(size, '\0');
    if (compress2(reinterpret_cast<Bytef *>(out.data()), &size, reinterpret_cast<const Bytef *>(bytes.data()),
                  static_cast<uLong>(bytes.size()), kLevel) != Z_OK)
        throw std::runtime_error("the replay could not be compressed");
    out.resize(size);
    return out;
}

std::string Base64(std::string_view bytes) {
    static constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const size_t here = std::min<size_t>(3, bytes.size() - i);
        uint32_t group = 0;
        for (size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < here ? static_cast<uint8_t>(bytes[i + k]) : 0U);
        for (size_t k = 0; k < 4; ++k)
            text.push_back(k <= here ? kDigits[group >> (18 - 6 * k) & 63] : '=');
    }
    return text;
}

namespace {

/// Puts `text` in the place of the mark, which the page has once.
void Fill(std::string &page, std::string_view mark, std::string_view text) {
    const size_t at = page.find(mark);
    if (at == std::string::npos)
        throw std::logic_error("the page has no place for " + std::string(mark));
    page.replace(at, mark.size(), text);
}

/// JSON that may stand inside a script element: nothing in it can end the element.
std::string Embedded(const nlohmann::json &json) {
    std::string text = json.dump();
    for (size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
        text.replace(at, 1, "\\u003c");
    return text;
}

} // namespace

std::string PageOf(const Replay &replay) {
    nlohmann::json about = replay.about;
    about["stepCount"] = replay.stepCount;
    about["eventKinds"] = replay.eventKinds;
    about["quanta"] = {{"position", kPositionQuantum}, {"angle", kAngleQuantum}, {"slack", kSlackQuantum}};
    std::string page(kPageHtml);
    Fill(page, "/*@style@*/", kPageStyle);
    Fill(page, "/*@script@*/", kPageScript);
    Fill(page, "@about@", Embedded(about));
    // Last, and the longest: nothing searches through it.
    Fill(page, "@data@", Base64(Deflate(Pack(ColumnsOf(replay)))));
    return page;
}

} // namespace testbed::replay
