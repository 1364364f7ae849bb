// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CONTRACTS_H
#define BOOMERANG_TEST_CONTRACTS_H

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "boomerang/allocator.h"
#include "boomerang/error.h"

/// @file
/// Functions, their arguments, and the rule that each argument must keep to. A rule has its bad values and
/// the answer to them. Every function is called with good values; then with one bad value at a time, which
/// must give the rule's answer. A function that allocates is called once for each of its allocations, which
/// fails. The tables of answers.md are printed from this: `PROGRAM PAGE` compares.

namespace contracts {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNull = -7.7e-77;                  ///< stands for a pointer that is NULL
constexpr double kSizeMax = 18446744073709551616.0; ///< stands for SIZE_MAX

/// A value of an argument. Where an argument is no number, the value chooses one, and has a name.
struct Value {
    Value(double value) : number(value) {}
    Value(const char *called, double value) : number(value), name(called) {}
    double number;
    std::string name;
};

/// The values to which a function gives this answer.
struct Rule {
    std::string name; ///< in the table of rules; empty: a rule of one argument
    std::vector<Value> values;
    std::string answer;
};
using Rules = std::vector<Rule>;
Rules operator+(Rules a, const Rules &b);
/// A rule of one argument alone.
inline Rules Says(const std::string &answer, std::vector<Value> values) {
    return {{"", std::move(values), answer}};
}

// The rules that arguments have in common. Which answers they give stands in contracts.cpp.
extern const Rules kNotNull, kMayBeNull, kFinite, kNumber, kAboveZero, kNotBelowZero, kNotNegative, kAbove2;

struct Argument {
    Argument(const char *called, Rules kept) : name(called), good(1.0), rules(std::move(kept)) {}
    Argument(const char *called, double value, Rules kept)
        : name(called), good(value), rules(std::move(kept)) {}
    std::string name;
    double good;
    Rules rules;
};
using Arguments = std::vector<Argument>;

/// What one call is made with.
struct Given {
    std::vector<double> values; ///< of the arguments, in their order
    const bmr_allocator *allocator = nullptr;
    uint64_t *bits = nullptr; ///< a hash of what is made is put here, where there is an allocator

    double operator[](size_t argument) const { return values[argument]; }
    float Float(size_t argument) const { return static_cast<float>(values[argument]); }
    size_t Count(size_t argument) const;
    /// The pointer, or NULL where that is this argument's value.
    template <typename T> T *Or(size_t argument, T *pointer) const {
        return values[argument] == kNull ? nullptr : pointer;
    }
    void Made(const void *bytes, size_t size) const;
};
using Call = std::function<std::string(const Given &)>;

/// The code without BMR_ and ERROR_; and "written" where there is an error and outputs are written.
std::string Said(bmr_error error, bool written = false);
std::string Said(bool answer);
/// "NaN", "infinite", "minus infinity" or "finite".
std::string Said(double value);

/// A function whose good call answers `good`.
void Answers(const std::string &function, const std::string &good, Arguments arguments, Call call);
/// A function whose good call answers OK.
void Refuses(const std::string &function, Arguments arguments, Call call);
/// The same, of a function that allocates from Given::allocator.
void Makes(const std::string &function, Arguments arguments, Call call);
/// Its good call allocates: a call that tries harder than that of Refuses.
void Allocates(const std::string &function, Call call);

/// A table of answers: a row is a thing that is handed over, a column is a function.
struct Matrix {
    std::vector<std::string> columns, rows;
    std::function<std::string(size_t row, size_t column)> answer;
    bool alone = true; ///< answers come from child processes: a signal that ends one is the answer
};

/// What a program checks under one name: functions, which `fill` adds by the calls above, or a matrix. The
/// page has each matrix, and the rules, behind "<!-- checked: NAME -->".
struct Table {
    Table(const char *name, void (*fill)());
    Table(const char *name, Matrix (*make)());
};

} // namespace contracts

#endif
