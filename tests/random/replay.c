// SPDX-License-Identifier: MIT
// Runs a fuzzer over packed corpora, or over inputs made from seeds, without libFuzzer: any compiler, any
// build.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "harness.h"
#include "packed_corpus.h"
#include "polygons.h"
#include "test_scale.h"

typedef struct input {
    char name[96];
    uint8_t *bytes;
    size_t size;
} input;

static input *corpus;
static size_t corpus_size, inputs;
static const char *program, *control;
static const input *playing;

static void show(void) {
    if (control) {
        fprintf(stderr, "control: found by %s\n", playing->name);
        _Exit(0);
    }
    fprintf(stderr, "Again: %s <(echo %s ", program, playing->name);
    for (size_t i = 0; i < playing->size; ++i)
        fprintf(stderr, "%02x", playing->bytes[i]);
    fputs(")\n", stderr);
}

static void play(const input *one) {
    playing = one;
    ++inputs;
    if (getenv("BMR_FUZZ_VERBOSE"))
        fprintf(stderr, "%s\n", one->name);
    LLVMFuzzerTestOneInput(one->bytes, one->size);
}

static void keep(void *context, const char *name, const uint8_t *bytes, size_t size) {
    (void)context;
    corpus = realloc(corpus, (corpus_size + 1) * sizeof *corpus);
    input *const kept = corpus ? &corpus[corpus_size++] : NULL;
    if (!kept || !(kept->bytes = malloc(size > 0 ? size : 1)))
        abort();
    snprintf(kept->name, sizeof kept->name, "%s", name);
    memcpy(kept->bytes, bytes, size);
    kept->size = size;
}

/// Bytes of any kind: all values, or mostly a few of them.
static uint8_t any_byte(test_random *random, uint32_t kind) {
    const uint8_t byte = (uint8_t)test_random_below(random, 256);
    return kind == 0 && test_random_below(random, 2) == 0 ? (uint8_t)(byte & 7) : byte;
}

/// Of an even seed: new bytes. Of an odd one: an input of the corpus, of which some bytes are others, and
/// which may go on as another input does.
static input made_from(uint64_t seed) {
    test_random random = {seed};
    const size_t fresh = (size_t)4 << test_random_below(&random, 8);
    const bool bent = seed % 2 != 0 && corpus_size > 0;
    const input *const from = bent ? &corpus[test_random_below(&random, (uint32_t)corpus_size)] : NULL,
                       *const on = bent ? &corpus[test_random_below(&random, (uint32_t)corpus_size)] : NULL;
    const size_t cut = bent ? test_random_below(&random, (uint32_t)from->size + 1) : 0;
    const bool goes_on = bent && test_random_below(&random, 2) == 0 && on->size > cut;
    input made = {"", NULL, !bent ? fresh : goes_on ? on->size : from->size};
    snprintf(made.name, sizeof made.name, "seed-%llu", (unsigned long long)seed);
    if (!(made.bytes = malloc(made.size > 0 ? made.size : 1)))
        abort();
    const uint32_t kind = test_random_below(&random, 3);
    for (size_t i = 0; i < made.size; ++i)
        made.bytes[i] = !bent ? any_byte(&random, kind) : goes_on && i >= cut ? on->bytes[i] : from->bytes[i];
    for (uint32_t changes = bent ? 1 + test_random_below(&random, 8) : 0; changes > 0 && made.size > 0;
         --changes)
        made.bytes[test_random_below(&random, (uint32_t)made.size)] = any_byte(&random, 0);
    return made;
}

static int usage(void) {
    fprintf(
        stderr,
        "usage: %s [--control NAME] [--seeds FIRST COUNT] CORPUS...\n"
        "Runs the fuzzer on each input of packed corpora; with --seeds on inputs made from so many seeds\n"
        "(times BMR_TEST_SCALE), every other one from an input of the corpora. --control: falsifies the\n"
        "answer of that name; 0 if that is found, 1 if not. BMR_FUZZ_VERBOSE=1 names each input first.\n",
        program);
    return 2;
}

int main(int count, char **arguments) {
    program = arguments[0];
    int first = 1;
    uint64_t seed = 0;
    size_t seeds = 0;
    for (; first < count && strncmp(arguments[first], "--", 2) == 0;)
        if (strcmp(arguments[first], "--control") == 0 && first + 1 < count) {
            control = arguments[first + 1];
            first += 2;
        } else if (strcmp(arguments[first], "--seeds") == 0 && first + 2 < count) {
            seed = strtoull(arguments[first + 1], NULL, 10);
            seeds = test_scaled(strtoull(arguments[first + 2], NULL, 10));
            first += 3;
        } else {
            return usage();
        }
    if (first >= count)
        return usage();
    for (int i = first; i < count; ++i)
        if (!packed_corpus_read(arguments[i], keep, NULL)) {
            fprintf(stderr, "%s is no packed corpus\n", arguments[i]);
            return 3;
        }
    fuzz_set_control(control, show);
    for (size_t i = 0; i < seeds; ++i) {
        const input made = made_from(seed + i);
        play(&made);
        free(made.bytes);
    }
    for (size_t i = 0; i < corpus_size; ++i) {
        fuzz_input_name = corpus[i].name;
        if (seeds == 0)
            play(&corpus[i]);
        free(corpus[i].bytes);
    }
    free(corpus);
    fprintf(stderr, "%zu inputs, nothing found\n", inputs);
    return control ? 1 : 0;
}
