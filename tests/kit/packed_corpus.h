// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_PACKED_CORPUS_H
#define BOOMERANG_TEST_PACKED_CORPUS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Takes an input of a corpus. `bytes` is a block of its very size, so that a sanitizer sees who reads past
/// it; it and `name` go when the call ends.
typedef void packed_input_reader(void *context, const char *name, const uint8_t *bytes, size_t size);

/// Gives all inputs of a packed corpus to `read`, in their order. A packed corpus is a text file: a line an
/// input, its name, a space, its bytes in hexadecimal (small letters). False where the file cannot be read or
/// has no input, or a line is not of that form.
bool packed_corpus_read(const char *path, packed_input_reader *read, void *context);

#ifdef __cplusplus
}
#endif
#endif
