// Motions in the output of panel programs: WAMIT's .out, AQWA's .LIS, HydroStar's .rao.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "model/waves/rao_table.h"
#include "seafiles/aqwa_data.h"
#include "seafiles/body_number.h"
#include "seafiles/hull_text.h"
#include "seafiles/rao_formats.h"
#include "seafiles/wamit_out.h"

namespace overbend::rao_formats {
namespace {

/// Runs a reader and reports its error, with the key of motions in place of that of hulls.
template <class Read>
RaoFile reported(const std::string& file, Diagnostics& diagnostics, Read read) {
  try {
    return read();
  } catch (HullFileError& error) {
    const std::string coupled = "vessel.motion.coupled.";
    if (const std::size_t place = error.hint.find(coupled); place != std::string::npos) {
      error.hint.replace(place, coupled.size(), "vessel.motion.");
    }
    add_error(error, file, diagnostics);
    return {};
  }
}

/// One .rao file.
struct HydroStarMotion {
  int freedom = -1;
  std::string unit;
  std::vector<double> headings;  ///< [rad]
  std::optional<Vec3> reference;
  std::vector<RaoRecord> records;
};

class HydroStarParser {
 public:
  explicit HydroStarParser(const std::string& text) : table_(split_table(text, ' ')) {}

  HydroStarMotion parse() {
    for (const TextRow& remark : table_.remarks) take_remark(remark);
    if (motion_.freedom < 0) throw HullFileError("no COMPONENT", "a file of motions of HydroStar");
    if (motion_.headings.empty()) throw HullFileError("no #HEADING", "the wave headings");
    if (headings_ != 0 && headings_ != motion_.headings.size()) {
      throw HullFileError(std::to_string(motion_.headings.size()) + " headings",
                          "NBHEADING " + std::to_string(headings_));
    }
    scale_ = find_scale();
    for (const TextRow& row : table_.rows) take_row(row);
    return std::move(motion_);
  }

 private:
  void take_remark(const TextRow& remark) {
    const std::string key = std::string(trim(remark.cells[0]));
    if (remark.cells.size() == 2) {
      const std::string value(remark.cells[1]);
      if (key == "RAOTYPE" && value != "MOTION") {
        throw HullFileError(remark.line, "RAOTYPE " + for_display(value), "MOTION");
      }
      if (key == "COMPONENT") motion_.freedom = static_cast<int>(whole(remark.line, value, 1, 6, "1 to 6")) - 1;
      if (key == "NBHEADING") headings_ = static_cast<std::size_t>(whole(remark.line, value, 1, 1000, "their number"));
      if (key == "UNIT") motion_.unit = value;
      if (key == "Forward speed") check_speed(remark.line, value);
      if (key.starts_with("Reference point")) take_reference(remark.line, value);
    } else if (key.starts_with("HEADING")) {
      const TextTable cells = split_table(key, ' ');
      for (std::size_t k = 1; k < cells.rows[0].cells.size(); ++k) {
        const auto angle = cell_number(cells.rows[0].cells[k]);
        if (!angle) {
          throw HullFileError(remark.line, "'" + for_display(cells.rows[0].cells[k]) + "'", "a wave heading in deg");
        }
        motion_.headings.push_back(*angle * kDegree);
      }
    }
  }

  static double whole(int line, const std::string& text, double low, double high, const char* expected) {
    const auto value = cell_number(text);
    if (value && *value >= low && *value <= high && *value == std::floor(*value)) return *value;
    throw HullFileError(line, "'" + for_display(text) + "'", expected);
  }

  static void check_speed(int line, const std::string& text) {
    const TextTable cells = split_table(text, ' ');
    const auto speed = cells.rows.empty() ? std::nullopt : cell_number(cells.rows[0].cells[0]);
    if (speed && std::abs(*speed) > 1e-6) {
      throw HullFileError(line, "a forward speed of " + format_number(*speed) + " m/s",
                          "a vessel without forward speed");
    }
  }

  void take_reference(int line, const std::string& text) {
    std::string plain = text;
    for (char& c : plain) {
      if (c == '(' || c == ')' || c == ',') c = ' ';
    }
    const TextTable cells = split_table(plain, ' ');
    const std::vector<double> p = cells.rows.empty() ? std::vector<double>() : numbers_in(cells.rows[0]);
    if (p.size() != 3) throw HullFileError(line, "'" + for_display(text) + "'", "the reference point, ( x y z )");
    motion_.reference = Vec3(p[0], p[1], p[2]);
    check_point(*motion_.reference, line, "the reference point");
  }

  /// Factor to m/m or deg/m.
  double find_scale() const {
    const bool turns = motion_.freedom > 2;
    if (!turns && motion_.unit == "m/m") return 1.0;
    if (turns && motion_.unit == "deg/m") return 1.0;
    if (turns && motion_.unit == "rad/m") return 1.0 / kDegree;
    throw HullFileError("UNIT '" + for_display(motion_.unit) + "'", turns ? "deg/m or rad/m" : "m/m");
  }

  void take_row(const TextRow& row) {
    const std::size_t count = motion_.headings.size();
    if (row.cells.size() != 1 + 2 * count) {
      throw HullFileError(row.line, std::to_string(row.cells.size()) + " numbers",
                          std::to_string(1 + 2 * count) + ": frequency, amplitudes and phases of " +
                              std::to_string(count) + " headings");
    }
    const double omega = require_number(row, 0, "a frequency in rad/s");
    if (!(omega > 0.0)) throw HullFileError(row.line, "the frequency " + format_number(omega), "more than 0");
    for (std::size_t k = 0; k < count; ++k) {
      const double amplitude = require_number(row, 1 + k, "an amplitude");
      const double phase = require_number(row, 1 + count + k, "a phase in deg");
      if (amplitude < 0.0) throw HullFileError(row.line, "an amplitude below zero", "at least 0");
      motion_.records.push_back(
          {motion_.headings[k], omega, motion_.freedom, amplitude * scale_, phase * kDegree, row.line});
    }
  }

  TextTable table_;
  HydroStarMotion motion_;
  std::size_t headings_ = 0;
  double scale_ = 1.0;
};

/// Name of the file of another motion: hull_heave.rao to hull_roll.rao. Empty if the name contains none of the motions.
std::string sibling(const std::string& file, int freedom) {
  const std::filesystem::path path(file);
  const std::string name = path.filename().string(), lower = lower_case(name);
  for (const char* motion : kFreedomNames) {
    const std::size_t place = lower.rfind(motion);
    if (place == std::string::npos) continue;
    const bool capitals = name.substr(place, 1) != lower.substr(place, 1);
    std::string wanted = kFreedomNames[static_cast<std::size_t>(freedom)];
    if (capitals) wanted[0] = static_cast<char>(wanted[0] - 'a' + 'A');
    return (path.parent_path() / (name.substr(0, place) + wanted + name.substr(place + std::string(motion).size())))
        .string();
  }
  return "";
}

/// Sense of the phases that long waves suggest: a vessel follows them, and surges forward a quarter period after the
/// crest has passed in waves from astern. Empty if the file has no such waves.
std::string suggested_sense(const std::vector<RaoRecord>& records) {
  const RaoRecord* max_period = nullptr;
  for (const RaoRecord& record : records) {
    const bool surge = record.freedom == 0 && std::abs(std::cos(record.heading)) > 0.5 && record.amplitude > 0.1;
    if (surge && (max_period == nullptr || record.omega < max_period->omega)) max_period = &record;
  }
  if (max_period == nullptr) return "";
  const double sine = std::sin(max_period->phase) * std::cos(max_period->heading);
  return sine > 0.0 ? "lag" : "lead";
}

HydroStarMotion read_motion(const std::string& text, const std::string& file) {
  try {
    return HydroStarParser(text).parse();
  } catch (const HullFileError& error) {
    throw error.in_file(file);
  }
}

void add_motion(RaoFile& content, HydroStarMotion motion, int freedom, const std::string& file) {
  if (motion.freedom != freedom) {
    throw HullFileError("COMPONENT " + std::to_string(motion.freedom + 1),
                        std::to_string(freedom + 1) + ", " + kFreedomNames[static_cast<std::size_t>(freedom)])
        .in_file(file);
  }
  if (content.stated.reference && motion.reference && (*content.stated.reference - *motion.reference).norm() > 1e-6) {
    throw HullFileError("another reference point", "that of the other files").in_file(file);
  }
  if (motion.reference) content.stated.reference = motion.reference;
  content.records.insert(content.records.end(), motion.records.begin(), motion.records.end());
}

}  // namespace

RaoFile read_wamit_output(const std::string& text, const std::string& file, const RaoSettings& user_settings,
                          Diagnostics& diagnostics) {
  return reported(file, diagnostics, [&] {
    const WamitOutput out = parse_wamit_output(HullText(text, file));
    const std::size_t index = find_body(user_settings.body, std::vector<std::string>(out.bodies.size()));
    RaoFile content;
    const double angle_scale = user_settings.length_scale / out.length_scale;
    for (const WamitOutput::WaveValue& value : out.motions) {
      const int freedom = value.mode - 1 - 6 * static_cast<int>(index);
      if (freedom < 0 || freedom > 5 || !(value.omega > 0.0) || std::isinf(value.omega)) continue;
      content.records.push_back({value.heading - out.bodies[index].turned, value.omega, freedom,
                                 value.modulus * (freedom > 2 ? angle_scale : 1.0), value.phase, value.line});
    }
    if (content.records.empty()) throw HullFileError("no RESPONSE AMPLITUDE OPERATORS", "those of the body");
    const WamitPoints points = find_wamit_points(out.bodies[index], Vec3::Zero());
    content.stated.values = {{"phase", "lead"}, {"rotation", "rad_per_m"}};
    content.stated.reference = points.origin;
    content.stated.wave_origin = points.wave_origin;
    content.axes_of_file = true;
    content.notes.push_back(
        "The RAOs of " + file_name(file) +
        " are those of the origin of the body's axes, with phases relative to the global X = Y = 0.");
    return content;
  });
}

RaoFile read_aqwa_listing(const std::string& text, const std::string& file, const RaoSettings& user_settings,
                          Diagnostics& diagnostics) {
  return reported(file, diagnostics, [&] {
    const AqwaData data = parse_aqwa_listing(HullText(text, file));
    const AqwaData::Structure& structure = find_structure(data, user_settings.body);
    RaoFile content;
    for (const AqwaData::WaveValues& values : structure.motions) {
      for (std::size_t k = 0; k < 6; ++k) {
        content.records.push_back(
            {values.heading, values.omega, static_cast<int>(k), values.amplitude[k], values.phase[k], values.line});
      }
    }
    if (content.records.empty()) throw HullFileError("no R.A.O.S-VARIATION", "the motions of the structure");
    if (!structure.centre_of_gravity) throw HullFileError("no centre of gravity", "that of the structure");
    content.stated.values = {{"phase", "lag"}, {"rotation", "deg_per_m"}};
    content.stated.reference = content.stated.wave_origin = structure.centre_of_gravity;
    content.axes_of_file = true;
    content.notes.push_back("The RAOs of " + file_name(file) + " are those of the centre of gravity.");
    return content;
  });
}

RaoFile read_hydrostar(const std::string& text, const std::string& file, const RaoSettings& user_settings,
                       Diagnostics& diagnostics) {
  return reported(file, diagnostics, [&] {
    RaoFile content;
    HydroStarMotion given = read_motion(text, file);
    if (sibling(file, 0).empty()) {
      throw HullFileError("a file of one motion", "six files named surge to yaw, such as hull_heave.rao");
    }
    for (int freedom = 0; freedom < 6; ++freedom) {
      const std::string name = sibling(file, freedom);
      if (freedom == given.freedom) {
        add_motion(content, given, freedom, file);
        continue;
      }
      const std::optional<std::string> content_text = read_text_file(name, diagnostics);
      if (!content_text) return RaoFile();
      add_motion(content, read_motion(*content_text, name), freedom, name);
    }
    content.stated.values = {{"rotation", "deg_per_m"}};
    content.stated.wave_origin = content.stated.reference;
    content.axes_of_file = true;
    if (user_settings.values.count("phase") == 0 && user_settings.set.empty()) {
      const std::string sense = suggested_sense(content.records);
      throw HullFileError("phases whose sense the file does not state", "vessel.motion.convention.phase: lag or lead",
                          sense.empty() ? "" : "the surge in long waves suggests " + sense);
    }
    return content;
  });
}

}  // namespace overbend::rao_formats
