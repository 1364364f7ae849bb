// SPDX-License-Identifier: MIT
#include "tell/trial.h"

#include "boomerang/box2d_glue.h"
#include "start/environment.h"
#include "start/install.h"
#include "start/settings.h"
#include "start/this_process.h"
#include "tell/event.h"

#if !defined(_WIN32)
#    include <cstdio>
#    include <cstdlib>
#    include <cstring>
#    include <string_view>

#    include <ctime>
#    include <fcntl.h>
#    if defined(__linux__)
#        include <link.h>
#    endif
#    include <sys/mman.h>
#    include <sys/stat.h>
#    include <unistd.h>
#endif

namespace bmr {

TrialPage *internal::trial = nullptr;
BMR_THREAD bool internal::inTimedStep = false;

#if !defined(_WIN32)

namespace {

int64_t Now() {
    timespec now = {};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return int64_t{now.tv_sec} * 1000000000 + now.tv_nsec;
}

TrialPage *Map(const char *name) {
    const int file = open(name, O_RDWR | O_CLOEXEC);
    if (file < 0)
        return nullptr;
    struct stat status = {};
    void *page = MAP_FAILED;
    if (fstat(file, &status) == 0 && status.st_size == static_cast<off_t>(sizeof(TrialPage)))
        page = mmap(nullptr, sizeof(TrialPage), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    if (page == MAP_FAILED)
        return nullptr;
    auto *trial = static_cast<TrialPage *>(page);
    if (trial->magic == TrialPage::kMagic && trial->size == sizeof(TrialPage))
        return trial;
    munmap(page, sizeof(TrialPage));
    return nullptr;
}

void Copy(char (&to)[TrialPage::kMostWords], const char *from) {
    std::snprintf(to, sizeof to, "%s", from);
}

/// At the end of a step, or of the process: writes what is at work, and what it has done.
void Tell(TrialPage *trial) {
    const uint32_t wanted = trial->wanted.load(std::memory_order_acquire);
    if (IsInstalled()) {
        const Presence presence = GetPresence();
        std::snprintf(trial->way, sizeof trial->way, "%s %s; rounds %s Box2D", presence.way, presence.box2d,
                      presence.roundsAsBox2D ? "as" : "otherwise than");
        Copy(trial->noPass, presence.whyNot);
        trial->counted = internal::ReadCounts();
    } else if (const char *why = WhyRefused()) {
        Copy(trial->whyNot, why);
    }
    trial->told.store(wanted, std::memory_order_release);
}

bool IsTheProcess(TrialPage *trial) {
    int64_t nobody = 0;
    const int64_t here = ThisProcess();
    return trial->steppedIn.compare_exchange_strong(nobody, here) || nobody == here;
}

#    if defined(__linux__)
/// A name that has no room on the page is left out.
int AddFile(dl_phdr_info *object, size_t, void *context) {
    char *names = static_cast<TrialPage *>(context)->files;
    const size_t used = std::strlen(names), length = std::strlen(object->dlpi_name);
    if (length > 0 && used + length + 2 <= TrialPage::kMostNames)
        std::snprintf(names + used, TrialPage::kMostNames - used, "%s\n", object->dlpi_name);
    return 0;
}
void ListFiles(TrialPage *trial) {
    dl_iterate_phdr(AddFile, trial);
}
#    else
void ListFiles(TrialPage *) {}
#    endif

/// A process that ends by itself cannot be asked any more: it tells now.
void TellAtExit() {
    TrialPage *trial = internal::trial;
    // Where nobody has stepped, of several processes the one that loaded the library last.
    const bool last = trial->steppedIn == 0 && trial->loadedIn == ThisProcess();
    if (last || trial->steppedIn == ThisProcess())
        Tell(trial);
    if (last)
        ListFiles(trial);
}

bool Open() {
    const std::string_view name = ReadEnvironment(kTrialVariable);
    if (name.empty())
        return false;
    TrialPage *page = Map(name.data());
    if (page == nullptr) {
        std::fprintf(stderr, "boomerang: %s=%s is not a file that this library can write to\n",
                     kTrialVariable, name.data());
        return false;
    }
    page->loadedIn = ThisProcess();
    internal::trial = page;
    return std::atexit(TellAtExit) == 0;
}

} // namespace

void OpenTrial() {
    [[maybe_unused]] static const bool opened = Open();
}

bool TrialCounts() {
    return internal::trial != nullptr && internal::trial->counts != 0;
}

void TellTrial(const char *whyNoStep) {
    if (internal::trial != nullptr)
        Copy(internal::trial->noStep, whyNoStep);
}

TimedStep::TimedStep() : m_begin(Now()), m_outermost(!internal::inTimedStep) {
    internal::inTimedStep = true;
}

void TimedStep::End() {
    const int64_t took = Now() - m_begin;
    TrialPage *trial = internal::trial;
    if (!m_outermost || !IsTheProcess(trial))
        return;
    if (trial->steps.load(std::memory_order_relaxed) == 0 && !trial->listed.exchange(true))
        ListFiles(trial);
    // (Worlds on several threads: each step has a place of its own, and is there once it is counted.)
    const uint32_t place = trial->steps.fetch_add(1, std::memory_order_acq_rel);
    if (place < TrialPage::kMostSteps)
        trial->microseconds[place] = static_cast<float>(static_cast<double>(took) * 1e-3);
    if (trial->wanted.load(std::memory_order_relaxed) != trial->told.load(std::memory_order_relaxed))
        Tell(trial);
}

TimedStep::~TimedStep() {
    if (m_outermost)
        internal::inTimedStep = false;
}

#else

void OpenTrial() {}
bool TrialCounts() {
    return false;
}
void TellTrial(const char *) {}
TimedStep::TimedStep() : m_begin(0), m_outermost(false) {}
void TimedStep::End() {}
TimedStep::~TimedStep() = default;

#endif

} // namespace bmr
