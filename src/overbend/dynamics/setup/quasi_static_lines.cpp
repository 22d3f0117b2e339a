#include "dynamics/setup/quasi_static_lines.h"

#include <limits>

namespace overbend {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

CatenarySolution near_solution(const LineEndForces& ends) {
  CatenarySolution near;
  near.pull = ends.pull;
  near.sink = ends.sink;
  return near;
}

/// One line; `one` is a spread of this line only, whose length is set before every use.
class QuasiStaticLine {
 public:
  QuasiStaticLine(const MooredLine& line, const SeabedSurface& bed, LengthTable program)
      : one_{{line}, bed}, length_(line.line.first_segment()), program_(std::move(program)) {}

  PlaceForce operator()(const Vec3& place, double time, const LineEndForces& before) {
    MooredLine& line = one_.lines.front();
    if (!program_.empty()) {
      line.line.set_first_segment(length_ + program_.at(time).length - program_.lengths.front());
    }
    const CatenarySolution near = near_solution(before);
    const LinePull pull = line_pull(one_, line, place, &near);
    const CatenarySolution& found = pull.solution;
    PlaceForce force;
    if (found.error != CatenaryError::none) {
      force.force.setConstant(kNone);
      return force;
    }
    force.force = pull.force_W;
    force.stiffness = pull.stiffness;
    force.ends = {found.pull,         found.sink,         found.anchor_pull, found.anchor_uplift,
                  line.line.length(), found.trace.on_bed, found.anchor_rise};
    return force;
  }

 private:
  MooringSpread one_;
  double length_;  ///< Initial length [m].
  LengthTable program_;
};

}  // namespace

std::vector<BodySpring> quasi_static_lines(const MooringSpread& spread, const std::vector<LengthTable>& programs) {
  std::vector<BodySpring> springs;
  for (std::size_t i = 0; i < spread.lines.size(); ++i) {
    const MooredLine& line = spread.lines[i];
    if (line.parted) continue;
    QuasiStaticLine force(line, spread.bed, i < programs.size() ? programs[i] : LengthTable{});
    springs.push_back({line.fairlead_V, std::move(force), false});
  }
  return springs;
}

}  // namespace overbend
