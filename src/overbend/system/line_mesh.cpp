#include "system/line_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/ranges.h"
#include "model/pipe_attachments.h"
#include "system/graded_mesh.h"

namespace overbend {
namespace {

constexpr double kMinElement = 0.1;  ///< [m]
/// Length of the element of a cable next to its head: it turns the tangent from one line to the other without
/// significant moment, like a hinge [m].
constexpr double kHinge = 2e-3;
constexpr double kHeadZone = 10.0;  ///< Fine zone on both sides of the end of a cable [m].

/// Minimum distance of two rows of rollers along the supports [m].
double row_spacing(const Supports& supports) {
  double min_spacing = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < supports.rows.size(); ++i) {
    min_spacing = std::min(min_spacing, (supports.rows[i].point_S - supports.rows[i - 1].point_S).norm());
  }
  return min_spacing;
}

/// Section that bends at a position: in place of a cable the pipe, whose element sizes also suit the cable.
const Section& bending_section(const Model& model, double from_top) {
  const Section& section = model.sections[static_cast<std::size_t>(model.section_at(from_top))];
  return section.kind == SectionKind::cable ? model.pipe_section() : section;
}

/// Minimum EI of the pipe at the tensioner and over the rows of rollers.
double min_stiffness_over_supports(const Model& model) {
  double EI = bending_section(model, 0.0).EI;
  for (const SupportRow& row : model.supports.rows) EI = std::min(EI, bending_section(model, row.from_top).EI);
  return EI;
}

/// On a shaped seabed the laid line bends everywhere, most where contact begins and ends.
void refine_laid_line(MeshPlan& plan, const Model& model, const MeshZones& zones, const MeshSizes& sizes) {
  const double soil = soil_length(model, bending_section(model, zones.touchdown).EI);
  plan.fine.push_back({zones.touchdown, zones.total, std::max(sizes.touchdown, 0.25 * soil)});
}

/// Refines where contact with the seabed begins and ends.
void refine_edges(MeshPlan& plan, const Model& model, const MeshZones& zones, const MeshSizes& sizes) {
  const double soil = soil_length(model, bending_section(model, zones.touchdown).EI);
  for (const LineStretch& edge : zones.bed_edges) {
    plan.fine.push_back({edge.from - soil, edge.to + soil, sizes.touchdown});
  }
}

/// Sets a node under each clump, buoy and wire, where the pipe bends sharply.
void refine_attachments(MeshPlan& plan, const Model& model, const MeshZones& zones, const MeshSizes& sizes) {
  constexpr double kSame = 1e-6;  // [m]
  for (const PipeAttachment& attachment : pipe_attachments(model.description)) {
    const double place = attachment.from_top;
    if (place >= zones.total - kMinElement) continue;
    plan.fine.push_back({place, place, sizes.touchdown});
    const auto above = ranges::lower_bound(plan.fixed, place - kSame);
    if (above == plan.fixed.end() || *above > place + kSame) plan.fixed.insert(above, place);
  }
}

MeshPlan plan_mesh(const Model& model, const MeshZones& zones) {
  const MeshSizes sizes = mesh_sizes(model, zones);
  MeshPlan plan;
  plan.max_length = sizes.max_length;
  plan.fine = {{0.0, zones.last_support, sizes.overbend},
               {zones.touchdown - sizes.touchdown_before, zones.touchdown + sizes.touchdown_after, sizes.touchdown}};
  if (model.seabed.surface.shape() != nullptr) refine_laid_line(plan, model, zones, sizes);
  refine_edges(plan, model, zones, sizes);
  if (zones.waterline > zones.last_support) {
    const double diameter = bending_section(model, zones.waterline).outer_diameter;
    plan.fine.push_back({zones.waterline - diameter, zones.waterline + diameter, std::max(sizes.overbend, diameter)});
  }
  for (const SectionSpan& span : model.spans) {
    if (model.sections[static_cast<std::size_t>(span.section)].kind == SectionKind::structure) {
      plan.fine.push_back({span.from - sizes.overbend, span.to + sizes.overbend, sizes.overbend});
    }
    const bool cable = model.sections[static_cast<std::size_t>(span.section)].kind == SectionKind::cable;
    // A cable ends at its winch at the top; at an anchor the line ends.
    const bool hinge_before = cable && span.from > 0.0, hinge_behind = cable && span.from == 0.0;
    for (const double end :
         {span.from, hinge_before ? span.from + kHinge : 0.0, hinge_behind ? span.to - kHinge : 0.0, span.to}) {
      const double last = plan.fixed.empty() ? 0.0 : plan.fixed.back();
      if (end > last && end < zones.total - kMinElement) {
        plan.fixed.push_back(end);
      }
    }
    if (cable) plan.fine.push_back({span.from - kHeadZone, span.from + kHeadZone, sizes.overbend});
    if (cable) plan.fine.push_back({span.to - kHeadZone, span.to + kHeadZone, sizes.overbend});
  }
  refine_attachments(plan, model, zones, sizes);
  plan.fixed.push_back(zones.total);
  return plan;
}

}  // namespace

double soil_length(const Model& model, double EI) {
  return std::pow(4.0 * EI / model.seabed.stiffness, 0.25);
}

MeshSizes mesh_sizes(const Model& model, const MeshZones& zones) {
  const MeshDescription& description = model.description.mesh;
  const double top_EI = min_stiffness_over_supports(model);
  const double bottom_EI = bending_section(model, zones.touchdown).EI;
  const double top_bending = std::sqrt(top_EI / zones.top_tension);
  const double bottom_bending = std::sqrt(bottom_EI / std::max(zones.bottom_tension, 0.02 * zones.top_tension));
  const double soil = soil_length(model, bottom_EI);

  MeshSizes sizes;
  // Roller forces within an element are exact without nodes under them.
  sizes.overbend = std::max(kMinElement, std::min(top_bending / 25.0, 0.8 * row_spacing(model.supports)));
  sizes.touchdown = std::max(kMinElement, std::min(bottom_bending / 20.0, soil / 8.0));
  const double suspended = std::max(zones.touchdown - zones.last_support, 1.0);
  sizes.max_length =
      std::max({sizes.overbend, sizes.touchdown, std::min(bottom_bending, suspended / 10.0) / 4.0, suspended / 300.0});
  sizes.overbend = description.overbend_element.value_or(sizes.overbend);
  sizes.touchdown = description.touchdown_element.value_or(sizes.touchdown);
  sizes.max_length = description.max_element_length.value_or(sizes.max_length);
  sizes.touchdown_before = 1.5 * std::min(bottom_bending, 0.2 * suspended) + 2.0 * soil;
  sizes.touchdown_after = 4.0 * soil;
  return sizes;
}

long count_elements(const Model& model, const MeshZones& zones) {
  constexpr long kEnough = 10'000'000;
  const MeshPlan plan = plan_mesh(model, zones);
  long count = 0;
  double from = 0.0;
  for (const double to : plan.fixed) {
    walk(plan, from, to, [&](double) { return ++count < kEnough; });
    from = to;
  }
  return count;
}

LineMesh build_mesh(const Model& model, const MeshZones& zones) {
  const MeshPlan plan = plan_mesh(model, zones);
  const std::vector<double> u = graded_nodes(plan);
  LineMesh mesh;
  for (auto it = u.rbegin(); it != u.rend(); ++it) {
    mesh.s.push_back(zones.total - *it);
  }
  for (std::size_t i = 0; i + 1 < mesh.s.size(); ++i) {
    mesh.length.push_back(mesh.s[i + 1] - mesh.s[i]);
    mesh.section.push_back(model.section_at(zones.total - 0.5 * (mesh.s[i] + mesh.s[i + 1])));
  }
  return mesh;
}

}  // namespace overbend
