// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_INTERPOSE_REAL_H
#define BOOMERANG_INTERPOSE_REAL_H

#include <atomic>

#include <box2d/b2_common.h>

#include "rounding_mode.h"

class b2ContactManager;
class b2World;
struct b2TOIInput;
struct b2TOIOutput;

/// @file
/// What the functions in this room share: their names, the functions of Box2D's that they stand in front of,
/// and whether a world is being stepped. ELF only.
///
/// A hook is a function of ours under the mangled name of Box2D's:
///
///     void Hook(b2TOIOutput *output, const b2TOIInput *input) BMR_STANDS_FOR("_Z14b2TimeOf...");
///
/// In the shared library loaders find it, linkers do not. The name has the version BOOMERANG_HOOKS, which is
/// not its default. A loader that looks for a name without a version takes it from a library's first version,
/// default or not; a linker takes the default alone. So calls to a Box2D that is loaded come here. A program
/// that has Box2D inside keeps all of that: if the linker saw the hooks, it would take them for the functions
/// that the program needs and leave Box2D's own out, which then is nowhere. (dlsym does not find hooks
/// either: what it finds is Box2D's.) With BMR_HOOKS_FOR_LINKERS linkers find them, too: for builds with
/// sanitizers or counts of lines, which are never linked ahead of an archive.
///
/// With BMR_STATIC_WRAP (a static link with -Wl,--wrap=NAME for each) the same source makes __wrap_NAME, and
/// Box2D's own function is __real_NAME.

#define BMR_EXPORTED __attribute__((visibility("default")))
#if defined(BMR_STATIC_WRAP)
#    define BMR_STANDS_FOR(name) asm("__wrap_" name) BMR_EXPORTED
#elif defined(BMR_SHARED_LIBRARY) && !defined(BMR_HOOKS_FOR_LINKERS)
#    define BMR_FOR_LOADERS(name) __asm__(".symver " name ", " name "@BOOMERANG_HOOKS, remove")
#    define BMR_STANDS_FOR(name)                                                                             \
        asm(name) BMR_EXPORTED;                                                                              \
        BMR_FOR_LOADERS(name)
#else
#    define BMR_FOR_LOADERS(name) static_assert(true)
#    define BMR_STANDS_FOR(name) asm(name) BMR_EXPORTED
#endif

namespace bmr {

/// The next definition of this name after this library's; where there is none, that of a module which was
/// opened for itself (dlopen with RTLD_LOCAL) and which then stays loaded: of several, the one that was
/// loaded first. Ends the program where nobody has it: it is called, so somebody must.
void *FindReal(const char *mangled);

} // namespace bmr

namespace bmr::interpose {

class ShortList;
class StepMark;

/// A function of Box2D's, looked up once. Any thread may be the first; initialised at compile time, since
/// Box2D may be called before this library's constructors ran.
template <typename Function> class Real {
public:
    explicit constexpr Real(const char *name) : m_name(name) {}

    Function *Get() {
        Function *function = m_function.load(std::memory_order_relaxed);
        return function != nullptr ? function : Find();
    }

private:
    __attribute__((noinline, cold)) Function *Find() {
        Function *function = reinterpret_cast<Function *>(FindReal(m_name));
        m_function.store(function, std::memory_order_relaxed);
        return function;
    }

    std::atomic<Function *> m_function{nullptr};
    const char *m_name;
};

/// What the hooks keep on a thread while it steps worlds, and no longer. A listener may step another world,
/// or its own; and steps of two worlds may be interleaved on one thread, where each runs on a stack of its
/// own and a listener leaves one for the other: the later one need not end first. So marks and lists take
/// themselves out of their chain wherever they are in it, and a list is looked up by the world it is of.
struct Stepping {
    StepMark *mark;        ///< the newest of the steps that have not ended; nullptr outside of steps
    ShortList *shortList;  ///< the newest that is alive
    uint32_t knownImpacts; ///< so many questions are left that KnownImpacts sends to Box2D
    bool *stepComplete;    ///< while there are any: what KnownImpacts sets to true
    /// Whose new contacts were looked for last, if that came by here.
    const b2ContactManager *searched;
};

/// This thread's. One load: the library is there when the program starts.
extern __thread Stepping stepping __attribute__((tls_model("initial-exec")));

/// Only in a step, and rounding to nearest, are questions answered here; whoever else calls these functions
/// gets Box2D's own.
inline bool InStep() {
    return stepping.mark != nullptr && RoundsToNearest();
}

/// Box2D's own b2TimeOfImpact, or what stands for it where a polygon is too big for that.
void RealTimeOfImpact(b2TOIOutput *output, const b2TOIInput *input);

/// As long as it lives, so many of this thread's next questions to b2TimeOfImpact go to Box2D at once: a
/// proof was sought for them already, in vain. They are the first thing that b2World::SolveTOI does, before
/// it calls anybody. Once it asks it has read `stepComplete`, which was false for it alone, and nobody else
/// is to see that.
class KnownImpacts {
public:
    KnownImpacts(uint32_t count, bool *stepComplete) {
        *stepComplete = false;
        stepping.knownImpacts = count;
        stepping.stepComplete = stepComplete;
    }
    ~KnownImpacts() { stepping.knownImpacts = 0; }
    KnownImpacts(const KnownImpacts &) = delete;
    KnownImpacts &operator=(const KnownImpacts &) = delete;

    static bool Take() {
        if (stepping.knownImpacts == 0)
            return false;
        --stepping.knownImpacts;
        *stepping.stepComplete = true;
        return true;
    }
};

} // namespace bmr::interpose

#endif
