/// Records of the assumptions behind a result.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace overbend {

/// Groups in the order in which assumptions are listed.
enum class AssumptionRank {
  governing,  ///< Chosen by the program, or a simplification that affects the results.
  setting,    ///< Interpretation of a value or a choice of the model file.
  other,
};

/// Returns the stored name, such as "governing".
std::string_view rank_name(AssumptionRank rank);

struct Assumption {
  AssumptionRank rank = AssumptionRank::other;
  std::string text;  ///< One sentence, with numbers in display units.

  bool operator==(const Assumption&) const = default;
};

using Assumptions = std::vector<Assumption>;

/// Returns `all`, then those of `more` that are not in it.
Assumptions merge(Assumptions all, const Assumptions& more);

/// Returns the sentences only.
std::vector<std::string> texts(const Assumptions& assumptions);
std::vector<std::string> texts(const Assumptions& assumptions, AssumptionRank rank);

/// Key under which the names of the ranks are stored next to the sentences.
inline constexpr const char* kAssumptionRanks = "assumption_ranks";
std::vector<std::string> rank_names(const Assumptions& assumptions);

/// Returns assumptions from stored sentences and rank names. Without stored ranks, as in results of older versions, the
/// rank is `other`.
Assumptions read_assumptions(std::vector<std::string> texts, const std::vector<std::string>& ranks);

}  // namespace overbend
