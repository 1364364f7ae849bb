// SPDX-License-Identifier: MIT
#include "temporary_file.h"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include <unistd.h>

namespace testbed {

TemporaryFile::TemporaryFile() {
    std::string pattern = (std::filesystem::temp_directory_path() / "boomerang-XXXXXX").string();
    const int descriptor = mkstemp(pattern.data());
    if (descriptor < 0)
        throw std::runtime_error("cannot make a temporary file in " +
                                 std::filesystem::temp_directory_path().string());
    close(descriptor);
    m_path = pattern;
    m_unfinished.emplace(m_path);
}

TemporaryFile::~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(m_path, ignored);
}

} // namespace testbed
