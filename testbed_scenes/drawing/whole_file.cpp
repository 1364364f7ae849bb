// SPDX-License-Identifier: MIT
#include "drawing/whole_file.h"

#include <stdexcept>

#include <unistd.h>

namespace testbed {
namespace {

namespace fs = std::filesystem;

fs::path DirectoryOf(const fs::path &path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

bool IsWritable(const fs::path &path) {
    return access(path.c_str(), W_OK) == 0;
}

} // namespace

WholeFile::WholeFile(const std::string &path) : m_target(path), m_writePath(path) {
    std::error_code error;
    const bool isLink = fs::is_symlink(path, error), exists = fs::exists(path, error);
    if (path.empty() || (exists ? !fs::is_regular_file(path, error) : isLink))
        return;
    // A link stays one: what it leads to is replaced.
    if (isLink)
        m_target = fs::canonical(path, error);
    if (error || (exists && !IsWritable(m_target)) || !IsWritable(DirectoryOf(m_target)))
        return;
    m_writePath = m_target;
    m_writePath += "." + std::to_string(getpid()) + ".part";
}

WholeFile::~WholeFile() {
    std::error_code ignored;
    if (m_writePath != m_target)
        fs::remove(m_writePath, ignored);
}

void WholeFile::Check(const std::string &path) {
    std::error_code error;
    const fs::path directory = DirectoryOf(path);
    const bool exists = fs::exists(path, error);
    if (!fs::is_directory(directory, error) || fs::is_directory(path, error) ||
        !IsWritable(exists ? fs::path(path) : directory))
        throw std::runtime_error("cannot write " + path);
}

void WholeFile::Finish() {
    if (m_writePath == m_target)
        return;
    std::error_code error;
    if (fs::exists(m_target, error))
        fs::permissions(m_writePath, fs::status(m_target, error).permissions(), error);
    fs::rename(m_writePath, m_target, error);
    if (error)
        throw std::runtime_error("cannot write " + m_target.string() + ": " + error.message());
    m_writePath = m_target;
}

} // namespace testbed
