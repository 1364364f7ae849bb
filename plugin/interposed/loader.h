// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_INTERPOSED_LOADER_H
#define BOOMERANG_INTERPOSED_LOADER_H

namespace bmr {

/// Whether a b2World::Step of this process is this library's, as far as dynamic linking goes.
bool StepsAreSeen();

/// Whether there is a Box2D behind this library in search order. There is none if a module opened its own
/// (dlopen with RTLD_LOCAL). Its calls reach this library all the same.
bool AnyBox2DBehind();

/// Is Boomerang in this process a second time, compiled with its Box2D (boomerang_accelerate)? As far as
/// names can be seen: a program shows what a library that it is linked with has, too.
bool AnotherIsCompiledIn();

/// Where StepsAreSeen() is false: is the b2World::Step that is called in the program itself?
bool ProgramStepsFirst();

/// If no step is seen: the reason, and the line to write, in a few words. The answer lives until the next
/// call.
const char *WhyNoStepIsSeen();

/// The same for a module's own Box2D, if AnyBox2DBehind() is false and a step is seen all the same.
const char *WhyModuleIsLeftAlone();

/// Why the libbox2d that was loaded must be left alone, or nullptr: the program calls another one, a symbol
/// of box2d_symbols.inc or of a hook is not there, or data has another size, or it was loaded when this
/// library's own references had been settled. Calls nothing of Box2D's. The answer lives until the next call.
const char *WhyLibraryIsUnknown();

/// Does LD_PRELOAD name this library? (One that /etc/ld.so.preload names is on with BOOMERANG=on.)
bool IsPreloaded();

} // namespace bmr

#endif
