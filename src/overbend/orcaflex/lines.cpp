// Lines: which of them is the pipe being laid, which are moorings, and those that are neither.
#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "orcaflex/translation.h"

namespace overbend::orcaflex {
namespace {

constexpr double kDegree = kPi / 180.0;

LineEnd read_end(const Translation& translation, const Object& line, const Table& ends, std::size_t row) {
  const double length = translation.units.length;
  LineEnd end;
  end.line = ends.line(row);
  end.connection = ends.text(row, "Connection");
  const auto coordinate = [&](const char* key) { return ends.number(row, key).value_or(0.0); };
  end.point = Vec3(coordinate("ConnectionX"), coordinate("ConnectionY"), coordinate("ConnectionZ")) * length;
  end.azimuth = coordinate("ConnectionAzimuth") * kDegree;
  end.declination = coordinate("ConnectionDeclination") * kDegree;
  using Kind = LineEnd::Kind;
  end.kind = end.connection == "Anchored"                ? Kind::anchored
             : end.connection == "Fixed"                 ? Kind::fixed
             : end.connection == "Free"                  ? Kind::free
             : end.connection == translation.vessel.name ? Kind::vessel
                                                         : Kind::another;
  if (end.kind == Kind::fixed || end.kind == Kind::free) end.point.z() -= translation.water_level;
  if (const std::optional<Table> springs = line.table("ConnectionxBendingStiffness");
      springs && row < springs->size()) {
    const double spring = springs->number(row, "ConnectionxBendingStiffness").value_or(0.0);
    end.is_clamped = std::isinf(spring);
    if (!end.is_clamped && spring != 0.0) end.stiffness = spring;
  }
  return end;
}

const LineType* find_type(Translation& translation, const Table& sections, std::size_t row, const Object& line) {
  const std::string name = sections.text(row, "LineType");
  if (const auto known = translation.line_types.find(name); known != translation.line_types.end()) {
    return &known->second;
  }
  for (const Object& object : translation.objects("LineTypes")) {
    if (object.name() == name) {
      return &translation.line_types.emplace(name, read_line_type(object, translation.units)).first->second;
    }
  }
  line.reject("LineType", "'" + for_display(name) + "'", "one of the LineTypes");
  return nullptr;
}

void read_pieces(Translation& translation, const Object& object, Line& line) {
  const std::optional<Table> sections = object.table("LineType");
  if (!sections || sections->size() == 0) {
    object.reject("LineType", "no sections", "LineType, Length, ...");
    return;
  }
  for (std::size_t row = 0; row < sections->size(); ++row) {
    const LineType* type = find_type(translation, *sections, row, object);
    const double length = sections->number(row, "Length").value_or(0.0) * translation.units.length;
    if (type == nullptr) return;
    if (!(length > 0.0)) object.reject("Length", number_text(length), "more than 0");
    const bool same = !line.pieces.empty() && line.pieces.back().type == type;
    same ? void(line.pieces.back().length += length) : line.pieces.push_back({type, length});
  }
}

/// The direction at an end runs from A to B: that of end B, seen from there, is the opposite one.
void turn_around(Line& line) {
  std::swap(line.ends[0], line.ends[1]);
  std::reverse(line.pieces.begin(), line.pieces.end());
  for (LineEnd& end : line.ends) {
    end.azimuth += kPi;
    end.declination = kPi - end.declination;
  }
}

Line read_line(Translation& translation, const Object& object) {
  Line line;
  line.object = &object;
  line.name = object.name();
  const std::optional<Table> ends = object.table("Connection");
  if (!ends || ends->size() != 2) {
    object.reject("Connection", ends ? std::to_string(ends->size()) + " rows" : "nothing",
                  "a row for each of two ends");
    return line;
  }
  for (std::size_t row = 0; row < 2; ++row) line.ends[row] = read_end(translation, object, *ends, row);
  read_pieces(translation, object, line);
  line.contents_density = object.number("ContentsDensity").value_or(0.0) * translation.units.density();
  if (object.text("ContentsMethod", "Uniform") != "Uniform") {
    translation.left_out("contents of " + for_display(line.name) + " that vary along it", true);
  }
  if (object.number("ContentsPressure").value_or(0.0) != 0.0) {
    translation.left_out("pressure of the contents of " + for_display(line.name), true);
  }
  if (line.ends[0].kind == LineEnd::Kind::anchored && line.ends[1].kind != LineEnd::Kind::anchored) turn_around(line);
  return line;
}

bool is_supported(const Translation& translation, const std::string& line) {
  if (!translation.vessel_object) return false;
  const std::optional<Table> supported = translation.vessel_object->table("SupportedLine");
  for (std::size_t row = 0; supported && row < supported->size(); ++row) {
    if (supported->text(row, "SupportedLine") == line) return true;
  }
  return false;
}

bool is_on_winch(const Translation& translation, const std::string& line) {
  for (const Object& winch : translation.objects("Winches")) {
    const std::optional<Table> places = winch.table("Connection");
    for (std::size_t row = 0; places && row < places->size(); ++row) {
      if (places->text(row, "Connection") == line) return true;
    }
  }
  return false;
}

void classify(const Translation& translation, Line& line) {
  if (line.pieces.empty()) return;
  using Kind = LineEnd::Kind;
  const auto all = [&](auto&& property) {
    return std::all_of(line.pieces.begin(), line.pieces.end(),
                       [&](const Piece& piece) { return property(*piece.type); });
  };
  const bool to_bed = line.ends[1].kind == Kind::anchored, from_vessel = line.ends[0].kind == Kind::vessel;
  const bool held = from_vessel || (line.ends[0].kind == Kind::free && is_on_winch(translation, line.name));
  const bool is_pipe = all([](const LineType& type) { return type.is_pipe; });
  line.is_laid = held && to_bed && (is_pipe || is_supported(translation, line.name));
  const bool is_limp = all([](const LineType& type) { return !type.is_pipe && type.bending_stiffness == 0.0; });
  line.is_mooring = from_vessel && to_bed && is_limp && !line.is_laid;
}

/// Hydrodynamic coefficients as a group of keys.
std::string hydrodynamics_text(const LineType& type) {
  std::string text = fmt::format("{{drag_normal: {}, drag_axial: {}, added_mass_normal: {}, added_mass_axial: {}",
                                 number_text(type.drag_normal), number_text(type.drag_axial),
                                 number_text(type.added_mass_normal), number_text(type.added_mass_axial));
  if (type.drag_diameter) text += ", drag_diameter: " + quantity_text(*type.drag_diameter, "m");
  return text + "}";
}

double axial_stiffness(const LineType& type) {
  if (!type.is_pipe) return type.axial_stiffness;
  return type.youngs_modulus * 0.25 * kPi * (std::pow(type.outside_diameter, 2) - std::pow(type.inside_diameter, 2));
}

double bending_stiffness(const LineType& type) {
  if (!type.is_pipe) return type.bending_stiffness;
  return type.youngs_modulus * kPi / 64.0 * (std::pow(type.outside_diameter, 4) - std::pow(type.inside_diameter, 4));
}

/// A line type by its numbers, with the weight of what is inside.
std::string numbers_text(const Translation& translation, const Line& line, const LineType& type, bool is_mooring) {
  const double mass = type.mass_of_wall() + type.mass_inside(line.contents_density);
  std::string text = fmt::format(
      "diameter: {}, weight_in_air: {}, axial_stiffness: {}", quantity_text(type.diameter(), "m"),
      quantity_text(mass * translation.units.gravity, "N/m"), quantity_text(axial_stiffness(type) / 1000.0, "kN"));
  if (!is_mooring) text += ", bending_stiffness: " + quantity_text(bending_stiffness(type) / 1000.0, "kN*m^2");
  if (is_mooring && type.allowable_tension) {
    text += ", breaking_load: " + quantity_text(*type.allowable_tension / 1000.0, "kN");
  }
  return text + ", friction: " + number_text(type.friction) + ", hydrodynamics: " + hydrodynamics_text(type);
}

std::string point_text(const Vec3& point) {
  return fmt::format("{{x: {}, y: {}, z: {}}}", quantity_text(point.x(), "m"), quantity_text(point.y(), "m"),
                     quantity_text(point.z(), "m"));
}

std::string end_text(Translation& translation, const Line& line, std::size_t index) {
  const LineEnd& end = line.ends[index];
  if (end.stiffness) {
    translation.left_out(fmt::format("{}: spring against rotation at end {}: the end is free to rotate",
                                     for_display(line.name), index + 1),
                         true);
  }
  const double sense = index == 0 ? 1.0 : -1.0;  // into the line
  const Vec3 direction = sense * Vec3(std::sin(end.declination) * std::cos(end.azimuth),
                                      std::sin(end.declination) * std::sin(end.azimuth), std::cos(end.declination));
  const auto direction_text = [](const Vec3& d) {
    return fmt::format(", direction: {{x: {}, y: {}, z: {}}}", number_text(d.x()), number_text(d.y()),
                       number_text(d.z()));
  };
  // World frame of the model: below midship of the vessel, x to the east.
  const auto world = [&](Vec3 point) {
    point.x() -= translation.vessel.position.x();
    point.y() -= translation.vessel.position.y();
    return point;
  };
  switch (end.kind) {
    case LineEnd::Kind::vessel:
      return "{body: vessel, at: " + point_text(end.point + Vec3(0, 0, translation.vessel.position.z())) +
             (end.is_clamped ? direction_text(direction) : "") + "}";
    case LineEnd::Kind::anchored: {
      const Vec3 place = world(end.point);
      if (end.point.z() > 0.5) {
        translation.approximated(fmt::format("{}: end {} m above the bed, taken as on it", for_display(line.name),
                                             number_text(end.point.z())));
      }
      return fmt::format("{{bed: {{x: {}, y: {}}}}}", quantity_text(place.x(), "m"), quantity_text(place.y(), "m"));
    }
    case LineEnd::Kind::free:
      return "{free: true}";
    case LineEnd::Kind::fixed:
      break;
    case LineEnd::Kind::another:
      line.object->reject("Connection", "'" + for_display(end.connection) + "'",
                          "the vessel of the model, Fixed, Anchored or Free");
      break;
  }
  return "{fixed: " + point_text(world(end.point)) + (end.is_clamped ? direction_text(direction) : "") + "}";
}

std::string key_text(const std::string& name) {
  std::string key = lower_case(name);
  for (char& c : key) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
  }
  return key;
}

}  // namespace

void read_lines(Translation& translation) {
  translation.line_objects = translation.objects("Lines");
  for (const Object& object : translation.line_objects) {
    Line line = read_line(translation, object);
    if (translation.diagnostics.has_errors()) return;
    classify(translation, line);
    translation.lines.push_back(std::move(line));
  }
  std::size_t laid = 0;
  for (Line& line : translation.lines) {
    if (line.is_laid && laid++ > 0) line.is_laid = false;  // further ones are lines
  }
}

std::string moorings_text(Translation& translation) {
  std::map<std::string, std::string> types;
  std::string lines;
  std::size_t count = 0;
  for (const Line& line : translation.lines) {
    if (!line.is_mooring) continue;
    ++count;
    const Vec3 fairlead = line.ends[0].point + Vec3(0, 0, translation.vessel.position.z());
    const Vec3 anchor = translation.vessel.from_global(line.ends[1].point);
    lines += "    - name: " + name_text(line.name) + "\n      fairlead: " + point_text(fairlead) +
             fmt::format("\n      anchor: {{x: {}, y: {}}}\n      segments:\n", quantity_text(anchor.x(), "m"),
                         quantity_text(anchor.y(), "m"));
    for (const Piece& piece : line.pieces) {
      const std::string key = key_text(piece.type->name);
      types[key] = "{" + numbers_text(translation, line, *piece.type, true) + "}";
      lines += fmt::format("        - {{type: {}, length: {}}}\n", key, quantity_text(piece.length, "m"));
    }
  }
  if (count == 0) return "";
  std::string text = "moorings:\n  types:\n";
  for (const auto& [key, numbers] : types) text += fmt::format("    {}: {}\n", key, numbers);
  translation.translated(fmt::format("{} mooring line{} of {} type{}; AllowableTension is the breaking load", count,
                                     count > 1 ? "s" : "", types.size(), types.size() > 1 ? "s" : ""));
  return text + "  find: pose\n  lines:\n" + lines + "\n";
}

std::string lines_text(Translation& translation) {
  std::string text;
  for (const Line& line : translation.lines) {
    if (line.is_laid || line.is_mooring) continue;
    text += "  - name: " + name_text(line.name) + "\n    ends:\n";
    for (std::size_t end = 0; end < 2; ++end) text += "      - " + end_text(translation, line, end) + "\n";
    text += "    segments:\n";
    for (const Piece& piece : line.pieces) {
      text += "      - {length: " + quantity_text(piece.length, "m") + ", " +
              numbers_text(translation, line, *piece.type, false) + "}\n";
      if (piece.type->is_pipe) {
        translation.approximated(for_display(line.name) + ": " + for_display(piece.type->name) +
                                 " by its stiffnesses and weight, without checks of its steel");
      }
    }
    translation.translated("line " + for_display(line.name) + ": ends, sections, weight with contents");
  }
  return text.empty() ? "" : "lines:\n" + text + "\n";
}

}  // namespace overbend::orcaflex
