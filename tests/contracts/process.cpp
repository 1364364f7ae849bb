// SPDX-License-Identifier: MIT
#include "process.h"

#include <cstdlib>

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace contracts {

namespace {

constexpr unsigned kMostSeconds = 1500; // what hangs ends; a busy machine takes its time

[[noreturn]] void Become(const std::vector<std::string> &command,
                         const std::vector<std::string> &environment) {
    const rlimit none = {0, 0};
    setrlimit(RLIMIT_CORE, &none);
    alarm(kMostSeconds); // execv keeps it
    for (const std::string &setting : environment) {
        const size_t equals = setting.find('=');
        setenv(setting.substr(0, equals).c_str(), setting.substr(equals + 1).c_str(), 1);
    }
    std::vector<char *> words;
    for (const std::string &word : command)
        words.push_back(const_cast<char *>(word.c_str()));
    words.push_back(nullptr);
    execv(words[0], words.data());
    _exit(127);
}

/// Reads both pipes to their ends: a program must not wait for us.
void ReadBoth(const int (&ends)[2], std::string *const (&texts)[2]) {
    pollfd pipes[2] = {{ends[0], POLLIN, 0}, {ends[1], POLLIN, 0}};
    while (pipes[0].fd >= 0 || pipes[1].fd >= 0) {
        if (poll(pipes, 2, -1) < 0)
            return;
        for (int i = 0; i < 2; ++i) {
            if (pipes[i].fd < 0 || pipes[i].revents == 0)
                continue;
            char buffer[4096];
            const ssize_t got = read(pipes[i].fd, buffer, sizeof buffer);
            if (got > 0)
                texts[i]->append(buffer, static_cast<size_t>(got));
            else
                pipes[i].fd = -1; // which poll leaves out
        }
    }
}

} // namespace

Ended RunProgram(const std::vector<std::string> &command, const std::vector<std::string> &environment) {
    Ended ended;
    int output[2], errors[2];
    if (pipe(output) != 0 || pipe(errors) != 0) {
        ended.status = 126;
        return ended;
    }
    const pid_t child = fork();
    if (child == 0) {
        dup2(output[1], STDOUT_FILENO);
        dup2(errors[1], STDERR_FILENO);
        for (const int end : {output[0], output[1], errors[0], errors[1]})
            close(end);
        Become(command, environment);
    }
    close(output[1]);
    close(errors[1]);
    ReadBoth({output[0], errors[0]}, {&ended.output, &ended.errors});
    close(output[0]);
    close(errors[0]);
    int status = 0;
    waitpid(child, &status, 0);
    ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    ended.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return ended;
}

} // namespace contracts
