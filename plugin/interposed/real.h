// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_INTERPOSED_REAL_H
#define BOOMERANG_INTERPOSED_REAL_H

#include <atomic>
#include <cstdint>
#include <mutex>

#include "base/compiler.h"

/// @file
/// How a call to Box2D gets to a hook, and a hook to the function of Box2D's that it stands in front of,
/// where Box2D is a shared library (ELF).
///
/// Loaders find a hook by its mangled name, linkers do not. The name has the version BOOMERANG_HOOKS, which
/// is not its default. A loader that looks for a name without a version takes it from a library's first
/// version, default or not; a linker takes the default alone. So calls to a Box2D that is loaded come here. A
/// program that has Box2D inside keeps all of that: if the linker saw the hooks, it would take them for the
/// functions that the program needs and leave Box2D's own out, which then is nowhere. (dlsym does not find
/// hooks either: what it finds is Box2D's.) With BMR_HOOKS_FOR_LINKERS linkers find them, too: for builds
/// with sanitizers or counts of lines, which are never linked ahead of an archive.

#if defined(BMR_SHARED_LIBRARY) && !defined(BMR_HOOKS_FOR_LINKERS)
#    define BMR_FOR_LOADERS(name) __asm__(".symver " name ", " name "@BOOMERANG_HOOKS, remove")
#else
#    define BMR_FOR_LOADERS(name) static_assert(true)
#endif

namespace bmr {

/// Where one of Box2D's functions is.
class FoundFunction {
public:
    explicit constexpr FoundFunction(const char *mangled) : m_name(mangled) {}

    /// The next definition of the name after this library's; where there is none, that of a module which was
    /// opened for itself (dlopen with RTLD_LOCAL): of several, the one that was loaded first. Looked up again
    /// where files were loaded or closed meanwhile; no file is kept open. Ends the program if no module has
    /// it: a function that is called must be somewhere.
    void *Find();

private:
    std::mutex m_guard; ///< never held while the loader is asked
    void *m_found = nullptr;
    uint64_t m_changes = 0; ///< of the loader's list, when it was found
    const char *m_name;
};

/// Was Box2D there when this library was loaded? Then it stays, for this library refers to it.
bool Box2DStays();

/// A function of Box2D's, looked up once where Box2D stays. Any thread may be the first; initialised at
/// compile time, since Box2D may be called before this library's constructors ran.
template <typename Function> class Real;
template <typename Result, typename... Arguments> class Real<Result(Arguments...)> {
    using Function = Result(Arguments...);

public:
    explicit constexpr Real(const char *name) : m_found(name) {}

    /// As the last thing that a hook does: a load, a test and a jump. (What looks the function up is a call
    /// of its own, so that the hook needs no room on the stack.)
    Result operator()(Arguments... arguments) {
        Function *function = m_function.load(std::memory_order_relaxed);
        return BMR_RARELY(function == nullptr) ? FindAndCall(arguments...) : function(arguments...);
    }

private:
    BMR_COLD Result FindAndCall(Arguments... arguments) {
        Function *const function = reinterpret_cast<Function *>(m_found.Find());
        if (Box2DStays())
            m_function.store(function, std::memory_order_relaxed);
        return function(arguments...);
    }

    std::atomic<Function *> m_function{nullptr};
    FoundFunction m_found;
};

} // namespace bmr

#endif
