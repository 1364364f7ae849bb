// SPDX-License-Identifier: MIT
//   PROGRAM PAGE     every rule holds, every allocation may fail, and the page has what the program prints
//   PROGRAM          prints its tables, as the page should have them
//   PROGRAM --list   the functions whose allocations fail
#include "contracts.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <map>
#include <sstream>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "every_allocation.h"
#include "leave.h"

namespace contracts {

const Rules kNotNull = {{"not `NULL`", {kNull}, "NULL_ARGUMENT"}};
const Rules kMayBeNull = {{"may be `NULL`", {kNull}, "OK"}};
const Rules kFinite = {{"finite", {kNaN, kInfinity, -kInfinity}, "NOT_FINITE"}};
const Rules kNumber = {{"a number", {kNaN, kInfinity, -kInfinity}, "OUT_OF_RANGE"}};
const Rules kAboveZero = {{"above 0", {0.0, -0.0, -1.0}, "OUT_OF_RANGE"}};
const Rules kNotBelowZero = {{"not below 0", {-1e-38, -1.0}, "OUT_OF_RANGE"}};
const Rules kNotNegative = {{"not negative", {-1e-38, -1.0}, "NEGATIVE"}};
const Rules kAbove2 = {{"above 2", {INT_MIN, -1.0, 0.0, 1.0, 2.0}, "TOO_FEW_POINTS"}};

namespace {

const Rules *const kRules[] = {&kNotNull,   &kMayBeNull,    &kFinite,      &kNumber,
                               &kAboveZero, &kNotBelowZero, &kNotNegative, &kAbove2};
constexpr unsigned kSecondsForACell = 1500; // what hangs ends; a busy machine takes its time

struct Function {
    std::string name, good;
    Arguments arguments;
    Call call;
    bool refuses, allocates;
};
struct Entry {
    const char *name;
    void (*fill)();
    Matrix (*make)();
};

std::vector<Entry> &Entries() {
    static std::vector<Entry> entries;
    return entries;
}
std::vector<Function> functions; ///< of the table that is being filled
size_t passed = 0, failed = 0;

void Check(bool holds, const std::string &what) {
    ++(holds ? passed : failed);
    if (!holds)
        std::printf("FAILED: %s\n", what.c_str());
}

std::string Joined(const std::vector<std::string> &parts, const char *between) {
    std::string all;
    for (const std::string &part : parts)
        all += (all.empty() ? "" : between) + part;
    return all;
}

std::string NameOf(const Value &value) {
    if (!value.name.empty())
        return value.name;
    if (value.number == kNull)
        return "`NULL`";
    if (value.number == kSizeMax)
        return "`SIZE_MAX`";
    if (value.number == UINT32_MAX)
        return "`UINT32_MAX`";
    if (value.number == INT_MAX || value.number == INT_MIN)
        return value.number > 0 ? "`INT_MAX`" : "`INT_MIN`";
    if (!std::isfinite(value.number))
        return Said(value.number);
    std::ostringstream text;
    text << std::setprecision(std::fabs(value.number) >= 1e7 ? 1 : 10) << value.number;
    std::string said = text.str();
    for (const char *padding : {"e+0", "e+", "e-0"}) // printf has two digits at least, and a sign
        if (const size_t at = said.find(padding); at != std::string::npos)
            said.replace(at, std::strlen(padding), padding[1] == '-' ? "e-" : "e");
    return said;
}

using Cells = std::vector<std::function<std::string()>>;

/// Of child processes: a cell that ends its process is answered by how it did, and the next child goes on
/// behind it.
std::vector<std::string> InChildren(const Cells &cells) {
    std::vector<std::string> answers;
    while (answers.size() < cells.size()) {
        int ends[2];
        if (pipe(ends) != 0)
            return std::vector<std::string>(cells.size(), "no pipe");
        std::fflush(nullptr);
        const pid_t child = fork();
        if (child == 0) {
            close(ends[0]);
            const rlimit none = {0, 0};
            setrlimit(RLIMIT_CORE, &none);
            for (size_t i = answers.size(); i < cells.size(); ++i) {
                alarm(kSecondsForACell);
                const std::string answer = cells[i]();
                const size_t size = answer.size() + 1;
                if (write(ends[1], answer.c_str(), size) != static_cast<ssize_t>(size))
                    test_leave(3);
            }
            test_leave(0);
        }
        close(ends[1]);
        std::string text, answer;
        char buffer[512];
        for (ssize_t got; (got = read(ends[0], buffer, sizeof buffer)) > 0;)
            text.append(buffer, static_cast<size_t>(got));
        close(ends[0]);
        int status = 0;
        waitpid(child, &status, 0);
        for (std::istringstream stream(text); std::getline(stream, answer, '\0');)
            answers.push_back(answer);
        if (answers.size() < cells.size())
            answers.push_back(WIFSIGNALED(status)
                                  ? "ends by signal " + std::to_string(WTERMSIG(status))
                                  : "ends with status " + std::to_string(WEXITSTATUS(status)));
    }
    return answers;
}

Given GoodFor(const Function &function) {
    Given given;
    for (const Argument &argument : function.arguments)
        given.values.push_back(argument.good);
    return given;
}

/// With good arguments, and with each bad value.
void CheckRules(const Function &function) {
    struct Question {
        std::string with, expected;
    };
    std::vector<Question> questions;
    Cells cells;
    const auto ask = [&](const std::string &with, const std::string &expected, const Given &given) {
        questions.push_back({with, expected});
        cells.push_back([&function, given] { return function.call(given); });
    };
    ask("all good", function.good, GoodFor(function));
    for (size_t i = 0; i < function.arguments.size(); ++i)
        for (const Rule &rule : function.arguments[i].rules)
            for (const Value &bad : rule.values) {
                Given given = GoodFor(function);
                given.values[i] = bad.number;
                ask(function.arguments[i].name + ": " + NameOf(bad), rule.answer, given);
            }
    std::vector<std::string> answers = InChildren(cells);
    for (size_t i = 0; i < cells.size(); ++i) {
        const auto &[with, expected] = questions[i];
        if (answers[i] != expected) // what succeeds once in a process asks for one of its own
            answers[i] = InChildren({cells[i]})[0];
        Check(answers[i] == expected,
              function.name + ", " + with + ": answers " + answers[i] + ", expected " + expected);
    }
}

const Function *trying;

bmr_error Try(const bmr_allocator *allocator, uint64_t *bits) {
    Given given = GoodFor(*trying);
    given.allocator = allocator;
    given.bits = bits;
    const std::string answer = trying->call(given);
    return answer == "OK"                        ? BMR_OK
           : answer == Said(BMR_ERROR_NO_MEMORY) ? BMR_ERROR_NO_MEMORY
                                                 : BMR_ERROR_COUNT;
}

/// Each of its allocations fails once: it says so, leaks nothing, leaves its outputs, and does the same with
/// memory as if nothing had been.
void CheckAllocations(const Function &function) {
    trying = &function;
    const test_attempt attempt = {function.name.c_str(), Try};
    const char *wrong = test_every_allocation(&attempt);
    Check(wrong == nullptr, function.name + " " + (wrong != nullptr ? wrong : ""));
}

std::string PrintedValues(const Rule &rule) {
    std::vector<std::string> values;
    for (const Value &value : rule.values)
        values.push_back(NameOf(value));
    return Joined(values, ", ");
}

/// Rows of the same answers stand in one line.
std::string PrintedMatrix(const Matrix &matrix) {
    std::vector<std::string> order;
    std::map<std::string, std::vector<std::string>> rows;
    const size_t columns = matrix.columns.size();
    Cells all;
    for (size_t i = 0; i < matrix.rows.size() * columns; ++i)
        all.push_back([&matrix, columns, i] { return matrix.answer(i / columns, i % columns); });
    const std::vector<std::string> answered = matrix.alone ? InChildren(all) : std::vector<std::string>();
    for (size_t row = 0; row < matrix.rows.size(); ++row) {
        std::vector<std::string> answers;
        for (size_t column = 0; column < columns; ++column) {
            const size_t i = row * columns + column;
            answers.push_back(matrix.alone ? answered[i] : all[i]());
        }
        std::string key = Joined(answers, " | ");
        if (rows[key].empty())
            order.push_back(key);
        rows[key].push_back(matrix.rows[row]);
    }
    std::string text = "| | " + Joined(matrix.columns, " | ") + " |\n| " +
                       Joined(std::vector<std::string>(matrix.columns.size() + 1, "---"), " | ") + " |\n";
    for (const std::string &key : order)
        text += "| " + Joined(rows[key], "; ") + " | " + key + " |\n";
    return text;
}

std::string PrintedRules() {
    std::string text = "| rule | bad values | answer |\n| --- | --- | --- |\n";
    for (const Rules *rules : kRules)
        for (const Rule &rule : *rules)
            text += "| " + rule.name + " | " + PrintedValues(rule) + " | " + rule.answer + " |\n";
    return text;
}

/// What stands on the page behind the table's mark, up to an empty line.
std::string OnPage(const std::string &page, const std::string &name) {
    std::string line, text;
    std::ifstream stream(page);
    while (std::getline(stream, line) && line != "<!-- checked: " + name + " -->")
        continue;
    while (std::getline(stream, line) && !line.empty())
        text += line + "\n";
    return text;
}

void ComparePage(const std::string &page, const std::string &name, const std::string &text) {
    std::string theirs = OnPage(page, name), ours = text;
    for (size_t end; theirs != ours && (end = ours.find('\n')) != std::string::npos &&
                     theirs.compare(0, end + 1, ours, 0, end + 1) == 0;) {
        ours.erase(0, end + 1);
        theirs.erase(0, end + 1);
    }
    Check(theirs == ours, "table " + name + ": " + page + " has \"" + theirs.substr(0, theirs.find('\n')) +
                              "\", it is \"" + ours.substr(0, ours.find('\n')) + "\"");
}

} // namespace

Rules operator+(Rules a, const Rules &b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

size_t Given::Count(size_t argument) const {
    return values[argument] >= kSizeMax ? SIZE_MAX : static_cast<size_t>(values[argument]);
}

void Given::Made(const void *bytes, size_t size) const {
    if (bits != nullptr)
        test_hash(bits, bytes, size);
}

std::string Said(bmr_error error, bool written) {
    static const char names[] =
        "OK NULL_ARGUMENT NO_POINTS TOO_MANY_POINTS NOT_FINITE OUT_OF_RANGE NO_MEMORY "
        "NOT_CONVEX TABLE_TOO_SMALL INVALID_STRUCTURE FALSE_CERTIFICATE STALLED "
        "UNSUPPORTED TOO_FEW_POINTS TOO_CLOSE NEGATIVE CORNER_TOO_LARGE TOO_LARGE "
        "WRONG_HIERARCHY UNKNOWN_NAME REPEATED_POINT CROSSING_EDGES "
        "OVERLAPPING_EDGES HOLE_OUTSIDE WORLD_LOCKED FAR_FROM_ORIGIN";
    std::istringstream words(names);
    const std::vector<std::string> all(std::istream_iterator<std::string>(words), {});
    if (all.size() != BMR_ERROR_COUNT || error < BMR_OK || error >= BMR_ERROR_COUNT)
        return "no code at all";
    return all[error] + (error != BMR_OK && written ? ", and something is written" : "");
}

std::string Said(bool answer) {
    return answer ? "true" : "false";
}

std::string Said(double value) {
    return std::isnan(value)      ? "NaN"
           : std::isfinite(value) ? "finite"
           : value > 0.0          ? "infinite"
                                  : "minus infinity";
}

void Answers(const std::string &function, const std::string &good, Arguments arguments, Call call) {
    functions.push_back({function, good, std::move(arguments), std::move(call), true, false});
}
void Refuses(const std::string &function, Arguments arguments, Call call) {
    Answers(function, "OK", std::move(arguments), std::move(call));
}
void Makes(const std::string &function, Arguments arguments, Call call) {
    Refuses(function, std::move(arguments), std::move(call));
    functions.back().allocates = true;
}
void Allocates(const std::string &function, Call call) {
    functions.push_back({function, "OK", {}, std::move(call), false, true});
}

Table::Table(const char *name, void (*fill)()) {
    Entries().push_back({name, fill, nullptr});
}
Table::Table(const char *name, Matrix (*make)()) {
    Entries().push_back({name, nullptr, make});
}

static void Treat(const Entry &entry, const std::string &what) {
    functions.clear();
    if (entry.fill != nullptr)
        entry.fill();
    if (what == "--list") {
        for (const Function &function : functions)
            if (function.allocates)
                std::printf("%s\n", function.name.c_str());
        return;
    }
    if (functions.empty()) { // functions say here what they answer
        const std::string text = entry.make != nullptr ? PrintedMatrix(entry.make()) : PrintedRules();
        if (what.empty())
            std::printf("<!-- checked: %s -->\n%s\n", entry.name, text.c_str());
        else
            ComparePage(what, entry.name, text);
    }
    for (const Function &function : functions) {
        if (function.refuses && !what.empty())
            CheckRules(function);
        if (function.allocates && !what.empty())
            CheckAllocations(function);
    }
}

} // namespace contracts

int main(int argc, char **argv) {
    using namespace contracts;
    const std::string what = argc > 1 ? argv[1] : "";
    for (const Entry &entry : Entries())
        Treat(entry, what);
    if (what.empty() || what == "--list")
        return 0;
    std::printf("%zu passed, %zu failed\n", passed, failed);
    return failed == 0 && passed > 0 ? 0 : 1;
}
