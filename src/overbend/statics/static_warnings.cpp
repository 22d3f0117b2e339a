#include "statics/static_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/constants.h"
#include "model/lay_stage.h"
#include "model/material_words.h"
#include "results/fields/words.h"
#include "results/regions.h"

namespace overbend {
namespace {

using Warnings = std::vector<std::string>;

void warn_of_slack(Warnings& list, const StaticResults& results) {
  if (results.smallest_tension.value >= 0.0) return;
  list.push_back(
      fmt::format("compression: the effective tension falls to {:.2f} kN {}; a pipe in compression may buckle, which "
                  "the model represents only as far as its mesh allows",
                  1e-3 * results.smallest_tension.value, pipe_place(results, results.smallest_tension.s)));
}

void warn_of_yield(Warnings& list, const Model& model, const StaticResults& results) {
  const Station* worst = nullptr;
  for (const Station& at : results.stations) {
    const Section& section = model.sections[static_cast<std::size_t>(model.section_at(results.total_length - at.s))];
    if (section.bending || section.kind == SectionKind::structure || at.yield_stress <= 0.0 ||
        at.von_mises <= at.yield_stress)
      continue;
    if (worst == nullptr || at.von_mises / at.yield_stress > worst->von_mises / worst->yield_stress) worst = &at;
  }
  if (worst == nullptr) return;
  list.push_back(fmt::format(
      "the von Mises stress of {:.0f} MPa {} exceeds the yield stress of {:.0f} MPa; the steel is linear elastic here, "
      "so stress and moment beyond yield are those of a pipe that does not yield (see pipe.steel.material)",
      1e-6 * worst->von_mises, pipe_place(results, worst->s), 1e-6 * worst->yield_stress));
}

/// Largest strain of pipe within two diameters of a stretch, given from the tensioner [-].
double max_strain_beside(const StaticResults& results, const SectionSpan& span, double diameter) {
  double strain = 0.0;
  for (const Station& station : results.stations) {
    const double from_top = results.total_length - station.s;
    const double off = std::max(span.from - from_top, from_top - span.to);
    if (off > 0.0 && off < 2.0 * diameter && station.kind == SectionKind::pipe)
      strain = std::max(strain, station.strain);
  }
  return strain;
}

/// A structure or a thicker segment takes the strain that it concentrates in yielding pipe along: its one place here
/// has not the history of its passage.
void warn_of_strain_beside_stiff_stretches(Warnings& list, const Model& model, const StaticResults& results) {
  const bool own_history = model.description.stage || model.description.statics.history != LayHistory::laying;
  const Section& pipe = model.sections.front();
  if (own_history || !pipe.bending) return;
  for (const SectionSpan& span : model.spans) {
    const Section& section = model.sections[static_cast<std::size_t>(span.section)];
    const bool concentrates = section.kind == SectionKind::structure || section.kind == SectionKind::pipe;
    if (!concentrates || span.section == model.coated || section.EI < 1.05 * pipe.EI) continue;
    const double strain = max_strain_beside(results, span, pipe.outer_diameter);
    if (strain <= pipe.yield_stress / pipe.youngs_modulus) continue;
    list.push_back(fmt::format(
        "the strain of {:.3f} % beside '{}' is too low: the pipe there yields, and on its way over the supports the "
        "stiffer stretch has bent it more than this one place shows; solve its passage (operation.type: passage)",
        100.0 * strain, section.name));
  }
}

/// "'a', 'b' and 2 more"
std::string names_of(const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kShown); ++i) text += (i == 0 ? "'" : ", '") + names[i] + "'";
  return names.size() > kShown ? text + fmt::format(" and {} more", names.size() - kShown) : text;
}

/// Boxes with a roller whose lowest point lies under the bed.
void warn_of_bed(Warnings& list, const Model& model) {
  std::vector<std::string> below;
  for (const SupportBox& box : model.supports.boxes) {
    const Vec3 point = point_from_ramp(model, model.mean_pose, box.point_S);
    if (point.z() < model.seabed.surface.height(point.x(), point.y())) below.push_back(box.name);
  }
  if (below.empty()) return;
  const bool tip =
      model.supports.boxes.back().structure == Structure::stinger && below.back() == model.supports.boxes.back().name;
  list.push_back(fmt::format("rollers are below the seabed: {}{}; the seabed neither supports nor moves them",
                             names_of(below), tip ? ", the stinger's tip among them" : ""));
}

void warn_of_shoe(Warnings& list, const StaticResults& results) {
  if (results.stern_shoe_W.z() >= 0.0) return;
  list.push_back(
      fmt::format("the stern shoe is {:.2f} m below the water; ramp and stinger depend on it, so check "
                  "vessel.stern_shoe.z, the trim and the draught",
                  -results.stern_shoe_W.z()));
}

/// A box and how far it stands off the line through its neighbours.
struct Proud {
  const SupportBox* box = nullptr;
  double height = 0.0;     ///< Above that line, across it [m].
  double curvature = 0.0;  ///< Of the circle through the three [1/m].
};

Proud proud_of(const SupportBox& before, const SupportBox& box, const SupportBox& after) {
  const auto flat = [](const Vec3& p) { return Eigen::Vector2d(p.x(), p.z()); };
  const Eigen::Vector2d a = flat(before.point_S), b = flat(box.point_S), c = flat(after.point_S);
  const double chord = (c - a).norm(), first = (b - a).norm(), second = (c - b).norm();
  if (std::min({chord, first, second}) <= 0.0) return {};
  const double twice_area = (c - a).x() * (b - a).y() - (c - a).y() * (b - a).x();
  return {&box, twice_area / chord, 2.0 * twice_area / (chord * first * second)};
}

/// Whether no stinger that a pipe is meant to follow is set so: a bend that yields it over a height beyond what is set
/// out by eye, or one of many times that.
bool out_of_line(const Proud& proud, double yields_at) {
  const double bend = std::abs(proud.curvature) / yields_at, height = std::abs(proud.height);
  return (bend > 2.0 && height > 0.2) || (bend > 5.0 && height > 0.05);
}

/// The box that stands furthest out of line. One out of line bends the circles through its neighbours too, each half as
/// much the other way: of these it is the one that bends most.
void warn_of_proud_box(Warnings& list, const Model& model) {
  const SectionDescription& pipe = model.description_of(static_cast<std::size_t>(model.section_at(0.0)));
  const double yields_at = 2.0 * pipe.steel.yield_stress / (pipe.steel.youngs_modulus * pipe.steel.outside_diameter);
  const std::vector<SupportBox>& boxes = model.supports.boxes;
  Proud worst;
  for (std::size_t i = 1; i + 1 < boxes.size(); ++i) {
    const Proud proud = proud_of(boxes[i - 1], boxes[i], boxes[i + 1]);
    if (std::abs(proud.curvature) > std::abs(worst.curvature)) worst = proud;
  }
  if (worst.box == nullptr || yields_at <= 0.0 || !out_of_line(worst, yields_at)) return;
  list.push_back(
      fmt::format("the box '{}' is {:.2f} m {} the line through its neighbours: a curvature of {:.4f} 1/m, {:.1f} "
                  "times that at "
                  "which the pipe yields; check its z and the sign of its offset",
                  worst.box->name, std::abs(worst.height), worst.height > 0.0 ? "above" : "below",
                  std::abs(worst.curvature), std::abs(worst.curvature) / yields_at));
}

/// Concrete that stops at the field joints makes the pipe bend most there.
void warn_of_field_joints(Warnings& list, const Model& model) {
  const SectionDescription& pipe = model.description.pipe.section;
  constexpr double kConcrete = 15e3;  // foam and rubber weigh less [N/m3]
  if (!pipe.joint || pipe.joint->field_joint <= 0.0) return;
  if (pipe.coatings.empty() || pipe.coatings.back().weight_density < kConcrete) return;
  if (pipe.joint->strain_factor || pipe.joint->coated_stiffness > 1.0) return;
  list.emplace_back(
      "the strain concentration at the field joints is missing: the coating between them stiffens the pipe and "
      "concentrates strain at the joints, but neither pipe.joint.strain_factor nor pipe.joint.coated_stiffness is "
      "given; the strain checks use a factor of 1");
}

/// Structures that the line, or the pipe of a start-up, ends before or in.
void warn_of_structures_beyond(Warnings& list, const Model& model, const StaticResults& results) {
  const double last = pipe_ends(model.description), end = std::min(results.total_length, last);
  for (const StructureDescription& structure : model.description.pipe.structures) {
    if (!structure.at) continue;
/// A bed that rises out of the water where the pipe lies on it. Stations run from the anchor.
void warn_of_land(Warnings& list, const Model& model, const StaticResults& results) {
  const BedSurface& bed = model.seabed.surface;
  const auto dry = [&](const Station& station) {
    return station.s <= results.touchdown.s && bed.height(station.p_W.x(), station.p_W.y()) > 0.0;
  };
  const auto landmost = std::find_if(results.stations.rbegin(), results.stations.rend(), dry);
  if (results.touchdown.s <= 0.0 || landmost == results.stations.rend()) return;
  const bool whole = bed.height(results.touchdown.p_W.x(), results.touchdown.p_W.y()) > 0.0;
  list.push_back(
      fmt::format("the seabed leaves the water under the laid pipe, which {} from {:.1f} m astern of the stern shoe "
                  "on: is the slope, "
                  "or the depth of the file, of the right sign?",
                  whole ? "touches down on land and lies there" : "lies on land", landmost->astern));
}

    const double middle = *structure.at + pipe_gone(model.description), half = 0.5 * structure.length;
    if (middle + half < end) continue;
    list.push_back(fmt::format(
        "the structure '{}' (at: {:.6g} m) {}{}", structure.name, *structure.at,
        middle - half < end ? "reaches beyond the end of the line, where it is cut off"
                            : "lies beyond the end of the line, which has nothing of it",
        end < last ? "; a pipe.length that reaches further keeps it in" : ": the pipe ends before it at its head"));
  }
}

/// A bed on whose slope the laid pipe would slide along itself: statics hold its far end.
void warn_of_slope(Warnings& list, const Model& model, const StaticResults& results) {
  const BedSurface& bed = model.seabed.surface;
  if (bed.shape() != nullptr || results.stations.size() < 2) return;
  const Vec3 from = results.stations.back().p_W, to = results.stations.front().p_W;
  const Vec3 along = Vec3(to.x() - from.x(), to.y() - from.y(), 0.0).normalized();
  const double fall = -bed.slope(to.x(), to.y(), along), friction = model.seabed.friction_axial;
  if (std::abs(fall) <= std::max(friction, 1e-6)) return;
  list.push_back(fmt::format(
      "the laid pipe slides on its bed, which {} astern by {:.3g} deg: axial friction of {:.3g} does not hold it, so "
      "that its tension depends on where its far end is held (environment.seabed.friction.axial)",
      fall > 0.0 ? "falls" : "rises", std::abs(std::atan(fall)) / kDegree, friction));
}
  warn_of_land(list, model, results);

/// An equilibrium, but hardly that of the lay that is meant.
void warn_of_last_resort(Warnings& list, const StaticResults& results) {
  if (!results.solve.last_resort) return;
  list.emplace_back(
      "no equilibrium was found in which the pipe lies on its rollers: in this one it has left most of its boxes, and "
      "a run may depart from it; check tension, current and the places of the boxes");
}

}  // namespace

std::string pipe_place(const StaticResults& results, double s) {
  return fmt::format("{:.1f} m from the tensioner ({})", results.total_length - s, word(regions(results).of(s)));
}

void warn_statics(const Model& model, StaticResults& results) {
  Warnings& list = results.warnings;
  warn_of_last_resort(list, results);
  warn_of_slack(list, results);
  warn_of_yield(list, model, results);
  warn_of_strain_beside_stiff_stretches(list, model, results);
  std::ranges::copy(material_warnings(model), std::back_inserter(list));
  warn_of_bed(list, model);
  warn_of_shoe(list, results);
  warn_of_proud_box(list, model);
  warn_of_field_joints(list, model);
  warn_of_structures_beyond(list, model, results);
  warn_of_slope(list, model, results);
}

}  // namespace overbend
