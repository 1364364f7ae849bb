// SPDX-License-Identifier: MIT
//
//   actor seeds FIRST COUNT [OPTION...]     what BytesOf makes of seeds
//   actor corpus FILE [NAME...] [OPTION...] the inputs of a packed corpus, or these
//   actor play BYTES                        these bytes, two digits each
//   actor hex FIRST COUNT                   prints those bytes: lines of a packed corpus
//   actor serve                             plays what comes in (serving.cpp)
//
//   --any-size            those with polygons of any size; without it the others
//   --dump RECORD         that record in words, on stderr
//   --perturb RECORD      the control: one unit in the last place of one velocity, ahead of that record
//
// Each input is played in a process of its own. Prints a line for each record: the input's name, the record's
// number, hashes of bodies, contacts, events and answers; and one for the ending: done, numbers that are
// none, an assertion of Box2D's and which, a signal.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include "../../kit/packed_corpus.h"
#include "actor.h"
#include "plugin.h"

namespace {

struct Input {
    std::string name;
    std::vector<uint8_t> bytes;
};

std::string playing; ///< the input's name; of an actor that serves none
int perturbAt = -1, dumpAt = -1;

int Usage() {
    std::fprintf(
        stderr,
        "usage: actor seeds FIRST COUNT | corpus FILE [NAME...] | play BYTES | hex FIRST COUNT | serve\n"
        "             [--any-size] [--dump RECORD] [--perturb RECORD]\n");
    return 2;
}

void End(const char *how, const char *text) {
    std::printf("%s ends %s%s\n", playing.c_str(), how, text);
    std::fflush(stdout);
}

/// Each record is out before the next step: a crash takes no line with it.
void Play(const Input &input) {
    actor::Actor player(input.bytes.data(), input.bytes.size());
    player.perturbAt = perturbAt;
    player.dumpAt = dumpAt;
    int number = 0;
    for (actor::Record r; player.PlayOn(&r); ++number) {
        std::printf("%s %d %016" PRIx64 " %016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", playing.c_str(),
                    number, r.bodies, r.contacts, r.events, r.probes);
        std::fflush(stdout);
    }
    std::fputs(player.dump.c_str(), stderr);
    End(player.IsFinite() ? "done" : "not finite", "");
}

void PlayAlone(const Input &input) {
    playing = input.name;
    const pid_t child = fork();
    if (child == 0) {
        Play(input);
        std::exit(0); // what the plugin does at the end of a program belongs to it
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child)
        std::exit(3);
    if (WIFSIGNALED(status))
        End("signal ", std::to_string(WTERMSIG(status)).c_str());
}

} // namespace

// Ahead of libc's: which assertion it is belongs to what is compared.
extern "C" __attribute__((visibility("default"))) void __assert_fail(const char *text, const char *, unsigned,
                                                                     const char *) noexcept {
    if (!playing.empty())
        End("assertion ", text);
    std::_Exit(0);
}

int main(int argc, char **argv) {
    std::vector<std::string> words;
    bool anySize = false;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--any-size")
            anySize = true;
        else if ((word == "--dump" || word == "--perturb") && i + 1 < argc)
            (word == "--dump" ? dumpAt : perturbAt) = std::atoi(argv[++i]);
        else
            words.push_back(word);
    }
    if (words.size() == 1 && words[0] == "serve") {
        actor::Install();
        actor::Serve(STDIN_FILENO, STDOUT_FILENO);
        return 0;
    }
    std::vector<Input> inputs;
    if (words.size() == 3 && (words[0] == "seeds" || words[0] == "hex")) {
        const auto first = static_cast<uint32_t>(std::strtoul(words[1].c_str(), nullptr, 10)),
                   count = static_cast<uint32_t>(std::strtoul(words[2].c_str(), nullptr, 10));
        for (uint32_t seed = first; seed != first + count; ++seed)
            inputs.push_back({std::to_string(seed), actor::BytesOf(seed)});
    } else if (words.size() == 2 && words[0] == "play") {
        Input input = {"bytes", {}};
        for (size_t i = 0; i + 1 < words[1].size(); i += 2)
            input.bytes.push_back(
                static_cast<uint8_t>(std::strtoul(words[1].substr(i, 2).c_str(), nullptr, 16)));
        inputs.push_back(input);
    } else if (words.size() >= 2 && words[0] == "corpus") {
        const auto keep = [](void *all, const char *name, const uint8_t *bytes, size_t size) {
            static_cast<std::vector<Input> *>(all)->push_back({name, {bytes, bytes + size}});
        };
        if (!packed_corpus_read(words[1].c_str(), keep, &inputs)) {
            std::fprintf(stderr, "%s is no packed corpus\n", words[1].c_str());
            return 3;
        }
    } else {
        return Usage();
    }
    if (words[0] == "hex") {
        for (const Input &input : inputs) {
            std::printf("%s ", input.name.c_str());
            for (const uint8_t byte : input.bytes)
                std::printf("%02x", byte);
            std::printf("\n");
        }
        return 0;
    }
    actor::Install();
    for (const Input &input : inputs) {
        bool wanted = words[0] != "corpus" || words.size() == 2;
        for (size_t i = 2; i < words.size() && words[0] == "corpus"; ++i)
            wanted = wanted || words[i] == input.name;
        if (wanted && anySize == actor::Actor::AsksForAnySize(input.bytes.data(), input.bytes.size()))
            PlayAlone(input);
    }
    return 0;
}
