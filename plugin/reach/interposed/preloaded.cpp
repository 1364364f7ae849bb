// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <cstring>
#include <string_view>

#include <dlfcn.h>
#include <link.h>

#include "reach/interposed/library_check.h"

namespace bmr {

namespace {

constexpr std::string_view kStem = "libboomerang_box2d.so";

std::string_view FileName(std::string_view path) {
    const size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

bool IsOurs(std::string_view path) {
    return FileName(path).substr(0, kStem.size()) == kStem;
}

/// LD_PRELOAD: paths with blanks or colons between.
bool EnvironmentNamesUs() {
    const char *preload = std::getenv("LD_PRELOAD");
    std::string_view rest = preload != nullptr ? preload : "";
    while (!rest.empty()) {
        const size_t end = rest.find_first_of(" :");
        if (IsOurs(rest.substr(0, end)))
            return true;
        rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
    return false;
}

/// ELF's headers hold addresses as numbers.
template <typename T> const T *At(ElfW(Addr) address) {
    return reinterpret_cast<const T *>(address); // NOLINT(performance-no-int-to-ptr)
}

/// Does this loaded object ask for us (DT_NEEDED)?
int AsksForUs(dl_phdr_info *object, size_t, void *) {
    const ElfW(Dyn) *dynamic = nullptr;
    for (int i = 0; i < object->dlpi_phnum; ++i)
        if (object->dlpi_phdr[i].p_type == PT_DYNAMIC)
            dynamic = At<ElfW(Dyn)>(object->dlpi_addr + object->dlpi_phdr[i].p_vaddr);
    if (dynamic == nullptr)
        return 0;
    ElfW(Addr) strings = 0;
    for (const ElfW(Dyn) *entry = dynamic; entry->d_tag != DT_NULL; ++entry)
        if (entry->d_tag == DT_STRTAB)
            strings = entry->d_un.d_ptr;
    // Most loaders have made it an address already; some leave the offset.
    if (strings < object->dlpi_addr)
        strings += object->dlpi_addr;
    for (const ElfW(Dyn) *entry = dynamic; entry->d_tag != DT_NULL; ++entry)
        if (entry->d_tag == DT_NEEDED && IsOurs(At<char>(strings + entry->d_un.d_val)))
            return 1;
    return 0;
}

} // namespace

bool IsPreloaded() {
    if (EnvironmentNamesUs())
        return true;
    // No library asks for one that the program opened itself (dlopen) either, but such a one does not come
    // first in search order.
    return StepsComeByHere() && dl_iterate_phdr(AsksForUs, nullptr) == 0;
}

} // namespace bmr
