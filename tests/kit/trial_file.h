// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_TRIAL_FILE_H
#define BOOMERANG_TEST_TRIAL_FILE_H

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>

#include "tell/trial_page.h"

/// @file
/// What the library has counted in another process: a trial page, in a file that BOOMERANG_TRIAL names.

inline bool MakeTrialFile(const std::string &name) {
    const uint32_t head[] = {bmr::TrialPage::kMagic, sizeof(bmr::TrialPage), 1};
    static_assert(offsetof(bmr::TrialPage, wanted) == sizeof head);
    std::ofstream file(name, std::ios::binary);
    file.write(reinterpret_cast<const char *>(head), sizeof head);
    file.seekp(sizeof(bmr::TrialPage) - 1);
    file.put('\0');
    return file.good();
}

/// Nothing where there is no such file, or the library has not come to work there.
inline std::unique_ptr<bmr::TrialPage> ReadTrialFile(const std::string &name) {
    auto page = std::make_unique<bmr::TrialPage>();
    std::ifstream file(name, std::ios::binary);
    file.read(reinterpret_cast<char *>(page.get()), sizeof *page);
    if (!file.good() || page->way[0] == '\0')
        page.reset();
    return page;
}

#endif
