// SPDX-License-Identifier: MIT
#include "workers.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace testbed {
namespace {

/// Enough for an assertion, a sanitizer's headline or a backtrace's top; the rest is noise in a table's
/// place.
constexpr size_t kErrorLinesKept = 12;
/// A tick a quarter of a second apart keeps a progress bar alive and costs nothing.
constexpr int kTickMilliseconds = 250;

struct Pipe {
    int ends[2] = {-1, -1};
    // Close-on-exec, so that a worker started meanwhile does not hold another's pipe open.
    Pipe() {
        if (pipe2(ends, O_CLOEXEC) != 0)
            throw WorkerError(std::string("cannot make a pipe: ") + std::strerror(errno));
    }
    ~Pipe() {
        for (int end : ends)
            if (end >= 0)
                close(end);
    }
    Pipe(const Pipe &) = delete;
    Pipe &operator=(const Pipe &) = delete;
    int TakeReadEnd() {
        const int end = ends[0];
        ends[0] = -1;
        return end;
    }
};

/// In the child: becomes the program.
[[noreturn]] void Become(std::vector<std::string> arguments, const std::vector<std::string> &environment,
                         int output, int errors) {
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    dup2(errors, STDERR_FILENO);
    for (const std::string &addition : environment)
        setenv(addition.substr(0, addition.find('=')).c_str(), &addition[addition.find('=') + 1], 1);
    std::vector<char *> pointers;
    for (std::string &argument : arguments)
        pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    execv(pointers[0], pointers.data());
    _exit(127);
}

/// Appends what can be read now to the buffer; false at the end of the stream.
bool ReadSome(int fd, std::string &buffer) {
    char block[65536];
    const ssize_t count = read(fd, block, sizeof block);
    if (count < 0)
        return errno == EINTR || errno == EAGAIN;
    buffer.append(block, static_cast<size_t>(count));
    return count > 0;
}

/// Hands the complete lines of the buffer on, and keeps the rest.
template <class Handler> void TakeLines(std::string &buffer, Handler &&handler) {
    size_t begin = 0;
    for (size_t end = buffer.find('\n'); end != std::string::npos; end = buffer.find('\n', begin)) {
        handler(buffer.substr(begin, end - begin));
        begin = end + 1;
    }
    buffer.erase(0, begin);
}

} // namespace

Process::Process(std::vector<std::string> arguments, const std::vector<std::string> &environment,
                 LineHandler onLine)
    : m_arguments(std::move(arguments)), m_onLine(std::move(onLine)) {
    if (access(m_arguments[0].c_str(), X_OK) != 0)
        throw WorkerError("cannot start " + m_arguments[0] + ": " + std::strerror(errno));
    Pipe output, errors;
    m_pid = fork();
    if (m_pid == 0)
        Become(m_arguments, environment, output.ends[1], errors.ends[1]);
    if (m_pid < 0)
        throw WorkerError("cannot start " + m_arguments[0] + ": " + std::strerror(errno));
    m_outputFd = output.TakeReadEnd();
    m_errorFd = errors.TakeReadEnd();
}

Process::~Process() {
    if (!m_reaped) {
        kill(m_pid, SIGKILL);
        Wait();
    }
    for (int fd : {m_outputFd, m_errorFd})
        if (fd >= 0)
            close(fd);
}

void Process::Wait() {
    while (waitpid(m_pid, &m_status, 0) < 0 && errno == EINTR) {
    }
    m_reaped = true;
}

bool Process::ReadOutput() {
    const bool more = ReadSome(m_outputFd, m_outputRest);
    if (!more && !m_outputRest.empty())
        m_outputRest += '\n'; // a last line without a newline is a line all the same
    TakeLines(m_outputRest, [this](const std::string &line) {
        try {
            m_onLine(line);
        } catch (const WorkerError &error) {
            throw WorkerError(CommandLine() + ": " + error.what()); // which of the workers it was
        }
    });
    return more;
}

bool Process::ReadErrors() {
    const bool more = ReadSome(m_errorFd, m_errorRest);
    if (!more && !m_errorRest.empty())
        m_errorRest += '\n';
    TakeLines(m_errorRest, [this](const std::string &line) {
        // As in CommandLine: a program that names itself need not say where it lies.
        const size_t directory = m_arguments[0].rfind('/') + 1;
        const bool isNamed = line.compare(0, m_arguments[0].size(), m_arguments[0]) == 0;
        m_errorTail.push_back(isNamed ? line.substr(directory) : line);
        if (m_errorTail.size() > kErrorLinesKept)
            m_errorTail.pop_front();
    });
    return more;
}

bool Process::Succeeded() const {
    return m_reaped && WIFEXITED(m_status) && WEXITSTATUS(m_status) == 0;
}

std::string Process::CommandLine() const {
    // The directory of the program says little and fills the line.
    std::string line = m_arguments[0].substr(m_arguments[0].rfind('/') + 1);
    for (size_t i = 1; i < m_arguments.size(); ++i)
        line += " " + m_arguments[i];
    return line;
}

std::string Process::Describe() const {
    std::string text = CommandLine() + ": ";
    if (!m_reaped) {
        text += "still running";
    } else if (WIFSIGNALED(m_status)) {
        const int number = WTERMSIG(m_status);
        text += "killed by signal " + std::to_string(number) + " (" + strsignal(number) + ")";
    } else {
        text += "exit status " + std::to_string(WEXITSTATUS(m_status));
    }
    for (const std::string &line : m_errorTail)
        text += "\n    | " + line;
    return text;
}

void RunAll(const std::vector<Process *> &processes, const std::function<void()> &onTick,
            std::optional<std::chrono::seconds> limit) {
    const auto begin = std::chrono::steady_clock::now();
    for (;;) {
        if (limit && std::chrono::steady_clock::now() - begin > *limit)
            throw WorkerError(processes.front()->CommandLine() + ": no answer within " +
                              std::to_string(limit->count()) + " seconds");
        std::vector<pollfd> polls;
        std::vector<Process *> owners;
        for (Process *process : processes) {
            for (int fd : {process->m_outputFd, process->m_errorFd}) {
                if (fd >= 0) {
                    polls.push_back({fd, POLLIN, 0});
                    owners.push_back(process);
                }
            }
        }
        if (polls.empty())
            break;
        if (poll(polls.data(), polls.size(), kTickMilliseconds) < 0 && errno != EINTR)
            throw WorkerError(std::string("cannot wait for a worker: ") + std::strerror(errno));
        for (size_t i = 0; i < polls.size(); ++i) {
            if (polls[i].revents == 0)
                continue;
            Process &owner = *owners[i];
            const bool isOutput = polls[i].fd == owner.m_outputFd;
            if (!(isOutput ? owner.ReadOutput() : owner.ReadErrors())) {
                close(polls[i].fd);
                (isOutput ? owner.m_outputFd : owner.m_errorFd) = -1;
            }
        }
        if (onTick)
            onTick();
    }
    for (Process *process : processes)
        if (!process->m_reaped)
            process->Wait();
}

} // namespace testbed
