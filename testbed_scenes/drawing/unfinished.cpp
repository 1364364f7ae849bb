// SPDX-License-Identifier: MIT
#include "drawing/unfinished.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstring>

#include <limits.h>
#include <unistd.h>

namespace testbed {
namespace {

/// Names in memory that a handler may read at any time.
struct Slot {
    std::atomic<bool> taken{false}, named{false};
    char path[PATH_MAX] = "";
};
std::array<Slot, 16> slots;

/// Calls nothing that a handler may not. On entry the signal got its usual action back: the second one ends
/// us.
void OnSignal(int signal) {
    for (const Slot &slot : slots)
        if (slot.named)
            unlink(slot.path);
    raise(signal);
}

} // namespace

Unfinished::Unfinished(const std::string &path) {
    for (std::size_t i = 0; i < slots.size() && path.size() < sizeof slots[i].path; ++i) {
        if (slots[i].taken.exchange(true))
            continue;
        std::memcpy(slots[i].path, path.c_str(), path.size() + 1);
        slots[i].named = true;
        m_slot = static_cast<int>(i);
        return;
    }
}

Unfinished::~Unfinished() {
    if (m_slot < 0)
        return;
    Slot &slot = slots[static_cast<std::size_t>(m_slot)];
    slot.named = false;
    slot.taken = false;
}

void Unfinished::RemoveOnSignals() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
        struct sigaction action = {};
        if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL)
            continue;
        action.sa_handler = OnSignal;
        action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
        sigaction(signal, &action, nullptr);
    }
}

} // namespace testbed
