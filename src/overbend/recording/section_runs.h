/// Consecutive places of one section: properties of the section are constants of the loop over them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace overbend {

struct SectionRun {
  std::size_t section = 0, first = 0, last = 0;  ///< `last`: one past the end.
};

/// Divides the sections of all places into `runs`. Allocates nothing if `runs` has held as many before.
inline void find_section_runs(std::span<const int> sections, std::vector<SectionRun>& runs) {
  runs.clear();
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const std::size_t section = static_cast<std::size_t>(sections[i]);
    if (runs.empty() || runs.back().section != section) runs.push_back({section, i, i});
    runs.back().last = i + 1;
  }
}

}  // namespace overbend
