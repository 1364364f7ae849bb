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

struct Message {
    bool more; ///< a record; else the end
    Record record;
};

} // namespace

void Serve(int in, int out) {
    uint64_t size = 0;
    while (ReadAll(in, &size, sizeof size)) {
        std::vector<uint8_t> bytes(size);
        if (!ReadAll(in, bytes.data(), size))
            return;
        const pid_t child = fork();
        if (child == 0) {
            Actor player(bytes.data(), bytes.size());
            for (Message message = {true, {}}; player.PlayOn(&message.record);)
                WriteAll(out, &message, sizeof message);
            std::_Exit(0);
        }
        int status = 0;
        if (child < 0 || waitpid(child, &status, 0) != child)
            std::_Exit(3);
        const Message end = {false, {}};
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

std::vector<Record> Server::Ask(const uint8_t *data, size_t size) {
    const uint64_t bytes = size;
    WriteAll(m_to, &bytes, sizeof bytes);
    WriteAll(m_to, data, size);
    std::vector<Record> records;
    for (Message message = {}; ReadAll(m_from, &message, sizeof message);) {
        if (!message.more)
            return records;
        records.push_back(message.record);
    }
    std::fprintf(stderr, "the actor that serves has ended\n");
    std::exit(3);
}

} // namespace actor
