#include "recording/mooring_watch.h"

#include <fmt/format.h>

#include <algorithm>

#include "dynamics/mooring_tension.h"

namespace overbend {
namespace {

/// Least of the segments; none where none says.
std::optional<double> breaking_load(const MooringLineDescription& line) {
  std::optional<double> least;
  for (const LineSegmentDescription& segment : line.segments) {
    if (const auto& load = segment.type.breaking_load; load && (!least || *load < *least)) least = load;
  }
  return least;
}

std::optional<double> brake_of(const MooringsDescription& moorings, const std::string& winch) {
  for (const WinchDescription& one : moorings.winches) {
    if (one.name == winch) return one.brake;
  }
  return std::nullopt;
}

}  // namespace

MooringWatch::MooringWatch(const std::optional<MooringsDescription>& moorings, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto described = std::find_if(moorings->lines.begin(), moorings->lines.end(),
                                        [&](const MooringLineDescription& line) { return line.name == name; });
    lines_.push_back({name,
                      breaking_load(*described),
                      moorings->working_load,
                      brake_of(*moorings, described->winch),
                      described->anchor_holding.holding,
                      {},
                      {}});
  }
}

void MooringWatch::add(const Assembly& assembly, const SystemState& state) {
  const double time = state.time;
  if (time <= 0.0) return;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto keep = [&](LineEnd end, Peak& peak) {
      const double tension = mooring_tension(assembly, state, i, end);
      if (tension > peak.tension) peak = {tension, time};
    };
    keep(LineEnd::last, lines_[i].fairlead);
    keep(LineEnd::first, lines_[i].anchor);
  }
}

std::vector<std::string> MooringWatch::warnings() const {
  std::vector<std::string> list;
  const auto warn = [&](const Watched& line, const Peak& peak, const std::optional<double>& limit, const char* of) {
    if (!limit || peak.tension <= *limit) return false;
    list.push_back(fmt::format("mooring line \"{}\" had {:.1f} kN at t = {:.1f} s, more than {} of {:.1f} kN",
                               line.name, 1e-3 * peak.tension, peak.time, of, 1e-3 * *limit));
    return true;
  };
  for (const Watched& line : lines_) {
    if (!warn(line, line.fairlead, line.breaking, "its breaking load")) {
      warn(line, line.fairlead, line.working, "the working load");
    }
    warn(line, line.fairlead, line.brake, "what its winch's brake holds, which does not render here,");
    warn(line, line.anchor, line.holding, "its anchor's holding power, which does not drag here,");
  }
  return list;
}

std::vector<double> MooringWatch::save() const {
  std::vector<double> out;
  for (const Watched& line : lines_) {
    out.insert(out.end(), {line.fairlead.tension, line.fairlead.time, line.anchor.tension, line.anchor.time});
  }
  return out;
}

void MooringWatch::restore(const std::vector<double>& saved) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const double* at = &saved.at(4 * i);
    lines_[i].fairlead = {at[0], at[1]};
    lines_[i].anchor = {at[2], at[3]};
  }
}

}  // namespace overbend
