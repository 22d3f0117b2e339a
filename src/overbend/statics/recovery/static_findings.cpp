#include "statics/recovery/static_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/constants.h"
#include "base/ranges.h"
#include "base/shown_unit.h"
#include "model/lay_stage.h"
#include "model/material_description.h"
#include "model/pipe_attachments.h"
#include "results/regions.h"
#include "results/result_enum_names.h"
#include "statics/solver/support_outlier.h"

namespace overbend {
namespace {

void warn_of_slack(Findings& list, const StaticResults& results) {
  if (results.min_effective_tension.value >= 0.0) return;
  list.push_back(Finding{
      FindingCode::compression,
      fmt::format("compression: the effective tension falls to {} {}; a pipe in compression may buckle, which the "
                  "model represents only as far as its mesh allows",
                  shown(results.min_effective_tension.value, "N", 2),
                  pipe_place(results, results.min_effective_tension.s))}
                     .on("pipe")
                     .at_place(results.total_length - results.min_effective_tension.s)
                     .with("effective_tension", results.min_effective_tension.value, "N"));
}

void warn_of_yield(Findings& list, const Model& model, const StaticResults& results) {
  const Station* worst = nullptr;
  for (const Station& station : results.stations) {
    const Section& section =
        model.sections[static_cast<std::size_t>(model.section_at(results.total_length - station.s))];
    if (section.bending || section.kind == SectionKind::structure || station.yield_stress <= 0.0 ||
        station.von_mises <= station.yield_stress) {
      continue;
    }
    if (worst == nullptr || station.von_mises / station.yield_stress > worst->von_mises / worst->yield_stress) {
      worst = &station;
    }
  }
  if (worst == nullptr) return;
  list.push_back(Finding{
      FindingCode::yield_with_linear_steel,
      fmt::format("the von Mises stress of {} {} exceeds the yield stress of {}; the steel is linear elastic here, so "
                  "stress and moment beyond yield are those of a pipe that does not yield (see pipe.steel.material)",
                  shown(worst->von_mises, "Pa", 0), pipe_place(results, worst->s), shown(worst->yield_stress, "Pa", 0))}
                     .on("pipe")
                     .at_place(results.total_length - worst->s)
                     .with("von_mises", worst->von_mises, "Pa"));
}

/// Maximum strain of pipe within two diameters of a span, given from the tensioner [-].
double max_strain_next_to(const StaticResults& results, const SectionSpan& span, double diameter) {
  double strain = 0.0;
  for (const Station& station : results.stations) {
    const double from_top = results.total_length - station.s;
    const double off = std::max(span.from - from_top, from_top - span.to);
    if (off > 0.0 && off < 2.0 * diameter && station.kind == SectionKind::pipe) {
      strain = std::max(strain, station.strain);
    }
  }
  return strain;
}

/// Warns of strain next to a structure or a thicker segment in yielding pipe: the strain accumulates during its
/// passage, which this one position does not include.
void warn_of_strain_next_to_stiff_sections(Findings& list, const Model& model, const StaticResults& results) {
  const bool own_history = model.description.stage || model.description.statics.history != LayHistory::laying;
  const Section& pipe = model.pipe_section();
  if (own_history || !pipe.bending) return;
  for (const SectionSpan& span : model.spans) {
    const Section& section = model.sections[static_cast<std::size_t>(span.section)];
    const bool concentrates = section.kind == SectionKind::structure || section.kind == SectionKind::pipe;
    if (!concentrates || span.section == model.coated || section.EI < 1.05 * pipe.EI) continue;
    const double strain = max_strain_next_to(results, span, pipe.outer_diameter);
    if (strain <= pipe.yield_stress / pipe.youngs_modulus) continue;
    list.push_back(Finding{FindingCode::strain_next_to_stiff_section,
                           fmt::format("the strain of {:.3f} % next to '{}' is too low: the pipe there yields, and "
                                       "during its passage over the supports the stiffer section has bent it more than "
                                       "in this position; solve its passage (operation.type: passage)",
                                       100.0 * strain, section.name)}
                       .on(section.name)
                       .with("strain", strain, "1"));
  }
}

/// Formats names as "'a', 'b' and 2 more".
std::string join_names(const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kShown); ++i) text += (i == 0 ? "'" : ", '") + names[i] + "'";
  return names.size() > kShown ? text + fmt::format(" and {} more", names.size() - kShown) : text;
}

/// Warns of boxes with a roller whose lowest point is below the bed.
void warn_of_bed(Findings& list, const Model& model) {
  std::vector<std::string> below;
  for (const SupportBox& box : model.supports.boxes) {
    const Vec3 point = point_from_ramp(model, model.mean_pose, box.point_S);
    if (point.z() < model.seabed.surface.height(point.x(), point.y())) below.push_back(box.name);
  }
  if (below.empty()) return;
  const bool tip =
      model.supports.boxes.back().structure == Structure::stinger && below.back() == model.supports.boxes.back().name;
  list.push_back(Finding{FindingCode::rollers_below_seabed,
                         fmt::format("rollers are below the seabed: {}{}; the seabed neither supports nor moves them",
                                     join_names(below), tip ? ", the stinger's tip among them" : "")}
                     .on(below.front())
                     .with("boxes", static_cast<double>(below.size()), "1"));
}

void warn_of_shoe(Findings& list, const Model& model) {
  const double height = point_from_ramp(model, model.mean_pose, Vec3::Zero()).z();
  if (height >= 0.0) return;
  list.push_back(Finding{FindingCode::stern_shoe_below_water,
                         fmt::format("the stern shoe is {} below the water; ramp and stinger depend on it, so check "
                                     "vessel.stern_shoe.z, the trim and the draught",
                                     shown(-height, "m", 2))}
                     .on("vessel")
                     .with("depth", -height, "m"));
}

/// Warns of a clamped tensioner that does not point towards the first box.
void warn_of_incline(Findings& list, const Model& model) {
  const TensionerDescription& tensioner = model.description.tensioner;
  if (model.supports.boxes.empty() || tensioner.guide != Guide::clamped) return;
  const Vec3& box = model.supports.boxes.front().point_S;
  const double dx = box.x() - tensioner.x, dz = box.z() + 0.5 * model.pipe_section().outer_diameter - tensioner.z;
  const double off = tensioner.incline - std::atan2(-dz, dx), bend = 2.0 * std::abs(off) / std::hypot(dx, dz);
  const SteelDescription& steel = model.find_section_description(static_cast<std::size_t>(model.section_at(0.0))).steel;
  const double yields_at = 2.0 * steel.yield_stress / (steel.youngs_modulus * steel.outside_diameter);
  if (std::abs(off) < 5.0 * kDegree || bend < 1.5 * yields_at) return;
  list.push_back(Finding{FindingCode::tensioner_incline,
                         fmt::format("the tensioner holds the pipe at {:.1f} deg while the first box lies {:.1f} deg "
                                     "{} it: check tensioner.incline and the position of the tensioner",
                                     tensioner.incline * kToDegrees, std::abs(std::atan2(dz, dx)) * kToDegrees,
                                     dz < 0.0 ? "below" : "above")}
                     .on("tensioner")
                     .with("angle", off, "rad"));
}

/// Warns of concrete that ends at the field joints, where the pipe bends most.
void warn_of_field_joints(Findings& list, const Model& model) {
  const SectionDescription& pipe = model.description.pipe.section;
  constexpr double kConcrete = 15e3;  // foam and rubber weigh less [N/m3]
  if (!pipe.joint || pipe.joint->field_joint <= 0.0) return;
  if (pipe.coatings.empty() || pipe.coatings.back().weight_density < kConcrete) return;
  if (pipe.joint->strain_factor || pipe.joint->coated_stiffness > 1.0) return;
  list.push_back(Finding{FindingCode::field_joint_strain_missing,
                         "the strain concentration at the field joints is missing: the coating between them stiffens "
                         "the pipe and concentrates strain at the joints, but neither pipe.joint.strain_factor nor "
                         "pipe.joint.coated_stiffness is given; the strain checks use a factor of 1"}
                     .on("pipe"));
}

/// Warns of structures beyond or across the end of the line or of the pipe of a start-up.
void warn_of_structures_beyond(Findings& list, const Model& model, const StaticResults& results) {
  const double last = pipe_end_distance(model.description), end = std::min(results.total_length, last);
  for (const StructureDescription& structure : model.description.pipe.structures) {
    if (!structure.at) continue;
    const double middle = *structure.at + pipe_shift(model.description), half = 0.5 * structure.length;
    if (middle + half < end) continue;
    list.push_back(Finding{
        FindingCode::structure_beyond_end,
        fmt::format("the structure '{}' (at: {}) {}{}", structure.name, shown_digits(*structure.at, "m", 6),
                    middle - half < end ? "extends beyond the end of the line, where it is cut off"
                                        : "lies beyond the end of the line and is ignored",
                    end < last ? "; increase pipe.length to include it" : ": the pipe ends before it at its head")}
                       .on(structure.name));
  }
}

/// Warns of clumps, buoys and wires beyond the end of the line.
void warn_of_attachments_beyond(Findings& list, const Model& model, const StaticResults& results) {
  for (const PipeAttachment& attached : pipe_attachments(model.description)) {
    if (attached.from_top < results.total_length) continue;
    const std::string& name = attached.point != nullptr ? attached.point->name : attached.line->name;
    list.push_back(
        Finding{FindingCode::structure_beyond_end,
                fmt::format("'{}' is on the pipe {} from the tensioner, beyond the end of the line, and is ignored",
                            name, shown(attached.from_top, "m", 1))}
            .on(name));
  }
}

/// Warns of a seabed slope on which the laid pipe would slide axially: statics hold its far end.
void warn_of_slope(Findings& list, const Model& model, const StaticResults& results) {
  const SeabedSurface& bed = model.seabed.surface;
  if (bed.shape() != nullptr || is_dragged(model.description) || results.stations.size() < 2) return;
  const Vec3 from = results.stations.back().p_W, to = results.stations.front().p_W;
  const Vec3 along = Vec3(to.x() - from.x(), to.y() - from.y(), 0.0).normalized();
  const double fall = -bed.slope(to.x(), to.y(), along), friction = model.seabed.friction_axial;
  if (std::abs(fall) <= std::max(friction, 1e-6)) return;
  list.push_back(Finding{
      FindingCode::laid_pipe_slides,
      fmt::format(
          "the laid pipe slides on its bed, which {} astern by {:.3g} deg: axial friction of {:.3g} does not hold it, "
          "so that its tension depends on where its far end is held (environment.seabed.friction.axial)",
          fall > 0.0 ? "falls" : "rises", std::abs(std::atan(fall)) / kDegree, friction)}
                     .on("pipe")
                     .with("slope", std::atan(fall), "rad"));
}

/// Warns of a seabed above the water at the laid pipe. Stations run from the anchor.
void warn_of_land(Findings& list, const Model& model, const StaticResults& results) {
  const SeabedSurface& bed = model.seabed.surface;
  const auto dry = [&](const Station& station) {
    return station.s <= results.touchdown.s && bed.height(station.p_W.x(), station.p_W.y()) > 0.0;
  };
  const auto landmost = std::find_if(results.stations.rbegin(), results.stations.rend(), dry);
  if (is_dragged(model.description)) return;  // it is pulled ashore
  if (results.touchdown.s <= 0.0 || landmost == results.stations.rend()) return;
  const bool all_on_land = bed.height(results.touchdown.p_W.x(), results.touchdown.p_W.y()) > 0.0;
  list.push_back(Finding{FindingCode::seabed_above_water,
                         fmt::format("the seabed is above the water under the laid pipe, which {} from {} astern of "
                                     "the stern shoe on: check the sign of the slope or of the depths in the file",
                                     all_on_land ? "touches down on land and lies there" : "lies on land",
                                     shown(landmost->astern, "m", 1))}
                     .on("pipe")
                     .with("distance", landmost->astern, "m"));
}

}  // namespace

std::string pipe_place(const StaticResults& results, double s) {
  return fmt::format("{} from the tensioner ({})", shown(results.total_length - s, "m", 1),
                     word(regions(results).of(s)));
}

Findings lay_findings(const Model& model) {
  Findings list;
  warn_of_bed(list, model);
  warn_of_shoe(list, model);
  if (const auto outlier = support_outlier(model)) {
    list.push_back(Finding{FindingCode::support_out_of_line, outlier_message(*outlier)}
                       .on(outlier->name)
                       .with("height", outlier->height, "m"));
  }
  warn_of_incline(list, model);
  warn_of_field_joints(list, model);
  ranges::copy(material_findings(model), std::back_inserter(list));
  return list;
}

void warn_statics(const Model& model, StaticResults& results) {
  Findings& list = results.findings;
  warn_of_slack(list, results);
  warn_of_yield(list, model, results);
  warn_of_strain_next_to_stiff_sections(list, model, results);
  append(list, lay_findings(model));
  warn_of_structures_beyond(list, model, results);
  warn_of_attachments_beyond(list, model, results);
  warn_of_slope(list, model, results);
  warn_of_land(list, model, results);
}

}  // namespace overbend
