// SPDX-License-Identifier: MIT
#include "hooks/start.h"

#include <atomic>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <box2d/b2_contact.h>
#include <dlfcn.h>
#include <link.h>

#include "boomerang/box2d.h"
#include "debug/statistics.h"
#include "interposed/real.h"
#include "interposed/weak_box2d.h"
#include "start/install.h"
#include "start/settings.h"

/// @file
/// How the shared library starts: what else is loaded, and what the environment says.

static_assert(sizeof(bmr_pair) == 64, "a pair is one cache line"); // as its header promises

namespace bmr {

/// The b2World::Step that the loader finds by name: this library's, if it is ahead.
extern const char boundStep[] asm("_ZN7b2World4StepEfii") __attribute__((weak));

namespace {

/// The program or the shared library that this address belongs to, as an address that is no other one's; null
/// of addresses that belong to none. Equal for what comes from one file.
const void *FileOf(const void *address) {
    Dl_info info;
    return address != nullptr && dladdr(address, &info) != 0 ? info.dli_fbase : nullptr;
}

struct Symbol {
    const char *name;
    size_t size; ///< of data; 0 of a function
};

/// Of a table of so many virtual functions: before them the Itanium ABI has an offset and a type.
constexpr size_t TableSize(size_t functions) {
    return (2 + functions) * sizeof(void *);
}

constexpr Symbol kSymbols[] = {
#define BMR_FUNCTION(name) {#name, 0},
#define BMR_DATA(name, bytes) {#name, bytes},
#define BMR_HOOK_SYMBOL(name, function, symbol, heard, result, parameters, renamed) BMR_FUNCTION(symbol)
    BMR_BOX2D_SYMBOLS(BMR_FUNCTION, BMR_DATA, BMR_FUNCTION) BMR_HOOKS(BMR_HOOK_SYMBOL)};

/// A program that includes our header calls another Box2D than this library. (Initialised at compile time.)
std::atomic<bool> programHasItsOwn{false};

constexpr char kStep[] = "_ZN7b2World4StepEfii";
constexpr char kCompiledIn[] = "libboomerang_box2d.so is a second copy here. The Box2D of this "
                               "process is compiled with Boomerang, or another copy is loaded, too";
constexpr char kInside[] = "the program has a Box2D of its own inside (boomerang_accelerate is for that)";

const void *OurFile() {
    static const void *const file = FileOf(&programHasItsOwn);
    return file;
}

/// Box2D's own definition: the first, or the next one where the first is ours. (It is where this was not made
/// as a shared library: dlsym passes its hooks over.)
void *Find(const char *name) {
    void *first = dlsym(RTLD_DEFAULT, name);
    return first != nullptr && FileOf(first) == OurFile() ? dlsym(RTLD_NEXT, name) : first;
}

/// Is this in the program itself, and not in a library that it loads?
bool IsInProgram(const void *address) {
    Dl_info info;
    void *file = nullptr;
    return dladdr1(address, &info, &file, RTLD_DL_LINKMAP) != 0 && file != nullptr &&
           static_cast<const link_map *>(file)->l_name[0] == '\0';
}

/// The path of the file that this address is in.
const char *PathOf(const void *address) {
    Dl_info info;
    return address != nullptr && dladdr(address, &info) != 0 ? info.dli_fname : "?";
}

const char *OurPath() {
    return PathOf(&programHasItsOwn);
}

/// The sentence about this process, with two paths at most. A second question is the same, or the last one.
char words[2 * PATH_MAX + 200];

/// In search order ahead of all else, both are in sight of each other.
const char *NameBoth(const char *why, const char *box2d) {
    std::snprintf(words, sizeof words, "%s. Name both: LD_PRELOAD=\"%s %s\"", why, OurPath(), box2d);
    return words;
}

std::string_view FileName(std::string_view path) {
    const size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

size_t SizeOf(const void *address) {
    Dl_info info;
    void *symbol = nullptr;
    if (dladdr1(address, &info, &symbol, RTLD_DL_SYMENT) == 0 || symbol == nullptr)
        return 0;
    return static_cast<const ElfW(Sym) *>(symbol)->st_size;
}

/// Does LD_PRELOAD name this library? (One that /etc/ld.so.preload names is on with BOOMERANG=on.) The
/// variable holds paths with blanks or colons between. The loader has noted by which it loaded us.
bool IsPreloaded() {
    const char *preload = std::getenv("LD_PRELOAD");
    std::string_view rest = preload != nullptr ? preload : "";
    while (!rest.empty()) {
        const size_t end = rest.find_first_of(" :");
        if (FileName(rest.substr(0, end)) == FileName(OurPath()))
            return true;
        rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
    return false;
}

/// Whether a b2World::Step of this process is this library's, as far as dynamic linking goes.
bool StepsAreSeen() {
    return FileOf(boundStep) == OurFile();
}

/// Whether there is a Box2D behind this library in search order. There is none if a module opened its own
/// (dlopen with RTLD_LOCAL). Its calls reach this library all the same.
bool AnyBox2DBehind() {
    return dlsym(RTLD_NEXT, kStep) != nullptr;
}

/// If no step is seen: the reason, and the line to write, in a few words. The answer lives until the next
/// call.
const char *WhyNoStepIsSeen() {
    const char *first = PathOf(boundStep);
    if (!StepsAreSeen() && IsInProgram(boundStep))
        std::snprintf(words, sizeof words,
                      "%s has a b2World::Step of its own. If Box2D is compiled into it, use "
                      "boomerang_accelerate()",
                      first);
    else if (!StepsAreSeen() && IsPreloaded())
        std::snprintf(words, sizeof words, "%s is ahead of it. Name it first: LD_PRELOAD=\"%s %s\"", first,
                      OurPath(), first);
    else if (!StepsAreSeen())
        std::snprintf(words, sizeof words, "%s is ahead of it. Link boomerang::box2d ahead of Box2D", first);
    else if (AnyBox2DBehind())
        std::snprintf(words, sizeof words, "this program never called b2World::Step");
    else
        std::snprintf(words, sizeof words,
                      "this program never called b2World::Step through this library. If Box2D is compiled "
                      "into it, use boomerang_accelerate()");
    return words;
}

/// The same for a module's own Box2D, if AnyBox2DBehind() is false and a step is seen all the same.
const char *WhyModuleIsLeftAlone() {
    const std::string_view path = PathOf(FoundFunction(kStep).Find());
    if (FileName(path).substr(0, 8) == "libbox2d")
        return NameBoth("the Box2D of this process is a module's own (dlopen)", path.data());
    std::snprintf(words, sizeof words,
                  "the Box2D of this process is inside a module's own file (dlopen), %s. Where that is "
                  "compiled, use boomerang_accelerate()",
                  path.data());
    return words;
}

/// Is Boomerang in this process a second time, compiled with its Box2D (boomerang_accelerate)? As far as
/// names can be seen: a program shows what a library that it is linked with has, too.
bool AnotherIsCompiledIn() {
    const void *other = Find("_ZN3bmr7InstallERKNS_7OptionsE");
    return other != nullptr && FileOf(other) != OurFile();
}

/// Why the libbox2d that was loaded must be left alone, or nullptr: the program calls another one, a symbol
/// of weak_box2d.h or of a hook is not there, or data has another size, or it was loaded when this
/// library's own references had been settled. Calls nothing of Box2D's. The answer lives until the next call.
const char *WhyLibraryIsUnknown() {
    if (AnotherIsCompiledIn())
        return kCompiledIn;
    if (programHasItsOwn)
        return kInside;
    for (const Symbol &symbol : kSymbols) {
        const void *found = Find(symbol.name);
        if (found == nullptr && IsInProgram(Find(kStep)))
            return kInside; // the linker shows as much of it as libraries ask for
        if (found == nullptr || (symbol.size > 0 && SizeOf(found) != symbol.size)) {
            std::snprintf(words, sizeof words, "the Box2D of this process %s %s",
                          found == nullptr ? "lacks" : "has another size of", symbol.name);
            return words;
        }
    }
    if (!Box2DStays())
        return NameBoth("the Box2D of this process was loaded after this library", PathOf(Find(kStep)));
    return nullptr;
}

/// Preloaded, or asked for by the environment. Otherwise the program calls bmr::Install.
bool startsAtFirstStep = false;

/// Where nothing else was said.
void SayWhyNotUsed() {
    const bool came = StepsAreSeen() && !internal::startsByItself;
    if (IsAnnounced())
        return;
    const char *why = nullptr;
    if (startsAtFirstStep)
        why = came ? nullptr : WhyNoStepIsSeen();
    else if (!InstallWasCalled())
        why = "nothing called bmr::Install(). Call it before the first step, or set BOOMERANG=on";
    if (why != nullptr)
        std::fprintf(stderr, "boomerang: not used: %s\n", why);
}

void SayAtExitIfNotUsed() {
    if (IsVerbose())
        CallAtEnd(SayWhyNotUsed);
}

/// Runs when the library is loaded, possibly before other libraries' and the program's own constructors: it
/// looks at the environment and at what else is loaded. No Box2D is needed yet, so values that are not
/// understood are not reported here; Install reports them.
__attribute__((constructor)) void Loaded() {
    SetLibraryCheck(WhyLibraryIsUnknown);
    if (AnotherIsCompiledIn()) {
        if (ModeOfEnvironment(Complaints::Held) != Mode::Off)
            Refuse(WhyLibraryIsUnknown());
        return;
    }
    ReadVerbosity();
    if (StepsAreSeen())
        SetWay("ahead of Box2D", nullptr);
    else
        SetWay("not ahead of Box2D", WhyNoStepIsSeen());
    const std::optional<Mode> asked = ModeOfEnvironment(Complaints::Held);
    if (asked == Mode::Off)
        return;
    if (!asked && !IsPreloaded()) {
        ModeOfEnvironment(); // for what it says of a word that was meant to switch it on
        SayAtExitIfNotUsed();
        return;
    }
    startsAtFirstStep = true;
    SayAtExitIfNotUsed();
    if (StepsAreSeen())
        internal::startsByItself = true;
    else if (asked && !IsInProgram(boundStep))
        Refuse(WhyNoStepIsSeen());
}

} // namespace

std::atomic<bool> internal::startsByItself{false};

bool internal::MeetBox2D(const void *function) {
    const bool same = function == reinterpret_cast<const void *>(&b2CollidePolygons);
    if (!same)
        programHasItsOwn = true;
    return same;
}

void internal::StartNow() {
    StartOnce([] {
        if (AnyBox2DBehind())
            Install(); // says itself why not; false where the program has called it before
        else if (IsVerbose() && ClaimAnnouncement())
            std::fprintf(stderr, "boomerang: not used: %s\n", WhyModuleIsLeftAlone());
    });
}

} // namespace bmr
