#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <iterator>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/print_findings.h"
#include "app/print_stages.h"
#include "base/constants.h"
#include "base/finding.h"
#include "base/shown_unit.h"
#include "model/box_dip.h"
#include "model/material_description.h"
#include "model/model.h"
#include "model/vessel/rao_limits.h"
#include "report/page/quantity.h"
#include "study/run/input_findings.h"
#include "study/run/prepared_case.h"
#include "study/stages/lay_operation.h"

namespace overbend {
namespace {

void line(const std::string& name, const std::string& value) {
  std::cout << fmt::format("  {:<24}{}\n", name, value);
}

void print_section(const Section& section, const SteelDescription& material) {
  std::cout << "\nSection: " << section.name << "\n";
  line("steel", fmt::format("{} outside, {} wall, yield {}", shown_digits(section.steel_diameter, section_length(), 6),
                            shown_digits(section.wall_thickness, section_length(), 6),
                            shown_digits(section.yield_stress, "Pa", 6)));
  const FirstYield yield = first_yield(material);
  line("material", material_law_label(material));
  line("first yield",
       fmt::format("{} at a curvature of {}", shown(yield.moment, "N m", 2), shown(yield.curvature, "1/m", 6)));
  line("steel area", shown_digits(section.steel_area, steel_area(), 6));
  line("outer diameter", shown_digits(section.outer_diameter, "m", 6) + " over the coatings (hydrodynamic diameter)");
  line("EA", shown(section.EA, "N", 2));
  line("EI", shown(section.EI, "N m2", 2));
  line("weight in air", shown(section.weight_in_air, "N/m", 7));
  line("submerged weight", shown(section.weight_submerged, "N/m", 7));
}

std::string point(const Vec3& p) {
  return fmt::format("{:>10}{:>10}{:>10}", shown_number(p.x(), "m", 3), shown_number(p.y(), "m", 3),
                     shown_number(p.z(), "m", 3));
}

void print_places(const Model& model) {
  const TensionerDescription& tensioner = model.description.tensioner;
  std::cout << fmt::format(
      "\nPositions in the world frame: x east, y north, z up [{}]; origin midship at the mean water level\n",
      shown_name("m"));
  std::cout << fmt::format("  {:<24}{:>10}{:>10}{:>10}\n", "", "x", "y", "z");
  const auto place = [&](const std::string& name, const Vec3& p_S) {
    std::cout << fmt::format("  {:<24}{}\n", name, point(point_from_ramp(model, model.mean_pose, p_S)));
  };
  place("stern shoe", Vec3::Zero());
  place("tensioner (pipe axis)", {tensioner.x, 0.0, tensioner.z});
}

/// Returns the positions of the rollers of a row: "bottom", "bottom, port, starboard".
std::string roller_positions(const Supports& supports, const SupportRow& row) {
  std::string text;
  for (int i = row.first_roller; i < row.first_roller + row.roller_count; ++i) {
    text += (text.empty() ? "" : ", ") + std::string(word(supports.rollers[i].position));
  }
  return text;
}

void print_supports(const Model& model) {
  const Supports& supports = model.supports;
  if (supports.boxes.empty()) {
    std::cout << "\nSupports: none, the pipe is suspended from the tensioner (J-lay)\n";
    return;
  }
  std::cout << fmt::format(
      "\nSupports: {} boxes, {} rows, {} rollers; support points at the underside of the pipe [{}]\n",
      supports.boxes.size(), supports.rows.size(), supports.rollers.size(), shown_name("m"));
  std::cout << fmt::format("  {:<24}{:>10}{:>10}{:>10}{:>14}{:>12}  rollers\n", "box / row", "x", "y", "z",
                           "incline [deg]", "length [" + shown_name("m") + "]");
  for (const SupportBox& box : supports.boxes) {
    std::cout << fmt::format("  {:<24}{}{:>14}{:>12}\n", box.name,
                             point(point_from_ramp(model, model.mean_pose, box.point_S)),
                             shown_number(box_dip(model.mean_pose, box), "rad", 3), shown_number(box.length, "m", 3));
    for (int r = 0; r < box.row_count; ++r) {
      const SupportRow& row = supports.rows[box.first_row + r];
      std::cout << fmt::format("  {:<24}{}{:>26}  {}\n", fmt::format("  row {}", r + 1),
                               point(point_from_ramp(model, model.mean_pose, row.point_S)), "",
                               roller_positions(supports, row));
    }
  }
}

/// Prints the long-wave limits of the RAOs, which reveal wrong conventions.
void print_raos(const Model& model) {
  const VesselDescription& vessel = model.description.vessel;
  if (!vessel.raos) return;
  const RaoTable& raos = *vessel.raos;
  std::cout << fmt::format("\nRAOs: {}, {} headings, {} frequencies from {:.4g} to {:.4g} rad/s\n", raos.source,
                           raos.headings.size(), raos.omegas.size(), raos.omegas.front(), raos.omegas.back());
  const RaoLimits limits =
      long_wave_limits(raos, vessel.length, vessel.draught, model.description.environment.water_depth);
  std::cout << fmt::format("  compared with the water in waves of {}; lags in deg behind the crest{}\n",
                           shown_digits(limits.wave_length, "m", 4),
                           limits.long_enough ? "" : "; too short relative to the vessel to be conclusive");
  std::cout << fmt::format("  {:<12}{:<10}{:<18}{:>8}{:>10}{:>12}\n", "travelling", "freedom", "over", "ratio", "lag",
                           "expected");
  constexpr std::array<const char*, 5> kOver = {"mean orbit", "mean orbit", "wave amplitude", "wave slope",
                                                "wave slope"};
  for (const RaoLimitRow& row : limits.rows) {
    const auto k = static_cast<std::size_t>(row.freedom);
    std::cout << fmt::format("  {:<12}{:<10}{:<18}{:>8.3f}{:>10.1f}{:>12.1f}{}\n",
                             fmt::format("{:.0f} deg", row.heading * kToDegrees), kFreedomNames[k], kOver[k], row.ratio,
                             row.lag * kToDegrees + 0.0, row.expected_lag * kToDegrees + 0.0,
                             row.agrees || !limits.long_enough ? "" : "  disagrees");
  }
}

void print_list(const std::string& head, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  std::cout << "\n" << head << "\n";
  for (const std::string& text : lines) std::cout << "  - " << text << "\n";
}

}  // namespace

int run_check(const std::string& model_file) {
  const std::optional<Description> description = load_model(model_file);
  if (!description) return kWrongInput;
  const Model model = build_model(*description);
  std::cout << description->title << "\n" << model_file << " is a valid model.\n";
  for (std::size_t i = 0; i < model.sections.size(); ++i) {
    print_section(model.sections[i], model.find_section_description(i).steel);
  }
  if (description->has_pipe) {
    print_places(model);
    print_supports(model);
  }
  std::cout << planned_stages(*description);
  Findings findings = input_findings(model);
  if (is_lay_operation(description->operation.type)) {
    if (const auto unsupported = unsupported_in_operation(*description)) {
      findings.push_back({FindingCode::stage_without_equilibrium, "the stages of the operation cannot be solved: " +
                                                                      failure_result(*unsupported, *description).why});
    }
  }
  print_raos(model);
  print_list("Assumptions", texts(assumptions(model)));
  if (!findings.empty()) std::cout << "\nFindings\n" << finding_lines(findings);
  return kDone;
}

}  // namespace overbend
