// SPDX-License-Identifier: MIT
// One run of a script, in the program itself.
#include "script.h"

extern "C" void fuzz_glue_run(const fuzz::RunRequest *request, fuzz::RunResult *result);

extern "C" void fuzz_glue_run(const fuzz::RunRequest *request, fuzz::RunResult *result) {
    // Its worlds are always in the same place: nothing that is kept under an address may outlive them.
    static std::optional<fuzz::Script> script;
    script.emplace(*request);
    *result = script->Run();
    script.reset();
}
