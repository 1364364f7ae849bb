// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_TEMPORARY_FILE_H
#define BOOMERANG_TESTBED_TEMPORARY_FILE_H

#include <optional>
#include <string>

#include "drawing/unfinished.h"

namespace testbed {

/// A file that goes away with its object, or with an interrupt.
class TemporaryFile {
public:
    /// Makes it, empty. Throws std::runtime_error.
    TemporaryFile();
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile &) = delete;
    TemporaryFile &operator=(const TemporaryFile &) = delete;
    const std::string &Path() const { return m_path; }

private:
    std::string m_path;
    std::optional<Unfinished> m_unfinished;
};

} // namespace testbed

#endif
