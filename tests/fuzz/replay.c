// SPDX-License-Identifier: MIT
// Runs a fuzzer over packed corpora, without libFuzzer: any compiler, any build.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "harness.h"
#include "packed_corpus.h"

static size_t inputs;
static const char *playing = "";

static void found_as_it_should_be(void) {
    fprintf(stderr, "control: found by %s\n", playing);
    _Exit(0);
}

static void run_input(void *context, const char *name, const uint8_t *bytes, size_t size) {
    (void)context;
    playing = name;
    ++inputs;
    if (getenv("BMR_FUZZ_VERBOSE"))
        fprintf(stderr, "%s\n", name);
    LLVMFuzzerTestOneInput(bytes, size);
}

int main(int count, char **arguments) {
    int first = 1;
    const bool control = count > 2 && strcmp(arguments[1], "--control") == 0;
    if (control) {
        fuzz_set_control(arguments[2], found_as_it_should_be);
        first = 3;
    }
    if (first >= count || strcmp(arguments[1], "--help") == 0) {
        fprintf(stderr,
                "usage: %s [--control NAME] CORPUS...\n"
                "Runs the fuzzer on each input of packed corpora. --control: falsifies the answer of that "
                "name;\n"
                "0 if that is found, 1 if not. BMR_FUZZ_VERBOSE=1 names each input first.\n",
                arguments[0]);
        return 2;
    }
    for (int i = first; i < count; ++i)
        if (!packed_corpus_read(arguments[i], run_input, NULL)) {
            fprintf(stderr, "%s is no packed corpus\n", arguments[i]);
            return 3;
        }
    fprintf(stderr, "%zu inputs, nothing found\n", inputs);
    return control ? 1 : 0;
}
