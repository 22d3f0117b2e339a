// Water, seabed, current, waves.
#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "orcaflex/translation.h"

namespace overbend::orcaflex {
namespace {

constexpr double kDegree = kPi / 180.0;

/// Azimuth [deg] of a direction of the file, from X (east) anticlockwise, between -180 and 360 as the sums fall.
double compute_azimuth(double direction) {
  return 90.0 - direction;
}

/// Depth at the stern shoe, or at the origin without a vessel.
double depth_in_model(Translation& translation, const Object& environment, std::string& slope) {
  const double unit = translation.units.length;
  std::optional<double> depth = environment.number("SeabedOriginDepth");
  if (!depth) depth = environment.number("WaterDepth");
  if (!depth) {
    environment.reject("SeabedOriginDepth", "nothing", "the water depth");
    return 100.0;
  }
  if (const std::string type = environment.text("SeabedType", "Flat"); type != "Flat") {
    environment.reject("SeabedType", "'" + for_display(type) + "'", "'Flat'",
                       "a bed of soundings is given by environment.bathymetry");
  }
  const double tangent = std::tan(environment.number("SeabedSlope").value_or(0.0) * kDegree);
  if (tangent == 0.0) return *depth * unit;
  const double direction = environment.number("SeabedSlopeDirection").value_or(0.0);
  slope = fmt::format(", slope: {} deg, slope_towards: {} deg", number_text(std::atan(tangent) / kDegree),
                      number_text(compute_azimuth(direction) + 180.0));
  const std::vector<std::optional<double>> origin = environment.numbers("SeabedOrigin");
  const auto origin_at = [&](std::size_t i) { return i < origin.size() ? origin[i].value_or(0.0) * unit : 0.0; };
  const Vec3 shoe = translation.vessel.to_global({translation.vessel.stern_shoe, 0.0, 0.0});
  const double along = (shoe.x() - origin_at(0)) * std::cos(direction * kDegree) +
                       (shoe.y() - origin_at(1)) * std::sin(direction * kDegree);
  return *depth * unit - tangent * along;
}

/// Diameter with which lines press on the bed: that of the laid pipe, else of the line that ends there.
const LineType* type_on_bed(const Translation& translation) {
  if (const Line* pipe = translation.laid_pipe()) return pipe->pieces.back().type;
  for (const Line& line : translation.lines) {
    if (line.ends[1].kind == LineEnd::Kind::anchored && !line.pieces.empty()) return line.pieces.back().type;
  }
  return translation.lines.empty() || translation.lines[0].pieces.empty() ? nullptr
                                                                          : translation.lines[0].pieces.back().type;
}

std::string seabed_text(Translation& translation, const Object& environment, const std::string& slope) {
  const LineType* type = type_on_bed(translation);
  const std::optional<double> stiffness = environment.number("SeabedNormalStiffness");
  if (type == nullptr || !stiffness) return "";
  const double per_area = *stiffness * translation.units.bed_stiffness();
  for (const auto& [name, differing] : translation.line_types) {
    if (std::abs(differing.diameter_on_bed() - type->diameter_on_bed()) < 1e-6) continue;
    translation.approximated(
        fmt::format("one stiffness of the bed, with the diameter of {} on it: {} kN/m^2; that of {} would be {} kN/m^2",
                    for_display(type->name), number_text(per_area * type->diameter_on_bed() / 1e3), for_display(name),
                    number_text(per_area * differing.diameter_on_bed() / 1e3)));
  }
  // Moorings and lines have friction of their own; the bed's is that of the pipe.
  const double friction =
      translation.laid_pipe() != nullptr ? translation.laid_pipe()->pieces.back().type->friction : type->friction;
  return fmt::format("  seabed: {{stiffness: {} kN/m^2, friction: {}{}}}\n",
                     number_text(per_area * type->diameter_on_bed() / 1000.0), number_text(friction), slope);
}

std::string current_text(Translation& translation, const Object& environment) {
  if (environment.text("MultipleCurrentDataCanBeDefined", "No") == "Yes") {
    translation.left_out("current: several sets of data", true);
    return "";
  }
  const double speed = environment.number("RefCurrentSpeed").value_or(0.0) * translation.units.length;
  if (speed == 0.0) return "";
  if (const std::string method = environment.text("VerticalCurrentVariationMethod", "Interpolated");
      method != "Interpolated") {
    translation.left_out("current: profile by " + for_display(method), true);
    return "";
  }
  const double direction = environment.number("RefCurrentDirection").value_or(0.0);
  const std::optional<Table> rows = environment.table("CurrentDepth");
  if (!rows || rows->size() == 0) {
    environment.reject("CurrentDepth", "no table", "CurrentDepth, CurrentFactor, CurrentRotation");
    return "";
  }
  std::string text = "  current:\n";
  for (std::size_t row = 0; row < rows->size(); ++row) {
    const double factor = rows->number(row, "CurrentFactor").value_or(1.0);
    const double rotation = rows->number(row, "CurrentRotation").value_or(0.0);
    text += fmt::format("    - {{depth: {} m, speed: {} m/s, towards: {} deg}}\n",
                        number_text(rows->number(row, "CurrentDepth").value_or(0.0) * translation.units.length),
                        number_text(speed * factor), number_text(compute_azimuth(direction + rotation)));
  }
  translation.translated(
      fmt::format("current: {} depths, factors and rotations on {} m/s", rows->size(), number_text(speed)));
  return text;
}

/// Returns the key of a train's period, ", tp: 9 s" or ", tz: 7 s"; an error if it has none.
std::string period_text(const Object& train) {
  if (const std::optional<double> peak = train.number("WaveTp")) return ", tp: " + number_text(*peak) + " s";
  const std::optional<double> frequency = train.number("Wavefm");
  if (frequency && *frequency > 0.0) return ", tp: " + number_text(1.0 / *frequency) + " s";
  if (const std::optional<double> crossing = train.number("WaveTz")) return ", tz: " + number_text(*crossing) + " s";
  train.reject("WaveTp", "nothing", "the peak period, or WaveTz");
  return "";
}

/// Exponent s of cos^2s(angle/2) with the first circular moment of the file's cos^n(angle).
std::string spreading_text(Translation& translation, const Object& train) {
  if (train.number("WaveNumberOfSpectralDirections").value_or(1.0) <= 1.0) return "";
  const std::optional<double> n = train.number("WaveDirectionSpreadingExponent");
  if (!n || !(*n > 0.0)) {
    translation.left_out("directional spreading of the waves " + for_display(train.name()) + ": no exponent", true);
    return "";
  }
  const double moment =
      std::exp(2.0 * std::lgamma(0.5 * *n + 1.0) - std::lgamma(0.5 * (*n + 1.0)) - std::lgamma(0.5 * (*n + 3.0)));
  const double s = moment / (1.0 - moment);
  translation.approximated(fmt::format("waves {}: spreading cos^{} as cos^2s of half the angle, s = {:.4g}",
                                       for_display(train.name()), number_text(*n), s));
  return fmt::format(", spreading: {:.6g}", s);
}

std::string jonswap_text(Translation& translation, const Object& train, const std::string& from, bool is_jonswap) {
  const double hs = train.number("WaveHs").value_or(0.0) * translation.units.length;
  if (hs == 0.0) return "";
  const bool is_automatic = is_jonswap && train.text("WaveJONSWAPParameters", "Automatic") == "Automatic";
  const double gamma = is_automatic ? 0.0 : is_jonswap ? train.number("WaveGamma").value_or(3.3) : 1.0;
  std::string text = fmt::format("{{type: {}, hs: {} m{}", is_jonswap ? "jonswap" : "pierson_moskowitz",
                                 number_text(hs), period_text(train));
  if (is_automatic) {
    translation.approximated("waves " + for_display(train.name()) +
                             ": gamma by the rule of DNV-RP-C205 from Hs and Tp, in place of the file's Automatic");
  } else if (is_jonswap) {
    text += ", gamma: " + number_text(gamma);
  }
  return text + spreading_text(translation, train) + ", " + from + "}";
}

/// A wave train as a group of keys; empty for a train without waves and for one that is left out.
std::string train_text(Translation& translation, const Object& train) {
  const std::string type = train.text("WaveType", "Airy"), name = for_display(train.name());
  // WaveDirection: the waves run towards it.
  const double from_azimuth = compute_azimuth(train.number("WaveDirection").value_or(0.0)) + 180.0;
  const std::string from = fmt::format("from: {} deg", number_text(from_azimuth));
  if (type == "JONSWAP" || type == "ISSC") return jonswap_text(translation, train, from, type == "JONSWAP");
  if (type == "Airy" || type == "Single Airy" || type == "Stokes' 5th" || type == "Stokes 5th") {
    const double height = train.number("WaveHeight").value_or(0.0) * translation.units.length;
    if (height == 0.0) return "";
    return fmt::format("{{type: {}, height: {} m, period: {} s, {}}}", type.starts_with("Stokes") ? "stokes5" : "airy",
                       number_text(height), number_text(train.number("WavePeriod").value_or(8.0)), from);
  }
  translation.left_out("waves " + name + " of type " + for_display(type), true);
  return "";
}

/// All trains with waves: one group of keys, or a list of groups.
std::string waves_text(Translation& translation, const Object& environment) {
  std::vector<std::pair<std::string, std::string>> trains;  // name and text
  for (const Object& train : environment.objects("WaveTrains")) {
    if (const std::string text = train_text(translation, train); !text.empty()) {
      trains.emplace_back(for_display(train.name()), text);
    }
  }
  if (trains.empty()) return "";
  if (trains.size() == 1) {
    translation.translated("waves " + trains.front().first);
    return "  waves: " + trains.front().second + "\n";
  }
  std::string list = "  waves:\n", names;
  for (auto& [name, text] : trains) {
    if (const std::size_t stokes = text.find("type: stokes5"); stokes != std::string::npos) {
      text.replace(stokes, std::string("type: stokes5").size(), "type: airy");
      translation.approximated("waves " + name + ": a linear wave, as those of Stokes cannot be added to others");
    }
    list += "    - " + text + "\n";
    names += (names.empty() ? "" : ", ") + name;
  }
  translation.translated(fmt::format("waves {}: {} groups at once", names, trains.size()));
  return list;
}

}  // namespace

std::string environment_text(Translation& translation) {
  const std::optional<Object> environment = translation.group("Environment");
  if (!environment) {
    translation.diagnostics.add({Severity::error, translation.document.files.front().string(), 0, 0, "Environment",
                                 "nothing", "water, seabed and waves", ""});
    return "";
  }
  std::string slope;
  const double depth = depth_in_model(translation, *environment, slope);
  const std::optional<double> density = environment->number("Density");
  if (environment->text("VerticalDensityVariation", "Constant") != "Constant") {
    translation.left_out("density of the water that varies with depth", true);
  }
  const double water = density ? *density * translation.units.weight_density() : 1025.0 * translation.units.gravity;
  std::string text = "environment:\n  water_depth: " + quantity_text(depth, "m") + "\n";
  text += "  water_weight_density: " + quantity_text(water / 1000.0, "kN/m^3") + "\n";
  text += seabed_text(translation, *environment, slope);
  translation.translated("water, seabed");
  text += current_text(translation, *environment);
  text += waves_text(translation, *environment);
  return text + "\n";
}

}  // namespace overbend::orcaflex
