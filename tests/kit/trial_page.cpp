// SPDX-License-Identifier: MIT
//
//   trial_page make FILE    a page for the library to write to, which BOOMERANG_TRIAL names
//   trial_page read FILE    what it has counted, "NAME NUMBER" on a line each, how it is at work, and the
//                           process's files; nothing where it did not come to work
#include <cinttypes>
#include <cstdio>
#include <cstring>

#include "trial_file.h"

int main(int argc, char **argv) {
    if (argc != 3)
        return 2;
    if (std::strcmp(argv[1], "make") == 0)
        return MakeTrialFile(argv[2]) ? 0 : 1;
    const auto page = ReadTrialFile(argv[2]);
    if (page == nullptr)
        return 1;
    bmr::VisitCounts([](const char *name, uint64_t count) { std::printf("%s %" PRIu64 "\n", name, count); },
                     page->counted);
    std::printf("way %s\nno_pass %s\n%s", page->way, page->noPass, page->files);
    return 0;
}
