// SPDX-License-Identifier: MIT
#include "tell/statistics_file.h"

#include <cinttypes>
#include <cstdlib>
#include <cstring>

#include "start/environment.h"
#include "start/settings.h"
#include "start/this_process.h"

namespace bmr {

namespace {

constexpr size_t kLongestName = 4096; // PATH_MAX of Linux
constexpr char kPlaceOfNumber[] = "%p";
char fileName[kLongestName];
long installedIn;

/// The file's name with the number of this process for each "%p". Without memory: an exit handler that throws
/// would end the program another way. False where the name is too long with it.
bool NameForThisProcess(char (&name)[kLongestName]) {
    size_t length = 0;
    for (const char *at = fileName; *at != '\0';) {
        const bool number = std::strncmp(at, kPlaceOfNumber, sizeof kPlaceOfNumber - 1) == 0;
        const size_t left = sizeof name - length;
        const int added = number ? std::snprintf(name + length, left, "%ld", ThisProcess())
                                 : std::snprintf(name + length, left, "%c", *at);
        length += static_cast<size_t>(added);
        if (length >= sizeof name)
            return false;
        at += number ? sizeof kPlaceOfNumber - 1 : 1;
    }
    return true;
}

/// A forked child has the handlers of its parent. Where both would write one file, the parent does.
void WriteNow() {
    if (ThisProcess() != installedIn && std::strstr(fileName, kPlaceOfNumber) == nullptr)
        return;
    char name[kLongestName] = "";
    std::FILE *file = NameForThisProcess(name) ? std::fopen(name, "w") : nullptr;
    if (file == nullptr) {
        std::fprintf(stderr, "boomerang: cannot write the statistics to %s\n", name);
        return;
    }
    WriteStatistics(file);
    const bool written = std::ferror(file) == 0;
    if (std::fclose(file) != 0 || !written)
        std::fprintf(stderr, "boomerang: the statistics in %s are not complete\n", name);
}

/// Writes the members of JSON objects, with commas where they belong. Names and words are our own: nothing in
/// them to escape.
class Members {
public:
    explicit Members(std::FILE *stream, const char *indent) : m_stream(stream), m_indent(indent) {}

    void Number(const char *name, uint64_t value) {
        Name(name);
        std::fprintf(m_stream, "%" PRIu64, value);
    }
    void Word(const char *name, const char *value) {
        Name(name);
        std::fprintf(m_stream, "\"%s\"", value);
    }
    void Name(const char *name) {
        std::fprintf(m_stream, "%s\n%s\"%s\": ", m_first ? "" : ",", m_indent, name);
        m_first = false;
    }

private:
    std::FILE *m_stream;
    const char *m_indent;
    bool m_first = true;
};

} // namespace

void WriteStatistics(std::FILE *stream) {
    const Statistics s = GetStatistics();
    std::fputc('{', stream);
    Members members(stream, "  ");
    members.Word("mode", NameOf(GetSettings().options.mode));
    members.Word("structure", bmr_structure_name(GetSettings().pairDef.structure));
    const Presence presence = GetPresence();
    members.Word("way", presence.way);
    members.Word("box2d", presence.box2d);
    members.Name("rounds_as_box2d");
    std::fputs(presence.roundsAsBox2D ? "true" : "false", stream);
    members.Name("passes_run");
    std::fputs(presence.passesRun ? "true" : "false", stream);
    members.Number("steps", s.steps);
    members.Number("evaluations", s.evaluations);
    members.Number("edge_checks", s.edgeChecks);
    members.Number("edge_searches", s.edgeSearches);
    members.Number("verdicts_reused", s.verdictsReused);
    members.Number("proved_apart", s.provedApart);
    members.Number("handed_over", s.handedOver);
    members.Number("handed_over_touching", s.handedOverTouching);
    members.Number("touching_answered", s.touchingAnswered);
    members.Number("toi_queries", s.toiQueries);
    members.Number("toi_answered", s.toiAnswered);
    members.Number("overlap_queries", s.overlapQueries);
    members.Number("overlaps_answered", s.overlapsAnswered);
    members.Number("pairs_watched", s.pairsWatched);
    members.Number("looks", s.looks);
    members.Number("renewals", s.renewals);
    members.Number("verified", s.verified);
    members.Number("differences", s.differences);
    members.Number("pairs", s.pairs);
    members.Number("hulls", s.hulls);
    members.Number("checks", s.kinetic.checks);
    members.Number("kinetic_steps", s.kinetic.steps);
    members.Name("events");
    std::fputc('{', stream);
    Members events(stream, "    ");
    for (int kind = 0; kind < BMR_EVENT_KIND_COUNT; ++kind)
        events.Number(bmr_event_name(static_cast<bmr_event_kind>(kind)), s.kinetic.events[kind]);
    std::fputs("\n  }\n}\n", stream);
}

bool WriteStatisticsAtExit(const char *file) {
    const size_t length = std::strlen(file);
    if (length >= kLongestName)
        return false;
    std::memcpy(fileName, file, length + 1);
    installedIn = ThisProcess();
    return std::atexit(WriteNow) == 0;
}

} // namespace bmr
