// SPDX-License-Identifier: MIT
#include "reach/interposed/loaded_file.h"

#include <cstddef>
#include <cstdint>

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

} // namespace

const void *FileOf(const void *address) {
    Sought sought = {reinterpret_cast<uintptr_t>(address), nullptr};
    if (address != nullptr)
        dl_iterate_phdr(LookInto, &sought);
    return sought.file;
}

} // namespace bmr
