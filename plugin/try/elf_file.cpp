// SPDX-License-Identifier: MIT
#include "try/elf_file.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>

#include <elf.h>
#include <link.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bmr::trial {

namespace {

/// The processor that this program is for. Its name varies; its number is in our own header.
constexpr unsigned char kClass = sizeof(void *) == 8 ? ELFCLASS64 : ELFCLASS32;

int OwnMachine() {
    std::ifstream self("/proc/self/exe", std::ios::binary);
    ElfW(Ehdr) header = {};
    self.read(reinterpret_cast<char *>(&header), sizeof header);
    return header.e_machine;
}

/// Does a segment ask for a loader, or is the file itself a library?
bool IsLoadable(const std::string &bytes, const ElfW(Ehdr) & header) {
    for (int i = 0; i < header.e_phnum; ++i) {
        ElfW(Phdr) segment = {};
        const size_t at = header.e_phoff + static_cast<size_t>(i) * header.e_phentsize;
        if (at > bytes.size() || bytes.size() - at < sizeof segment)
            return false;
        std::memcpy(&segment, bytes.data() + at, sizeof segment);
        if (segment.p_type == PT_INTERP)
            return true;
    }
    return false;
}

bool Has(const std::string &bytes, std::string_view word) {
    return bytes.find(word) != std::string::npos;
}

bool IsExecutable(const std::string &path) {
    struct stat status = {};
    return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && access(path.c_str(), X_OK) == 0;
}

} // namespace

ElfFile LookAtFile(const std::string &path) {
    ElfFile file;
    std::ifstream stream(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    if (!stream && bytes.empty())
        return file;
    file.kind = ElfFile::Kind::kOther;
    // Types of classes with virtual functions are named also in a program without symbols.
    file.hasBox2D2 = Has(bytes, "14b2PolygonShape") || Has(bytes, "_ZN7b2World4Step");
    file.hasBox2D3 = Has(bytes, "b2World_Step") || Has(bytes, "b2CreateWorld");
    file.callsInstall = Has(bytes, "_ZN3bmr7Install");
    ElfW(Ehdr) header = {};
    if (bytes.size() < sizeof header || bytes.compare(0, SELFMAG, ELFMAG) != 0)
        return file;
    std::memcpy(&header, bytes.data(), sizeof header);
    if (header.e_ident[EI_CLASS] != kClass)
        file.kind = ElfFile::Kind::kOtherWidth;
    else if (header.e_machine != OwnMachine())
        file.kind = ElfFile::Kind::kForeign;
    else
        file.kind = IsLoadable(bytes, header) ? ElfFile::Kind::kLoadable : ElfFile::Kind::kStatic;
    return file;
}

std::string FindProgram(const std::string &word) {
    if (word.find('/') != std::string::npos)
        return IsExecutable(word) ? word : "";
    const char *path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "/usr/local/bin:/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::string candidate = (folder.empty() ? "." : folder) + "/" + word;
        if (IsExecutable(candidate))
            return candidate;
    }
    return "";
}

std::string WhyNoProgram(const std::string &word) {
    struct stat status = {};
    if (word.find('/') == std::string::npos) {
        const std::string here = "./" + word;
        const bool isHere = IsExecutable(here);
        return "no folder of PATH has a program of this name" + (isHere ? "; here is one: " + here : "");
    }
    if (stat(word.c_str(), &status) != 0)
        return std::strerror(errno);
    if (S_ISDIR(status.st_mode))
        return "it is a folder";
    return S_ISREG(status.st_mode) ? "it may not be executed (chmod +x?)" : "it is no file";
}

} // namespace bmr::trial
