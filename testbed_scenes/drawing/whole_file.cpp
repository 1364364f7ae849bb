// SPDX-License-Identifier: MIT
#include "drawing/whole_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace testbed {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void FailToWrite(const std::string &path, const std::string &reason) {
    throw std::runtime_error("cannot write " + path + ": " + reason);
}

} // namespace

void CheckWritable(const std::string &path) {
    std::error_code error;
    const fs::path directory = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : ".";
    if (!fs::exists(directory, error))
        FailToWrite(path, "there is no directory " + directory.string());
    if (!fs::is_directory(directory, error))
        FailToWrite(path, std::strerror(ENOTDIR));
    if (fs::is_directory(path, error))
        FailToWrite(path, std::strerror(EISDIR));
}

void WriteWholeFile(const std::string &path, const std::string &content) {
    std::error_code error;
    const fs::path target = fs::weakly_canonical(path, error);
    const bool replaces = !fs::exists(target, error) || fs::is_regular_file(target, error);
    const fs::path written = replaces ? fs::path(target) += ".part" : target;
    errno = 0;
    std::ofstream stream(written, std::ios::binary);
    stream << content << std::flush;
    const int failure = errno;
    if (!stream) {
        if (replaces)
            fs::remove(written, error);
        FailToWrite(path, std::strerror(failure));
    }
    if (!replaces)
        return;
    fs::rename(written, target, error);
    if (error)
        FailToWrite(path, error.message());
}

} // namespace testbed
