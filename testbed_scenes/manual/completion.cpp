// SPDX-License-Identifier: MIT
#include "manual/completion.h"

namespace testbed {
namespace {

std::string Joined(const std::vector<std::string> &words, const char *between) {
    std::string all;
    for (const std::string &word : words)
        all += (all.empty() ? "" : between) + word;
    return all;
}

/// Within single quotes of a shell; `more` are characters that need a backslash there.
std::string Quoted(const std::string &text, const std::string &more = "") {
    std::string quoted;
    for (const char c : text) {
        if (c == '\'') {
            quoted += "'\\''";
            continue;
        }
        if (more.find(c) != std::string::npos)
            quoted += '\\';
        quoted += c;
    }
    return quoted;
}

/// The first clause: what fits beside a word in a menu.
std::string Brief(const std::string &text) {
    return text.substr(0, text.find_first_of(";("));
}

// ---- bash ----

/// What replies to a value of this option.
std::string BashReply(const OptionDescription &option) {
    if (!option.words.empty())
        return "_boomerang_testbed_words '" + Quoted(Joined(option.words, " ")) + "'";
    if (option.TakesDirectory())
        return "_boomerang_testbed_files -d";
    return option.TakesFile() ? "_boomerang_testbed_files -f" : ":";
}

void WriteBashCases(std::ostream &out, const CommandDescription &command, const std::string &name) {
    for (const OptionDescription &option : command.options) {
        if (option.IsArgument() || !option.TakesValue())
            continue;
        std::vector<std::string> patterns;
        for (const std::string &flag : option.flags)
            patterns.push_back("'" + name + " " + flag + "'");
        out << "    " << Joined(patterns, " | ") << ") " << BashReply(option) << "; return ;;\n";
    }
}

void WriteBashWords(std::ostream &out, const CommandDescription &command, const std::string &name) {
    std::vector<std::string> flags;
    std::string argument = ":";
    for (const OptionDescription &option : command.options) {
        if (option.IsArgument() && argument == ":")
            argument = BashReply(option);
        flags.insert(flags.end(), option.flags.begin(), option.flags.end());
    }
    if (!command.commands.empty()) {
        std::vector<std::string> names;
        for (const CommandDescription &each : command.commands)
            names.push_back(each.name);
        argument = "_boomerang_testbed_words '" + Joined(names, " ") + "'";
    }
    out << "    '" << name << " -'*) _boomerang_testbed_words '" << Joined(flags, " ") << "' ;;\n    '"
        << name << " '*) " << argument << " ;;\n";
}

// ---- zsh ----

std::string ZshAction(const OptionDescription &option) {
    if (!option.words.empty())
        return "(" + Quoted(Joined(option.words, " ")) + ")";
    if (option.TakesDirectory())
        return "_directories";
    return option.TakesFile() ? "_files" : " ";
}

/// One specification of _arguments for each flag.
void WriteZshOptions(std::ostream &out, const CommandDescription &command, const char *indent) {
    for (const OptionDescription &option : command.options) {
        const std::string value =
            ":" + Quoted(option.IsArgument() ? option.name : option.value, ":") + ":" + ZshAction(option);
        if (option.IsArgument())
            out << " \\\n" << indent << "'" << (option.repeated ? "*" : "") << value << "'";
        for (const std::string &flag : option.flags)
            out << " \\\n"
                << indent << "'" << (option.repeated ? "*" : "") << flag << "["
                << Quoted(Brief(option.text), "[]:\\") << "]" << (option.TakesValue() ? value : "") << "'";
    }
}

// ---- fish ----

void WriteFishOptions(std::ostream &out, const CommandDescription &command, const std::string &program,
                      const std::string &condition) {
    for (const OptionDescription &option : command.options) {
        out << "complete -c " << program << condition;
        for (const std::string &flag : option.flags)
            out << (flag.compare(0, 2, "--") == 0 ? " -l " + flag.substr(2) : " -s " + flag.substr(1));
        if (!option.words.empty())
            out << " -x -a '" << Quoted(Joined(option.words, " "), "\\") << "'";
        else if (option.TakesDirectory())
            out << " -x -a '(__fish_complete_directories)'";
        else if (option.TakesFile())
            out << (option.IsArgument() ? " -F" : " -r -F");
        else if (option.TakesValue())
            out << " -x";
        if (!option.IsArgument())
            out << " -d '" << Quoted(Brief(option.text), "\\") << "'";
        out << '\n';
    }
}

} // namespace

void WriteBashCompletion(std::ostream &out, const CommandDescription &program) {
    std::vector<std::string> names, valued;
    for (const CommandDescription &command : program.commands)
        names.push_back(command.name);
    for (const OptionDescription &option : program.options)
        if (option.TakesValue())
            valued.insert(valued.end(), option.flags.begin(), option.flags.end());
    out << "# bash completion of " << program.name << ": written by `" << program.name
        << " completion bash`\n\n"
           "_boomerang_testbed_words() {\n"
           "  mapfile -t COMPREPLY < <(compgen -W \"$1\" -- \"${COMP_WORDS[COMP_CWORD]}\")\n}\n\n"
           "_boomerang_testbed_files() {\n"
           "  mapfile -t COMPREPLY < <(compgen \"$1\" -- \"${COMP_WORDS[COMP_CWORD]}\")\n"
           "  compopt -o filenames 2>/dev/null\n}\n\n"
           "_boomerang_testbed() {\n"
           "  local command=- i\n"
           "  COMPREPLY=()\n"
           "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
           "    case ${COMP_WORDS[i]} in\n"
           "    "
        << (valued.empty() ? "''" : Joined(valued, " | ")) << ") ((++i)) ;;\n    " << Joined(names, " | ")
        << ") command=${COMP_WORDS[i]}; break ;;\n    esac\n  done\n"
           "  case \"$command ${COMP_WORDS[COMP_CWORD - 1]}\" in\n";
    WriteBashCases(out, program, "-");
    for (const CommandDescription &command : program.commands) {
        WriteBashCases(out, command, command.name);
        WriteBashCases(out, {"", "", "", program.options, {}}, command.name);
    }
    out << "  esac\n  case \"$command ${COMP_WORDS[COMP_CWORD]}\" in\n";
    WriteBashWords(out, program, "-");
    for (const CommandDescription &command : program.commands)
        WriteBashWords(out, command, command.name);
    out << "  esac\n}\n\ncomplete -F _boomerang_testbed " << program.name << '\n';
}

void WriteZshCompletion(std::ostream &out, const CommandDescription &program) {
    out << "#compdef " << program.name << "\n# zsh completion: written by `" << program.name
        << " completion zsh`\n\nlocal context state line\ntypeset -A opt_args\n_arguments -C";
    WriteZshOptions(out, program, "  ");
    out << " \\\n  '1: :->command' \\\n  '*:: :->argument'\ncase $state in\ncommand)\n  local -a commands\n"
           "  commands=(\n";
    for (const CommandDescription &command : program.commands)
        out << "    '" << command.name << ":" << Quoted(Brief(command.text), ":\\") << "'\n";
    out << "  )\n  _describe -t commands command commands\n  ;;\nargument)\n  case $line[1] in\n";
    for (const CommandDescription &command : program.commands) {
        out << "  " << command.name << ")\n    _arguments";
        WriteZshOptions(out, command, "      ");
        out << "\n    ;;\n";
    }
    out << "  esac\n  ;;\nesac\n";
}

void WriteFishCompletion(std::ostream &out, const CommandDescription &program) {
    out << "# fish completion of " << program.name << ": written by `" << program.name
        << " completion fish`\ncomplete -c " << program.name << " -f\n";
    for (const CommandDescription &command : program.commands)
        out << "complete -c " << program.name << " -n __fish_use_subcommand -a " << command.name << " -d '"
            << Quoted(Brief(command.text), "\\") << "'\n";
    WriteFishOptions(out, program, program.name, "");
    for (const CommandDescription &command : program.commands)
        WriteFishOptions(out, command, program.name,
                         " -n '__fish_seen_subcommand_from " + command.name + "'");
}

} // namespace testbed
