/// In which order assumptions are read: what decides the result first.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace overbend {

enum class AssumptionRank {
  decides,  ///< Chosen by the program or a simplification that results hang on.
  given,    ///< Says how a value or a choice of the model file was understood.
  besides,
};

AssumptionRank rank_of(const std::string& assumption);

/// The assumptions of each rank, in the order given.
std::array<std::vector<std::string>, 3> ranked(const std::vector<std::string>& assumptions);

/// Phrases by which an assumption is known; each is one that the program says somewhere.
const std::vector<std::string>& assumption_phrases(AssumptionRank rank);

}  // namespace overbend
