// SPDX-License-Identifier: MIT
#ifndef AS_STOCK_ACTOR_SERVING_H
#define AS_STOCK_ACTOR_SERVING_H

#include <functional>
#include <vector>

#include "actor.h"

namespace actor {

/// Plays what comes from `in`, each input in a process of its own, and writes to `out` the records up to
/// where it ends, be it by an assertion of Box2D's. Returns when `in` is closed.
void Serve(int in, int out);

/// A process that serves.
class Server {
public:
    /// `process` is what the new process does; it does not return.
    explicit Server(const std::function<void(int in, int out)> &process);
    Server(const Server &) = delete;
    Server &operator=(const Server &) = delete;
    std::vector<Record> Ask(const uint8_t *data, size_t size);

private:
    int m_to = -1, m_from = -1;
};

} // namespace actor

#endif
