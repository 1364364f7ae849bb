// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_FIGURES_H
#define BOOMERANG_TESTBED_FIGURES_H

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare.h"

namespace testbed {

/// The figures of one scene, worked out from its workers' summaries. Names are the columns of the CSV file
/// and, split at the dots, the keys of the JSON file; an unknown figure has no value.
class Figures {
public:
    explicit Figures(const SceneResult &result);

    std::optional<double> operator[](const std::string &name) const;
    const std::vector<std::pair<std::string, std::optional<double>>> &All() const & { return m_values; }
    /// A loop over the values of a temporary would outlive them.
    void All() && = delete;

private:
    void Add(const std::string &name, std::optional<double> value) { m_values.emplace_back(name, value); }
    void AddCounts(const SceneResult &result);
    void AddEvents(const SceneResult &result);
    void AddTimes(const SceneResult &result);

    std::vector<std::pair<std::string, std::optional<double>>> m_values;
};

/// The middle value, or the mean of the two in the middle; nothing of nothing.
std::optional<double> Median(std::vector<double> values);

/// Nothing of nothing.
std::optional<double> GeometricMean(const std::vector<double> &values);

} // namespace testbed

#endif
