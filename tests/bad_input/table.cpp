// SPDX-License-Identifier: MIT
#include "table.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "leave.h"

namespace bad_input {

namespace {

constexpr unsigned kSecondsForACell = 1500; // what hangs ends; a busy machine takes its time

/// What the page says of one table.
struct Page {
    std::vector<std::string> columns, rows;
    std::vector<std::vector<std::string>> cells;
};

std::string Trimmed(const std::string &text) {
    const size_t first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
    return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

/// "| a | b |" as {"a", "b"}; nothing where the line is no row.
std::vector<std::string> CellsOf(const std::string &line) {
    std::vector<std::string> cells;
    const std::string row = Trimmed(line);
    if (row.size() < 2 || row.front() != '|' || row.back() != '|')
        return cells;
    for (size_t start = 1; start < row.size();) {
        const size_t end = row.find('|', start);
        cells.push_back(Trimmed(row.substr(start, end - start)));
        start = end + 1;
    }
    return cells;
}

bool ReadPage(const char *file, const std::string &name, Page *page) {
    std::ifstream stream(file);
    const std::string mark = "<!-- checked: " + name + " -->";
    std::string line;
    while (std::getline(stream, line) && Trimmed(line) != mark)
        continue;
    std::getline(stream, line);
    page->columns = CellsOf(line);
    std::getline(stream, line); // the rule under the head
    while (std::getline(stream, line)) {
        std::vector<std::string> cells = CellsOf(line);
        if (cells.empty())
            break;
        page->rows.push_back(cells[0]);
        cells.erase(cells.begin());
        page->cells.push_back(cells);
    }
    if (page->columns.empty())
        return false;
    page->columns.erase(page->columns.begin());
    return true;
}

/// Of a child process, so that no cell can spoil another.
std::string Answer(const Table &table, size_t row, size_t column) {
    if (!table.alone)
        return table.answer(row, column);
    int ends[2];
    if (pipe(ends) != 0)
        return "no pipe";
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        const rlimit none = {0, 0};
        setrlimit(RLIMIT_CORE, &none);
        alarm(kSecondsForACell);
        const std::string answer = table.answer(row, column);
        const bool written =
            write(ends[1], answer.data(), answer.size()) == static_cast<ssize_t>(answer.size());
        test_leave(written ? 0 : 3);
    }
    close(ends[1]);
    std::string answer;
    char buffer[512];
    for (ssize_t got; (got = read(ends[0], buffer, sizeof buffer)) > 0;)
        answer.append(buffer, static_cast<size_t>(got));
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFSIGNALED(status))
        return "ends by signal " + std::to_string(WTERMSIG(status));
    if (WEXITSTATUS(status) != 0)
        return "ends with status " + std::to_string(WEXITSTATUS(status));
    return answer;
}

std::string CaseName(const Table &table, size_t row, size_t column) {
    return table.name + " / " + table.rows[row] + " / " + table.columns[column];
}

/// The heads of the page must be the test's: no row without a test, no test without a row.
size_t CompareHeads(const std::string &what, const std::vector<std::string> &page,
                    const std::vector<std::string> &test) {
    size_t failures = 0;
    for (const std::string &head : page)
        if (std::find(test.begin(), test.end(), head) == test.end()) {
            std::printf("FAILED: %s \"%s\" of the page has no test\n", what.c_str(), head.c_str());
            ++failures;
        }
    for (const std::string &head : test)
        if (std::count(page.begin(), page.end(), head) != 1) {
            std::printf("FAILED: %s \"%s\" is not on the page once\n", what.c_str(), head.c_str());
            ++failures;
        }
    return failures;
}

struct Result {
    size_t passed = 0, failed = 0;
};

void CheckCell(const Table &table, size_t row, size_t column, const std::string &expected, Result *result) {
    const std::string found = Answer(table, row, column);
    if (found == expected) {
        ++result->passed;
        return;
    }
    ++result->failed;
    std::printf("FAILED: %s: the page says \"%s\", it is \"%s\"\n", CaseName(table, row, column).c_str(),
                expected.c_str(), found.c_str());
}

void CheckTable(const char *file, const Table &table, const char *only, Result *result) {
    Page page;
    if (!ReadPage(file, table.name, &page)) {
        std::printf("FAILED: the page has no table %s\n", table.name.c_str());
        ++result->failed;
        return;
    }
    result->failed += CompareHeads(table.name + ": the column", page.columns, table.columns);
    result->failed += CompareHeads(table.name + ": the row", page.rows, table.rows);
    for (size_t i = 0; i < page.rows.size(); ++i)
        for (size_t j = 0; j < page.columns.size(); ++j) {
            const auto row = std::find(table.rows.begin(), table.rows.end(), page.rows[i]);
            const auto column = std::find(table.columns.begin(), table.columns.end(), page.columns[j]);
            if (row == table.rows.end() || column == table.columns.end())
                continue;
            const auto r = static_cast<size_t>(row - table.rows.begin());
            const auto c = static_cast<size_t>(column - table.columns.begin());
            if (only == nullptr || CaseName(table, r, c) == only)
                CheckCell(table, r, c, j < page.cells[i].size() ? page.cells[i][j] : "", result);
        }
}

int Check(const char *file, const std::vector<Table> &tables, const char *only) {
    Result result;
    for (const Table &table : tables)
        CheckTable(file, table, only, &result);
    std::printf("%zu passed, %zu failed\n", result.passed, result.failed);
    return result.failed == 0 && result.passed > 0 ? 0 : 1;
}

void List(const std::vector<Table> &tables) {
    for (const Table &table : tables)
        for (size_t row = 0; row < table.rows.size(); ++row)
            for (size_t column = 0; column < table.columns.size(); ++column)
                std::printf("%s\n", CaseName(table, row, column).c_str());
}

void Print(const std::vector<Table> &tables) {
    for (const Table &table : tables) {
        std::printf("<!-- checked: %s -->\n| |", table.name.c_str());
        for (const std::string &column : table.columns)
            std::printf(" %s |", column.c_str());
        std::printf("\n| --- |");
        for (size_t column = 0; column < table.columns.size(); ++column)
            std::printf(" --- |");
        for (size_t row = 0; row < table.rows.size(); ++row) {
            std::printf("\n| %s |", table.rows[row].c_str());
            for (size_t column = 0; column < table.columns.size(); ++column)
                std::printf(" %s |", Answer(table, row, column).c_str());
        }
        std::printf("\n\n");
    }
}

} // namespace

int Main(int argc, char **argv, const std::vector<Table> &tables) {
    const char *what = argc > 1 ? argv[1] : "";
    if (std::strcmp(what, "check") == 0 && argc > 2)
        return Check(argv[2], tables, argc > 3 ? argv[3] : nullptr);
    if (std::strcmp(what, "list") == 0)
        List(tables);
    else if (std::strcmp(what, "print") == 0)
        Print(tables);
    else {
        std::fprintf(stderr, "usage: %s check PAGE [CASE] | list | print\n", argv[0]);
        return 2;
    }
    return 0;
}

} // namespace bad_input
