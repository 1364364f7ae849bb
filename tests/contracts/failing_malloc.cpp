// SPDX-License-Identifier: MIT
// Memory that fails for the code it is linked with, and for nobody else: every call of malloc and of operator
// new in there comes by here (the linker's --wrap). What Box2D and the C++ runtime ask for themselves does
// not.
#include "failing_malloc.h"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

// NOLINTBEGIN(bugprone-reserved-identifier): the linker's names
extern "C" {
void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *block, size_t size);
void __real_free(void *block);
void *__real__Znwm(size_t size);
void __real__ZdlPv(void *block);

void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *block, size_t size);
void __wrap_free(void *block);
void *__wrap__Znwm(size_t size);
void *__wrap__ZnwmRKSt9nothrow_t(size_t size, const std::nothrow_t &);
void __wrap__ZdlPv(void *block);
void __wrap__ZdlPvm(void *block, size_t size);
}

namespace {

std::atomic<uint64_t> failAt{UINT64_MAX};
std::atomic<uint64_t> asked{0}, failed{0};
std::atomic<int64_t> out{0};

/// Is this allocation to fail? Counts it.
bool Fails() {
    const uint64_t number = asked.fetch_add(1);
    const bool fails = number == failAt;
    failed += fails;
    return fails;
}

void *Counted(void *block) {
    out += block != nullptr;
    return block;
}

} // namespace

extern "C" {

void *__wrap_malloc(size_t size) {
    return Fails() ? nullptr : Counted(__real_malloc(size));
}

void *__wrap_calloc(size_t count, size_t size) {
    return Fails() ? nullptr : Counted(__real_calloc(count, size));
}

/// (Nobody here asks for none.) A block that grows stays one block.
void *__wrap_realloc(void *block, size_t size) {
    if (Fails())
        return nullptr;
    void *const grown = __real_realloc(block, size);
    return block == nullptr ? Counted(grown) : grown;
}

void __wrap_free(void *block) {
    out -= block != nullptr;
    __real_free(block);
}

void *__wrap__Znwm(size_t size) {
    if (Fails())
        throw std::bad_alloc();
    return Counted(__real__Znwm(size));
}

void *__wrap__ZnwmRKSt9nothrow_t(size_t size, const std::nothrow_t &) {
    return Fails() ? nullptr : Counted(__real__Znwm(size));
}

void __wrap__ZdlPv(void *block) {
    out -= block != nullptr;
    __real__ZdlPv(block);
}

void __wrap__ZdlPvm(void *block, size_t) {
    __wrap__ZdlPv(block);
}

} // extern "C"
// NOLINTEND(bugprone-reserved-identifier)

namespace failing_malloc {

void FailAt(uint64_t number) {
    asked = failed = 0;
    failAt = number;
}

uint64_t Asked() {
    return asked;
}

uint64_t Failed() {
    return failed;
}

int64_t Out() {
    return out;
}

} // namespace failing_malloc
