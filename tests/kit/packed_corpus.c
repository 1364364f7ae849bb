// SPDX-License-Identifier: MIT
#define _POSIX_C_SOURCE 200809L // getline
#include "packed_corpus.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool read_line(char *line, packed_input_reader *read, void *context) {
    static const char digits[] = "0123456789abcdef";
    line[strcspn(line, "\n")] = '\0';
    char *const space = strchr(line, ' ');
    if (!space || space == line)
        return false;
    *space = '\0';
    const char *const hex = space + 1;
    const size_t length = strlen(hex), size = length / 2;
    if (length % 2 != 0 || strspn(hex, digits) != length)
        return false;
    uint8_t *const bytes = malloc(size > 0 ? size : 1);
    if (!bytes)
        return false;
    for (size_t i = 0; i < size; ++i)
        bytes[i] =
            (uint8_t)(16 * (strchr(digits, hex[2 * i]) - digits) + (strchr(digits, hex[2 * i + 1]) - digits));
    read(context, line, bytes, size);
    free(bytes);
    return true;
}

bool packed_corpus_read(const char *path, packed_input_reader *read, void *context) {
    FILE *const file = fopen(path, "r");
    if (!file)
        return false;
    char *line = NULL;
    size_t room = 0, count = 0;
    bool good = true;
    for (; good && getline(&line, &room, file) > 0; ++count)
        good = read_line(line, read, context);
    good = good && count > 0 && !ferror(file);
    free(line);
    fclose(file);
    return good;
}
