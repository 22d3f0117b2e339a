#include "dynamics/setup/winch_programs.h"

namespace overbend {

std::vector<LengthTable> winch_programs(const StaticSolution& start) {
  return start.winches ? winch_tables(start.winches->lengths, start.winches->profile) : std::vector<LengthTable>{};
}

void set_winch_programs(const MooringSpread& spread, const std::vector<LengthTable>& programs, System& system) {
  std::size_t mooring = 0;
  for (Attachment& held : system.attachments) {
    const bool mooring_line = system.lines[static_cast<std::size_t>(held.line)].role == LineRole::mooring;
    if (!mooring_line || held.end != LineEnd::last) continue;
    while (mooring < spread.lines.size() && spread.lines[mooring].parted) ++mooring;
    if (mooring >= programs.size()) return;
    WinchLaw& winch = held.winch ? *held.winch : held.winch.emplace();
    if (winch.tension.mode == TensionerMode::locked) winch.program = programs[mooring];
    ++mooring;
  }
}

}  // namespace overbend
