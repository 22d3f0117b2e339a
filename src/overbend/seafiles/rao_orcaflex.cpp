// Reads displacement RAOs from OrcaFlex text data files. The layout follows publicly available files.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "base/yaml_document.h"
#include "model/waves/rao_table.h"
#include "orcaflex/unit_system.h"
#include "seafiles/rao_formats.h"
#include "seafiles/text_table.h"

namespace overbend::rao_formats {
namespace {

const YamlNode* member(const YamlNode& node, const std::string& key) {
  for (const YamlEntry& entry : node.entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

/// A setting of OrcaFlex and the translation of its values; the first is the default if the key is absent.
struct Setting {
  const char* theirs;
  const char* ours;
  std::vector<std::pair<const char*, const char*>> values;
};

const std::vector<Setting>& settings() {
  static const std::vector<Setting> kSettings = {
      {"RAOPhaseConvention", "phase", {{"lags", "lag"}, {"leads", "lead"}}},
      {"RAOPhaseRelativeToConvention",
       "phase_zero",
       {{"crest", "crest"},
        {"trough", "trough"},
        {"zero up-crossing", "up_crossing"},
        {"zero down-crossing", "down_crossing"}}},
      {"SurgePositive", "positive.surge", {{"forward", "forward"}, {"aft", "aft"}}},
      {"SwayPositive", "positive.sway", {{"port", "port"}, {"starboard", "starboard"}}},
      {"HeavePositive", "positive.heave", {{"up", "up"}, {"down", "down"}}},
      {"RollPositiveStarboard", "positive.roll", {{"down", "starboard_down"}, {"up", "port_down"}}},
      {"PitchPositiveBow", "positive.pitch", {{"down", "bow_down"}, {"up", "bow_up"}}},
      {"YawPositiveBow", "positive.yaw", {{"port", "bow_to_port"}, {"starboard", "bow_to_starboard"}}},
  };
  return kSettings;
}

constexpr double kSameLength = 0.02;

class OrcaFlexReader {
 public:
  OrcaFlexReader(std::string file, const RaoSettings& user_settings, OrcaFlexRaos kind, Diagnostics& diagnostics)
      : file_(std::move(file)), user_settings_(user_settings), kind_(kind), diagnostics_(diagnostics) {}

  bool has_table(const std::string& text) {
    const std::optional<YamlNode> root = parse_yaml(text, file_, diagnostics_);
    if (!root || diagnostics_.has_errors()) return false;
    const YamlNode* draught = find_draught(*root);
    const YamlNode* raos = draught != nullptr ? member(*draught, group_name()) : nullptr;
    const YamlNode* list = raos != nullptr ? member(*raos, "RAOs") : nullptr;
    return list != nullptr && !list->items.empty();
  }

  RaoFile read(const std::string& text) {
    const std::optional<YamlNode> root = parse_yaml(text, file_, diagnostics_);
    if (!root || diagnostics_.has_errors()) return {};
    read_unit(*root);
    const YamlNode* draught = find_draught(*root);
    if (draught == nullptr) return {};
    read_settings(*type_);
    const YamlNode* raos = member(*draught, group_name());
    const YamlNode* list = raos != nullptr ? member(*raos, "RAOs") : nullptr;
    if (list == nullptr || list->items.empty()) {
      complain(draught->line, std::string("Draughts.") + group_name() + ".RAOs", "nothing",
               "a list of RAODirection with its table");
      return {};
    }
    read_points(*raos);
    for (const YamlNode& direction : list->items) read_direction(direction);
    return std::move(content_);
  }

 private:
  void complain(int line, const std::string& key, const std::string& found, const std::string& expected,
                const std::string& hint = {}) {
    diagnostics_.add({Severity::error, file_, line, 0, key, found, expected, hint});
  }

  const char* group_name() const {
    return kind_ == OrcaFlexRaos::displacement ? "DisplacementRAOs"
           : kind_ == OrcaFlexRaos::load       ? "LoadRAOs"
                                               : "WaveDrift";
  }

  const YamlNode* find_draught(const YamlNode& root) {
    type_ = choose(root, "VesselTypes", user_settings_.vessel_type, "vessel_type");
    return type_ != nullptr ? choose(*type_, "Draughts", user_settings_.draught, "draught") : nullptr;
  }

  /// Lengths of the file are in its unit, rotations per that unit of wave amplitude.
  void read_unit(const YamlNode& root) {
    const YamlNode* general = member(root, "General");
    if (general == nullptr) return;
    units_ = orcaflex::read_units(orcaflex::Object(*general, {file_, "General", &diagnostics_}));
    length_unit_ = units_.length;
  }

  /// Returns the selected item of a list of named groups, or the only item.
  const YamlNode* choose(const YamlNode& parent, const std::string& key, const std::string& wanted,
                         const std::string& asked_by) {
    const YamlNode* list = member(parent, key);
    if (list == nullptr || list->items.empty()) {
      complain(parent.line, key, "nothing", "a list of named groups",
               "save a text data file (.yml) that contains the vessel type");
      return nullptr;
    }
    if (wanted.empty() && list->items.size() == 1) return &list->items.front();
    std::vector<std::string> names;
    for (const YamlNode& item : list->items) {
      const YamlNode* name = member(item, "Name");
      names.push_back(name != nullptr ? for_display(name->text) : "(without name)");
      if (name != nullptr && !wanted.empty() && name->text == wanted) return &item;
    }
    complain(list->line, key, wanted.empty() ? "several" : "none called '" + for_display(wanted) + "'",
             join_choices(names),
             std::string("select with vessel.motion.") +
                 (kind_ == OrcaFlexRaos::displacement ? "convention." : "coupled.convention.") + asked_by);
    return nullptr;
  }

  /// Returns the value of a setting of the vessel type, or its default if absent; reports values that are not `known`.
  std::string word(const YamlNode& type, const std::string& key, const std::vector<std::string>& known) {
    const YamlNode* node = member(type, key);
    if (node == nullptr) return known.front();
    if (std::find(known.begin(), known.end(), node->text) == known.end()) {
      complain(node->line, key, "'" + for_display(node->text) + "'", join_choices(known));
      return known.front();
    }
    return node->text;
  }

  void read_settings(const YamlNode& type) {
    if (member(type, "RAOPhaseConvention") == nullptr && user_settings_.values.count("phase") == 0) {
      complain(type.line, "RAOPhaseConvention", "nothing (the key is missing)", "lags or leads",
               kind_ == OrcaFlexRaos::displacement ? "set vessel.motion.convention.phase" : "");
    }
    for (const Setting& setting : settings()) {
      std::vector<std::string> known;
      for (const auto& [theirs, ours] : setting.values) known.emplace_back(theirs);
      const std::string chosen = word(type, setting.theirs, known);
      for (const auto& [theirs, ours] : setting.values) {
        if (chosen == theirs) content_.stated.values[setting.ours] = ours;
      }
    }
    wave_ = word(type, "WavesReferredToBy", {"period (s)", "frequency (rad/s)", "frequency (Hz)"});
    phase_unit_ = word(type, "RAOPhaseUnitsConvention", {"degrees", "radians"}) == "radians" ? 1.0 : kPi / 180.0;
    read_symmetry(type);
    check_length(type);
    read_rotation(type);
  }

  void read_symmetry(const YamlNode& type) {
    static const std::vector<std::pair<std::string, RaoSymmetry>> kKnown = {{"None", RaoSymmetry::none},
                                                                            {"xz plane", RaoSymmetry::port_starboard},
                                                                            {"yz plane", RaoSymmetry::fore_aft},
                                                                            {"xz and yz planes", RaoSymmetry::quarters},
                                                                            {"circular", RaoSymmetry::circular}};
    if (member(type, "Symmetry") == nullptr) return;
    std::vector<std::string> names;
    for (const auto& [name, symmetry] : kKnown) names.push_back(name);
    const std::string stated = word(type, "Symmetry", names);
    for (const auto& [name, symmetry] : kKnown) {
      if (name == stated) content_.symmetry = symmetry;
    }
  }

  /// Warns if the RAOs belong to a vessel of another length.
  void check_length(const YamlNode& type) {
    const YamlNode* node = member(type, "Length");
    const std::optional<double> length = node != nullptr ? scalar(*node) : std::nullopt;
    if (!length || *length <= 0.0 || user_settings_.vessel_length <= 0.0) return;
    if (std::abs(*length * length_unit_ / user_settings_.vessel_length - 1.0) <= kSameLength) return;
    diagnostics_.add({Severity::warning, file_, node->line, 0, "Length",
                      "the vessel of the RAOs is " + format_number(*length * length_unit_) +
                          " m long, the vessel of the model " + format_number(user_settings_.vessel_length) +
                          " m; the RAOs are used without scaling",
                      "", ""});
  }

  /// Checks that reference points lie on the planes and axes of symmetry, as the symmetry of motions requires.
  void check_points(const YamlNode& raos) {
    const bool in_length = content_.symmetry == RaoSymmetry::fore_aft || content_.symmetry == RaoSymmetry::quarters ||
                           content_.symmetry == RaoSymmetry::circular;
    for (const auto& [key, p] :
         {std::pair{"RAOOrigin", content_.stated.reference}, std::pair{"PhaseOrigin", content_.stated.wave_origin}}) {
      if (!p || !in_length) continue;
      const bool across = content_.symmetry == RaoSymmetry::circular && p->y() != 0.0;
      if (p->x() == 0.0 && !across) continue;
      complain(raos.line, key, "a point off the plane or axis of Symmetry",
               "x of 0" + std::string(across ? ", y of 0" : ""), "save RAOs for all headings with Symmetry: None");
    }
  }

  void read_rotation(const YamlNode& type) {
    if (kind_ != OrcaFlexRaos::displacement) return read_wave_unit(type);
    const bool degrees = word(type, "RAOResponseUnits", {"degrees", "radians"}) == "degrees";
    const std::string per = word(type, "RAOWaveUnit", {"amplitude", "wave steepness", "max wave slope"});
    is_per_length_ = per == "amplitude";
    if (is_per_length_) {
      content_.stated.values["rotation"] = degrees ? "deg_per_m" : "rad_per_m";
    } else if (!degrees) {
      content_.stated.values["rotation"] = per == "max wave slope" ? "per_slope" : "rad_per_steepness";
    } else if (user_settings_.values.count("rotation") == 0) {
      complain(member(type, "RAOWaveUnit")->line, "RAOWaveUnit", "degrees per " + per, "per amplitude, or radians",
               "set vessel.motion.convention.rotation");
    }
  }

  /// Loads are per wave amplitude; the unit of rotations is of no matter to them.
  void read_wave_unit(const YamlNode& type) {
    content_.stated.values["rotation"] = "rad_per_m";
    const std::string per = word(type, "RAOWaveUnit", {"amplitude", "wave steepness", "max wave slope"});
    if (per == "amplitude" || kind_ == OrcaFlexRaos::drift) return;
    complain(member(type, "RAOWaveUnit")->line, "RAOWaveUnit", "loads per " + per, "loads per amplitude");
  }

  static std::optional<double> scalar(const YamlNode& node) {
    return node.kind == YamlNode::Kind::scalar ? cell_number(node.text) : std::nullopt;
  }

  void read_points(const YamlNode& raos) {
    content_.stated.reference = point(raos, "RAOOrigin");
    if (!content_.stated.reference && !diagnostics_.has_errors()) content_.stated.reference = Vec3::Zero();
    content_.stated.wave_origin = point(raos, "PhaseOrigin");
    if (!content_.stated.wave_origin) content_.stated.wave_origin = content_.stated.reference;
    check_points(raos);
  }

  /// Returns a point `[x, y, z]`; nothing if it is absent or left at its default '~'.
  std::optional<Vec3> point(const YamlNode& raos, const std::string& key) {
    const YamlNode* node = member(raos, key);
    if (node == nullptr) return std::nullopt;
    const auto open = [](const YamlNode& item) { return item.kind == YamlNode::Kind::null; };
    if (node->kind == YamlNode::Kind::null || (!node->items.empty() && open(node->items.front()))) return std::nullopt;
    Vec3 p = Vec3::Zero();
    bool right = node->items.size() == 3;
    for (std::size_t i = 0; right && i < 3; ++i) {
      const std::optional<double> value = scalar(node->items[i]);
      right = value && std::abs(*value) < 1e4;
      if (right) p(static_cast<Eigen::Index>(i)) = *value * length_unit_;
    }
    if (right) return p;
    complain(node->line, key, "no point", "[x, y, z] in metres");
    return std::nullopt;
  }

  /// Returns the frequency [rad/s]; 0 for the limits of zero and infinite frequency, which are skipped.
  double frequency_of_value(double value) const {
    if (value <= 0.0) return 0.0;
    return wave_ == "period (s)" ? 2.0 * kPi / value : wave_ == "frequency (Hz)" ? 2.0 * kPi * value : value;
  }

  /// Returns the columns of amplitude and phase of each degree of freedom, from the key above the rows.
  std::array<std::array<std::size_t, 2>, 6> find_response_columns(const std::string& key, bool& complete) const {
    constexpr std::array<const char*, 6> kTheirs = {"Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"};
    const TextTable names = split_table(key, ',');
    std::array<std::array<std::size_t, 2>, 6> columns{};
    complete = names.rows.size() == 1;
    for (std::size_t k = 0; complete && k < 6; ++k) {
      for (std::size_t part = 0; part < 2; ++part) {
        const std::string name = std::string("RAO") + kTheirs[k];
        const std::string wanted = name + (part == 0 ? "Amp" : "Phase");
        const auto& cells = names.rows[0].cells;
        auto found = std::find(cells.begin(), cells.end(), wanted);
        // Drift has no phases: both parts are the same column.
        if (kind_ == OrcaFlexRaos::drift) {
          found = std::find(cells.begin(), cells.end(), name);
          if (found == cells.end()) found = std::find(cells.begin(), cells.end(), name + "Amp");
        }
        complete = complete && found != cells.end();
        columns[k][part] = static_cast<std::size_t>(found - cells.begin());
      }
    }
    return columns;
  }

  void read_direction(const YamlNode& direction) {
    const YamlNode* angle = member(direction, "RAODirection");
    const std::optional<double> heading = angle != nullptr ? scalar(*angle) : std::nullopt;
    if (!heading) {
      complain(direction.line, "RAODirection", "nothing", "the direction the waves travel in, in degrees");
      return;
    }
    for (const YamlEntry& entry : direction.entries) {
      if (entry.key.rfind("RAOPeriodOrFreq", 0) != 0) continue;
      bool complete = false;
      const auto columns = find_response_columns(entry.key, complete);
      if (!complete) {
        complain(entry.line, "RAOPeriodOrFrequency",
                 kind_ == OrcaFlexRaos::drift ? "not all of RAOSurge to RAOYaw"
                                              : "not all of RAOSurgeAmp, RAOSurgePhase to RAOYawPhase",
                 kind_ == OrcaFlexRaos::drift ? "a column for each of the six degrees of freedom"
                                              : "amplitude and phase of the six degrees of freedom");
        return;
      }
      for (const YamlNode& row : entry.value.items) read_row(row, *heading, columns);
      return;
    }
    complain(direction.line, "RAODirection", "no table", "RAOPeriodOrFrequency, RAOSurgeAmp, RAOSurgePhase, ...");
  }

  void read_row(const YamlNode& row, double heading, const std::array<std::array<std::size_t, 2>, 6>& columns) {
    const auto limit = [](const YamlNode& cell) { return cell.text == "Infinity" || cell.text == "~"; };
    if (row.items.empty() || limit(row.items[0])) return;
    std::vector<double> numbers;
    for (const YamlNode& cell : row.items) {
      const std::optional<double> value = scalar(cell);
      if (!value) {
        complain(cell.line, "RAOs", "'" + for_display(cell.text) + "'", "a number");
        return;
      }
      numbers.push_back(*value);
    }
    const double omega = frequency_of_value(numbers[0]);
    if (omega <= 0.0) return;
    for (std::size_t k = 0; k < 6; ++k) {
      if (std::max(columns[k][0], columns[k][1]) >= numbers.size()) {
        complain(row.line, "RAOs", std::to_string(numbers.size()) + " numbers", "one for each name in the key above");
        return;
      }
      const double phase = kind_ == OrcaFlexRaos::drift ? 0.0 : numbers[columns[k][1]] * phase_unit_;
      content_.records.push_back(
          {heading * kPi / 180.0, omega, static_cast<int>(k), numbers[columns[k][0]] * scale(k), phase, row.line});
    }
  }

  /// Factor that turns the values of a degree of freedom into SI, except angles.
  double scale(std::size_t freedom) const {
    const double moment = freedom < 3 ? 1.0 : length_unit_;
    if (kind_ == OrcaFlexRaos::load) return units_.force * moment / length_unit_;
    if (kind_ == OrcaFlexRaos::drift) return units_.force * moment / (length_unit_ * length_unit_);
    return 1.0 / (freedom < 3 || !is_per_length_ ? 1.0 : length_unit_);
  }

  std::string file_;
  const RaoSettings& user_settings_;
  OrcaFlexRaos kind_;
  Diagnostics& diagnostics_;
  const YamlNode* type_ = nullptr;
  orcaflex::UnitSystemOfFile units_;
  RaoFile content_;
  std::string wave_;
  double phase_unit_ = kPi / 180.0;
  double length_unit_ = 1.0;    ///< [m]
  bool is_per_length_ = false;  ///< Rotations per wave amplitude.
};

}  // namespace

RaoFile read_orcaflex(const std::string& text, const std::string& file, const RaoSettings& user_settings,
                      Diagnostics& diagnostics, OrcaFlexRaos raos) {
  return OrcaFlexReader(file, user_settings, raos, diagnostics).read(text);
}

bool has_orcaflex_raos(const std::string& text, const RaoSettings& user_settings, OrcaFlexRaos raos) {
  Diagnostics ignored;
  return OrcaFlexReader("", user_settings, raos, ignored).has_table(text);
}

}  // namespace overbend::rao_formats
