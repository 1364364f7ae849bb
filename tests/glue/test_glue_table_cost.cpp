// SPDX-License-Identifier: MIT
// When a pass over the table of pairs pays.
#include <doctest/doctest.h>

#include "glue/pairs/table_cost.h"

namespace {

constexpr uint32_t kPairs = 200;

/// How many of 2,000 steps go by the list in a world of which each step is so.
int StepsByList(uint32_t updates, uint32_t fixtures, uint32_t awake, int searches, uint32_t pairs = kPairs) {
    bmr::TableCost cost;
    int byList = 0;
    for (int step = 0; step < 2000; ++step) {
        if (!cost.NextStepPays()) {
            ++byList;
            cost.NoteList(pairs, awake);
            continue;
        }
        for (int i = 0; i < searches; ++i)
            cost.NoteSearch();
        cost.NotePass(step == 0 ? pairs : updates, fixtures, pairs, awake);
    }
    return byList;
}

} // namespace

TEST_CASE("a table rests where most pairs are updated, and works where few are") {
    CHECK(StepsByList(5, 60, kPairs, 0) == 0);
    // Nine passes of 265 steps are tries.
    CHECK(StepsByList(kPairs, 60, kPairs, 0) > 1900);
    CHECK(StepsByList(kPairs, 60, kPairs, 0) < 2000);
}

TEST_CASE("searches for impacts, and walks over many contacts, are a reason to work") {
    CHECK(StepsByList(kPairs, 60, kPairs, 100) == 0);
    CHECK(StepsByList(3000, 3000, 4096, 0, 4096) > 1900);
    CHECK(StepsByList(3000, 3000, 4097, 0, 4097) == 0);
}

TEST_CASE("a world of fewer pairs than a pass costs is stepped by its list; sleepers end a rest") {
    CHECK(StepsByList(2, 20, 30, 0, 30) > 1900);
    bmr::TableCost cost;
    for (int pass = 0; pass < 9; ++pass)
        cost.NotePass(kPairs, kPairs, kPairs, kPairs);
    REQUIRE_FALSE(cost.NextStepPays());
    cost.NoteList(kPairs, kPairs);
    REQUIRE_FALSE(cost.NextStepPays());
    cost.NoteList(kPairs, 3);
    CHECK(cost.NextStepPays());
}
