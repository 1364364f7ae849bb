// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_COMPLETION_H
#define BOOMERANG_TESTBED_COMPLETION_H

#include <ostream>

#include "manual/description.h"

namespace testbed {

// Scripts that a shell loads to complete the command line of this program: its commands, their options, and
// the words that options and arguments take.
void WriteBashCompletion(std::ostream &out, const CommandDescription &program);
void WriteZshCompletion(std::ostream &out, const CommandDescription &program);
void WriteFishCompletion(std::ostream &out, const CommandDescription &program);

} // namespace testbed

#endif
