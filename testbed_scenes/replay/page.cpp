// SPDX-License-Identifier: MIT
#include "page.h"

#include <stdexcept>

#include "encoding.h"
#include "page_files.h"

namespace testbed::replay {
namespace {

/// Puts `text` in the place of the mark, which the page has once.
void Fill(std::string &page, std::string_view mark, std::string_view text) {
    const size_t at = page.find(mark);
    if (at == std::string::npos)
        throw std::logic_error("the page has no place for " + std::string(mark));
    page.replace(at, mark.size(), text);
}

/// JSON that may stand inside a script element: nothing in it can end the element.
std::string Embedded(const nlohmann::json &json) {
    std::string text = json.dump();
    for (size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
        text.replace(at, 1, "\\u003c");
    return text;
}

} // namespace

std::string PageOf(const Replay &replay) {
    nlohmann::json about = replay.about;
    about["stepCount"] = replay.stepCount;
    about["eventKinds"] = replay.eventKinds;
    about["quanta"] = {{"position", kPositionQuantum}, {"angle", kAngleQuantum}, {"slack", kSlackQuantum}};
    std::string page(kPageHtml);
    Fill(page, "/*@style@*/", kPageStyle);
    Fill(page, "/*@script@*/", kPageScript);
    Fill(page, "@about@", Embedded(about));
    // Last, and the longest: nothing searches through it.
    Fill(page, "@data@", Base64(Deflate(Pack(ColumnsOf(replay)))));
    return page;
}

} // namespace testbed::replay
