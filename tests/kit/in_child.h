// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_IN_CHILD_H
#define BOOMERANG_TEST_IN_CHILD_H

#include <cstdarg>

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "boomerang/box2d_glue.h"
#include "cases.h"
#include "debug/statistics.h"

#if defined(__has_feature)
#    if __has_feature(address_sanitizer)
#        define IN_CHILD_ASAN
#    endif
#endif
#if defined(__SANITIZE_ADDRESS__)
#    define IN_CHILD_ASAN
#endif
#if defined(IN_CHILD_ASAN)
// Of the sanitizer's own headers, which not every compiler brings.
extern "C" size_t __sanitizer_get_current_allocated_bytes(void);
extern "C" int __lsan_do_recoverable_leak_check(void);
#endif

// Of the compiler's runtime, where the lines that run are counted; nowhere else.
extern "C" int __llvm_profile_write_file(void) __attribute__((weak));

/// Ends a forked child as _exit does, without its parent's exit handlers; but what it ran is written down.
[[noreturn]] inline void test_leave(int status) {
    if (__llvm_profile_write_file != nullptr)
        __llvm_profile_write_file();
    _exit(status);
}

/// @file
/// Plays something in a child process, and says what it printed. (The contact register is process-wide: a
/// process with the library in it is no reference.)

namespace as_stock {

/// As long as one lives, what is installed holds every pair by this structure (nullptr: as games have it).
class PairsBy {
public:
    explicit PairsBy(const char *structure) {
        if (structure != nullptr)
            setenv("BOOMERANG_PAIRS_BY", structure, 1);
    }
    explicit PairsBy(bmr_structure structure) : PairsBy(bmr_structure_name(structure)) {}
    ~PairsBy() { unsetenv("BOOMERANG_PAIRS_BY"); }
    PairsBy(const PairsBy &) = delete;
    PairsBy &operator=(const PairsBy &) = delete;
};

/// What is played sees of the run that it is in.
class Run {
public:
    Run(int pipe, const bmr::Options *options) : m_pipe(pipe), m_options(options) {
        m_text.reserve(kBuffer + 1024); // so that printing allocates nothing later
    }
    ~Run() { Flush(); }

    bool HasPlugin() const { return m_options != nullptr; }
    /// Does it count? Then claims about counts may be made. (Where all is verified Box2D is asked, too.)
    bool Counts() const { return HasPlugin() && m_options->statistics && !Verifies(); }
    bool Verifies() const { return HasPlugin() && m_options->mode == bmr::Mode::Verify; }
    /// Do contacts remember edges? Else the hulls of bodies have structures.
    bool RemembersEdges() const { return HasPlugin() && std::getenv("BOOMERANG_PAIRS_BY") == nullptr; }
    /// Does nothing in a stock run.
    void Install() {
        if (HasPlugin())
            Expect(bmr::Install(*m_options), "the first Install succeeds");
    }

    /// A line that must be the same in all runs. One that begins with ! fails the test.
    void Print(const char *format, ...) __attribute__((format(printf, 2, 3))) {
        char line[512];
        va_list arguments;
        va_start(arguments, format);
        std::vsnprintf(line, sizeof line, format, arguments);
        va_end(arguments);
        Write(line);
        Write("\n");
    }
    void Write(const std::string &text) {
        m_text += text;
        if (m_text.size() > kBuffer)
            Flush();
    }
    /// The line of a game's ahead of which each number is written that went into its hash.
    static std::string &InWords() {
        static std::string line;
        return line;
    }
    /// A claim about the library's own doing: a failure of this run if it is false. Stock has none.
    void Expect(bool holds, const char *claim) {
        m_stages = true;
        if (HasPlugin() && !holds)
            Print("!claim broken: %s", claim);
    }
    /// A claim about its counts.
    void ExpectCounted(bool holds, const char *claim) {
        if (Counts())
            Expect(holds, claim);
    }
    /// Takes place in stock too, or the game is staged wrongly. (Stock plays first, and fails the test
    /// alone.)
    void Stage(bool holds, const char *what) {
        m_stages = true;
        if (!holds)
            Print(HasPlugin() ? "!takes place in stock alone: %s" : "!not staged: %s", what);
    }
    /// The game breaks Box2D's rules: until another world begins it is as safe as with stock, and no more. It
    /// need not say what takes place.
    void BreaksRules() {
        if (!m_isBreaking)
            Print("Box2D's rules are broken");
        m_isBreaking = m_breaksRules = true;
    }
    /// It changes the direction of rounding inside a step. Bits stay stock's where the compiler leaves the
    /// arithmetic in its place, which clang does not for its sanitizers.
    void ChangesRounding() {
#if defined(IN_CHILD_ASAN)
        BreaksRules();
#endif
    }
    void BeginsWorld() {
        if (m_isBreaking)
            Print("another world");
        m_isBreaking = false;
    }
    bool HasBrokenRules() const {
        return m_breaksRules;
    }
    static constexpr const char *kBrokenRules = "Box2D's rules are broken\n",
                                *kAnotherWorld = "another world\n";
    bool SaysWhatTookPlace() const {
        return m_stages || m_breaksRules;
    }

private:
    static constexpr size_t kBuffer = 60000;

    void Flush() {
        for (size_t done = 0; done < m_text.size();) {
            const ssize_t written = write(m_pipe, m_text.data() + done, m_text.size() - done);
            if (written <= 0)
                _exit(3);
            done += static_cast<size_t>(written);
        }
        m_text.clear();
    }

    int m_pipe;
    const bmr::Options *m_options;
    std::string m_text;
    bool m_stages = false, m_breaksRules = false, m_isBreaking = false;
};

/// Bytes that malloc has given out, some hundreds more or less: what it keeps at hand for the thread counts,
/// and the rest of a block that is too small to be another one.
inline size_t BytesInUse() {
#if defined(IN_CHILD_ASAN)
    return __sanitizer_get_current_allocated_bytes();
#else
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
#endif
}

/// Does `live`, which plays this many rounds, take less than one of malloc's smallest blocks for each round?
/// What malloc keeps at hand for the thread grows to some ten thousand bytes before it stays. So `live` is
/// played up to six times: what leaks takes something each time.
template <class Live> bool LeavesNothing(int rounds, const Live &live) {
    for (int repeat = 0; repeat < 6; ++repeat) {
        const size_t before = BytesInUse();
        live();
        if (BytesInUse() < before + 32 * static_cast<size_t>(rounds))
            return true;
    }
    return false;
}

using Scenario = std::function<void(Run &)>;
enum class Installed { Before, ByPlay };

/// What a child printed, and how it ended appended where that was badly. Without options it is on stock
/// Box2D.
inline std::string InChild(const Scenario &play, const bmr::Options *options = nullptr,
                           Installed installed = Installed::Before) {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    std::fflush(nullptr);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        close(ends[0]);
        mallopt(M_PERTURB, 0x5a); // memory that nobody initialised is no zeros
        // It takes seconds of the processor. What goes round for ever ends here.
        const rlimit most = {60, 60};
        setrlimit(RLIMIT_CPU, &most);
        {
            Run run(ends[1], options);
            if (installed == Installed::Before)
                run.Install();
            play(run);
        }
#if defined(IN_CHILD_ASAN)
        if (__lsan_do_recoverable_leak_check() != 0)
            test_leave(4);
#endif
        test_leave(0);
    }
    close(ends[1]);
    std::string text;
    char buffer[65536];
    for (ssize_t got; (got = read(ends[0], buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<size_t>(got));
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFSIGNALED(status))
        text += "!child was ended by signal " + std::to_string(WTERMSIG(status)) + "\n";
    else if (status != 0)
        text += "!child ended with status " + std::to_string(WEXITSTATUS(status)) + "\n";
    return text;
}

/// Without what a game printed from where it broke Box2D's rules until another world began.
inline std::string WithinRules(std::string text) {
    const std::string broken = Run::kBrokenRules, another = Run::kAnotherWorld;
    for (size_t at = 0; (at = text.find(broken, at)) != std::string::npos;) {
        at += broken.size();
        text.erase(at, std::min(text.find(another, at), text.size()) - at);
    }
    return text;
}

/// The first lines that are not the same, "" if there are none, and their number.
struct FirstDifference {
    FirstDifference(const std::string &stock, const std::string &plugin) {
        size_t a = 0, b = 0;
        while (a < stock.size() || b < plugin.size()) {
            const size_t endA = std::min(stock.find('\n', a), stock.size()),
                         endB = std::min(plugin.find('\n', b), plugin.size());
            ++number;
            ofStock = stock.substr(std::min(a, endA), endA - std::min(a, endA));
            ofPlugin = plugin.substr(std::min(b, endB), endB - std::min(b, endB));
            if (ofStock != ofPlugin)
                return;
            a = endA + 1;
            b = endB + 1;
        }
        ofStock = ofPlugin = "";
    }
    bool Is() const { return ofStock != ofPlugin; }
    std::string Say(const char *unit) const {
        return unit + (" " + std::to_string(number)) + "\nstock:  " + ofStock + "\nplugin: " + ofPlugin +
               "\n";
    }
    int number = 0;
    std::string ofStock, ofPlugin;
};

/// "" if the texts are the same within Box2D's rules, else the first difference and what was broken.
inline std::string Difference(const std::string &stock, const std::string &plugin) {
    std::string report;
    for (const std::string *text : {&stock, &plugin})
        for (size_t at = text->find('!'); at != std::string::npos; at = text->find('!', at + 1))
            report += text->substr(at, text->find('\n', at) - at) + "\n";
    const FirstDifference first(WithinRules(stock), WithinRules(plugin));
    return first.Is() ? report + first.Say("line of the game") : report;
}

} // namespace as_stock

#endif
