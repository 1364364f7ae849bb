// SPDX-License-Identifier: MIT
#include "actor.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include <sys/wait.h>
#include <unistd.h>

namespace actor {

namespace {

/// False at the end of the pipe.
bool ReadAll(int from, void *into, size_t size) {
    for (char *at = static_cast<char *>(into); size > 0;) {
        const ssize_t got = read(from, at, size);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return false;
        at += got;
        size -= static_cast<size_t>(got);
    }
    return true;
}

void WriteAll(int to, const void *from, size_t size) {
    for (const char *at = static_cast<const char *>(from); size > 0;) {
        const ssize_t put = write(to, at, size);
        if (put < 0 && errno != EINTR)
            std::_Exit(3);
        at += put > 0 ? put : 0;
        size -= put > 0 ? static_cast<size_t>(put) : 0;
    }
}

using Question = uint64_t[2]; ///< size of the bytes that follow, dumpAt
struct Message {
    bool more; ///< a record; else the end
    Record record;
    uint64_t dumped; ///< bytes that follow
};

} // namespace

void Serve(int in, int out) {
    Question question = {};
    while (ReadAll(in, &question, sizeof question)) {
        std::vector<uint8_t> bytes(question[0]);
        if (!ReadAll(in, bytes.data(), bytes.size()))
            return;
        const pid_t child = fork();
        if (child == 0) {
            Actor player(bytes.data(), bytes.size());
            player.dumpAt = static_cast<int>(question[1]);
            for (Message message = {true, {}, 0}; player.PlayOn(&message.record); player.dump.clear()) {
                message.dumped = player.dump.size();
                WriteAll(out, &message, sizeof message);
                WriteAll(out, player.dump.data(), player.dump.size());
            }
            std::_Exit(0);
        }
        int status = 0;
        if (child < 0 || waitpid(child, &status, 0) != child)
            std::_Exit(3);
        const Message end = {false, {}, 0};
        WriteAll(out, &end, sizeof end);
    }
}

Server::Server(const std::function<void(int in, int out)> &process) {
    int to[2], from[2];
    if (pipe(to) != 0 || pipe(from) != 0)
        std::abort();
    if (fork() == 0) {
        close(to[1]);
        close(from[0]);
        process(to[0], from[1]);
        std::_Exit(0);
    }
    close(to[0]);
    close(from[1]);
    m_to = to[1];
    m_from = from[0];
}

std::vector<Record> Server::Ask(const uint8_t *data, size_t size, int dumpAt, std::string *dump) {
    const Question question = {size, static_cast<uint64_t>(dumpAt)};
    WriteAll(m_to, &question, sizeof question);
    WriteAll(m_to, data, size);
    std::vector<Record> records;
    for (Message message = {}; ReadAll(m_from, &message, sizeof message);) {
        if (!message.more)
            return records;
        records.push_back(message.record);
        std::string dumped(message.dumped, '\0');
        ReadAll(m_from, dumped.data(), dumped.size());
        if (dump != nullptr)
            *dump += dumped;
    }
    std::fprintf(stderr, "the actor that serves has ended\n");
    std::exit(3);
}

} // namespace actor
