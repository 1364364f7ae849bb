// SPDX-License-Identifier: MIT
#include "manual/description.h"

#include <sstream>

#include <CLI/CLI.hpp>

namespace testbed {
namespace {

/// CLI11 says what a value is like this: "TEXT:{on,off}", "TEXT:FILE", "INT:INT in [1 - 10]".
void ReadType(const std::string &type, OptionDescription &option) {
    const size_t brace = type.find('{'), end = type.rfind('}');
    if (brace != std::string::npos && end != std::string::npos) {
        std::istringstream words(type.substr(brace + 1, end - brace - 1));
        for (std::string word; std::getline(words, word, ',');)
            option.words.push_back(word);
    }
    option.value = type.substr(0, type.find(':'));
    for (const char *kind : {"FILE", "DIR"})
        if (type.find(std::string(":") + kind) != std::string::npos)
            option.value = kind;
}

OptionDescription DescribeOption(const CLI::Option &option, const KnownWords &words) {
    OptionDescription description;
    for (const std::string &name : option.get_snames())
        description.flags.push_back("-" + name);
    for (const std::string &name : option.get_lnames())
        description.flags.push_back("--" + name);
    description.name = option.get_single_name();
    description.text = option.get_description();
    description.defaultValue = option.get_default_str();
    description.required = option.get_required();
    // Flags take no value; what may come again and again has a huge limit.
    if (option.get_items_expected_max() > 0)
        ReadType(option.get_type_name(), description);
    description.repeated = option.get_items_expected_max() > 1;
    const auto known = words.find(description.name);
    if (known != words.end())
        description.words = known->second;
    return description;
}

} // namespace

CommandDescription Describe(const CLI::App &app, const KnownWords &words) {
    CommandDescription description = {app.get_name(), app.get_description(), app.get_footer(), {}, {}};
    for (const CLI::Option *option : app.get_options())
        description.options.push_back(DescribeOption(*option, words));
    for (const CLI::App *command : app.get_subcommands([](const CLI::App *) { return true; }))
        description.commands.push_back(Describe(*command, words));
    return description;
}

} // namespace testbed
