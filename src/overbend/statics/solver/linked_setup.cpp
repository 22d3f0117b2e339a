// System of lines attached to each other, with its initial shape.
#include <algorithm>

#include "base/ranges.h"
#include "model/bodies.h"
#include "statics/initial_shape/cable_shape.h"
#include "statics/initial_shape/lying_shape.h"
#include "statics/solver/linked_lines.h"

namespace overbend {
namespace {

std::size_t to_size(int i) {
  return static_cast<std::size_t>(i);
}

std::size_t find_line_index(const std::vector<FreeLineDescription>& lines, const std::string& name) {
  return static_cast<std::size_t>(ranges::find(lines, name, &FreeLineDescription::name) - lines.begin());
}

/// Builds the system line by line; the lines that a line is attached to come first.
class LinkedSetup {
 public:
  explicit LinkedSetup(const Model& model) : model_(model), lines_(model.description.lines), made_(lines_.size()) {
    setup_.lines.assign(lines_.size(), -1);
    setup_.wires.assign(lines_.size(), -1);
    int count = 0;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (!is_wire(lines_[i])) setup_.lines[i] = count++;
    }
    setup_.system.bodies.resize(1 + model.description.bodies.size());
    setup_.system.lines.resize(to_size(count));
    setup_.system.attachments.resize(2 * to_size(count));
    setup_.start.resize(to_size(count));
  }

  LinesSetup make() {
    for (bool more = true; more;) {
      more = false;
      for (std::size_t i = 0; i < lines_.size(); ++i) {
        if (made_[i] || !is_placed(lines_[i].first) || !is_placed(lines_[i].second)) continue;
        add(i);
        made_[i] = more = true;
      }
    }
    put_surroundings();
    return std::move(setup_);
  }

 private:
  static bool is_wire(const FreeLineDescription& line) { return !has_pipe_section(line) && is_weightless(line); }

  /// True if the position of an end's attachment is known.
  bool is_placed(const LineEndDescription& end) const {
    return end.kind != LineEndKind::line || made_[find_line_index(lines_, end.line)];
  }

  std::vector<double> attached_arc_lengths(const std::string& name) const {
    std::vector<double> places;
    for (const FreeLineDescription& other_line : lines_) {
      for (const LineEndDescription* end : {&other_line.first, &other_line.second}) {
        if (end->kind == LineEndKind::line && end->line == name) places.push_back(end->arc_length);
      }
    }
    return places;
  }

  void add(std::size_t i) {
    const FreeLineDescription& line = lines_[i];
    if (is_wire(line)) {
      add_wire(i);
    } else if (line.first.kind == LineEndKind::free || line.second.kind == LineEndKind::free) {
      add_lying(i);
    } else {
      add_suspended(i);
    }
  }

  CableParts make_parts(const FreeLineDescription& line) const {
    return {line.segments, line.points, attached_arc_lengths(line.name)};
  }

  /// Initial shape straight from the held end, or from the line's start: along the bed, or level if it is held above
  /// the bed.
  void add_lying(std::size_t i) {
    const FreeLineDescription& line = lines_[i];
    const CableParts parts = make_parts(line);
    const bool first_free = line.first.kind == LineEndKind::free && line.second.kind != LineEndKind::free;
    const LineEndDescription& held = first_free ? line.second : line.first;
    const Vec3 place = held.kind == LineEndKind::free ? *line.start : end_point(held);
    const double sense = first_free ? -1.0 : 1.0;  // sign of the direction from the held end along the line
    Vec3 direction = model_.nominal_pose.R_WV * Vec3::UnitX() * -sense;
    if (held.clamped) {
      direction = held.direction;
    } else if (line.start && held.kind != LineEndKind::free) {
      direction = sense * (*line.start - place);
    }
    direction.z() = 0.0;
    direction.normalize();
    const double length = parts.length();
    const Vec3 far_end = place + sense * length * direction;
    Line& made = put_line(i, cable_line(model_, parts, make_mesh_requirements(model_, line, parts),
                                        first_free ? far_end : place, first_free ? place : far_end));
    const bool lies = held.kind == LineEndKind::bed || held.kind == LineEndKind::free;
    setup_.start[to_size(setup_.lines[i])] =
        lies ? lying_shape(model_, made, place, direction, first_free ? length : 0.0)
             : level_shape(made, place, direction, first_free ? length : 0.0);
    attach_ends(i);
  }

  void add_suspended(std::size_t i) {
    const FreeLineDescription& line = lines_[i];
    CableParts parts = make_parts(line);
    const Vec3 first = end_point(line.first), second = end_point(line.second);
    if (!parts.has_pipe() && is_linked(line)) {
      lengthen(parts, slack_length(unstressed_length(line), (second - first).norm()));
    }
    const CableShape start = make_cable_shape(model_, parts, first, second);
    CableMesh mesh = make_mesh_requirements(model_, line, parts);
    mesh.touchdown = start.touchdown();
    Line& made = put_line(i, cable_line(model_, parts, mesh, first, second));
    setup_.start[to_size(setup_.lines[i])] = start.shape(made.mesh);
    attach_ends(i);
  }

  void add_wire(std::size_t i) {
    const FreeLineDescription& line = lines_[i];
    Wire wire;
    wire.name = line.name;
    const auto put_end = [&](const LineEndDescription& end, int& body, Vec3& place) {
      body = find_or_add_body(end);
      place = body == kGround ? end_point(end) : end.kind == LineEndKind::line ? Vec3(Vec3::Zero()) : end.at;
    };
    put_end(line.first, wire.first_body, wire.first);
    put_end(line.second, wire.second_body, wire.second);
    wire.length = slack_length(unstressed_length(line), (end_point(line.second) - end_point(line.first)).norm());
    wire.axial_stiffness = axial_stiffness(line);
    setup_.wires[i] = static_cast<int>(setup_.system.wires.size());
    setup_.system.wires.push_back(wire);
  }

  /// Length at which a wire is slack while the pipe lies on the bed.
  static double slack_length(double drawn, double span) { return std::max(drawn, 1.001 * span); }

  static void lengthen(CableParts& parts, double length) {
    const double share = length / parts.length();
    for (LineSegmentDescription& segment : parts.segments) segment.length = share * segment.length.value();
    for (LinePointDescription& point : parts.points) point.at *= share;
    for (double& place : parts.attached) place *= share;
  }

  Line& put_line(std::size_t i, Line line) {
    Line& made = setup_.system.lines[to_size(setup_.lines[i])];
    made = std::move(line);
    made.name = lines_[i].name;
    return made;
  }

  Vec3 end_point(const LineEndDescription& end) {
    return end.kind == LineEndKind::line ? setup_.system.bodies[to_size(find_or_add_body(end))].free->rest.h.head<3>()
                                         : end_place(model_, end);
  }

  /// Body to which an end is attached; created as a point of the other line if necessary.
  int find_or_add_body(const LineEndDescription& end) {
    if (end.kind == LineEndKind::body) return static_cast<int>(body_index(model_.description, end.body));
    if (end.kind != LineEndKind::line) return kGround;
    const int line = setup_.lines[find_line_index(lines_, end.line)];
    const Line& of = setup_.system.lines[to_size(line)];
    const int node = node_at(of.mesh, end.arc_length);
    for (const Attachment& held : setup_.system.attachments) {
      if (held.end == LineEnd::inner && held.line == line && held.node == node) return held.body;
    }
    Attachment& held = setup_.system.attachments.emplace_back();
    held.line = line;
    held.end = LineEnd::inner;
    held.node = node;
    held.hold_place = true;
    held.body = static_cast<int>(setup_.system.bodies.size());
    const double* q = setup_.start[to_size(line)].data() + 6 * node;
    setup_.system.bodies.emplace_back().free = free_point(Eigen::Map<const Vec3>(q), of.force_scale);
    return held.body;
  }

  void attach_ends(std::size_t i) {
    const std::size_t line = to_size(setup_.lines[i]);
    const std::vector<double>& q = setup_.start[line];
    setup_.system.attachments[2 * line] = attachment(i, lines_[i].first, LineEnd::first, q.data());
    setup_.system.attachments[2 * line + 1] = attachment(i, lines_[i].second, LineEnd::last, q.data() + q.size() - 6);
  }

  Attachment attachment(std::size_t i, const LineEndDescription& end, LineEnd which, const double* q) {
    Attachment held;
    held.line = setup_.lines[i];
    held.end = which;
    if (end.kind == LineEndKind::free) return held;
    const Vec3 place = Eigen::Map<const Vec3>(q), tangent = Eigen::Map<const Vec3>(q + 3);
    held.hold_place = true;
    held.body = find_or_add_body(end);
    held.place = end.kind == LineEndKind::body                                 ? end.at
                 : end.kind == LineEndKind::line                               ? Vec3(Vec3::Zero())
                 : end.kind == LineEndKind::bed && has_pipe_section(lines_[i]) ? place
                                                                               : end_place(model_, end);
    held.hold_direction = end.clamped;
    if (!end.clamped) return held;
    held.direction = end.direction.normalized();
    if (end.kind == LineEndKind::bed && has_pipe_section(lines_[i])) {  // it lies on the bed in equilibrium
      held.direction = tangent.normalized();
      held.free_along = model_.seabed.surface.normal(place.x(), place.y());
    }
    return held;
  }

  void put_surroundings() {
    setup_.system.surroundings = static_surroundings(body_poses(model_), setup_.system.attachments);
  }

  const Model& model_;
  const std::vector<FreeLineDescription>& lines_;
  std::vector<bool> made_;
  LinesSetup setup_;
};

}  // namespace

LinesSetup linked_lines_setup(const Model& model) {
  return LinkedSetup(model).make();
}

}  // namespace overbend
