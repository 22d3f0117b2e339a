/// Structure of the cases of a study, which determines its charts; and groups of cases that differ only in their seed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/study_results.h"

namespace overbend {

enum class StudyShape {
  single,  ///< Only the seed varies.
  curves,  ///< One key takes several values.
  maps,    ///< Two or more keys are combined.
  one_at_a_time,
  sample,
};

/// The finished cases of one group, values in SI.
struct StudyGroup {
  std::size_t group = 0;
  const StudyCase* first = nullptr;                    ///< The first of its cases.
  std::vector<std::optional<double>> mean, low, high;  ///< Statistics of every output over the finished cases.
  int done = 0, failed = 0, open = 0;
  VerdictKind verdict = VerdictKind::not_judged;  ///< The most severe verdict of its cases; not judged if a case is not
                                                  ///< done.
  std::string governing;                          ///< Check with the maximum utilisation over its cases.
  std::optional<double> utilisation;              ///< That utilisation.
};

/// Returns the groups in their order.
std::vector<StudyGroup> study_groups(const StudyResults& results);

/// Returns the indices of the axes that vary independently and take more than one value.
std::vector<std::size_t> free_axes(const StudyResults& results);

/// Returns the structure of the cases by the number of varied keys and their combination.
StudyShape study_shape(const StudyResults& results);

/// Returns the group from which the others of a one-at-a-time study differ in one key; nothing in another study.
std::optional<std::size_t> base_group(const StudyResults& results, const std::vector<StudyGroup>& groups);

/// Returns the rank correlation [spearman1904] of pairs, ties sharing their ranks; nothing with fewer than three pairs
/// or if one side is constant.
std::optional<double> rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace overbend
