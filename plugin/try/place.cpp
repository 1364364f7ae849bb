// SPDX-License-Identifier: MIT
#include "try/place.h"

#include <algorithm>
#include <set>

#include "try/elf_file.h"

namespace bmr::trial {

Place PlaceOfBox2D(const Trial &trial) {
    std::set<std::string> files = trial.asItIs.files;
    for (const Run &run : trial.off)
        files.insert(run.files.begin(), run.files.end());
    files.insert(trial.program);
    Place place;
    for (const std::string &file : files) {
        const std::string name = file.substr(file.rfind('/') + 1);
        if (name.rfind("libboomerang", 0) == 0) {
            if (name.rfind("libboomerang_box2d", 0) == 0 && trial.asItIs.files.count(file) != 0)
                place.boomerang = file;
            continue;
        }
        const ElfFile found = LookAtFile(file);
        place.callsInstall = place.callsInstall || found.callsInstall;
        if (found.hasBox2D2 && name.rfind("libbox2d", 0) == 0)
            place.shared = file;
        else if (found.hasBox2D2 && (file != trial.program || place.inside.empty()))
            place.inside = file;
        if (found.hasBox2D3 && !found.hasBox2D2)
            place.version3 = file;
    }
    // (A program that calls a shared Box2D has its names, too.)
    if (!place.shared.empty() && place.inside == trial.program)
        place.inside.clear();
    return place;
}

Already AlreadyIn(const Trial &trial, const Place &place) {
    if (!trial.on.empty() && trial.on.front().way.rfind("compiled with", 0) == 0)
        return Already::kCompiled;
    if (place.boomerang.empty())
        return Already::kNot;
    if (trial.preloadedAsItIs)
        return Already::kPreloaded;
    return place.callsInstall ? Already::kInstalled : Already::kLinked;
}

bool HasBoomerang(const Run &run) {
    return std::any_of(run.files.begin(), run.files.end(), [](const std::string &file) {
        return file.find("/libboomerang_box2d") != std::string::npos;
    });
}

} // namespace bmr::trial
