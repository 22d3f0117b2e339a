#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "model/description/description_words.h"
#include "modelfile/checks/model_checks.h"
#include "modelfile/schema/check_helper.h"

namespace overbend {
namespace {

/// The keys that say where the motion comes from.
std::vector<std::string> sources(const FieldValue& motion) {
  std::vector<std::string> words = words_of<VesselMotion>();
  std::erase(words, word_of(VesselMotion::fixed));
  if (!motion.path.starts_with("vessel.")) std::erase(words, word_of(VesselMotion::coupled));
  return words;
}

/// Amplitude and period of a freedom that no vessel has together.
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
  const std::vector<std::string> known = sources(motion);
  if (const FieldValue* harmonic = motion.find("harmonic"); harmonic != nullptr) {
    for (const FieldValue& freedom : harmonic->children) check_harmonic(check, freedom);
  }
  std::vector<std::string> given;
  for (const std::string& source : known) {
    if (motion.mentions(source)) given.push_back(source);
  }
  const FieldValue* convention = motion.find("convention");
  const bool stated = convention != nullptr && convention->given;
  if (given.size() > 1 || (given.empty() && (stated || motion.mentions("convention")))) {
    check.error(motion, given.empty() ? "a convention without a motion" : join_words(given, "and"),
                "1 of " + join_words(known, "or"));
    return;
  }
  if (!stated || given.empty() || given.front() == word_of(VesselMotion::raos)) return;
  for (const FieldValue& key : convention->children) {
    if (key.given && (key.key != "reference" || given.front() == word_of(VesselMotion::coupled))) {
      check.warn(key, "has no meaning for a motion by " + given.front() + " and is not used",
                 FindingCode::unused_input);
    }
  }
}

}  // namespace overbend
