/// Places of one section in a row: what hangs on the section is a constant of the loop over them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace overbend {

struct SectionRun {
  std::size_t section = 0, first = 0, last = 0;  ///< `last`: one beyond.
};

/// Of the sections of all places, into `runs`. Allocates nothing where `runs` has held as many.
inline void find_section_runs(std::span<const int> sections, std::vector<SectionRun>& runs) {
  runs.clear();
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const std::size_t section = static_cast<std::size_t>(sections[i]);
    if (runs.empty() || runs.back().section != section) runs.push_back({section, i, i});
    runs.back().last = i + 1;
  }
}

}  // namespace overbend
