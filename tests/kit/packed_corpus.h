// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_PACKED_CORPUS_H
#define BOOMERANG_TEST_PACKED_CORPUS_H

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

/// One input of a corpus. A corpus is a text file: a line an input, its name and its bytes in hexadecimal.
struct PackedInput {
    std::string name;
    std::vector<uint8_t> bytes;
};

/// False where the file cannot be read, or a line is not of that form.
inline bool ReadPackedCorpus(const std::string &path, std::vector<PackedInput> *inputs) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        const size_t end = line.find(' ');
        if (end == 0 || end == std::string::npos || (line.size() - end) % 2 == 0 ||
            line.find_first_not_of("0123456789abcdef", end + 1) != std::string::npos)
            return false;
        inputs->push_back({line.substr(0, end), {}});
        for (size_t at = end + 1; at < line.size(); at += 2)
            inputs->back().bytes.push_back(static_cast<uint8_t>(std::stoi(line.substr(at, 2), nullptr, 16)));
    }
    return file.eof() && !inputs->empty();
}

#endif
