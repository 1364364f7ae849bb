// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_UNFINISHED_H
#define BOOMERANG_TESTBED_UNFINISHED_H

#include <string>

namespace testbed {

/// A file that a signal takes away while this object lives: an interrupt leaves nothing behind that is not
/// whole.
class Unfinished {
public:
    /// Touches nothing. A path too long for the system, or one of too many at a time, is not taken away.
    explicit Unfinished(const std::string &path);
    ~Unfinished();
    Unfinished(const Unfinished &) = delete;
    Unfinished &operator=(const Unfinished &) = delete;

    /// From now on a signal that ends this program (an interrupt, a hang-up, a broken pipe, a request to end)
    /// takes them away first. A signal that is ignored stays so.
    static void RemoveOnSignals();

private:
    int m_slot = -1;
};

} // namespace testbed

#endif
