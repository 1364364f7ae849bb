// SPDX-License-Identifier: MIT
#include "recorded_run.h"

#include <fstream>
#include <optional>

#include "commands.h"

namespace testbed {

void RunRecorded(const Workers &workers, const RecordRequest &request,
                 const std::function<void(const recording::Head &, recording::Frame)> &onFrame,
                 const std::function<void()> &onTick) {
    WorkerRequest work;
    work.side = request.side;
    work.scene = request.scene;
    work.steps = request.last + 1;
    work.mode = request.calls ? "count" : "hash";
    work.extra = {"--record", std::to_string(request.first) + ":" + std::to_string(request.last) + ":" +
                                  std::to_string(request.every)};
    if (request.boxes)
        work.extra.emplace_back("--record-boxes");
    if (request.compact)
        work.extra.emplace_back("--record-compact");

    std::optional<recording::Head> head;
    int64_t frames = 0;
    const auto process = workers.Start(work, request.worker, [&](const std::string &line) {
        if (recording::IsHead(line)) {
            head = recording::ParseHead(line);
        } else if (recording::IsFrame(line)) {
            if (!head)
                throw WorkerError("printed a frame before the head of its recording");
            ++frames;
            onFrame(*head, recording::ParseFrame(line));
        } else if (!IsSummaryLine(line)) {
            throw WorkerError("printed what is no line of a recording: \"" + line.substr(0, 200) + "\"");
        }
    });
    RunAll({process.get()}, onTick);
    if (!process->Succeeded())
        throw WorkerError(process->Describe());
    if (frames != (request.last - request.first) / request.every + 1)
        throw WorkerError(process->CommandLine() + ": ended after " + std::to_string(frames) + " frames");
}

void ReadRecorded(const std::string &path,
                  const std::function<void(const recording::Head &, recording::Frame)> &onFrame) {
    std::ifstream file(path);
    std::string line;
    const auto parsed = [&](auto parse) {
        try {
            return parse(line);
        } catch (const std::runtime_error &error) {
            throw UsageError(path + ": " + error.what());
        }
    };
    if (!std::getline(file, line) || !recording::IsHead(line))
        throw UsageError(path + " is no recording");
    const recording::Head head = parsed(recording::ParseHead);
    int64_t frames = 0;
    for (; std::getline(file, line); ++frames)
        onFrame(head, parsed(recording::ParseFrame));
    if (head.every < 1 || frames != (head.last - head.first) / head.every + 1)
        throw UsageError(path + " ends after " + std::to_string(frames) + " frames");
}

} // namespace testbed
