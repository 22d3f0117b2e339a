#include <cmath>

#include "base/text.h"
#include "base/units.h"
#include "model/description/description_enum_names.h"
#include "modelfile/checks/line_checks.h"
#include "modelfile/checks/model_checks.h"

namespace overbend {
namespace {

/// Checks that the anchor position is given in one of three ways.
void check_anchor(Checker& check, const FieldValue& line) {
  std::vector<std::string> keys;
  for (const char* key : {"azimuth", "bearing", "anchor"}) {
    if (line.mentions(key)) keys.emplace_back(key);
  }
  if (keys.size() != 1) {
    check.error(line, keys.empty() ? "no anchor position" : join_items(keys, "and"),
                "one of azimuth, bearing or anchor");
    return;
  }
  const FieldValue* distance = line.find("anchor_distance");
  if (keys.front() == "anchor") {
    if (distance != nullptr) {
      check.error(*distance, "a distance and the position of the anchor", "one of them");
    }
  } else if (!line.mentions("anchor_distance")) {
    check.missing(line, "anchor_distance", "a length with its unit", "or give the position of the anchor");
  }
}

/// Checks that a fairlead is above the seabed and not farther from the hull than the hull is large.
void check_fairlead(Checker& check, const FieldValue& line) {
  const FieldValue* z = line.find("fairlead.z");
  const auto depth = level_bed(check.root());
  if (z != nullptr && depth && z->number <= -*depth) {
    check.error(*z, z->shown, "above the seabed, " + format_quantity(-*depth, "m", "m"));
    return;
  }
  const FieldValue* vessel = check.root().find("vessel");
  if (vessel == nullptr) return;
  const auto far = [&](const char* key, double reach) {
    const FieldValue* place = line.find(key);
    if (place == nullptr || std::abs(place->number) <= reach) return;
    check.error(*place, place->shown + ", far outside the vessel",
                "within " + format_quantity(reach, "m", "m") + " either way", "is the unit right?");
  };
  far("fairlead.x", vessel->get_number("length").value_or(0.0));
  far("fairlead.y", 2.0 * vessel->get_number("beam").value_or(0.0));
  far("fairlead.z", 100.0);
}

void check_holding(Checker& check, const FieldValue& line) {
  const FieldValue* slides = line.find("anchor_slides");
  if (slides != nullptr && slides->text == enum_name(true) && !line.mentions("anchor_holding")) {
    check.missing(line, "anchor_holding", "a force with its unit", "required for an anchor that slides");
  }
}

void check_winch(Checker& check, const FieldValue& winch) {
  if (winch.get_word<WinchMode>("mode") == WinchMode::tension && !winch.mentions("tension")) {
    check.missing(winch, "tension", "a force with its unit", "required in mode tension");
  }
  const FieldValue *haul = winch.find("haul"), *stall = winch.find("stall"), *brake = winch.find("brake");
  if (haul != nullptr && stall != nullptr && stall->number < haul->number) {
    check.error(*stall, stall->shown, "at least haul, " + haul->shown);
  }
  if (stall != nullptr && brake != nullptr && brake->number < stall->number) {
    check.warn(*brake, "the brake renders below the tension at which the winch stalls, " + stall->shown);
  }
}

/// Checks that the steps of a program are in order and that the mode of the winch uses it.
void check_program(Checker& check, const FieldValue& winch) {
  const std::vector<FieldValue>& steps = Checker::items(winch, "program");
  const WinchMode mode = winch.get_word<WinchMode>("mode").value_or(WinchMode::hold);
  if (!steps.empty() && mode != WinchMode::speed && mode != WinchMode::length) {
    check.error(*winch.find("program"), std::string("a program in mode ") + enum_name(mode), "mode speed or length");
  }
  if (steps.empty() && mode == WinchMode::speed) {
    check.missing(winch, "program", "a list of time and paid_out", "required in mode speed");
  }
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const FieldValue *before = steps[i - 1].find("time"), *time = steps[i].find("time");
    if (before != nullptr && time != nullptr && time->number <= before->number) {
      check.error(*time, time->shown, "later than the step before, " + before->shown);
    }
  }
}

void check_winches(Checker& check, const std::set<std::string>& used) {
  const FieldValue* winches = check.root().find("moorings.winches");
  if (winches == nullptr) return;
  for (const FieldValue& winch : winches->children) {
    check_winch(check, winch);
    check_program(check, winch);
    if (used.count(winch.key) == 0) check.warn(winch, "no line uses this winch", FindingCode::unused_input);
  }
}

/// Warns if the pose of a hull with prescribed motion is not sought.
void check_pose(Checker& check, const FieldValue& moorings) {
  const FieldValue *find = moorings.find("find"), *motion = check.root().find("vessel.motion");
  const bool pose = find != nullptr && find->given && moorings.get_word<FindMooring>("find") == FindMooring::pose;
  if (!pose || hull_floats(check.root())) return;
  const bool prescribed = motion != nullptr && motion->given && motion->kind == FieldValue::Kind::map;
  check.warn(*find, std::string("no pose is found: the vessel is held as drawn, ") +
                        (prescribed ? "because its motion is prescribed" : "because the model gives no hydrostatics") +
                        "; give vessel.motion.coupled, or vessel.hydrostatics" +
                        (prescribed ? " without a motion" : ""));
}

void check_find(Checker& check) {
  const FieldValue* moorings = check.root().find("moorings");
  if (moorings == nullptr) return;
  const FieldValue *min_tension = moorings->find("least_tension"), *working_load = moorings->find("working_load");
  if (min_tension != nullptr && working_load != nullptr && min_tension->number >= working_load->number) {
    check.error(*min_tension, min_tension->shown, "less than the working load, " + working_load->shown);
  }
  check_pose(check, *moorings);
  if (moorings->get_word<FindMooring>("find") != FindMooring::lengths) return;
  for (const FieldValue& line : Checker::items(*moorings, "lines")) {
    if (!line.mentions("tension")) {
      check.missing(line, "tension", "a force with its unit", "find: lengths requires a target tension for each line");
    }
  }
}

/// Checks that a free hull has at least three lines, without which it has no unique equilibrium.
void check_count(Checker& check, const std::vector<FieldValue>& lines) {
  if (!hull_floats(check.root()) || lines.empty() || lines.size() >= 3) return;
  if (check.root().mentions("station_keeping") || check.root().mentions("pipe")) return;
  check.error(*check.root().find("moorings.lines"),
              std::to_string(lines.size()) + (lines.size() == 1 ? " line" : " lines") + " on a hull that floats free",
              "at least three", "or hold the hull: omit hydrostatics, or give station_keeping");
}

}  // namespace

void check_moorings(Checker& check, std::set<std::string>& used_types) {
  const std::vector<FieldValue>& lines = Checker::items(check.root(), "moorings.lines");
  check_unique_names(check, lines, "line");
  const std::vector<std::string> winches = names_below(check.root(), "moorings.winches");
  std::set<std::string> used_winches;
  for (const FieldValue& line : lines) {
    check_line_body(check, line, "tension", used_types);
    check_anchor(check, line);
    check_fairlead(check, line);
    check_holding(check, line);
    if (const FieldValue* winch = line.find("winch")) {
      used_winches.insert(winch->text);
      check_name(check, *winch, winches, "moorings.winches");
    }
  }
  check_winches(check, used_winches);
  check_find(check);
  check_count(check, lines);
}

}  // namespace overbend
