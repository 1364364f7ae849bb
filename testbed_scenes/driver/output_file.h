// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_OUTPUT_FILE_H
#define BOOMERANG_TESTBED_OUTPUT_FILE_H

#include <fstream>
#include <stdexcept>
#include <string>

#include "commands.h"

namespace testbed {

/// A file that is opened before the work begins: hours of comparing should not end in "cannot write".
class OutputFile {
public:
    explicit OutputFile(const std::string &path) : m_path(path) {
        if (path.empty())
            return;
        if (path == "-")
            throw UsageError("the table takes standard output: give this option a file");
        m_stream.open(path);
        if (!m_stream)
            throw UsageError("cannot write " + path);
    }
    bool IsWanted() const { return !m_path.empty(); }
    std::ostream &Stream() { return m_stream; }
    void Close() {
        m_stream.close();
        if (!m_stream)
            throw std::runtime_error("writing " + m_path + " failed");
    }

private:
    std::string m_path;
    std::ofstream m_stream;
};

} // namespace testbed

#endif
