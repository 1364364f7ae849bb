// SPDX-License-Identifier: MIT
#include "recording/bytes.h"

#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "recording/fields.h"

namespace testbed::recording {
namespace {

constexpr char kPacked[] = "packed ";
constexpr std::size_t kPackedLength = sizeof kPacked - 1;
constexpr char kLineEnd = 10, kMark = 11, kMarkedLineEnd = 1, kMarkedMark = 2;

class Writer {
public:
    void Number(std::uint64_t value) {
        for (; value >= 0x80; value >>= 7)
            m_bytes.push_back(static_cast<char>(value | 0x80));
        m_bytes.push_back(static_cast<char>(value));
    }
    void Raw(const void *data, std::size_t size) { m_bytes.append(static_cast<const char *>(data), size); }
    /// The bytes as the rest of a line.
    void AppendTo(std::string *line) const {
        line->reserve(line->size() + m_bytes.size() + m_bytes.size() / 64);
        for (const char byte : m_bytes) {
            if (byte == kLineEnd || byte == kMark) {
                line->push_back(kMark);
                line->push_back(byte == kLineEnd ? kMarkedLineEnd : kMarkedMark);
            } else {
                line->push_back(byte);
            }
        }
    }

private:
    std::string m_bytes;
};

class Reader {
public:
    explicit Reader(const std::string &line) {
        m_bytes.reserve(line.size());
        for (std::size_t i = kPackedLength; i < line.size(); ++i) {
            if (line[i] != kMark) {
                m_bytes.push_back(line[i]);
                continue;
            }
            if (++i == line.size() || (line[i] != kMarkedLineEnd && line[i] != kMarkedMark))
                Fail();
            m_bytes.push_back(line[i] == kMarkedLineEnd ? kLineEnd : kMark);
        }
    }
    std::uint64_t Number() {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 64; shift += 7) {
            const auto byte = static_cast<unsigned char>(*Take(1));
            value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
            if (byte < 0x80)
                return value;
        }
        Fail();
    }
    /// How many elements follow; each takes a byte at least.
    std::size_t Count() {
        const std::uint64_t count = Number();
        if (count > m_bytes.size() - m_at)
            Fail();
        return static_cast<std::size_t>(count);
    }
    const char *Take(std::size_t size) {
        if (size > m_bytes.size() - m_at)
            Fail();
        m_at += size;
        return m_bytes.data() + m_at - size;
    }
    void CheckEnd() const {
        if (m_at != m_bytes.size())
            Fail();
    }
    [[noreturn]] static void Fail() { throw std::runtime_error("a packed frame is damaged or cut off"); }

private:
    std::string m_bytes;
    std::size_t m_at = 0;
};

/// How a value becomes bytes and comes back: an object with the fields of fields.h, unless it is one of those
/// below.
template <typename Value, typename = void> struct Code {
    static bool Same(const Value &a, const Value &b) {
        bool same = true;
        Fields(&a, [&](const char *, auto member) {
            using Member = Code<std::decay_t<decltype(a.*member)>>;
            same = same && Member::Same(a.*member, b.*member);
        });
        return same;
    }
    static void Write(Writer *writer, const Value &value) {
        static const Value usual;
        std::uint64_t set = 0, bit = 1;
        Fields(&value, [&](const char *, auto member) {
            using Member = Code<std::decay_t<decltype(value.*member)>>;
            set |= Member::Same(value.*member, usual.*member) ? 0 : bit;
            bit <<= 1;
        });
        writer->Number(set);
        bit = 1;
        Fields(&value, [&](const char *, auto member) {
            if ((set & bit) != 0)
                Code<std::decay_t<decltype(value.*member)>>::Write(writer, value.*member);
            bit <<= 1;
        });
    }
    static void Read(Reader *reader, Value *value) {
        std::uint64_t set = reader->Number();
        Fields(value, [&](const char *, auto member) {
            if ((set & 1) != 0)
                Code<std::decay_t<decltype(value->*member)>>::Read(reader, &(value->*member));
            set >>= 1;
        });
        if (set != 0)
            Reader::Fail();
    }
};

template <typename Value> struct Code<Value, std::enable_if_t<std::is_integral_v<Value>>> {
    static bool Same(Value a, Value b) { return a == b; }
    static void Write(Writer *writer, Value value) {
        const auto wide = static_cast<std::int64_t>(value);
        writer->Number(static_cast<std::uint64_t>(wide) << 1 ^ (wide < 0 ? ~std::uint64_t{0} : 0));
    }
    static void Read(Reader *reader, Value *value) {
        const std::uint64_t coded = reader->Number();
        *value = static_cast<Value>(coded >> 1 ^ ((coded & 1) != 0 ? ~std::uint64_t{0} : 0));
    }
};

/// Floats and what is made of nothing else: as in memory, and compared so (-0 is not 0, and NaN is itself).
template <typename Value> struct RawCode {
    static_assert(std::is_trivially_copyable_v<Value> && sizeof(Value) % sizeof(float) == 0);
    static bool Same(const Value &a, const Value &b) { return std::memcmp(&a, &b, sizeof a) == 0; }
    static void Write(Writer *writer, const Value &value) { writer->Raw(&value, sizeof value); }
    static void Read(Reader *reader, Value *value) {
        std::memcpy(value, reader->Take(sizeof *value), sizeof *value);
    }
};
template <> struct Code<float> : RawCode<float> {};
template <> struct Code<Vec> : RawCode<Vec> {};
template <> struct Code<Pose> : RawCode<Pose> {};
template <> struct Code<Box> : RawCode<Box> {};

template <> struct Code<std::string> {
    static bool Same(const std::string &a, const std::string &b) { return a == b; }
    static void Write(Writer *writer, const std::string &value) {
        writer->Number(value.size());
        writer->Raw(value.data(), value.size());
    }
    static void Read(Reader *reader, std::string *value) {
        const std::size_t size = reader->Count();
        value->assign(reader->Take(size), size);
    }
};

template <typename Element> struct Code<std::vector<Element>> {
    static bool Same(const std::vector<Element> &a, const std::vector<Element> &b) {
        return a.empty() && b.empty(); // only defaults are asked for, and those are empty
    }
    static void Write(Writer *writer, const std::vector<Element> &list) {
        writer->Number(list.size());
        for (const Element &element : list)
            Code<Element>::Write(writer, element);
    }
    static void Read(Reader *reader, std::vector<Element> *list) {
        list->resize(reader->Count());
        for (Element &element : *list)
            Code<Element>::Read(reader, &element);
    }
};

template <typename Element, std::size_t N> struct Code<std::array<Element, N>> {
    static bool Same(const std::array<Element, N> &a, const std::array<Element, N> &b) {
        bool same = true;
        for (std::size_t i = 0; i < N; ++i)
            same = same && Code<Element>::Same(a[i], b[i]);
        return same;
    }
    static void Write(Writer *writer, const std::array<Element, N> &list) {
        for (const Element &element : list)
            Code<Element>::Write(writer, element);
    }
    static void Read(Reader *reader, std::array<Element, N> *list) {
        for (Element &element : *list)
            Code<Element>::Read(reader, &element);
    }
};

} // namespace

bool IsSame(const Proof &a, const Proof &b) {
    return Code<Proof>::Same(a, b);
}

std::string Pack(const Frame &frame) {
    Writer writer;
    Code<Frame>::Write(&writer, frame);
    std::string line = kPacked;
    writer.AppendTo(&line);
    return line;
}

bool IsPacked(const std::string &line) {
    return line.compare(0, kPackedLength, kPacked) == 0;
}

Frame Unpack(const std::string &line) {
    Reader reader(line);
    Frame frame;
    Code<Frame>::Read(&reader, &frame);
    reader.CheckEnd();
    return frame;
}

} // namespace testbed::recording
