// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_DESCRIPTION_H
#define BOOMERANG_TESTBED_DESCRIPTION_H

#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace testbed {

/// An option or an argument of a command.
struct OptionDescription {
    std::vector<std::string> flags; ///< "-o", "--output"; none: an argument that stands by itself
    std::string name;               ///< of an argument, or the last flag without its dashes
    std::string value;              ///< what follows the flag: "FILE", "INT"; empty: nothing
    std::vector<std::string> words; ///< the values it takes, if they can be listed
    std::string text, defaultValue;
    bool required = false, repeated = false;

    bool IsArgument() const { return flags.empty(); }
    bool TakesValue() const { return !value.empty(); }
    bool TakesDirectory() const { return value == "DIR"; }
    /// Numbers are not completed, and what has words has no files.
    bool TakesFile() const { return words.empty() && (value == "FILE" || value == "TEXT"); }
};

struct CommandDescription {
    std::string name, text, footer;
    std::vector<OptionDescription> options; ///< in the order of --help
    std::vector<CommandDescription> commands;
};

/// The words that an option or argument takes, by its name: scenes, motions and the like, which the parser
/// does not know.
using KnownWords = std::map<std::string, std::vector<std::string>>;

/// What the parser itself knows of its options, so that nothing needs to be written down twice.
CommandDescription Describe(const CLI::App &app, const KnownWords &words);

} // namespace testbed

#endif
