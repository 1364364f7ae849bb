// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_OUTPUT_FILE_H
#define BOOMERANG_TESTBED_OUTPUT_FILE_H

#include <cerrno>
#include <fstream>
#include <string>

#include "commands.h"
#include "drawing/whole_file.h"

namespace testbed {

/// A file that is checked before the work begins, for hours of comparing should not end in "cannot write";
/// and that replaces an older one only when it is whole.
class OutputFile {
public:
    /// No file is wanted where the path is empty. Throws std::runtime_error if it cannot be written.
    explicit OutputFile(const std::string &path) : m_path(path), m_file(path) {
        if (path == "-")
            throw UsageError("the table takes standard output: give this option a file");
        if (IsWanted())
            WholeFile::Check(path);
    }
    bool IsWanted() const { return !m_path.empty(); }
    /// Opened when it is first asked for.
    std::ostream &Stream() {
        errno = 0;
        if (!m_stream.is_open())
            m_stream.open(m_file.WritePath());
        if (!m_stream)
            FailToWrite(m_path, errno);
        return m_stream;
    }
    void Close() {
        m_stream.flush();
        if (!m_stream) { // once more, for the reason of what failed may be forgotten
            m_stream.clear();
            errno = 0;
            m_stream.put('\n').flush();
            FailToWrite(m_path, errno);
        }
        m_stream.close();
        m_file.Finish();
    }

private:
    std::string m_path;
    WholeFile m_file;
    std::ofstream m_stream;
};

} // namespace testbed

#endif
