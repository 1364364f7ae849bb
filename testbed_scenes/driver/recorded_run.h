// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_RECORDED_RUN_H
#define BOOMERANG_TESTBED_RECORDED_RUN_H

#include <functional>
#include <string>

#include "recording/recording.h"
#include "workers.h"

namespace testbed {

/// What to record.
struct RecordRequest {
    std::string scene;
    Side side = Side::Plugin;
    int64_t first = 0, last = 0, every = 1;
    bool boxes = false; ///< with the boxes of the broad phase
    bool calls = false; ///< count the calls that reach Box2D
    /// No more than a replay needs (Recorder's range says what that is), in a tenth of the time.
    bool compact = false;
    WorkerOptions worker;
};

/// Runs a worker and hands on each frame as it comes, with the head. Throws WorkerError if the worker fails
/// or gives fewer frames than were asked for; what onFrame throws ends the run.
void RunRecorded(const Workers &workers, const RecordRequest &request,
                 const std::function<void(const recording::Head &, recording::Frame)> &onFrame,
                 const std::function<void()> &onTick = nullptr);

/// Reads a recording from a file: each frame in order, with the head. Throws UsageError, which names the
/// file, where it is none or ends too early; what onFrame throws ends it.
void ReadRecorded(const std::string &path,
                  const std::function<void(const recording::Head &, recording::Frame)> &onFrame);

} // namespace testbed

#endif
