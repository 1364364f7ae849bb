// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_FUZZ_GLUE_RUN_REQUEST_H
#define BOOMERANG_FUZZ_GLUE_RUN_REQUEST_H

#include <cstddef>
#include <cstdint>

/// @file
/// What crosses from one link namespace to the other: plain numbers and one C function.

namespace fuzz {

/// What was seen of all worlds after one step (or, last, after the script's end). `probes`: of what was asked
/// out of turn since the record before.
struct Record {
    uint64_t bodies, contacts, events, probes;
};

constexpr int32_t kMostRecords = 49;

enum class Ending : int32_t {
    Done,
    Enough,    ///< as many records as were asked for
    Asserted,  ///< Box2D's assertions do not allow what comes next
    NotFinite, ///< a body has left the numbers
};

struct RunRequest {
    const uint8_t *data = nullptr;
    size_t size = 0;
    int32_t mostRecords = kMostRecords;
    int32_t perturbAt = -1; ///< before this record one velocity is changed by one unit in the last place
    int32_t dumpAt = -1;    ///< this record is printed on stderr, a line for each field
    Record *records = nullptr;
};

struct RunResult {
    int32_t records = 0;
    Ending ending = Ending::Done;
    char assertion[160] = ""; ///< which one, of Ending::Asserted
};

} // namespace fuzz

extern "C" {
using fuzz_glue_run_function = void(const fuzz::RunRequest *request, fuzz::RunResult *result);
}

#endif
