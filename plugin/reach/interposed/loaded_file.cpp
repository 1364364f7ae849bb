// SPDX-License-Identifier: MIT
#include "reach/interposed/loaded_file.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <link.h>

namespace bmr {

namespace {

struct Sought {
    uintptr_t address;
    const void *file;
};

int LookInto(dl_phdr_info *object, size_t, void *context) {
    auto *sought = static_cast<Sought *>(context);
    for (int i = 0; i < object->dlpi_phnum; ++i) {
        const ElfW(Phdr) &segment = object->dlpi_phdr[i];
        // (Below the segment the difference is a huge number.)
        if (segment.p_type == PT_LOAD &&
            sought->address - (object->dlpi_addr + segment.p_vaddr) < segment.p_memsz) {
            sought->file = object->dlpi_phdr;
            return 1;
        }
    }
    return 0;
}

struct SoughtWords {
    const void *file;
    std::string_view words;
    bool found;
};

int ReadThrough(dl_phdr_info *object, size_t, void *context) {
    auto *sought = static_cast<SoughtWords *>(context);
    if (object->dlpi_phdr != sought->file)
        return 0;
    for (int i = 0; i < object->dlpi_phnum && !sought->found; ++i) {
        const ElfW(Phdr) &segment = object->dlpi_phdr[i];
        if (segment.p_type != PT_LOAD || (segment.p_flags & (PF_R | PF_W)) != PF_R)
            continue;
        // NOLINTNEXTLINE(performance-no-int-to-ptr): where the loader has put it
        const auto *bytes = reinterpret_cast<const char *>(object->dlpi_addr + segment.p_vaddr);
        sought->found =
            std::string_view(bytes, segment.p_filesz).find(sought->words) != std::string_view::npos;
    }
    return 1;
}

} // namespace

bool FileHolds(const void *address, const char *words) {
    SoughtWords sought = {FileOf(address), words, false};
    if (sought.file != nullptr)
        dl_iterate_phdr(ReadThrough, &sought);
    return sought.found;
}

const void *FileOf(const void *address) {
    Sought sought = {reinterpret_cast<uintptr_t>(address), nullptr};
    if (address != nullptr)
        dl_iterate_phdr(LookInto, &sought);
    return sought.file;
}

} // namespace bmr
