#include "report/assumption_rank.h"

#include <algorithm>

namespace overbend {
namespace {

bool says_one_of(const std::string& assumption, AssumptionRank rank) {
  const std::vector<std::string>& phrases = assumption_phrases(rank);
  return std::any_of(phrases.begin(), phrases.end(),
                     [&](const std::string& phrase) { return assumption.find(phrase) != std::string::npos; });
}

}  // namespace

const std::vector<std::string>& assumption_phrases(AssumptionRank rank) {
  static const std::vector<std::string> kDecides = {
      "load-controlled, displacement-controlled and simplified laying criteria are recalled",
      "API RP 1111 are recalled",
      "the manufacture of the pipe is not given",
      "is not given and no grade of API 5L",
      "with this yield stress is used",
      "over the supports the pipe conforms to the stinger",
      "counts as functional load effect",
      "is the functional load effect",
      "coatings add weight, not stiffness",
      "times as stiff; stress is that in the steel",
      "linear elastic",
      "The steel stays linear in the dynamic analysis as well",
      "retains its plastic curvature",
      "every section is bent directly to its final shape",
      "is one gap spring at its middle",
      "in statics they are frictionless",
      "axial friction is not mobilised in statics",
      "m face and no given stiffness",
      "Hard impacts amplify the smallest differences",
      "Impacts are captured, not resolved",
      "The hardest impact, ",
      "Fatigue: the sea of the run lasts",
      "The vessel does not move.",
      "There are no waves.",
      "In the dynamic analysis the tensioner is a locked brake",
      "an ideal machine for comparison",
      "the pipe does not act back on it",
      "the offset of the vessel depends on them",
      "Slowly varying drift follows from mean drift",
      "Mooring lines are elastic catenaries",
  };
  static const std::vector<std::string> kGiven = {
      "is the effective tension at the tensioner",
      "Water depth ",
      "The weight density of water is",
      "The stern shoe, origin of ramp and stinger",
      "The vessel floats on even keel",
      "The vessel is trimmed",
      "The vessel moves harmonically as given",
      "The vessel moves as recorded",
      "The tensioner holds the pipe's direction",
      "The seabed stiffness is",
      "The pipe is empty, at atmospheric pressure",
      "Steel of section '",
      "The sea has",
      "It is the sum of",
      "The regular wave",
      "Waves and vessel motion",
      "The tensioner waits",
      "Morison's coefficients do not depend",
      "Impacts weaker than",
      "installation, safety class",
      "Code checks: API RP 1111, ",
      "The current is steady",
      "The hull is a rigid body of",
  };
  static const std::vector<std::string> kNone;
  return rank == AssumptionRank::decides ? kDecides : rank == AssumptionRank::given ? kGiven : kNone;
}

AssumptionRank rank_of(const std::string& assumption) {
  if (says_one_of(assumption, AssumptionRank::decides)) return AssumptionRank::decides;
  return says_one_of(assumption, AssumptionRank::given) ? AssumptionRank::given : AssumptionRank::besides;
}

std::array<std::vector<std::string>, 3> ranked(const std::vector<std::string>& assumptions) {
  std::array<std::vector<std::string>, 3> all;
  for (const std::string& assumption : assumptions) {
    all[static_cast<std::size_t>(rank_of(assumption))].push_back(assumption);
  }
  return all;
}

}  // namespace overbend
