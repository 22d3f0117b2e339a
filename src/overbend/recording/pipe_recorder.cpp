#include "recording/pipe_recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/ranges.h"
#include "mechanics/contact_damage.h"
#include "mechanics/rod_element.h"
#include "recording/pipe_recorder_layout.h"
#include "system/cut_forces.h"

namespace overbend {
namespace {

Vec3 node_place(const LineState& state, int node) {
  return Vec3(Eigen::Map<const Vec3>(state.q.data() + 6 * node));
}

/// Horizontal component of the total force in the cut at a node [N].
double horizontal_tension_at(const Instant& instant, int node) {
  const LineState& state = instant.pipe();
  const CutForces cut = cut_at_node(instant.pipe_assembly().cuts(), state.q, static_cast<std::size_t>(node));
  return horizontal_tension(cut.force, Eigen::Map<const Vec3>(state.q.data() + 6 * node + 3));
}

double inclination(const Vec3& t) {
  return std::atan2(t.z(), std::hypot(t.x(), t.y()));
}

/// Tangent of the centreline at arc length `s`.
Vec3 tangent_at(const LineState& state, const LineMesh& mesh, double s) {
  const auto after = std::upper_bound(mesh.s.begin() + 1, mesh.s.end() - 1, s);
  const std::size_t e = static_cast<std::size_t>(after - mesh.s.begin()) - 1;
  const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
  return centreline(q, std::clamp((s - mesh.s[e]) / mesh.length[e], 0.0, 1.0), mesh.length[e]).a.normalized();
}

/// Direction of tension of a cable without bending stiffness at a roller: the mean of the directions on both sides,
/// from the loads along its element up to there.
Vec3 pull_at(const LineAssembly& line, const LineState& state, const RollerContact& roller) {
  const std::size_t e = static_cast<std::size_t>(roller.closest.element);
  Vec3 pull = cut_at_node(line.cuts(), state.q, e).force;
  Vec3 spread = pull - cut_at_node(line.cuts(), state.q, e + 1).force;
  for (const RollerContact& contact : line.contacts().contacts()) {
    if (!(contact.normal > 0.0) || contact.closest.element != roller.closest.element) continue;
    spread -= contact.force();
    if (contact.closest.xi < roller.closest.xi) pull -= contact.force();
  }
  return pull - 0.5 * roller.force() - roller.closest.xi * spread;
}

/// Clear distance of pipe and roller [m]; NaN if the pipe does not pass the roller.
double separation(const RollerContact& contact) {
  return contact.closest.found ? -contact.penetration : std::numeric_limits<double>::quiet_NaN();
}

void keep_peak(RegionPeak& peak, double value, double s, double time) {
  peak.present = std::max(peak.present, value);
  if (time > 0.0 && value > peak.maximum) {
    peak.maximum = value;
    peak.s = s;
    peak.time = time;
  }
}

int last_stinger_roller(const Supports& supports) {
  for (std::size_t row = supports.rows.size(); row-- > 0;) {
    if (supports.boxes[static_cast<std::size_t>(supports.rows[row].box)].structure == Structure::stinger) {
      return supports.rows[row].first_roller;
    }
  }
  return -1;
}

/// Returns the motion of the carrier of a box: the vessel, or its section of a moving stinger, whose body follows the
/// vessel's.
const RigidMotion& find_carrier(const Instant& instant, const SupportBox& box) {
  if (box.section < 0 || instant.assembly->hinged().empty()) {
    return instant.vessel();
  }
  return instant.assembly->surroundings().bodies[static_cast<std::size_t>(box.section) + 1];
}

}  // namespace

PipeRecorder::PipeRecorder(const Model& model, const StaticResults& statics, const Simulation& simulation)
    : model_(&model),
      statics_(&statics),
      line_(&simulation.system().lines[find_laid_pipe(simulation.system()).value().line]),
      body_rollers_(&simulation.rollers()),
      recovery_(model, *line_, simulation.move() != nullptr),
      design_(model, recovery_.sections()),
      move_(simulation.move()),
      tip_roller_(last_stinger_roller(model.supports)),
      rollers_(model.supports.rollers.size()),
      boxes_(model.supports.boxes.size()),
      tensioner_(*simulation.system().attachments[find_laid_pipe(simulation.system()).value().tensioner].tensioner),
      stinger_(model),
      start_(model, simulation.options().build_up, move_ != nullptr || simulation.controllers().active()) {
  const std::vector<double>& s = places();
  first_ = static_cast<std::size_t>(std::lower_bound(s.begin(), s.end(), 0.0) - s.begin());
  nodes_.resize(s.size());
  if (model.description.fatigue) fatigue_.emplace(model, recovery_.sections(), first_);
  support_sample_.resize(kBoxQuantities * boxes_ + kRollerQuantities * rollers_);
  key_sample_.resize(kKeyQuantities);
  node_statistics_ = RunningStatistics(kNodeQuantities * (s.size() - first_));
  support_statistics_ = RunningStatistics(support_sample_.size());
  key_statistics_ = RunningStatistics(key_sample_.size());
  reaction_sample_.resize(boxes_);
  reaction_quantiles_ = RunningQuantiles(boxes_);
  impacts_.resize(rollers_);
  departures_.resize(boxes_);
  max_reaction_.assign(boxes_, 0.0);
  min_separation_.assign(boxes_, std::numeric_limits<double>::infinity());
  max_key_.assign(kKeyQuantities, -std::numeric_limits<double>::infinity());
  min_key_.assign(kKeyQuantities, std::numeric_limits<double>::infinity());
  key_.slack.maximum = -kNever;
  hardest_.reserve(kHardestImpacts + 1);
}

/// Passes the effect of the current on the static state to the checks.
void PipeRecorder::pass_current_effect() {
  if (!has_current_part(*statics_)) return;
  std::vector<CurrentPart> parts;
  for (const double s : places()) parts.push_back(current_part(*statics_, s));
  design_.set_current(std::move(parts));
}

void PipeRecorder::start(const Instant& instant) {
  pass_current_effect();
  if (const RollerContact* last = last_contact(instant)) static_departure_ = contact_position(*last);
  recover(instant);
  static_nodes_ = nodes_;
  static_supports_ = support_sample_;
  design_.start(design_instant(instant));
  if (fatigue_) fatigue_->start(design_instant(instant));
  stinger_.start(*instant.assembly);
  start_.start(nodes_, instant.vessel().pose);
}

DesignInstant PipeRecorder::design_instant(const Instant& instant) const {
  return {nodes_,
          recovery_.moments(),
          recovery_.tangents(),
          recovery_.station_of_node(),
          instant.contacts(),
          instant.state->time};
}

void PipeRecorder::recover(const Instant& instant) {
  recovery_.recover(instant, nodes_);
  find_key_values(instant);
  find_support_values(instant);
  find_left_boxes(instant);
  for (std::size_t i = 0; i < kKeyQuantities; ++i) {
    max_key_[i] = std::max(max_key_[i], key_sample_[i]);
    min_key_[i] = std::min(min_key_[i], key_sample_[i]);
  }
}

void PipeRecorder::find_key_values(const Instant& instant) {
  const LineState& state = instant.pipe();
  const int top = line_->mesh.nodes() - 1;
  key_.top_tension = nodes_.effective_tension.back();
  const SeabedSurface& bed = model_->seabed.surface;
  const double radius = line_->elements.radius[0];
  const auto clearance = [&](int node) { return bed.clearance(node_place(state, node)) - radius; };
  int touchdown = 0;
  for (int node = top; node > 0; --node) {
    if (clearance(node) <= 0.0) {
      touchdown = node;
      break;
    }
  }
  Vec3 landing = node_place(state, touchdown);
  double landing_s = line_->mesh.s[static_cast<std::size_t>(touchdown)];
  key_.bottom_tension = horizontal_tension_at(instant, touchdown);
  if (touchdown > 0 && touchdown < top) {
    const double below = clearance(touchdown), above = clearance(touchdown + 1), share = below / (below - above);
    landing += share * (node_place(state, touchdown + 1) - landing);
    landing_s += share * line_->mesh.length[static_cast<std::size_t>(touchdown)];
    key_.bottom_tension += share * (horizontal_tension_at(instant, touchdown + 1) - key_.bottom_tension);
  }
  const Vec3 shoe = point_from_ramp(*model_, model_->mean_pose, Vec3::Zero()) + instant.move.ahead_W;
  key_.lay_back = (landing - shoe).dot(astern_direction(model_->mean_pose));
  const RollerContact* last = last_contact(instant);
  const std::optional<double> leaving = last != nullptr ? contact_position(*last) : static_departure_;
  key_.departure_angle =
      inclination(last != nullptr && is_cable(*last)
                      ? pull_at(instant.pipe_assembly(), state, *last).normalized()
                      : tangent_at(state, line_->mesh, recovery_.arc_length_at(leaving.value_or(places().back()))));
  key_.tip_clearance = tip_clearance(instant);
  const bool clamped = model_->description.tensioner.guide == Guide::clamped;
  find_region_peaks(find_regions({places(), nodes_.bending_moment, nodes_.vertical_moment},
                                 recovery_.position_at(landing_s), leaving, clamped),
                    instant.state->time);
  find_slack(instant.state->time);
  key_sample_ = {key_.top_tension,        key_.bottom_tension,     key_.lay_back,           key_.departure_angle,
                 key_.tip_clearance,      key_.upper[0].present,   key_.upper[1].present,   key_.upper[2].present,
                 key_.upper[3].present,   key_.sagbend[0].present, key_.sagbend[1].present, key_.sagbend[2].present,
                 key_.sagbend[3].present, -key_.slack.present};
}

/// Position of a contact along the line [m].
double PipeRecorder::contact_position(const RollerContact& contact) const {
  const std::size_t e = static_cast<std::size_t>(contact.closest.element);
  return recovery_.position_at(line_->mesh.s[e] + contact.closest.xi * line_->mesh.length[e]);
}

bool PipeRecorder::is_cable(const RollerContact& contact) const {
  const int section = line_->mesh.section[static_cast<std::size_t>(contact.closest.element)];
  return model_->sections[static_cast<std::size_t>(section)].kind == SectionKind::cable;
}

/// Returns the last contact with a support, seen from the top; null if the pipe has lifted off all supports.
const RollerContact* PipeRecorder::last_contact(const Instant& instant) const {
  const RollerContact* last = nullptr;
  for (const RollerContact& contact : instant.contacts()) {
    if (contact.normal > 0.0 && (last == nullptr || contact_position(contact) < contact_position(*last))) {
      last = &contact;
    }
  }
  return last;
}

void PipeRecorder::find_region_peaks(const Regions& regions, double time) {
  const std::vector<double>* quantity[kRegionQuantities] = {&nodes_.bending_moment, &nodes_.bending_stress,
                                                            &nodes_.von_mises, &nodes_.strain};
  for (std::size_t i = 0; i < kRegionQuantities; ++i) {
    key_.upper[i].present = key_.sagbend[i].present = 0.0;
  }
  const auto built_in = [&](std::size_t node) {  // not pipe: excluded from maxima
    const std::size_t section = static_cast<std::size_t>(recovery_.sections()[node]);
    return model_->sections[section].kind == SectionKind::structure;
  };
  for (std::size_t node = 0; node < nodes_.x.size(); ++node) {
    const double s = places()[node];
    const Region region = regions.of(s);
    if (region == Region::seabed || built_in(node)) continue;
    RegionPeak* peaks = region == Region::sagbend ? key_.sagbend : key_.upper;
    for (std::size_t i = 0; i < kRegionQuantities; ++i) {
      keep_peak(peaks[i], (*quantity[i])[node], s, time);
    }
  }
  // On an edge of an uneven seabed the maximum bending of the sagbend is at its end, between two nodes.
  const auto after = ranges::upper_bound(places(), regions.touchdown);
  if (after == places().begin() || after == places().end()) return;
  const std::size_t upper = static_cast<std::size_t>(after - places().begin()), lower = upper - 1;
  if (built_in(upper) || built_in(lower)) return;
  const double share = (regions.touchdown - places()[lower]) / (*after - places()[lower]);
  for (std::size_t i = 0; i < kRegionQuantities; ++i) {
    const std::vector<double>& values = *quantity[i];
    keep_peak(key_.sagbend[i], values[lower] + share * (values[upper] - values[lower]), regions.touchdown, time);
  }
}

/// Finds the minimum of the effective tension.
void PipeRecorder::find_slack(double time) {
  key_.slack.present = -std::numeric_limits<double>::infinity();
  for (std::size_t node = 0; node < nodes_.x.size(); ++node) {
    keep_peak(key_.slack, -nodes_.effective_tension[node], places()[node], time);
  }
}

/// True if the pipe has left the box of a roller over its side and is not held by a side roller.
bool PipeRecorder::is_past_side(const Instant& instant, std::size_t roller) const {
  const Roller& placed = model_->supports.rollers[roller];
  return has_left_box_sideways(placed.position, instant.pipe_assembly().contacts().placed(static_cast<int>(roller)),
                               instant.contacts()[roller].closest, model_->section_over(placed).outer_radius());
}

/// Clearance over the last row of the stinger, as in statics [m].
double PipeRecorder::tip_clearance(const Instant& instant) const {
  if (tip_roller_ < 0) return 0.0;
  const RollerContact& contact = instant.contacts()[static_cast<std::size_t>(tip_roller_)];
  if (!contact.closest.found || !is_past_side(instant, static_cast<std::size_t>(tip_roller_))) {
    return separation(contact);
  }
  return height_above_roller(instant.pipe_assembly().contacts().placed(tip_roller_), contact.closest,
                             line_->elements.radius[static_cast<std::size_t>(contact.closest.element)]);
}

/// Records when the pipe first left each box, and over which side.
void PipeRecorder::find_left_boxes(const Instant& instant) {
  const VesselPose& pose = instant.vessel().pose;
  for (std::size_t i = 0; i < rollers_; ++i) {
    const ClosestPoint& closest = instant.contacts()[i].closest;
    BoxDeparture& box = departures_[static_cast<std::size_t>(model_->supports.rollers[i].box)];
    if (box.time == kNever && is_past_side(instant, i)) {
      const Vec3& place = closest.found ? closest.place : closest.reference;
      const double to_port = pose.R_WV.col(1).dot(place - pose.p_WV);
      box = {instant.state->time, to_port > 0.0 ? 1.0 : -1.0};
    }
  }
}

void PipeRecorder::find_support_values(const Instant& instant) {
  const Mat3& axes = instant.vessel().pose.R_WV;
  const Vec3 port = axes.col(1);
  const std::vector<Roller>& rollers = model_->supports.rollers;
  double* of_rollers = support_sample_.data() + kBoxQuantities * boxes_;
  std::size_t roller = 0;
  for (std::size_t box = 0; box < boxes_; ++box) {
    const SupportBox& support = model_->supports.boxes[box];
    const Vec3 along = direction_from_ramp(find_carrier(instant, support).pose, support.direction_S);
    Vec3 force = Vec3::Zero();
    double nearest = std::numeric_limits<double>::infinity();
    for (; roller < rollers_ && rollers[roller].box == static_cast<int>(box); ++roller) {
      const RollerContact& contact = instant.contacts()[roller];
      double* out = of_rollers + kRollerQuantities * roller;
      out[0] = contact.normal;
      out[1] = separation(contact);
      out[2] = contact.normal > 0.0 ? 1.0 : 0.0;
      force += contact.force();
      if (rollers[roller].position == RollerPosition::bottom) {
        nearest = std::min(nearest, out[1]);
      }
    }
    min_separation_[box] = std::min(min_separation_[box], nearest);
    double* out = support_sample_.data() + kBoxQuantities * box;
    const double size = force.norm();
    const double values[kBoxQuantities] = {
        size, force.z(), force.dot(along), force.dot(port), or_missing(nearest), size > 0.0 ? 1.0 : 0.0};
    std::copy_n(values, kBoxQuantities, out);
    reaction_sample_[box] = size;
    max_reaction_[box] = std::max(max_reaction_[box], size);
  }
}

void PipeRecorder::add(const Instant& instant) {
  recover(instant);
  tensioner_.add(*instant.tensioner, instant.move.paid_out, instant.state->time, instant.step);
  stinger_.add(*instant.assembly, instant.state->time, instant.step);
  start_.add(nodes_, instant.vessel().pose, instant.state->time);
  crossing_.add(instant.pipe(), instant.state->time, instant.water(), line_->mesh, recovery_.position_at(0.0));
  if (instant.state->time <= 0.0) {
    return;
  }
  if (move_ != nullptr) design_.set_sections(recovery_.sections());
  design_.step(design_instant(instant));
  if (fatigue_) fatigue_->step(design_instant(instant));
  const auto recorded = [&](const std::vector<double>& values) { return std::span(values).subspan(first_); };
  node_statistics_.add_parts(
      {recorded(nodes_.effective_tension), recorded(nodes_.bending_moment), recorded(nodes_.bending_stress),
       recorded(nodes_.von_mises), recorded(nodes_.strain), recorded(nodes_.x), recorded(nodes_.y), recorded(nodes_.z)},
      instant.step);
  support_statistics_.add(support_sample_, instant.step);
  reaction_quantiles_.add(reaction_sample_, instant.step);
  key_statistics_.add(key_sample_, instant.step);
}

void PipeRecorder::fill_row(RowSource& row) const {
  row.key = key_sample_;
  row.max_key = max_key_;
  row.min_key = min_key_;
  row.max_reaction = max_reaction_;
  row.min_separation = min_separation_;
}

void PipeRecorder::reset_interval() {
  std::fill(max_reaction_.begin(), max_reaction_.end(), 0.0);
  std::fill(min_separation_.begin(), min_separation_.end(), std::numeric_limits<double>::infinity());
  std::fill(max_key_.begin(), max_key_.end(), -std::numeric_limits<double>::infinity());
  std::fill(min_key_.begin(), min_key_.end(), std::numeric_limits<double>::infinity());
}

double* PipeRecorder::append_snapshot(double* out) const {
  for (std::size_t node = first_; node < nodes_.x.size(); ++node) {
    const double values[5] = {nodes_.x[node], nodes_.y[node], nodes_.z[node], nodes_.effective_tension[node],
                              nodes_.von_mises[node]};
    out = std::copy_n(values, 5, out);
  }
  return out;
}

Impact PipeRecorder::add_impact(const EndedImpact& ended) {
  Impact impact = ended.impact;
  const Roller& roller = model_->supports.rollers[static_cast<std::size_t>(impact.roller)];
  const Section& pipe = model_->section_over(roller);
  impact.dent_depth = dent_depth(impact.peak_force, pipe);
  impact.line_load =
      line_load(impact.peak_force, contact_length(roller.face, pipe.outer_diameter, pipe.steel_diameter));
  if (impact.time > 0.0) count(impact, ended.box_force);
  return impact;
}

void PipeRecorder::count(const Impact& impact, double box_force) {
  RollerImpacts& sum = impacts_[static_cast<std::size_t>(impact.roller)];
  sum.count += 1.0;
  sum.velocity = std::max(sum.velocity, impact.approach_velocity);
  sum.force = std::max(sum.force, impact.peak_force);
  sum.impulse = std::max(sum.impulse, impact.impulse);
  sum.of_box = std::max(sum.of_box, box_force);
  impact_count_ += 1.0;
  const auto harder = [](const Impact& a, const Impact& b) { return a.peak_force > b.peak_force; };
  hardest_.insert(std::upper_bound(hardest_.begin(), hardest_.end(), impact, harder), impact);
  if (hardest_.size() > kHardestImpacts) {
    hardest_.pop_back();
  }
}

}  // namespace overbend
