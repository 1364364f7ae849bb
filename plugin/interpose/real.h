// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_INTERPOSE_REAL_H
#define BOOMERANG_INTERPOSE_REAL_H

#include <atomic>

#include <box2d/b2_common.h>

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
/// With BMR_STATIC_WRAP (a static link with -Wl,--wrap=NAME for each) the same source makes __wrap_NAME, and
/// Box2D's own function is __real_NAME.

#define BMR_EXPORTED __attribute__((visibility("default")))
#if defined(BMR_STATIC_WRAP)
#    define BMR_STANDS_FOR(name) asm("__wrap_" name) BMR_EXPORTED
#else
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

/// What the hooks keep on a thread while it steps a world, and no longer: a step that a listener makes of
/// another world begins with none of it, and what the outer step had is there again afterwards.
struct Stepping {
    const b2World *world;  ///< nullptr outside of steps
    ShortList *shortList;  ///< the innermost that is alive
    uint32_t knownImpacts; ///< so many questions are left that KnownImpacts sends to Box2D
};

/// This thread's. One load: the library is there when the program starts.
extern __thread Stepping stepping __attribute__((tls_model("initial-exec")));

/// Only in a step are questions answered here; whoever else calls these functions gets Box2D's own.
inline bool InStep() {
    return stepping.world != nullptr;
}

/// Box2D's own b2TimeOfImpact, or what stands for it where a polygon is too big for that.
void RealTimeOfImpact(b2TOIOutput *output, const b2TOIInput *input);

/// As long as it lives, so many of this thread's next questions to b2TimeOfImpact go to Box2D at once: a
/// proof was sought for them already, in vain.
class KnownImpacts {
public:
    explicit KnownImpacts(uint32_t count) : m_outer(stepping.knownImpacts) { stepping.knownImpacts = count; }
    ~KnownImpacts() { stepping.knownImpacts = m_outer; }
    KnownImpacts(const KnownImpacts &) = delete;
    KnownImpacts &operator=(const KnownImpacts &) = delete;

    static bool Take() {
        if (stepping.knownImpacts == 0)
            return false;
        --stepping.knownImpacts;
        return true;
    }

private:
    uint32_t m_outer;
};

} // namespace bmr::interpose

#endif
