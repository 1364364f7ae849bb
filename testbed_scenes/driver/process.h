// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PROCESS_H
#define BOOMERANG_TESTBED_PROCESS_H

#include <chrono>
#include <deque>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/types.h>

namespace testbed {

/// A worker that did not do its job: not started, crashed, left with an error, or printed nonsense.
class WorkerError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A child process whose two output streams are read line by line while it runs.
class Process {
public:
    using LineHandler = std::function<void(const std::string &line)>;

    /// Starts arguments[0] (a path: PATH is not searched) with this process's environment and the given
    /// additions ("NAME=value", replacing what is there). Throws WorkerError if it cannot be started.
    Process(std::vector<std::string> arguments, const std::vector<std::string> &environment,
            LineHandler onLine);
    /// Kills a process that still runs, and waits for it.
    ~Process();
    Process(const Process &) = delete;
    Process &operator=(const Process &) = delete;

    /// Only after RunAll: the exit status was 0.
    bool Succeeded() const;
    /// "boomerang-scene needles --mode hash: killed by signal 11 (Segmentation fault)", with the last lines
    /// it wrote to stderr.
    std::string Describe() const;
    /// The command line, for messages.
    std::string CommandLine() const;

private:
    friend void RunAll(const std::vector<Process *> &processes, const std::function<void()> &onTick,
                       std::optional<std::chrono::seconds> limit);
    bool ReadOutput();
    bool ReadErrors();
    void Wait();

    std::vector<std::string> m_arguments;
    LineHandler m_onLine;
    pid_t m_pid = -1;
    int m_outputFd = -1;
    int m_errorFd = -1;
    std::string m_outputRest;
    std::string m_errorRest;
    std::deque<std::string> m_errorTail;
    int m_status = 0;
    bool m_reaped = false;
};

/// Reads from all processes at once until each has closed its streams, then waits for them. onTick, if any,
/// is called a few times a second. What a line handler throws ends the reading and is passed on; the
/// processes' destructors then end what still runs. With a time limit, whoever is not done by then is a
/// failure.
void RunAll(const std::vector<Process *> &processes, const std::function<void()> &onTick = nullptr,
            std::optional<std::chrono::seconds> limit = std::nullopt);

} // namespace testbed

#endif
