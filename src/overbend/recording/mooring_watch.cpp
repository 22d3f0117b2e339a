#include "recording/mooring_watch.h"

#include <fmt/format.h>

#include <algorithm>

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

WinchDescription winch_named(const MooringsDescription& moorings, const std::string& winch) {
  for (const WinchDescription& one : moorings.winches) {
    if (one.name == winch) return one;
  }
  return {};
}

double tension_at(const LineAssembly& line, LineEnd end) {
  const std::array<double, 6>& force = line.end_force(end);
  return Vec3(force[0], force[1], force[2]).norm();
}

}  // namespace

MooringWatch::MooringWatch(const std::optional<MooringsDescription>& moorings, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto described = std::find_if(moorings->lines.begin(), moorings->lines.end(),
                                        [&](const MooringLineDescription& line) { return line.name == name; });
    const WinchDescription winch = winch_named(*moorings, described->winch);
    Watched line;
    line.name = name;
    line.breaking = breaking_load(*described);
    line.working = moorings->working_load;
    line.holding = described->anchor_holding.holding;
    line.drags = described->anchor_holding.slides;
    line.brake = winch.brake;
    line.stall = winch.stall;
    line.parts_at = described->fails_at;
    lines_.push_back(std::move(line));
  }
}

void MooringWatch::add_given(const System& system, const SystemState& state) {
  for (std::size_t i = 0; i < system.attachments.size(); ++i) {
    const Attachment& held = system.attachments[i];
    if (held.line < 1 || static_cast<std::size_t>(held.line) > lines_.size()) continue;
    const AttachmentState& at = state.attachments[i];
    Given& given = lines_[static_cast<std::size_t>(held.line) - 1].given;
    if (held.end == LineEnd::first) {
      given.dragged = at.way.gave_way;
    } else {
      given.rendered = at.way.gave_way;
      given.held_up_for = at.way.held_up_for;
      given.parted = at.parted;
      if (at.way.last_element > 0.0) {
        const Line& line = system.lines[static_cast<std::size_t>(held.line)];
        const double share = at.way.last_element / line.mesh.length.back();
        given.least_element = std::min(given.least_element, share);
        given.most_element = std::max(given.most_element, share);
      }
    }
  }
}

void MooringWatch::add(const Assembly& assembly, const SystemState& state) {
  const double time = state.time;
  add_given(assembly.system(), state);
  if (time <= 0.0) return;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto keep = [&](LineEnd end, Peak& peak) {
      const double tension = tension_at(assembly.line(i + 1), end);
      if (tension > peak.tension) peak = {tension, time};
    };
    keep(LineEnd::last, lines_[i].fairlead);
    keep(LineEnd::first, lines_[i].anchor);
  }
}

void MooringWatch::warn_of_given(const Watched& line, std::vector<std::string>& list) {
  constexpr double kLeastElement = 0.5, kMostElement = 1.5;
  constexpr double kLeast = 0.01;  // less is not worth a word [m], [s]
  const Given& given = line.given;
  if (given.rendered > kLeast) {
    list.push_back(
        fmt::format("the winch of mooring line \"{}\" rendered: its brake, set to {:.1f} kN, paid out {:.2f} m",
                    line.name, 1e-3 * line.brake.value_or(0.0), given.rendered));
  }
  if (given.held_up_for > kLeast) {
    list.push_back(
        fmt::format("the winch of mooring line \"{}\" could not haul in for {:.1f} s: it stalls at {:.1f} kN",
                    line.name, given.held_up_for, 1e-3 * line.stall.value_or(0.0)));
  }
  if (given.dragged > kLeast) {
    list.push_back(
        fmt::format("the anchor of mooring line \"{}\" dragged by {:.2f} m: its holding power is {:.1f} kN, less the "
                    "uplift",
                    line.name, given.dragged, 1e-3 * line.holding.value_or(0.0)));
  }
  if (given.least_element < kLeastElement || given.most_element > kMostElement) {
    list.push_back(fmt::format(
        "the winch of mooring line \"{}\" changed the length of the line's last element to {:.2f} to {:.2f} "
        "times its own: forces are less accurate beyond a half and one and a half",
        line.name, given.least_element, given.most_element));
  }
  if (given.parted) {
    list.push_back(fmt::format("mooring line \"{}\" parted at its fairlead at t = {:.1f} s", line.name,
                               line.parts_at.value_or(0.0)));
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
    if (!line.drags) warn(line, line.anchor, line.holding, "its anchor's holding power, which does not drag here,");
    warn_of_given(line, list);
  }
  return list;
}

std::vector<double> MooringWatch::save() const {
  std::vector<double> out;
  for (const Watched& line : lines_) {
    out.insert(out.end(), {line.fairlead.tension, line.fairlead.time, line.anchor.tension, line.anchor.time,
                           line.given.rendered, line.given.dragged, line.given.held_up_for,
                           line.given.parted ? 1.0 : 0.0, line.given.least_element, line.given.most_element});
  }
  return out;
}

void MooringWatch::restore(const std::vector<double>& saved) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const double* at = &saved.at(10 * i);
    lines_[i].fairlead = {at[0], at[1]};
    lines_[i].anchor = {at[2], at[3]};
    lines_[i].given = {at[4], at[5], at[6], at[7] != 0.0, at[8], at[9]};
  }
}

}  // namespace overbend
