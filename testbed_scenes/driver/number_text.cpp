// SPDX-License-Identifier: MIT
#include "number_text.h"

#include <cstdio>

namespace testbed {

std::string Fixed(std::optional<double> number, int decimals) {
    if (!number)
        return "-";
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, *number);
    return text;
}

} // namespace testbed
