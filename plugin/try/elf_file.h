// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TRY_ELF_FILE_H
#define BOOMERANG_TRY_ELF_FILE_H

#include <string>

namespace bmr::trial {

/// The kind of a file to a loader, and the parts of Box2D inside it.
struct ElfFile {
    enum class Kind {
        kUnreadable,
        kOther,      ///< a script, say
        kStatic,     ///< a program that no loader is asked for: nothing can be preloaded
        kOtherWidth, ///< for 32 bits where this program is for 64, or the other way round
        kForeign,    ///< for another processor than this program
        kLoadable
    };
    Kind kind = Kind::kUnreadable;
    bool hasBox2D2 = false;    ///< names of Box2D 2's classes are in it, be they symbols or types
    bool hasBox2D3 = false;    ///< names of Box2D 3's functions
    bool callsInstall = false; ///< the name of bmr::Install
};

/// Reads the whole file once.
ElfFile LookAtFile(const std::string &path);

/// The path of the file that a shell would start for this word, or empty. A word with a slash is a path.
std::string FindProgram(const std::string &word);
/// Of a word for which there is none: why.
std::string WhyNoProgram(const std::string &word);

} // namespace bmr::trial

#endif
