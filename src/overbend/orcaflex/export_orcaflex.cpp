#include "orcaflex/export_orcaflex.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "base/constants.h"
#include "model/site/wave_groups.h"
#include "orcaflex/translation.h"

namespace overbend::orcaflex {
namespace {

constexpr double kDegree = kPi / 180.0;

double compute_direction(double azimuth) {
  return 90.0 - azimuth / kDegree;
}

double disc(double diameter) {
  return 0.25 * kPi * diameter * diameter;
}

/// Point of the ramp/stinger frame in the axes of the vessel.
Vec3 in_vessel(const Model& model, const Vec3& point_S) {
  const VesselDescription& vessel = model.description.vessel;
  return {vessel.stern_shoe_x - point_S.x(), -point_S.y(), vessel.stern_shoe_z + point_S.z()};
}

std::string list(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", number_text(v.x()), number_text(v.y()), number_text(v.z()));
}

std::string regular_train_text(const char* type, const std::string& direction, double height, double period) {
  return fmt::format("      WaveType: {}\n{}      WaveHeight: {}\n      WavePeriod: {}\n", type, direction,
                     number_text(height), number_text(period));
}

/// A group of waves as a wave train; empty for one that has no counterpart.
std::string train_text(const WavesDescription& waves, Account& account) {
  const std::string direction =
      fmt::format("      WaveDirection: {}\n", number_text(compute_direction(waves.from) + 180.0));
  switch (waves.type) {
    case WaveType::airy:
      return regular_train_text("Airy", direction, waves.height, waves.period);
    case WaveType::stokes5:
      return regular_train_text("Stokes' 5th", direction, waves.height, waves.period);
    case WaveType::jonswap:
    case WaveType::pierson_moskowitz: {
      const double gamma = waves.type == WaveType::pierson_moskowitz ? 1.0 : waves.gamma.value_or(0.0);
      std::string text =
          fmt::format("      WaveType: JONSWAP\n{}      WaveJONSWAPParameters: {}\n      WaveHs: {}\n", direction,
                      gamma > 0.0 ? "Partially specified" : "Automatic", number_text(waves.hs));
      if (gamma > 0.0) text += fmt::format("      WaveGamma: {}\n", number_text(gamma));
      if (gamma == 0.0) account.approximated.emplace_back("gamma of the waves by the rule of the other program");
      return text + fmt::format("      WaveTp: {}\n", number_text(waves.tp));
    }
    case WaveType::ochi_hubble:
    case WaveType::torsethaugen:
    case WaveType::user:
      account.left_out.push_back({waves.type == WaveType::user          ? "waves by a spectrum from a file"
                                  : waves.type == WaveType::ochi_hubble ? "waves by an Ochi-Hubble spectrum"
                                                                        : "waves by a Torsethaugen spectrum",
                                  true});
      return "";
    case WaveType::elevation:
      account.left_out.push_back({"measured elevation of the waves", true});
      return "";
    case WaveType::none:
      break;
  }
  return "";
}

std::string waves_text(const WaveGroups& groups, Account& account) {
  std::string text = "  WaveTrains:\n";
  int number = 0;
  const auto add = [&](const std::string& train) { text += fmt::format("    - Name: Wave{}\n", ++number) + train; };
  for (const WavesDescription& waves : groups) {
    if (const std::string train = train_text(waves, account); !train.empty()) add(train);
  }
  if (number == 0) add(regular_train_text("Airy", "      WaveDirection: 270\n", 0.0, 8.0));
  return text;
}

std::string current_text(const Model& model) {
  const std::vector<CurrentPoint>& rows = model.description.environment.current;
  double max_speed = 0.0;
  for (const CurrentPoint& row : rows) max_speed = std::max(max_speed, row.speed);
  const double reference = rows.empty() ? 180.0 : compute_direction(rows.front().towards);
  std::string text =
      fmt::format("  RefCurrentSpeed: {}\n  RefCurrentDirection: {}\n  CurrentDepth, CurrentFactor, CurrentRotation:\n",
                  number_text(max_speed), number_text(reference));
  if (max_speed == 0.0) return text + "    - [0, 1, 0]\n";
  for (const CurrentPoint& row : rows) {
    text += fmt::format("    - [{}, {}, {}]\n", number_text(row.depth), number_text(row.speed / max_speed),
                        number_text(compute_direction(row.towards) - reference));
  }
  return text;
}

std::string environment_text(const Model& model, Account& account) {
  const EnvironmentDescription& environment = model.description.environment;
  const SeabedDescription& bed = environment.seabed;
  const Vec3 shoe = point_from_ramp(model, model.nominal_pose, Vec3::Zero());
  if (!bed.profile.empty() || !bed.bathymetry_file.empty()) {
    account.left_out.push_back(
        {"profile or soundings of the bed: written flat, with the depth at the stern shoe", true});
  }
  if (bed.soil != SoilModel::linear) account.left_out.push_back({"soil that softens: written linear", true});
  std::string text = fmt::format(
      "Environment:\n  WaterSurfaceZ: 0\n  Density: {}\n  SeabedType: Flat\n  SeabedOrigin: [{}, {}]\n  "
      "SeabedOriginDepth: {}\n",
      number_text(model.water_weight_density / kGravity / 1e3), number_text(shoe.x()), number_text(shoe.y()),
      number_text(environment.water_depth));
  if (bed.slope != 0.0) {
    text += fmt::format("  SeabedSlope: {}\n  SeabedSlopeDirection: {}\n", number_text(bed.slope / kDegree),
                        number_text(compute_direction(bed.slope_towards) + 180.0));
  }
  text += fmt::format("  SeabedModel: Elastic\n  SeabedNormalStiffness: {}\n",
                      number_text(model.seabed.stiffness / model.pipe_section().outer_diameter / 1e3));
  account.translated.emplace_back("water, seabed, current, waves");
  return text + waves_text(environment.waves, account) + current_text(model);
}

std::string line_type_text(const Model& model, std::size_t index) {
  const Section& section = model.sections[index];
  const SteelDescription& steel = model.described[index].steel;
  const double bore = section.steel_diameter - 2.0 * section.wall_thickness;
  const double steel_mass = section.steel_area * steel.weight_density / kGravity;
  const double contents = section.contents_weight_density / kGravity;
  const double coating = 0.5 * (section.outer_diameter - section.steel_diameter);
  const double coating_mass = section.weight_in_air / kGravity - steel_mass - contents * disc(bore);
  std::string text = fmt::format(
      "  - Name: {}\n    Category: Homogeneous pipe\n    OD: {}\n    ID: {}\n    MaterialDensity: {}\n    E: {}\n"
      "    PoissonRatio: {}\n    Cdn: {}\n    Cdz: {}\n    Can: {}\n    Caz: {}\n    SeabedLateralFrictionCoefficient: "
      "{}\n"
      "    CoatingThickness: {}\n",
      name_text(section.name), number_text(section.steel_diameter), number_text(bore),
      number_text(steel.weight_density / kGravity / 1e3), number_text(section.youngs_modulus / 1e3),
      number_text(section.poissons_ratio), number_text(section.drag_normal), number_text(section.drag_axial),
      number_text(section.added_mass_normal), number_text(section.added_mass_axial),
      number_text(model.seabed.friction_lateral), number_text(coating));
  if (coating > 0.0) {
    const double area = disc(section.outer_diameter) - disc(section.steel_diameter);
    text += fmt::format("    CoatingMaterialDensity: {}\n", number_text(coating_mass / area / 1e3));
  }
  return text + fmt::format("    LiningThickness: 0\n    DNVSTF101Fy: {}\n", number_text(section.yield_stress / 1e3));
}

/// Sections of the line in their order.
std::vector<std::pair<int, double>> pieces(const Model& model, double length) {
  std::vector<std::pair<int, double>> result;
  double done = 0.0;
  const auto add = [&](int section, double to) {
    const double end = std::min(to, length);
    if (end > done + 1e-9) result.emplace_back(section, end - done);
    done = std::max(done, end);
  };
  for (const SectionSpan& span : model.spans) {
    add(0, span.from);
    add(span.section, span.to);
  }
  add(0, length);
  return result;
}

/// Types of supports by geometry and stiffness, with the text of each.
class SupportTypes {
 public:
  std::string find_name(const Model& model, const SupportRow& row, Account& account) {
    const Roller& bottom = model.supports.rollers[static_cast<std::size_t>(row.first_roller)];
    const double stiffness = bottom.stiffness > 0.0 ? bottom.stiffness : model.contact_parts(bottom).total();
    std::string geometry = fmt::format("    Geometry: Flat\n    FlatSupportLength: {}\n", number_text(bottom.face));
    for (int i = 1; i < row.roller_count; ++i) {
      const Roller& side = model.supports.rollers[static_cast<std::size_t>(row.first_roller + i)];
      if (side.position != RollerPosition::port) continue;
      const double across = std::abs(side.face_middle_S().y()) + bottom.radius;
      // The clearance of inclined rollers is reduced to that of a U.
      if (std::abs(side.axis_S.y()) > 1e-6) {
        account.approximated.emplace_back("side rollers that lean: upright ones of a U");
      }
      if (std::abs(side.radius - bottom.radius) > 1e-9) {
        account.approximated.emplace_back("side rollers of another radius: that of the bottom roller");
      }
      geometry =
          fmt::format("    Geometry: U shaped\n    USupportHorizontalLength: {}\n    USupportVerticalLength: {}\n",
                      number_text(2.0 * across), number_text(side.face));
    }
    const std::string text = fmt::format("    NormalStiffness: {}\n    ShearStiffness: 0\n    Diameter: {}\n{}",
                                         number_text(stiffness / 1e3), number_text(2.0 * bottom.radius), geometry);
    const auto known = names_.find(text);
    if (known != names_.end()) return known->second;
    std::string name = "Rollers " + std::to_string(names_.size() + 1);
    names_[text] = name;
    text_ += "  - Name: " + name + "\n" + text;
    return name;
  }
  const std::string& text() const { return text_; }

 private:
  std::map<std::string, std::string> names_;  ///< By the text of the type.
  std::string text_;
};

std::string supports_text(const Model& model, SupportTypes& types, Account& account) {
  if (model.supports.rows.empty()) return "    SupportGeometrySpecification: None\n";
  std::string text = "    SupportGeometrySpecification: Explicit\n    SupportedLine:\n      - Pipe\n    Supports:\n";
  for (const SupportRow& row : model.supports.rows) {
    const Roller& bottom = model.supports.rollers[static_cast<std::size_t>(row.first_roller)];
    const double dip = model.supports.boxes[static_cast<std::size_t>(row.box)].inclination;
    text += fmt::format(
        "      - SupportType: {}\n        SupportPosition: {}\n        SupportOrientation: [180, {}, 0]\n",
        types.find_name(model, row, account), list(in_vessel(model, bottom.center_S)), number_text(dip / kDegree));
  }
  account.translated.push_back(fmt::format("{} rows of rollers as supports one by one", model.supports.rows.size()));
  account.left_out.push_back({"friction, restitution and damping of rollers", false});
  return text;
}

std::string vessel_text(const Model& model, SupportTypes& types, Account& account) {
  const VesselDescription& vessel = model.description.vessel;
  if (vessel.trim != 0.0 || vessel.heel != 0.0) account.left_out.push_back({"trim and heel of the vessel", true});
  if (vessel.motion != VesselMotion::fixed) {
    account.left_out.push_back({"motion of the vessel: give its RAOs there", false});
  }
  account.translated.emplace_back("vessel: length, heading");
  return fmt::format(
             "VesselTypes:\n  - Name: Vessel type\n    Length: {}\nVessels:\n  - Name: Vessel\n    VesselType: Vessel "
             "type\n"
             "    Length: ~\n    InitialPosition: [0, 0, 0]\n    Orientation: [0, 0, {}]\n    IncludedInStatics: "
             "None\n",
             number_text(vessel.length), number_text(compute_direction(vessel.heading))) +
         supports_text(model, types, account);
}

std::string lines_text(const Model& model, const LineExtent& extent, Account& account) {
  const TensionerDescription& tensioner = model.description.tensioner;
  const bool is_on_winch = tensioner.tension.has_value();
  const Vec3 top = in_vessel(model, {tensioner.x, 0.0, tensioner.z});
  const Vec3 world = point_from_ramp(model, model.nominal_pose, {tensioner.x, 0.0, tensioner.z});
  const Vec3 anchor = point_from_ramp(model, model.nominal_pose, {extent.anchor, 0.0, 0.0});
  const double heading = compute_direction(model.description.vessel.heading);
  const double declination = tensioner.incline / kDegree + 90.0;
  const Section& last = model.sections[static_cast<std::size_t>(pieces(model, extent.length).back().first)];
  std::string text =
      "Lines:\n  - Name: Pipe\n    TopEnd: End A\n    Connection, ConnectionX, ConnectionY, ConnectionZ, "
      "ConnectionAzimuth, ConnectionDeclination, ConnectionGamma:\n";
  text += is_on_winch
              ? fmt::format("      - [Free, {}, {}, {}, {}, {}, 0]\n", number_text(world.x()), number_text(world.y()),
                            number_text(world.z()), number_text(heading + 180.0), number_text(declination))
              : fmt::format("      - [Vessel, {}, {}, {}, 180, {}, 0]\n", number_text(top.x()), number_text(top.y()),
                            number_text(top.z()), number_text(declination));
  text += fmt::format("      - [Anchored, {}, {}, {}, {}, 90, 0]\n", number_text(anchor.x()), number_text(anchor.y()),
                      number_text(last.outer_radius()), number_text(heading + 180.0));
  text +=
      fmt::format("    ConnectionxBendingStiffness, ConnectionyBendingStiffness:\n      - [{}, ~]\n      - [0, ~]\n",
                  tensioner.guide == Guide::clamped ? "Infinity" : "0");
  text += "    LineType, Length, TargetSegmentLength:\n";
  for (const auto& [section, length] : pieces(model, extent.length)) {
    text += fmt::format("      - [{}, {}, {}]\n", name_text(model.sections[static_cast<std::size_t>(section)].name),
                        number_text(length), number_text(std::min(5.0, length)));
  }
  text += fmt::format(
      "    ContentsMethod: Uniform\n    ContentsDensity: {}\n    StaticsStep1: Catenary\n    StaticsStep2: Full "
      "statics\n"
      "    StaticsSeabedFrictionPolicy: As laid\n    LayAzimuth: {}\n    AsLaidTension: 0\n",
      number_text(model.pipe_section().contents_weight_density / kGravity / 1e3), number_text(heading));
  account.translated.push_back(fmt::format("pipe of {} m, anchor {} m astern of the stern shoe",
                                           number_text(extent.length), number_text(extent.anchor)));
  if (!is_on_winch) return text;
  account.approximated.emplace_back("tensioner of given tension: winch on the free end of the pipe");
  return text + fmt::format(
                    "Winches:\n  - Name: Tensioner\n    WinchType: Simple\n    Connection, ConnectionX, ConnectionY, "
                    "ConnectionZ:\n"
                    "      - [Vessel, {}, {}, {}]\n      - [Pipe, 0, 0, 0]\n    ConnectionzRelativeTo: [~, End A]\n"
                    "    WinchControlType: By stage\n    StageMode, StageValue:\n      - [Specified tension, {}]\n"
                    "      - [Specified tension, {}]\n",
                    number_text(top.x()), number_text(top.y()), number_text(top.z()),
                    number_text(*tensioner.tension / 1e3), number_text(*tensioner.tension / 1e3));
}

void report_losses(const Model& model, Account& account) {
  const Description& description = model.description;
  if (!description.pipe.structures.empty()) account.left_out.push_back({"in-line structures", true});
  if (!description.pipe.points.empty()) account.left_out.push_back({"clumps and buoys on the pipe", true});
  if (description.moorings) account.left_out.push_back({"moorings", false});
  if (!description.lines.empty()) account.left_out.push_back({"other lines", true});
  if (!description.environment.current.empty() && description.statics.laying == SeabedLayHistory::steady) {
    account.approximated.emplace_back(
        "lateral friction of the laid pipe in a side current: as laid on a straight line");
  }
  for (const Section& section : model.sections) {
    if (!section.bending) continue;
    account.left_out.push_back({"yielding of the steel: written linear", true});
    break;
  }
  for (const SectionDescription& described : model.described) {
    if (!described.joint && described.coatings.size() < 2) continue;
    account.approximated.emplace_back("coatings and field joints: one coating of the same diameter and weight");
    break;
  }
}

}  // namespace

ExportedModel export_orcaflex(const Model& model, const LineExtent& extent) {
  if (!model.description.has_pipe) throw std::invalid_argument("a model without a pipe cannot be exported to OrcaFlex");
  ExportedModel result;
  Account& account = result.account;
  SupportTypes supports;
  const std::string environment = environment_text(model, account);
  const std::string vessel = vessel_text(model, supports, account);
  std::string types = "LineTypes:\n";
  for (std::size_t i = 0; i < model.sections.size(); ++i) types += line_type_text(model, i);
  const std::string lines = lines_text(model, extent, account);
  report_losses(model, account);
  account.left_out.push_back({"settings of the analysis", false});
  std::sort(account.approximated.begin(), account.approximated.end());
  account.approximated.erase(std::unique(account.approximated.begin(), account.approximated.end()),
                             account.approximated.end());
  result.text = "%YAML 1.1\n# Written by Overbend: " + model.description.title +
                "\n---\nGeneral:\n  UnitsSystem: SI\n" + environment +
                (supports.text().empty() ? "" : "SupportTypes:\n" + supports.text()) + types + vessel + lines + "...\n";
  return result;
}

}  // namespace overbend::orcaflex
