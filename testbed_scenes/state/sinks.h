// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_SINKS_H
#define BOOMERANG_TESTBED_SINKS_H

#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string>

namespace testbed {

/// Two takers of the same fields (state/visit.h hands them out), so that a dump covers what the hash covers.
///
///     Begin(kind, number)    an object begins: "body 12"
///     Key(name, number)      and is named further: "bodyA 3"
///     Is(name, number)       is of a kind, which text calls by its name
///     Of(part)               what follows is of a part of it, which text alone names
///     Field(name, value)     one of its fields

/// Folds the raw bits of every number into 64 bits. Like FNV-1a (the same prime), but 32 bits at a time, and
/// with the high half folded into the low one, which a multiplication alone leaves behind. Each step is a
/// bijection of the hash for a given word: one differing word is never lost.
class HashSink {
public:
    void Begin(const char *, uint64_t number) { Key("", number); }
    void Key(const char *, uint64_t number) {
        Add(static_cast<uint32_t>(number));
        Add(static_cast<uint32_t>(number >> 32));
    }
    void Is(const char *, uint64_t number) { Key("", number); }
    void Of(const char *) {}
    void Field(const char *, uint64_t value) { Key("", value); }
    void Field(const char *, uint32_t value) { Add(value); }
    void Field(const char *, int32_t value) { Add(static_cast<uint32_t>(value)); }
    /// (Which NaN comes of two of them hangs on how a compiler orders their sum.)
    void Field(const char *, float value) {
        uint32_t bits;
        const float number = std::isnan(value) ? std::numeric_limits<float>::quiet_NaN() : value;
        std::memcpy(&bits, &number, sizeof bits);
        Add(bits);
    }
    uint64_t Value() const { return m_hash; }

private:
    void Add(uint32_t word) {
        m_hash = (m_hash ^ word) * 0x100000001b3u;
        m_hash ^= m_hash >> 32;
    }
    uint64_t m_hash = 0xcbf29ce484222325u; // FNV's own beginning
};

/// One line per field: "body 12 position.x = 12 (0x1.8p+3)".
class TextSink {
public:
    void Begin(const char *kind, uint64_t number) {
        m_object = std::string(kind) + " " + std::to_string(number);
    }
    void Key(const char *name, uint64_t number) {
        m_object += std::string(" ") + name + " " + std::to_string(number);
    }
    void Is(const char *name, uint64_t) { Of(name); }
    void Of(const char *part) { m_object += std::string(" ") + part; }
    void Field(const char *name, uint64_t value) { Line(name, "0x%016" PRIx64, value); }
    void Field(const char *name, uint32_t value) { Line(name, "0x%" PRIx32, value); }
    void Field(const char *name, int32_t value) { Line(name, "%" PRId32, value); }
    void Field(const char *name, float value) {
        const auto number = static_cast<double>(std::isnan(value) ? std::fabs(value) : value);
        Line(name, "%.9g (%a)", number, number);
    }
    const std::string &Text() const { return m_text; }
    void Clear() { m_text.clear(); }

private:
    template <typename... Values> void Line(const char *name, const char *format, Values... values) {
        char buffer[64];
        std::snprintf(buffer, sizeof buffer, format, values...);
        m_text += m_object + " " + name + " = " + buffer + "\n";
    }
    std::string m_object, m_text;
};

} // namespace testbed

#endif
