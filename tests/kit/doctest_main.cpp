// SPDX-License-Identifier: MIT
//
// doctest's own part and the main of all tests in C++, compiled once: it takes three times as long as a test.
#define DOCTEST_CONFIG_IMPLEMENT
#include <string>

#include <doctest/doctest.h>

#include "random.h"

namespace {

/// Says of each check that fails how its test is run again, and where the random numbers were by then.
struct Again : doctest::ConsoleReporter {
    using ConsoleReporter::ConsoleReporter;

    void test_case_start(const doctest::TestCaseData &test) override {
        ConsoleReporter::test_case_start(test);
        test_random_last = {};
    }
    void log_assert(const doctest::AssertData &check) override {
        ConsoleReporter::log_assert(check);
        if (!check.m_failed)
            return;
        std::string name;
        for (const char *c = tc->m_name; *c != '\0'; ++c) // a comma parts two names, ? is any character
            name += *c == ',' ? "\\," : std::string(1, *c == '\'' ? '?' : *c);
        s << "Again: " << opt.binary_name << " --test-case='" << name.c_str() << "'";
        if (test_random_last.drawn > 0)
            s << ". After " << test_random_last.drawn << " random numbers of the seed "
              << test_random_last.seed;
        s << "\n\n";
    }
};

REGISTER_REPORTER("again", 1, Again);

} // namespace

int main(int argc, char **argv) {
    doctest::Context context;
    context.setOption("reporters", "again");
    context.applyCommandLine(argc, argv);
    return context.run();
}
