#include "statics/solver/line_reach.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "model/bodies.h"
#include "model/vessel/mooring_queries.h"

namespace overbend {
namespace {

/// Fixed place, and the length of other lines between it and an end [m].
struct HeldPlace {
  Vec3 place;
  double length_between = 0.0;
};

/// Maximum length of a line relative to its unstressed length [-].
double max_stretch_ratio(const FreeLineDescription& line) {
  constexpr double kPipe = 1.02, kUnknown = 1.5, kMinStretch = 1.01, kOverBreaking = 3.0;
  if (has_pipe_section(line)) return kPipe;
  double max_stretch = kMinStretch;
  for (const LineSegmentDescription& segment : line.segments) {
    if (!segment.type.breaking_load) return kUnknown;
    max_stretch =
        std::max(max_stretch, 1.0 + kOverBreaking * *segment.type.breaking_load / segment.type.axial_stiffness);
  }
  return max_stretch;
}

double drawn_length(const FreeLineDescription& line) {
  return CableParts{line.segments, line.points}.length();
}

class Reach {
 public:
  Reach(const Model& model, const LiftPosition& position)
      : model_(model), lines_(model.description.lines), position_(position), poses_(poses_at(model, position)) {}

  std::optional<StaticFailure> check(std::size_t i) const {
    const FreeLineDescription& line = lines_[i];
    const double length = position_.lengths[i];
    for (const HeldPlace& first : held_places(line.first)) {
      for (const HeldPlace& second : held_places(line.second)) {
        const double apart = (second.place - first.place).norm(), others = first.length_between + second.length_between;
        if (position_.tensions[i] || apart <= max_stretch_ratio(line) * length + others) continue;
        const std::string along =
            others > 0.0 ? fmt::format(" plus {} of the straight line to which it is attached", shown(others, "m", 2))
                         : "";
        return StaticFailure{fmt::format("line \"{}\" cannot reach: it is {} long{}, its ends are held {} apart",
                                         line.name, shown(length, "m", 2), along, shown(apart, "m", 2)),
                             "", "make it longer, or move its ends closer together", true, fmt::format("lines[{}]", i)};
      }
    }
    return std::nullopt;
  }

 private:
  /// True if the position of an end is known: neither free nor on a vessel that floats freely.
  bool has_known_position(const LineEndDescription& end) const {
    return end.kind != LineEndKind::free && !(is_on_vessel(end) && hull_is_free(model_.description));
  }

  /// For an end on another line, returns the held ends of that line.
  std::vector<HeldPlace> held_places(const LineEndDescription& end) const {
    if (!has_known_position(end)) return {};
    if (end.kind != LineEndKind::line) return {{held_place(end), 0.0}};
    const auto other_line = ranges::find(lines_, end.line, &FreeLineDescription::name);
    const double drawn = drawn_length(*other_line);
    const double stretched = max_stretch_ratio(*other_line) *
                             position_.lengths[static_cast<std::size_t>(other_line - lines_.begin())] / drawn;
    std::vector<HeldPlace> places;
    for (const auto& [held, span] :
         {std::pair{&other_line->first, end.arc_length}, {&other_line->second, drawn - end.arc_length}}) {
      if (!has_known_position(*held) || held->kind == LineEndKind::line) continue;
      places.push_back({held_place(*held), stretched * span});
    }
    return places;
  }

  Vec3 held_place(const LineEndDescription& end) const {
    if (end.kind != LineEndKind::body) return end_place(model_, end);
    const VesselPose& pose = poses_[body_index(model_.description, end.body)];
    return pose.p_WV + pose.R_WV * end.at;
  }

  const Model& model_;
  const std::vector<FreeLineDescription>& lines_;
  const LiftPosition& position_;
  std::vector<VesselPose> poses_;
};

}  // namespace

std::optional<StaticFailure> reach_failure(const Model& model, const LiftPosition& position) {
  const Reach reach(model, position);
  for (std::size_t i = 0; i < model.description.lines.size(); ++i) {
    if (std::optional<StaticFailure> failure = reach.check(i)) return failure;
  }
  return std::nullopt;
}

}  // namespace overbend
