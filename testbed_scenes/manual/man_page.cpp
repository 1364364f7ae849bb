// SPDX-License-Identifier: MIT
#include "manual/man_page.h"

#include <algorithm>

namespace testbed {
namespace {

/// Text that means itself: no escapes, no requests at the beginning of a line, dashes that can be copied.
std::string Plain(const std::string &text) {
    std::string plain;
    bool atStart = true;
    for (const char c : text) {
        if (atStart && (c == '.' || c == '\''))
            plain += "\\&";
        if (c == '\\')
            plain += "\\e";
        else if (c == '-')
            plain += "\\-";
        else
            plain += c;
        atStart = c == '\n';
    }
    return plain;
}

std::string Bold(const std::string &text) {
    return "\\fB" + Plain(text) + "\\fR";
}
std::string Italic(const std::string &text) {
    return "\\fI" + Plain(text) + "\\fR";
}

std::string Upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

/// "--output FILE", or an argument's name.
std::string Usage(const OptionDescription &option) {
    const std::string more = option.repeated ? " ..." : "";
    if (option.IsArgument())
        return Italic(option.name) + more;
    std::string usage;
    for (const std::string &flag : option.flags)
        usage += (usage.empty() ? "" : ", ") + Bold(flag);
    return usage + (option.TakesValue() ? " " + Italic(option.value) + more : "");
}

void WriteOptions(std::ostream &out, const CommandDescription &command) {
    // Words that the parser itself checks are worth reading; lists that come from elsewhere are long, and
    // said in the text.
    constexpr size_t kFewWords = 6;
    for (const OptionDescription &option : command.options) {
        out << ".TP\n" << Usage(option) << '\n' << Plain(option.text);
        if (!option.words.empty() && option.words.size() <= kFewWords) {
            out << "\n(";
            for (size_t i = 0; i < option.words.size(); ++i)
                out << (i == 0 ? "" : ", ") << Bold(option.words[i]);
            out << ")";
        }
        if (!option.defaultValue.empty())
            out << "\n[default: " << Plain(option.defaultValue) << "]";
        out << '\n';
    }
}

/// The lines of a footer as they are: tables are made of blanks.
void WriteLines(std::ostream &out, const std::string &lines) {
    out << ".PP\n.nf\n" << Plain(lines) << "\n.fi\n";
}

void WriteSynopsis(std::ostream &out, const CommandDescription &program) {
    out << ".SH SYNOPSIS\n";
    bool first = true;
    for (const CommandDescription &command : program.commands) {
        out << (first ? "" : ".br\n") << ".B " << Plain(program.name + " " + command.name) << '\n';
        first = false;
        bool hasOptions = false;
        for (const OptionDescription &option : command.options) {
            if (option.IsArgument() || option.required)
                out << (option.required ? Usage(option) : "[" + Usage(option) + "]") << '\n';
            else
                hasOptions = true;
        }
        if (hasOptions)
            out << "[" << Italic("options") << "]\n";
    }
}

} // namespace

void WriteManPage(std::ostream &out, const CommandDescription &program, const ManPage &page) {
    out << ".\\\" Written by `" << program.name << " man`: from the program's own options.\n.TH "
        << Upper(Plain(program.name)) << " 1 \"" << Plain(page.date) << "\" \"" << Plain(page.version)
        << "\" \"User Commands\"\n.SH NAME\n"
        << Plain(program.name) << " \\- " << Plain(page.brief) << '\n';
    WriteSynopsis(out, program);
    out << ".SH DESCRIPTION\n" << Plain(program.text) << "\n.SH OPTIONS\nBefore or behind the command:\n";
    WriteOptions(out, program);
    out << ".SH COMMANDS\n";
    for (const CommandDescription &command : program.commands) {
        out << ".SS " << Plain(command.name) << '\n' << Plain(command.text) << ".\n";
        WriteOptions(out, command);
        // The commands repeat the program's own footer under theirs.
        const std::string own = command.footer.substr(0, command.footer.rfind(program.footer));
        if (!own.empty() && own != command.footer)
            WriteLines(out, own.substr(0, own.find_last_not_of('\n') + 1));
    }
    for (const auto &[heading, paragraphs] : page.sections) {
        out << ".SH " << Plain(heading) << '\n';
        bool first = true;
        for (const std::string &paragraph : paragraphs) {
            const size_t tab = paragraph.find('\t');
            if (tab == std::string::npos)
                out << (first ? "" : ".PP\n") << Plain(paragraph) << '\n';
            else
                out << ".TP\n"
                    << Bold(paragraph.substr(0, tab)) << '\n'
                    << Plain(paragraph.substr(tab + 1)) << '\n';
            first = false;
        }
    }
}

} // namespace testbed
