// SPDX-License-Identifier: MIT
// A program that never heard of Box2D.
#include <cstdio>

int main() {
    std::puts("no game");
    return 7;
}
