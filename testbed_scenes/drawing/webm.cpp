// SPDX-License-Identifier: MIT
#include "drawing/webm.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "drawing/whole_file.h"

namespace testbed {
namespace {

class Webm final : public MovingPicture {
public:
    explicit Webm(const std::string &path) : m_path(path), m_whole(path) {}
    ~Webm() override {
        CloseInput();
        if (m_pid > 0)
            kill(m_pid, SIGKILL);
        Wait();
    }

    void Add(const Image &image, double seconds) override {
        if (m_pid <= 0)
            Start(image, seconds);
        const auto *bytes = reinterpret_cast<const char *>(image.pixels.data());
        std::size_t left = image.pixels.size() * sizeof image.pixels[0];
        while (left > 0) {
            const ssize_t written = write(m_input, bytes, left);
            if (written < 0 && errno == EINTR)
                continue;
            if (written < 0)
                Fail("ffmpeg takes no more pictures");
            bytes += written;
            left -= static_cast<std::size_t>(written);
        }
    }

    void Finish() override {
        CloseInput();
        if (Wait() != 0)
            Fail("ffmpeg failed");
        m_whole.Finish();
    }

private:
    [[noreturn]] void Fail(const std::string &why) const {
        throw std::runtime_error("cannot write " + m_path + ": " + why);
    }

    void Start(const Image &image, double seconds) {
        signal(SIGPIPE, SIG_IGN); // an ffmpeg that ended is an error here, not our end
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0)
            Fail(std::strerror(errno));
        m_input = ends[1];
        char size[32], rate[32];
        std::snprintf(size, sizeof size, "%dx%d", image.width, image.height);
        std::snprintf(rate, sizeof rate, "%.6f", 1.0 / seconds);
        std::string target = m_whole.WritePath().string();
        // A path is never an option of ffmpeg's, nor one of its protocols.
        target.insert(0, "file:");
        std::vector<std::string> words = {
            "ffmpeg",     "-v",      "error",     "-y",   "-f",   "rawvideo", "-pix_fmt", "bgr0",
            "-s",         size,      "-r",        rate,   "-i",   "-",        "-an",      "-c:v",
            "libvpx-vp9", "-crf",    "30",        "-b:v", "0",    "-pix_fmt", "yuv420p",  "-threads",
            "1",          "-fflags", "+bitexact", "-f",   "webm", target};
        std::vector<char *> arguments;
        for (std::string &word : words)
            arguments.push_back(word.data());
        arguments.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
        const int error = posix_spawnp(&m_pid, "ffmpeg", &actions, nullptr, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        close(ends[0]);
        if (error != 0)
            m_pid = -1;
        if (error == ENOENT)
            Fail("it needs ffmpeg, which is not installed (Debian: apt-get install ffmpeg); a .gif needs "
                 "nothing");
        if (error != 0)
            Fail(std::string("ffmpeg: ") + std::strerror(error));
    }

    void CloseInput() {
        if (m_input >= 0)
            close(m_input);
        m_input = -1;
    }

    int Wait() {
        int status = -1;
        while (m_pid > 0 && waitpid(m_pid, &status, 0) < 0 && errno == EINTR) {
        }
        m_pid = -1;
        return status;
    }

    const std::string m_path;
    WholeFile m_whole;
    pid_t m_pid = -1;
    int m_input = -1;
};

} // namespace

std::unique_ptr<MovingPicture> MakeWebm(const std::string &path) {
    return std::make_unique<Webm>(path);
}

} // namespace testbed
