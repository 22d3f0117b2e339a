#include "model/model_findings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/shown_unit.h"
#include "model/site/wave_groups.h"
#include "model/vessel/rao_limits.h"

namespace overbend {
namespace {

bool recorded_motion_moves(const VesselDescription& vessel) {
  if (!vessel.history) return true;  // reported as an error by the reader
  const auto& rows = vessel.history->freedoms;
  return std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row != rows.front(); });
}

bool vessel_moves(const VesselDescription& vessel) {
  switch (vessel.motion) {
    case VesselMotion::fixed:
    case VesselMotion::raos:  // RAOs cause motion only in waves
      return false;
    case VesselMotion::harmonic:
      return std::any_of(vessel.harmonic.begin(), vessel.harmonic.end(),
                         [](const auto& motion) { return motion.second.amplitude != 0.0; });
    case VesselMotion::history:
      return recorded_motion_moves(vessel);
    case VesselMotion::coupled:
      break;
  }
  return true;
}

/// Returns true if anything other than waves and the vessel changes with time.
bool has_moving_equipment(const Description& d) {
  const auto moving_end = [](const FreeLineDescription& line) {
    return !line.first.amplitude.isZero(0.0) || !line.second.amplitude.isZero(0.0);
  };
  if (d.operation.type != OperationType::none || std::any_of(d.lines.begin(), d.lines.end(), moving_end)) return true;
  if (!d.moorings) return false;
  const auto fails = [](const MooringLineDescription& line) { return line.fails_at.has_value(); };
  return !d.moorings->winches.empty() || std::any_of(d.moorings->lines.begin(), d.moorings->lines.end(), fails);
}

/// Warns of lines whose tension exceeds the breaking load: an input error in tension or diameter.
void warn_of_breaking_lines(Findings& findings, const MooringsDescription& moorings) {
  for (const MooringLineDescription& line : moorings.lines) {
    for (const LineSegmentDescription& segment : line.segments) {
      if (!line.tension || !segment.type.breaking_load || *line.tension <= *segment.type.breaking_load) continue;
      findings.push_back(
          Finding{FindingCode::breaking_load_exceeded,
                  fmt::format("the tension of mooring line '{}', {}, is more than its breaking load, {} of {}",
                              line.name, shown_digits(*line.tension, "N", 4),
                              shown_digits(*segment.type.breaking_load, "N", 4), segment.type.made_from)}
              .on("mooring line " + line.name)
              .with("tension", *line.tension, "N"));
      break;
    }
  }
}

/// Reports the sections whose yield stress is assumed, in one finding: their checks mean nothing.
void report_assumed_yield(Findings& findings, const PipeDescription& pipe) {
  std::vector<std::string> names;
  double min_yield = HUGE_VAL;
  const auto note = [&](const std::string& name, const SteelDescription& steel) {
    if (!steel.yield_assumed) return;
    names.push_back(name);
    min_yield = std::min(min_yield, steel.yield_stress);
  };
  note("pipe", pipe.section.steel);
  for (const SegmentDescription& segment : pipe.segments) note("segment " + segment.name, segment.section.steel);
  if (names.empty()) return;
  findings.push_back(Finding{FindingCode::yield_assumed,
                             fmt::format("the yield stress of {} is an assumption, {}: its checks of stress, strain "
                                         "and moment mean nothing until pipe.steel.yield_stress is that of the steel",
                                         fmt::join(names, ", "), shown_digits(min_yield, "Pa", 4))}
                         .on(names.front())
                         .with("yield_stress", min_yield, "Pa"));
}

}  // namespace

Findings model_findings(const Model& model) {
  const Description& d = model.description;
  Findings findings = d.findings;
  if (d.vessel.raos) {
    const RaoLimits limits =
        long_wave_limits(*d.vessel.raos, d.vessel.length, d.vessel.draught, d.environment.water_depth);
    append(findings, limit_findings(limits));
  }
  if (d.has_pipe) report_assumed_yield(findings, d.pipe);
  if (d.moorings) warn_of_breaking_lines(findings, *d.moorings);
  if (d.dynamics && is_calm(d.environment.waves) && !vessel_moves(d.vessel) && !has_moving_equipment(d)) {
    findings.push_back({FindingCode::nothing_moves,
                        "nothing moves in the dynamic analysis: the water is calm (environment.waves) and the vessel "
                        "does not move (vessel.motion)"});
  }
  if (d.dynamics && d.has_pipe && d.tensioner.mode_assumed) {
    findings.push_back(Finding{
        FindingCode::tensioner_mode_assumed,
        "tensioner.mode is not given: in the dynamic analysis the tensioner keeps the set tension, an ideal machine "
        "without limits of speed and travel; give its range and velocity, or set mode to constant or locked"}
                           .on("tensioner"));
  }
  return findings;
}

}  // namespace overbend
