/// What had to be assumed for a result, as a record.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace overbend {

/// In the order in which assumptions are read.
enum class AssumptionRank {
  governing,  ///< Chosen by the program, or a simplification on which the results depend.
  setting,    ///< How a value or a choice of the model file was understood.
  other,
};

/// "governing", as stored with results.
std::string_view rank_name(AssumptionRank rank);

struct Assumption {
  AssumptionRank rank = AssumptionRank::other;
  std::string text;  ///< One sentence, with its numbers in the units that people read.

  bool operator==(const Assumption&) const = default;
};

using Assumptions = std::vector<Assumption>;

/// All, then those of `more` that are not among them.
Assumptions merge(Assumptions all, const Assumptions& more);

/// The sentences alone.
std::vector<std::string> texts(const Assumptions& assumptions);
std::vector<std::string> texts(const Assumptions& assumptions, AssumptionRank rank);

/// The names of their ranks, one by one; stored next to the sentences under this name.
inline constexpr const char* kAssumptionRanks = "assumption_ranks";
std::vector<std::string> rank_names(const Assumptions& assumptions);

/// Those of stored sentences with the names of their ranks. Results of a version that stored none have `other`.
Assumptions read_assumptions(std::vector<std::string> texts, const std::vector<std::string>& ranks);

}  // namespace overbend
