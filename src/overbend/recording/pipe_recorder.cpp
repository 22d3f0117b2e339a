#include "recording/pipe_recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/contact_damage.h"
#include "mechanics/rod_element.h"
#include "recording/pipe_recorder_layout.h"
#include "system/cut_forces.h"

namespace overbend {
namespace {

Vec3 node_place(const LineState& state, int node) {
  return Vec3(Eigen::Map<const Vec3>(state.q.data() + 6 * node));
}

/// Of the whole force in the cut at a node.
double horizontal_tension_at(const Instant& at, int node) {
  const LineState& state = at.pipe();
  const CutForces cut = cut_at_node(at.pipe_assembly().cuts(), state.q, static_cast<std::size_t>(node));
  return horizontal_tension(cut.force, Eigen::Map<const Vec3>(state.q.data() + 6 * node + 3));
}

double inclination(const Vec3& t) {
  return std::atan2(t.z(), std::hypot(t.x(), t.y()));
}

/// Of the centreline at arc length `s`, the tangent.
Vec3 tangent_at(const LineState& state, const LineMesh& mesh, double s) {
  const auto after = std::upper_bound(mesh.s.begin() + 1, mesh.s.end() - 1, s);
  const std::size_t e = static_cast<std::size_t>(after - mesh.s.begin()) - 1;
  const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
  return centreline(q, std::clamp((s - mesh.s[e]) / mesh.length[e], 0.0, 1.0), mesh.length[e]).a.normalized();
}

/// How a cable without bending stiffness is pulled where it meets a roller: between the directions either side of it,
/// by what works along its element up to there.
Vec3 pull_at(const LineAssembly& line, const LineState& state, const RollerContact& roller) {
  const std::size_t e = static_cast<std::size_t>(roller.at.element);
  Vec3 pull = cut_at_node(line.cuts(), state.q, e).force;
  Vec3 spread = pull - cut_at_node(line.cuts(), state.q, e + 1).force;
  for (const RollerContact& other : line.contacts().contacts()) {
    if (!(other.normal > 0.0) || other.at.element != roller.at.element) continue;
    spread -= other.force();
    if (other.at.xi < roller.at.xi) pull -= other.force();
  }
  return pull - 0.5 * roller.force() - roller.at.xi * spread;
}

/// Clear distance of pipe and roller; not a number where the pipe does not pass it [m].
double separation(const RollerContact& contact) {
  return contact.at.found ? -contact.penetration : std::numeric_limits<double>::quiet_NaN();
}

void keep_peak(RegionPeak& peak, double value, double s, double time) {
  peak.now = std::max(peak.now, value);
  if (time > 0.0 && value > peak.largest) {
    peak.largest = value;
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

/// What carries a box: the vessel, or its section of a stinger that turns in time, whose body follows the vessel's.
const RigidMotion& carrier_of(const Instant& at, const SupportBox& box) {
  if (box.section < 0 || at.assembly->hinged().empty()) {
    return at.vessel();
  }
  return at.assembly->surroundings().bodies[static_cast<std::size_t>(box.section) + 1];
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
  left_.resize(boxes_);
  largest_reaction_.assign(boxes_, 0.0);
  least_separation_.assign(boxes_, std::numeric_limits<double>::infinity());
  largest_key_.assign(kKeyQuantities, -std::numeric_limits<double>::infinity());
  least_key_.assign(kKeyQuantities, std::numeric_limits<double>::infinity());
  key_.slack.largest = -kNever;
  hardest_.reserve(kHardestImpacts + 1);
}

/// Tells the checks what the current adds to the static state.
void PipeRecorder::tell_current() {
  if (!tells_current(*statics_)) return;
  std::vector<CurrentPart> parts;
  for (const double s : places()) parts.push_back(current_part(*statics_, s));
  design_.set_current(std::move(parts));
}

void PipeRecorder::start(const Instant& at) {
  tell_current();
  if (const RollerContact* last = last_contact(at)) static_departure_ = place_of(*last);
  recover(at);
  static_nodes_ = nodes_;
  static_supports_ = support_sample_;
  design_.start(design_instant(at));
  if (fatigue_) fatigue_->start(design_instant(at));
  stinger_.start(*at.assembly);
  start_.start(nodes_, at.vessel().pose);
}

DesignInstant PipeRecorder::design_instant(const Instant& at) const {
  return {nodes_,        recovery_.moments(), recovery_.tangents(), recovery_.station_of_node(),
          at.contacts(), at.state->time};
}

void PipeRecorder::recover(const Instant& at) {
  recovery_.recover(at, nodes_);
  find_key_values(at);
  find_support_values(at);
  find_passed(at);
  for (std::size_t i = 0; i < kKeyQuantities; ++i) {
    largest_key_[i] = std::max(largest_key_[i], key_sample_[i]);
    least_key_[i] = std::min(least_key_[i], key_sample_[i]);
  }
}

void PipeRecorder::find_key_values(const Instant& at) {
  const LineState& state = at.pipe();
  const int top = line_->mesh.nodes() - 1;
  key_.top_tension = nodes_.effective_tension.back();
  const BedSurface& bed = model_->seabed.surface;
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
  key_.bottom_tension = horizontal_tension_at(at, touchdown);
  if (touchdown > 0 && touchdown < top) {
    const double below = clearance(touchdown), above = clearance(touchdown + 1), share = below / (below - above);
    landing += share * (node_place(state, touchdown + 1) - landing);
    landing_s += share * line_->mesh.length[static_cast<std::size_t>(touchdown)];
    key_.bottom_tension += share * (horizontal_tension_at(at, touchdown + 1) - key_.bottom_tension);
  }
  const Vec3 shoe = point_from_ramp(*model_, model_->mean_pose, Vec3::Zero()) + at.move.ahead_W;
  key_.lay_back = (landing - shoe).dot(astern_direction(model_->mean_pose));
  const RollerContact* last = last_contact(at);
  const std::optional<double> leaving = last != nullptr ? place_of(*last) : static_departure_;
  key_.departure_angle =
      inclination(last != nullptr && is_cable(*last)
                      ? pull_at(at.pipe_assembly(), state, *last).normalized()
                      : tangent_at(state, line_->mesh, recovery_.arc_length_of(leaving.value_or(places().back()))));
  key_.tip_clearance = tip_clearance(at);
  const bool clamped = model_->description.tensioner.guide == Guide::clamped;
  find_region_peaks(find_regions({places(), nodes_.bending_moment, nodes_.vertical_moment},
                                 recovery_.place_of(landing_s), leaving, clamped),
                    at.state->time);
  find_slack(at.state->time);
  key_sample_ = {key_.top_tension,    key_.bottom_tension, key_.lay_back,       key_.departure_angle,
                 key_.tip_clearance,  key_.upper[0].now,   key_.upper[1].now,   key_.upper[2].now,
                 key_.upper[3].now,   key_.sagbend[0].now, key_.sagbend[1].now, key_.sagbend[2].now,
                 key_.sagbend[3].now, -key_.slack.now};
}

/// Place of a contact along the line.
double PipeRecorder::place_of(const RollerContact& contact) const {
  const std::size_t e = static_cast<std::size_t>(contact.at.element);
  return recovery_.place_of(line_->mesh.s[e] + contact.at.xi * line_->mesh.length[e]);
}

bool PipeRecorder::is_cable(const RollerContact& contact) const {
  const int section = line_->mesh.section[static_cast<std::size_t>(contact.at.element)];
  return model_->sections[static_cast<std::size_t>(section)].kind == SectionKind::cable;
}

/// The last contact with a support, seen from the top; null where the pipe has jumped off all of them.
const RollerContact* PipeRecorder::last_contact(const Instant& at) const {
  const RollerContact* last = nullptr;
  for (const RollerContact& contact : at.contacts()) {
    if (contact.normal > 0.0 && (last == nullptr || place_of(contact) < place_of(*last))) last = &contact;
  }
  return last;
}

void PipeRecorder::find_region_peaks(const Regions& regions, double time) {
  const std::vector<double>* quantity[kRegionQuantities] = {&nodes_.bending_moment, &nodes_.bending_stress,
                                                            &nodes_.von_mises, &nodes_.strain};
  for (std::size_t i = 0; i < kRegionQuantities; ++i) {
    key_.upper[i].now = key_.sagbend[i].now = 0.0;
  }
  const auto built_in = [&](std::size_t node) {  // no pipe: its stresses are in no maximum
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
  // On an edge of an uneven bed the sagbend is bent most where it ends, between two nodes.
  const auto after = std::ranges::upper_bound(places(), regions.touchdown);
  if (after == places().begin() || after == places().end()) return;
  const std::size_t upper = static_cast<std::size_t>(after - places().begin()), lower = upper - 1;
  if (built_in(upper) || built_in(lower)) return;
  const double share = (regions.touchdown - places()[lower]) / (*after - places()[lower]);
  for (std::size_t i = 0; i < kRegionQuantities; ++i) {
    const std::vector<double>& values = *quantity[i];
    keep_peak(key_.sagbend[i], values[lower] + share * (values[upper] - values[lower]), regions.touchdown, time);
  }
}

/// Where the effective tension is least.
void PipeRecorder::find_slack(double time) {
  key_.slack.now = -std::numeric_limits<double>::infinity();
  for (std::size_t node = 0; node < nodes_.x.size(); ++node) {
    keep_peak(key_.slack, -nodes_.effective_tension[node], places()[node], time);
  }
}

/// Whether the pipe has left the box of a roller over its side: then that no longer holds it, and no side roller did.
bool PipeRecorder::beside(const Instant& at, std::size_t roller) const {
  const Roller& of = model_->supports.rollers[roller];
  return lies_beside(of.position, at.pipe_assembly().contacts().placed(static_cast<int>(roller)),
                     at.contacts()[roller].at, model_->section_over(of).outer_radius());
}

/// Over the last row of the stinger, as in statics.
double PipeRecorder::tip_clearance(const Instant& at) const {
  if (tip_roller_ < 0) return 0.0;
  const RollerContact& contact = at.contacts()[static_cast<std::size_t>(tip_roller_)];
  if (!contact.at.found || !beside(at, static_cast<std::size_t>(tip_roller_))) return separation(contact);
  return height_over(at.pipe_assembly().contacts().placed(tip_roller_), contact.at,
                     line_->elements.radius[static_cast<std::size_t>(contact.at.element)]);
}

/// When the pipe left each box first, and over which side.
void PipeRecorder::find_passed(const Instant& at) {
  const VesselPose& pose = at.vessel().pose;
  for (std::size_t i = 0; i < rollers_; ++i) {
    const ClosestPoint& closest = at.contacts()[i].at;
    BoxLeft& box = left_[static_cast<std::size_t>(model_->supports.rollers[i].box)];
    if (box.time == kNever && beside(at, i)) {
      const Vec3& place = closest.found ? closest.place : closest.reference;
      const double to_port = pose.R_WV.col(1).dot(place - pose.p_WV);
      box = {at.state->time, to_port > 0.0 ? 1.0 : -1.0};
    }
  }
}

void PipeRecorder::find_support_values(const Instant& at) {
  const Mat3& axes = at.vessel().pose.R_WV;
  const Vec3 port = axes.col(1);
  const std::vector<Roller>& rollers = model_->supports.rollers;
  double* of_rollers = support_sample_.data() + kBoxQuantities * boxes_;
  std::size_t roller = 0;
  for (std::size_t box = 0; box < boxes_; ++box) {
    const SupportBox& support = model_->supports.boxes[box];
    const Vec3 along = direction_from_ramp(carrier_of(at, support).pose, support.direction_S);
    Vec3 force = Vec3::Zero();
    double nearest = std::numeric_limits<double>::infinity();
    for (; roller < rollers_ && rollers[roller].box == static_cast<int>(box); ++roller) {
      const RollerContact& contact = at.contacts()[roller];
      double* out = of_rollers + kRollerQuantities * roller;
      out[0] = contact.normal;
      out[1] = separation(contact);
      out[2] = contact.normal > 0.0 ? 1.0 : 0.0;
      force += contact.force();
      if (rollers[roller].position == RollerPosition::bottom) {
        nearest = std::min(nearest, out[1]);
      }
    }
    least_separation_[box] = std::min(least_separation_[box], nearest);
    double* out = support_sample_.data() + kBoxQuantities * box;
    const double size = force.norm();
    const double values[kBoxQuantities] = {
        size, force.z(), force.dot(along), force.dot(port), or_absent(nearest), size > 0.0 ? 1.0 : 0.0};
    std::copy_n(values, kBoxQuantities, out);
    reaction_sample_[box] = size;
    largest_reaction_[box] = std::max(largest_reaction_[box], size);
  }
}

void PipeRecorder::add(const Instant& at) {
  recover(at);
  tensioner_.add(*at.tensioner, at.move.paid_out, at.state->time, at.step);
  stinger_.add(*at.assembly, at.state->time, at.step);
  start_.add(nodes_, at.vessel().pose, at.state->time);
  crossing_.add(at.pipe(), at.state->time, at.water(), line_->mesh, recovery_.place_of(0.0));
  if (at.state->time <= 0.0) {
    return;
  }
  if (move_ != nullptr) design_.set_sections(recovery_.sections());
  design_.step(design_instant(at));
  if (fatigue_) fatigue_->step(design_instant(at));
  const auto recorded = [&](const std::vector<double>& values) { return std::span(values).subspan(first_); };
  node_statistics_.add_parts(
      {recorded(nodes_.effective_tension), recorded(nodes_.bending_moment), recorded(nodes_.bending_stress),
       recorded(nodes_.von_mises), recorded(nodes_.strain), recorded(nodes_.x), recorded(nodes_.y), recorded(nodes_.z)},
      at.step);
  support_statistics_.add(support_sample_, at.step);
  reaction_quantiles_.add(reaction_sample_, at.step);
  key_statistics_.add(key_sample_, at.step);
}

void PipeRecorder::show(RowSource& row) const {
  row.key = key_sample_;
  row.largest_key = largest_key_;
  row.least_key = least_key_;
  row.largest_reaction = largest_reaction_;
  row.least_separation = least_separation_;
}

void PipeRecorder::forget_interval() {
  std::fill(largest_reaction_.begin(), largest_reaction_.end(), 0.0);
  std::fill(least_separation_.begin(), least_separation_.end(), std::numeric_limits<double>::infinity());
  std::fill(largest_key_.begin(), largest_key_.end(), -std::numeric_limits<double>::infinity());
  std::fill(least_key_.begin(), least_key_.end(), std::numeric_limits<double>::infinity());
}

double* PipeRecorder::film(double* out) const {
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
