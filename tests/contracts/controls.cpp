// SPDX-License-Identifier: MIT
// Contracts that nobody keeps: each of the checks must fail.
#include <csignal>

#include "contracts.h"
#include "every_allocation.h"

using namespace contracts;

namespace {

std::string Leak(const Given &g) {
    const bmr_allocator *allocator = g.allocator;
    static void *first; // which a checker of the whole program shall not call lost
    first = allocator->allocate(allocator->context, 8);
    void *second = first != nullptr ? allocator->allocate(allocator->context, 8) : nullptr;
    if (second == nullptr)
        return "NO_MEMORY"; // the first stays out
    allocator->release(allocator->context, second, 8);
    allocator->release(allocator->context, first, 8);
    g.Made("x", 1);
    return "OK";
}

std::string Hide(const Given &g) {
    void *block = g.allocator->allocate(g.allocator->context, 8);
    if (block != nullptr)
        g.allocator->release(g.allocator->context, block, 8);
    g.Made(block != nullptr ? "x" : "y", 1);
    return "OK";
}

std::string ConfuseSizes(const Given &g) {
    void *block = g.allocator->allocate(g.allocator->context, 8);
    if (block == nullptr)
        return "NO_MEMORY";
    g.allocator->release(g.allocator->context, block, 16);
    g.Made("x", 1);
    return "OK";
}

const Table kControls("functions", [] {
    Allocates("leak", Leak);
    Allocates("hide", Hide);
    Allocates("confuse sizes", ConfuseSizes);
    Answers("another answer", "OK", {{"x", kFinite}}, [](const Given &) { return "OUT_OF_RANGE"; });
    Answers("a signal", "OK", {}, [](const Given &) {
        std::raise(SIGKILL);
        return "OK";
    });
    Refuses("written", {}, [](const Given &) { return Said(BMR_ERROR_NOT_FINITE, true); });
});
const Table kMatrix("nowhere on the page", [] {
    return Matrix{{"a column"}, {"a row"}, [](size_t, size_t) { return std::string("an answer"); }};
});

} // namespace
