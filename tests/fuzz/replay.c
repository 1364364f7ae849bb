// SPDX-License-Identifier: MIT
// Runs a fuzzer over files and directories of files, without libFuzzer: any compiler, any build.
#define _POSIX_C_SOURCE 200809L // scandir
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "harness.h"

static size_t files;

static void found_as_it_should_be(void) {
    fprintf(stderr, "control: found, file %zu\n", files);
    _Exit(0);
}

/// Of its very size, so that reading past it is seen.
static void run_bytes(const char *name, const uint8_t *data, size_t size) {
    uint8_t *exact = malloc(size > 0 ? size : 1);
    if (!exact)
        abort();
    memcpy(exact, data, size);
    ++files;
    if (getenv("BMR_FUZZ_VERBOSE"))
        fprintf(stderr, "%s\n", name);
    LLVMFuzzerTestOneInput(exact, size);
    free(exact);
}

/// A line an input: its name, and its bytes in hexadecimal.
static int run_packed(FILE *file, const char *path) {
    char *line = NULL;
    size_t room = 0;
    int answer = 0;
    for (ssize_t length; answer == 0 && (length = getline(&line, &room, file)) > 0;) {
        char *hex = strchr(line, ' ');
        if (!hex) {
            fprintf(stderr, "%s: no input: %s\n", path, line);
            answer = 3;
            break;
        }
        *hex++ = '\0';
        size_t size = 0;
        for (unsigned byte; sscanf(hex + 2 * size, "%2x", &byte) == 1; ++size)
            hex[size] = (char)byte;
        run_bytes(line, (const uint8_t *)hex, size);
    }
    free(line);
    return answer;
}

static int run_file(const char *path) {
    FILE *file = fopen(path, "rb");
    if (!file) {
        perror(path);
        return 3;
    }
    const size_t end = strlen(path);
    if (end > 4 && strcmp(path + end - 4, ".txt") == 0) {
        const int answer = run_packed(file, path);
        fclose(file);
        return answer;
    }
    uint8_t *data = NULL;
    size_t size = 0, room = 0;
    for (size_t got = 1; got > 0; size += got) {
        if (size == room) {
            room = room ? 2 * room : 4096;
            uint8_t *more = realloc(data, room);
            if (!more)
                abort();
            data = more;
        }
        got = fread(data + size, 1, room - size, file);
    }
    fclose(file);
    run_bytes(path, data, size);
    free(data);
    return 0;
}

static int by_name(const struct dirent **a, const struct dirent **b) {
    return strcmp((*a)->d_name, (*b)->d_name);
}

static int run_path(const char *path) {
    struct stat status;
    if (stat(path, &status) != 0) {
        perror(path);
        return 3;
    }
    if (!S_ISDIR(status.st_mode))
        return run_file(path);
    struct dirent **entries = NULL;
    const int count = scandir(path, &entries, NULL, by_name);
    int answer = count < 0 ? 3 : 0;
    for (int i = 0; i < count; ++i) {
        char inside[4096];
        const int length = snprintf(inside, sizeof inside, "%s/%s", path, entries[i]->d_name);
        if (answer == 0 && entries[i]->d_name[0] != '.' && length > 0 && (size_t)length < sizeof inside)
            answer = run_path(inside);
        free(entries[i]);
    }
    free(entries);
    return answer;
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
                "usage: %s [--control NAME] FILE-OR-DIRECTORY...\n"
                "Runs the fuzzer on each file. --control: falsifies the answer of that name; 0 if that is "
                "found,\n"
                "1 if not. BMR_FUZZ_VERBOSE=1 names each file first.\n",
                arguments[0]);
        return 2;
    }
    for (int i = first; i < count; ++i) {
        const int answer = run_path(arguments[i]);
        if (answer != 0)
            return answer;
    }
    if (files == 0) {
        fprintf(stderr, "no files\n");
        return 3;
    }
    fprintf(stderr, "%zu files, nothing found\n", files);
    return control ? 1 : 0;
}
