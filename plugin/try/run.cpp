// SPDX-License-Identifier: MIT
#include "try/run.h"

#include <algorithm>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>

#include <dirent.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

namespace bmr::trial {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kTick = std::chrono::milliseconds(20);
constexpr size_t kLastLines = 8;

volatile std::sig_atomic_t interrupted = 0;

double SecondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::string Why() {
    return std::strerror(errno);
}

/// A file without a name in any folder, which children find under /proc; it goes with its last user.
class UnnamedFile {
public:
    explicit UnnamedFile(const char *what) : m_file(memfd_create(what, 0)) {
        if (m_file < 0)
            throw CannotRun(std::string("no room for ") + what + ": " + Why());
    }
    ~UnnamedFile() { close(m_file); }
    UnnamedFile(const UnnamedFile &) = delete;
    UnnamedFile &operator=(const UnnamedFile &) = delete;
    int Number() const { return m_file; }
    /// For other processes, as long as this one lives.
    std::string Path() const { return "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(m_file); }

private:
    int m_file;
};

/// The page that the game's library writes to.
class Page {
public:
    Page() : m_file("boomerang-trial") {
        void *room = MAP_FAILED;
        if (ftruncate(m_file.Number(), sizeof(TrialPage)) == 0)
            room = mmap(nullptr, sizeof(TrialPage), PROT_READ | PROT_WRITE, MAP_SHARED, m_file.Number(), 0);
        if (room == MAP_FAILED)
            throw CannotRun("no room for what the library tells: " + Why());
        m_page = static_cast<TrialPage *>(room);
        m_page->magic = TrialPage::kMagic;
        m_page->size = sizeof(TrialPage);
    }
    ~Page() { munmap(m_page, sizeof(TrialPage)); }
    Page(const Page &) = delete;
    Page &operator=(const Page &) = delete;
    TrialPage *operator->() const { return m_page; }
    std::string Path() const { return m_file.Path(); }

private:
    UnnamedFile m_file;
    TrialPage *m_page;
};

bool BeginsWith(const std::string &text, const char *with) {
    return text.rfind(with, 0) == 0;
}

std::vector<std::string> EnvironmentWith(const std::vector<std::string> &variables) {
    std::vector<std::string> made = variables;
    for (char **variable = environ; *variable != nullptr; ++variable) {
        const std::string text = *variable;
        const std::string name = text.substr(0, text.find('=') + 1);
        const bool replaced = std::any_of(variables.begin(), variables.end(), [&](const std::string &with) {
            return BeginsWith(with, name.c_str());
        });
        if (!replaced && !BeginsWith(text, "BOOMERANG"))
            made.push_back(text);
    }
    return made;
}

std::vector<char *> Pointers(const std::vector<std::string> &words) {
    std::vector<char *> pointers;
    pointers.reserve(words.size() + 1);
    for (const std::string &word : words)
        pointers.push_back(const_cast<char *>(word.c_str()));
    pointers.push_back(nullptr);
    return pointers;
}

pid_t Start(const std::vector<std::string> &command, const std::vector<std::string> &variables, int output) {
    const std::vector<std::string> environment = EnvironmentWith(variables);
    const std::vector<char *> arguments = Pointers(command), names = Pointers(environment);
    const pid_t child = fork();
    if (child < 0)
        throw CannotRun("no process for " + command[0] + ": " + Why());
    if (child > 0)
        return child;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    if (output >= 0) {
        dup2(output, STDOUT_FILENO);
        dup2(output, STDERR_FILENO);
    }
    execvpe(arguments[0], arguments.data(), names.data());
    _exit(127);
}

/// A process that has lost its parent becomes this process's child (PR_SET_CHILD_SUBREAPER). So all that a
/// game has left behind are children, and theirs.
std::vector<pid_t> ChildrenOf(pid_t parent) {
    std::vector<pid_t> children;
    const std::string tasks = "/proc/" + std::to_string(parent) + "/task";
    DIR *folder = opendir(tasks.c_str());
    while (const dirent *entry = folder == nullptr ? nullptr : readdir(folder)) {
        std::ifstream list(tasks + "/" + entry->d_name + "/children");
        for (pid_t child; list >> child;)
            children.push_back(child);
    }
    if (folder != nullptr)
        closedir(folder);
    return children;
}

std::vector<pid_t> Descendants() {
    std::vector<pid_t> found = ChildrenOf(getpid());
    for (size_t i = 0; i < found.size(); ++i)
        for (const pid_t child : ChildrenOf(found[i]))
            found.push_back(child);
    return found;
}

/// Takes note of all children that have ended; true if `child` is among them, with its status.
bool Reap(pid_t child, int *status) {
    bool found = false;
    int how = 0;
    for (pid_t ended; (ended = waitpid(-1, &how, WNOHANG)) > 0;) {
        if (ended == child)
            *status = how;
        found = found || ended == child;
    }
    return found;
}

/// The file of this program, which a child is until it has become the game.
std::string OwnFile() {
    char path[PATH_MAX];
    const ssize_t length = readlink("/proc/self/exe", path, sizeof path);
    return std::string(path, length > 0 ? static_cast<size_t>(length) : 0);
}

void NoteFiles(std::set<std::string> *files) {
    static const std::string own = OwnFile();
    for (const pid_t process : Descendants()) {
        std::ifstream maps("/proc/" + std::to_string(process) + "/maps");
        for (std::string line; std::getline(maps, line);) {
            const size_t path = line.find('/');
            const size_t rights = line.find(' ');
            if (path != std::string::npos && line.compare(rights, 5, " r-xp") == 0 &&
                line.compare(path, std::string::npos, own) != 0)
                files->insert(line.substr(path));
        }
    }
}

/// Ends all that the game has started: asked first, then not. `gone`: the first of them has ended already.
void EndAll(pid_t child, bool gone, double patience) {
    const Clock::time_point begin = Clock::now();
    for (int signal = SIGTERM;;) {
        std::vector<pid_t> left = Descendants();
        if (!gone && left.empty())
            left.push_back(child); // of a system that lists no children
        if (left.empty())
            return;
        for (const pid_t process : left)
            kill(process, signal);
        int status = 0;
        gone = Reap(child, &status) || gone;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        if (SecondsSince(begin) > patience)
            signal = SIGKILL;
    }
}

std::vector<std::string> LastLines(int file) {
    std::vector<std::string> lines;
    lseek(file, 0, SEEK_SET);
    constexpr off_t kRead = 8192;
    const off_t size = lseek(file, 0, SEEK_END);
    std::string text(static_cast<size_t>(std::min(size, kRead)), '\0');
    const ssize_t length = pread(file, text.data(), text.size(), size - static_cast<off_t>(text.size()));
    text.resize(static_cast<size_t>(std::max<ssize_t>(length, 0)));
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        if (!line.empty())
            lines.push_back(line);
    if (lines.size() > kLastLines)
        lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(kLastLines));
    return lines;
}

void ReadPage(const Page &page, Run *run) {
    run->loaded = page->loadedIn != 0;
    run->steps = page->steps;
    const uint32_t kept = std::min(run->steps, TrialPage::kMostSteps);
    run->microseconds.assign(page->microseconds, page->microseconds + kept);
    run->verified = page->counted.verified;
    run->differences = page->counted.differences;
    run->way = page->way;
    run->noPass = page->noPass;
    run->whyNot = page->whyNot;
    run->noStep = page->noStep;
    std::istringstream files(page->files);
    for (std::string file; std::getline(files, file);)
        run->files.insert(file);
}

/// Waits until the library has written what is at work, as long as steps are seen.
void AskForMore(const Page &page, double patience) {
    const uint32_t wanted = ++page->wanted;
    const Clock::time_point begin = Clock::now();
    while (page->told != wanted && page->steps > 0 && SecondsSince(begin) < patience)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

} // namespace

void WatchForInterrupts() {
    struct sigaction action = {};
    action.sa_handler = [](int) { interrupted = 1; };
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool IsInterrupted() {
    return interrupted != 0;
}

Run RunGame(const std::vector<std::string> &command, const std::vector<std::string> &variables, bool page,
            bool shown, const Limits &limits, const std::function<void(double, uint32_t)> &onTick) {
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    Run run;
    const UnnamedFile output("boomerang-output");
    std::unique_ptr<Page> told;
    std::vector<std::string> environment = variables;
    if (page) {
        told = std::make_unique<Page>();
        environment.push_back(kTrialVariable + ("=" + told->Path()));
    }
    const Clock::time_point begin = Clock::now();
    const pid_t child = Start(command, environment, shown ? -1 : output.Number());
    double look = 0.0; // at first often, for games that end at once
    // (What was started may be a launcher that goes when the game has come.)
    bool launched = false;
    while (!run.ended) {
        std::this_thread::sleep_for(
            std::min(kTick, std::chrono::milliseconds(2 + static_cast<int>(200 * run.seconds))));
        launched = Reap(child, &run.status) || launched;
        run.ended = launched && Descendants().empty();
        run.seconds = SecondsSince(begin);
        const uint32_t steps = told != nullptr ? (*told)->steps.load() : 0;
        if (run.seconds >= look) {
            NoteFiles(&run.files);
            look = std::min(2.0 * run.seconds, run.seconds + 0.25);
        }
        if (IsInterrupted() || run.seconds > limits.seconds || (limits.steps > 0 && steps >= limits.steps))
            break;
        onTick(run.seconds, steps);
    }
    if (!run.ended) {
        NoteFiles(&run.files);
        if (told != nullptr)
            AskForMore(*told, IsInterrupted() ? 0.0 : limits.patience);
    }
    EndAll(child, launched, IsInterrupted() ? 0.5 : limits.patience);
    if (told != nullptr)
        ReadPage(*told, &run);
    run.lastWords = LastLines(output.Number());
    return run;
}

} // namespace bmr::trial
