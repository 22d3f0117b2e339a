#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "model/description/description_enum_names.h"
#include "modelfile/checks/model_checks.h"
#include "modelfile/schema/check_helper.h"

namespace overbend {
namespace {

/// Returns the keys that select the source of the motion.
std::vector<std::string> source_keys(const FieldValue& motion) {
  std::vector<std::string> choices = enum_names<VesselMotion>();
  std::erase(choices, enum_name(VesselMotion::fixed));
  if (!motion.path.starts_with("vessel.")) std::erase(choices, enum_name(VesselMotion::coupled));
  return choices;
}

/// Warns of an implausible amplitude and period of a degree of freedom.
void check_harmonic(Checker& check, const FieldValue& freedom) {
  constexpr double kGravity = 9.81, kTurning = 100.0 * kDegree, kSteepest = 45.0 * kDegree;  // [m/s2, rad/s2, rad]
  const FieldValue *amplitude = freedom.find("amplitude"), *period = freedom.find("period");
  if (amplitude == nullptr || period == nullptr) return;
  const bool turns = freedom.key == "roll" || freedom.key == "pitch" || freedom.key == "yaw";
  const double acceleration = amplitude->number * std::pow(kTurn / period->number, 2);
  if (acceleration > (turns ? kTurning : kGravity)) {
    check.warn(*amplitude, amplitude->shown + " at a period of " + period->shown + " is an acceleration of " +
                               (turns ? format_number(acceleration * kToDegrees, 3) + " deg/s^2"
                                      : format_number(acceleration, 3) + " m/s^2") +
                               ", which no vessel has; are the units right?");
  } else if (turns && freedom.key != "yaw" && amplitude->number > kSteepest) {
    check.warn(*amplitude, amplitude->shown + " is steeper than a vessel rolls or pitches; is the unit right?");
  }
}

}  // namespace

void check_motion(const FieldValue& root, const std::string& file, Diagnostics& diagnostics) {
  Checker check(root, file, diagnostics);
  if (const FieldValue* motion = root.find("vessel.motion")) check_motion_source(check, *motion);
}

void check_motion_source(Checker& check, const FieldValue& motion) {
  if (motion.kind != FieldValue::Kind::map) return;
  const std::vector<std::string> known = source_keys(motion);
  if (const FieldValue* harmonic = motion.find("harmonic"); harmonic != nullptr) {
    for (const FieldValue& freedom : harmonic->children) check_harmonic(check, freedom);
  }
  std::vector<std::string> given_sources;
  for (const std::string& source : known) {
    if (motion.mentions(source)) given_sources.push_back(source);
  }
  const FieldValue* convention = motion.find("convention");
  const bool stated = convention != nullptr && convention->given;
  if (given_sources.size() > 1 || (given_sources.empty() && (stated || motion.mentions("convention")))) {
    check.error(motion, given_sources.empty() ? "a convention without a motion" : join_items(given_sources, "and"),
                "1 of " + join_items(known, "or"));
    return;
  }
  const FieldValue* columns = motion.find("columns");
  if (columns != nullptr && columns->given && !given_sources.empty() &&
      given_sources.front() != enum_name(VesselMotion::history)) {
    check.warn(*columns, "has no effect for a motion by " + given_sources.front() + " and is not used",
               FindingCode::unused_input);
  }
  if (!stated || given_sources.empty() || given_sources.front() == enum_name(VesselMotion::raos)) return;
  for (const FieldValue& key : convention->children) {
    if (key.given && (key.key != "reference" || given_sources.front() == enum_name(VesselMotion::coupled))) {
      check.warn(key, "has no effect for a motion by " + given_sources.front() + " and is not used",
                 FindingCode::unused_input);
    }
  }
}

}  // namespace overbend
