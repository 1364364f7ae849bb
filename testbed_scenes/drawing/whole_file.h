// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_WHOLE_FILE_H
#define BOOMERANG_TESTBED_WHOLE_FILE_H

#include <filesystem>
#include <string>

namespace testbed {

/// A file that is there whole or as it was before: it is written beside its place, under another name, and
/// takes its place when it is finished. What is no regular file (a device, a pipe) is written directly, and
/// so is a file whose directory takes no other. (An interrupt leaves a file .part behind.)
class WholeFile {
public:
    /// Touches nothing yet.
    explicit WholeFile(const std::string &path);
    /// Takes away what was not finished.
    ~WholeFile();
    WholeFile(const WholeFile &) = delete;
    WholeFile &operator=(const WholeFile &) = delete;

    /// Throws std::runtime_error, which says why, if the file cannot be written, as far as that can be known
    /// before.
    static void Check(const std::string &path);

    /// Where to write meanwhile.
    const std::filesystem::path &WritePath() const { return m_writePath; }
    /// Puts what was written there in its place. Throws std::runtime_error.
    void Finish();

private:
    std::filesystem::path m_target, m_writePath;
};

/// "cannot write PATH: Permission denied": what errno says, or the number given.
[[noreturn]] void FailToWrite(const std::string &path, int error);

} // namespace testbed

#endif
