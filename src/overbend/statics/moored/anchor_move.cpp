#include "statics/moored/anchor_move.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/shown_unit.h"

namespace overbend {
namespace {

constexpr int kMaxRounds = 60;     ///< Iterations between length and hull position.
constexpr double kSettled = 1e-9;  ///< Tolerance relative to the tension.

/// New position of the anchor on the seabed.
Vec3 new_place(const Model& model, const AnchorMoveDescription& move, const Vec3& fairlead_V,
               const SeabedSurface& bed) {
  Vec3 place = Vec3::Zero();
  if (move.to) {
    place = {(*move.to)[0], (*move.to)[1], 0.0};
  } else {
    const Vec3 forward = model.nominal_pose.R_WV.col(0);
    const double azimuth = std::atan2(forward.x(), forward.y()) + move.bearing.value_or(0.0);
    place = model.nominal_pose.R_WV * fairlead_V +
            move.anchor_distance.value_or(0.0) * Vec3(std::sin(azimuth), std::cos(azimuth), 0.0);
  }
  place.z() = bed.height(place.x(), place.y());
  return place;
}

/// Finds the equilibrium of the hull with one line at a given tension and the others at constant length: length by the
/// secant method, with the hull's equilibrium at each.
void solve_at_tension(MooredHull& moored, std::size_t index, double tension) {
  MooredLine& line = moored.spread.lines[index];
  const auto set_length = [&] {
    const HullPlace place = make_hull_place(moored.hull, moored.rest.offset);
    const Vec3 fairlead = place.p_W + place.R_WV * line.fairlead_V;
    return set_length_for_tension(line.line, line_site(moored.spread, line, fairlead),
                                  line_direction(line, fairlead).distance, tension)
        .error;
  };
  if (set_length() != CatenaryError::none) {
    moored.rest.error = fmt::format("mooring line \"{}\": no length of its first segment gives a tension of {}",
                                    line.name, shown(tension, "N", 1));
    return;
  }
  double before = line.line.first_segment(), miss_before = 0.0;
  for (int round = 0; round < kMaxRounds; ++round) {
    find_pose(moored);
    if (moored.rest.error) return;
    const double length = line.line.first_segment(), miss = moored.rest.lines[index].tension() - tension;
    if (std::abs(miss) <= kSettled * tension) return;
    const double slope = round == 0 ? 0.0 : (miss - miss_before) / (length - before);
    before = length;
    miss_before = miss;
    if (slope < 0.0) {
      line.line.set_first_segment(length - miss / slope);
    } else if (set_length() != CatenaryError::none) {
      break;
    }
  }
  moored.rest.error = fmt::format("mooring line \"{}\": no equilibrium of the hull was found at a tension of {}",
                                  line.name, shown(tension, "N", 1));
}

}  // namespace

std::vector<AnchorStage> anchor_stages(const Model& model, const MooredHull& start) {
  const AnchorMoveDescription& move = model.description.operation.anchor;
  std::vector<AnchorStage> stages;
  MooredHull moored = start;
  const auto named = std::find_if(moored.spread.lines.begin(), moored.spread.lines.end(),
                                  [&](const MooredLine& line) { return line.name == move.line; });
  if (named == moored.spread.lines.end()) return stages;
  const std::size_t index = static_cast<std::size_t>(named - moored.spread.lines.begin());
  MooredLine& line = moored.spread.lines[index];
  const auto at_tension = [&](const std::string& name, double tension) {
    solve_at_tension(moored, index, tension);
    stages.push_back({name, moored});
    return !moored.rest.error;
  };
  const double working = move.working_tension.value_or(start.rest.lines[index].tension());
  if (!at_tension("slackened", move.handling_tension)) return stages;
  line.parted = true;
  find_pose(moored);
  stages.push_back({"anchor up", moored});
  if (moored.rest.error) return stages;
  line.parted = false;
  line.anchor_W = new_place(model, move, line.fairlead_V, moored.spread.bed);
  moored.rest.lines[index] = {};
  if (!at_tension("anchor at its new place", move.handling_tension)) return stages;
  if (!at_tension("hauled to working tension", working)) return stages;
  if (move.test_tension) at_tension("holding test", *move.test_tension);
  return stages;
}

}  // namespace overbend
