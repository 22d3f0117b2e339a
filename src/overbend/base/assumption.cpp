#include "base/assumption.h"

#include <algorithm>
#include <array>

namespace overbend {
namespace {

constexpr std::array<std::string_view, 3> kRankNames = {"governing", "setting", "other"};

AssumptionRank rank_named(std::string_view name) {
  const auto* const found = std::find(kRankNames.begin(), kRankNames.end(), name);
  return found == kRankNames.end() ? AssumptionRank::other : static_cast<AssumptionRank>(found - kRankNames.begin());
}

}  // namespace

std::string_view rank_name(AssumptionRank rank) {
  return kRankNames[static_cast<std::size_t>(rank)];
}

Assumptions merge(Assumptions all, const Assumptions& more) {
  for (const Assumption& assumption : more) {
    if (std::find(all.begin(), all.end(), assumption) == all.end()) all.push_back(assumption);
  }
  return all;
}

std::vector<std::string> texts(const Assumptions& assumptions) {
  std::vector<std::string> list;
  for (const Assumption& assumption : assumptions) list.push_back(assumption.text);
  return list;
}

std::vector<std::string> texts(const Assumptions& assumptions, AssumptionRank rank) {
  std::vector<std::string> list;
  for (const Assumption& assumption : assumptions) {
    if (assumption.rank == rank) list.push_back(assumption.text);
  }
  return list;
}

std::vector<std::string> rank_names(const Assumptions& assumptions) {
  std::vector<std::string> list;
  for (const Assumption& assumption : assumptions) list.emplace_back(rank_name(assumption.rank));
  return list;
}

Assumptions read_assumptions(std::vector<std::string> texts, const std::vector<std::string>& ranks) {
  Assumptions list;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    list.push_back({i < ranks.size() ? rank_named(ranks[i]) : AssumptionRank::other, std::move(texts[i])});
  }
  return list;
}

}  // namespace overbend
