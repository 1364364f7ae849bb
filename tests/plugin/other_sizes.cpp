// SPDX-License-Identifier: MIT
// Preloaded ahead of Box2D: its register of contacts, larger than 2.4.1's.
extern "C" char registers[1024] __asm__("_ZN9b2Contact11s_registersE");
char registers[1024];
