// SPDX-License-Identifier: MIT
#include "drawing/whole_file.h"

#include <cerrno>
#include <cstring>
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

void FailToWrite(const std::string &path, int error) {
    throw std::runtime_error("cannot write " + path +
                             (error != 0 ? std::string(": ") + std::strerror(error) : ""));
}

void WholeFile::Check(const std::string &path) {
    std::error_code error;
    const fs::path directory = DirectoryOf(path);
    if (!fs::exists(directory, error))
        throw std::runtime_error("cannot write " + path + ": there is no directory " + directory.string());
    if (!fs::is_directory(directory, error))
        FailToWrite(path, ENOTDIR);
    if (fs::is_directory(path, error))
        FailToWrite(path, EISDIR);
    errno = 0;
    if (!IsWritable(fs::exists(path, error) ? fs::path(path) : directory))
        FailToWrite(path, errno);
}

void WholeFile::Finish() {
    if (m_writePath == m_target)
        return;
    std::error_code error;
    if (fs::exists(m_target, error))
        fs::permissions(m_writePath, fs::status(m_target, error).permissions(), error);
    fs::rename(m_writePath, m_target, error);
    if (error)
        FailToWrite(m_target.string(), error.value());
    m_writePath = m_target;
}

} // namespace testbed
