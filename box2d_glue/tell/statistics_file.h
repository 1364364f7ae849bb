// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_STATISTICS_FILE_H
#define BOOMERANG_GLUE_STATISTICS_FILE_H

#include <cstdio>

namespace bmr {

/// When the process ends (by exit, or by returning from main; not by a signal or _exit), the statistics go
/// into this file as JSON. Once for a process, after MakeSettings. The handler reads only objects without
/// destructors, so it may run at any time. "%p" in the name becomes the number of the process: with it each
/// process that is forked after this writes its own, without it the one that called this writes alone. False
/// where the name is too long or there is no room for another exit handler.
bool WriteStatisticsAtExit(const char *file);

/// The statistics and the options they were made under, as one JSON object and a newline.
void WriteStatistics(std::FILE *stream);

} // namespace bmr

#endif
