// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_TEMPORARY_FILE_H
#define BOOMERANG_TESTBED_TEMPORARY_FILE_H

#include <string>

namespace testbed {

/// A file that goes away with its object.
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
};

} // namespace testbed

#endif
