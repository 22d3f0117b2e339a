/// How the cases of a study lie to each other, from which its charts follow; and the cases that differ in the seed
/// alone taken together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/study_results.h"

namespace overbend {

enum class StudyShape {
  single,  ///< Nothing changes but the seed.
  curves,  ///< One key takes several values.
  maps,    ///< Two or more are crossed.
  one_at_a_time,
  sample,
};

/// The finished cases of one group, values in SI.
struct StudyGroup {
  std::size_t group = 0;
  const StudyCase* first = nullptr;                    ///< Of all its cases.
  std::vector<std::optional<double>> mean, low, high;  ///< Of every output over the finished cases.
  int done = 0, failed = 0, open = 0;
  VerdictKind verdict = VerdictKind::not_judged;  ///< The worst of its cases; not judged where one is not done.
  std::string governing;                          ///< Check with the largest utilisation of its cases,
  std::optional<double> utilisation;              ///< and that.
};

/// In their order.
std::vector<StudyGroup> study_groups(const StudyResults& results);

/// Indices of the axes that change by themselves and take more than one value.
std::vector<std::size_t> free_axes(const StudyResults& results);

StudyShape study_shape(const StudyResults& results);

/// The group from which the others of a one-at-a-time study differ in one key; nothing in another study.
std::optional<std::size_t> base_group(const StudyResults& results, const std::vector<StudyGroup>& groups);

/// Rank correlation [spearman1904] of pairs, ties sharing their ranks; nothing with fewer than three pairs or where one
/// side does not change.
std::optional<double> rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace overbend
