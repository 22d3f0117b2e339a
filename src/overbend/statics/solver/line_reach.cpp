#include "statics/solver/line_reach.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/shown_unit.h"
#include "model/bodies.h"
#include "model/vessel/station.h"

namespace overbend {
namespace {

/// A place that does not move, and the length of other lines that lies between it and an end [m].
struct HeldPlace {
  Vec3 place;
  double way = 0.0;
};

/// Longest a line gets, over its unstressed length [-].
double longest_stretch(const FreeLineDescription& line) {
  constexpr double kPipe = 1.02, kUnknown = 1.5, kLeast = 1.01, kOverBreaking = 3.0;
  if (has_pipe_section(line)) return kPipe;
  double most = kLeast;
  for (const LineSegmentDescription& segment : line.segments) {
    if (!segment.type.breaking_load) return kUnknown;
    most = std::max(most, 1.0 + kOverBreaking * *segment.type.breaking_load / segment.type.axial_stiffness);
  }
  return most;
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
        const double apart = (second.place - first.place).norm(), others = first.way + second.way;
        if (position_.tensions[i] || apart <= longest_stretch(line) * length + others) continue;
        const std::string along =
            others > 0.0 ? fmt::format(" with {} of the line it is on, straight", shown(others, "m", 2)) : "";
        return StaticFailure{
            fmt::format("line \"{}\" cannot reach: it is {} long{}, the places that hold it are {} apart", line.name,
                        shown(length, "m", 2), along, shown(apart, "m", 2)),
            "", "make it longer, or bring what holds it nearer", true, fmt::format("lines[{}]", i)};
      }
    }
    return std::nullopt;
  }

 private:
  /// Whether an end is somewhere: neither free nor on a vessel that floats to where its lines let it.
  bool stays(const LineEndDescription& end) const {
    return end.kind != LineEndKind::free && !(is_on_vessel(end) && hull_is_free(model_.description));
  }

  /// Of an end on another line: by way of it the ends of that one which are held.
  std::vector<HeldPlace> held_places(const LineEndDescription& end) const {
    if (!stays(end)) return {};
    if (end.kind != LineEndKind::line) return {{held_place(end), 0.0}};
    const auto other = std::ranges::find(lines_, end.line, &FreeLineDescription::name);
    const double drawn = drawn_length(*other);
    const double stretched =
        longest_stretch(*other) * position_.lengths[static_cast<std::size_t>(other - lines_.begin())] / drawn;
    std::vector<HeldPlace> places;
    for (const auto& [held, way] :
         {std::pair{&other->first, end.arc_length}, {&other->second, drawn - end.arc_length}}) {
      if (!stays(*held) || held->kind == LineEndKind::line) continue;
      places.push_back({held_place(*held), stretched * way});
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
