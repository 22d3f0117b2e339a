#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <iterator>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/finding_lines.h"
#include "app/stage_lines.h"
#include "base/constants.h"
#include "base/finding.h"
#include "model/box_dip.h"
#include "model/material_words.h"
#include "model/model.h"
#include "model/rao_limits.h"
#include "study/input_findings.h"
#include "study/lay_operation.h"
#include "study/prepared_case.h"

namespace overbend {
namespace {

void line(const std::string& name, const std::string& value) {
  std::cout << fmt::format("  {:<24}{}\n", name, value);
}

void print_section(const Section& section, const SteelDescription& material) {
  std::cout << "\nSection: " << section.name << "\n";
  line("steel", fmt::format("{:.6g} mm outside, {:.6g} mm wall, yield {:.6g} MPa", section.steel_diameter * 1e3,
                            section.wall_thickness * 1e3, section.yield_stress / 1e6));
  const FirstYield yield = first_yield(material);
  line("material", material_words(material));
  line("first yield", fmt::format("{:.2f} kN m at a curvature of {:.6f} 1/m", yield.moment / 1e3, yield.curvature));
  line("steel area", fmt::format("{:.6g} mm2", section.steel_area * 1e6));
  line("outer diameter", fmt::format("{:.6g} m over the coatings (hydrodynamic diameter)", section.outer_diameter));
  line("EA", fmt::format("{:.2f} kN", section.EA / 1e3));
  line("EI", fmt::format("{:.2f} kN m2", section.EI / 1e3));
  line("weight in air", fmt::format("{:.7f} kN/m", section.weight_in_air / 1e3));
  line("submerged weight", fmt::format("{:.7f} kN/m", section.weight_submerged / 1e3));
}

std::string point(const Vec3& p) {
  const auto shown = [](double value) { return std::abs(value) < 5e-4 ? 0.0 : value; };  // no "-0.000"
  return fmt::format("{:>10.3f}{:>10.3f}{:>10.3f}", shown(p.x()), shown(p.y()), shown(p.z()));
}

void print_places(const Model& model) {
  const TensionerDescription& tensioner = model.description.tensioner;
  std::cout << "\nPositions in the world frame: x east, y north, z up [m]; origin midship at the mean water level\n";
  std::cout << fmt::format("  {:<24}{:>10}{:>10}{:>10}\n", "", "x", "y", "z");
  const auto place = [&](const std::string& name, const Vec3& p_S) {
    std::cout << fmt::format("  {:<24}{}\n", name, point(point_from_ramp(model, model.mean_pose, p_S)));
  };
  place("stern shoe", Vec3::Zero());
  place("tensioner (pipe axis)", {tensioner.x, 0.0, tensioner.z});
}

/// The rollers of a row by their place: "bottom", "bottom, port, starboard".
std::string rollers_of(const Supports& supports, const SupportRow& row) {
  std::string words;
  for (int i = row.first_roller; i < row.first_roller + row.roller_count; ++i) {
    words += (words.empty() ? "" : ", ") + std::string(word(supports.rollers[i].position));
  }
  return words;
}

void print_supports(const Model& model) {
  const Supports& supports = model.supports;
  if (supports.boxes.empty()) {
    std::cout << "\nSupports: none, the pipe hangs from the tensioner (J-lay)\n";
    return;
  }
  std::cout << fmt::format(
      "\nSupports: {} boxes, {} rows, {} rollers; points where the underside of the pipe rests [m]\n",
      supports.boxes.size(), supports.rows.size(), supports.rollers.size());
  std::cout << fmt::format("  {:<24}{:>10}{:>10}{:>10}{:>14}{:>12}  rollers\n", "box / row", "x", "y", "z",
                           "incline [deg]", "length [m]");
  for (const SupportBox& box : supports.boxes) {
    std::cout << fmt::format("  {:<24}{}{:>14.3f}{:>12.3f}\n", box.name,
                             point(point_from_ramp(model, model.mean_pose, box.point_S)),
                             box_dip(model.mean_pose, box) * kToDegrees, box.length);
    for (int r = 0; r < box.row_count; ++r) {
      const SupportRow& row = supports.rows[box.first_row + r];
      std::cout << fmt::format("  {:<24}{}{:>26}  {}\n", fmt::format("  row {}", r + 1),
                               point(point_from_ramp(model, model.mean_pose, row.point_S)), "",
                               rollers_of(supports, row));
    }
  }
}

/// The table by which wrong conventions of RAOs show.
void print_raos(const Model& model) {
  const VesselDescription& vessel = model.description.vessel;
  if (!vessel.raos) return;
  const RaoTable& raos = *vessel.raos;
  std::cout << fmt::format("\nRAOs: {}, {} headings, {} frequencies from {:.4g} to {:.4g} rad/s\n", raos.source,
                           raos.headings.size(), raos.omegas.size(), raos.omegas.front(), raos.omegas.back());
  const RaoLimits limits =
      long_wave_limits(raos, vessel.length, vessel.draught, model.description.environment.water_depth);
  std::cout << fmt::format("  compared with the water in waves of {:.4g} m; lags in deg behind the crest{}\n",
                           limits.wave_length,
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
    print_section(model.sections[i], model.description_of(i).steel);
  }
  if (description->has_pipe) {
    print_places(model);
    print_supports(model);
  }
  std::cout << planned_stages(*description);
  Findings findings = input_findings(model);
  if (is_lay_operation(description->operation.type)) {
    if (const auto obstacle = operation_obstacle(*description)) {
      findings.push_back({FindingCode::stage_without_equilibrium,
                          "the stages of the operation cannot be solved: " + failed_end(*obstacle, *description).why});
    }
  }
  print_raos(model);
  print_list("Assumptions", assumptions(model));
  if (!findings.empty()) std::cout << "\nFindings\n" << finding_lines(findings);
  return kDone;
}

}  // namespace overbend
