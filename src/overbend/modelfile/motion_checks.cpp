#include "base/text.h"
#include "model/description_words.h"
#include "modelfile/check_helper.h"
#include "modelfile/model_checks.h"

namespace overbend {
namespace {

/// The keys that say where the motion comes from.
std::vector<std::string> sources() {
  std::vector<std::string> words = words_of<VesselMotion>();
  std::erase(words, word_of(VesselMotion::fixed));
  return words;
}

}  // namespace

void check_motion(const FieldValue& root, const std::string& file, Diagnostics& diagnostics) {
  Checker check(root, file, diagnostics);
  const FieldValue* motion = root.find("vessel.motion");
  if (motion == nullptr || motion->kind != FieldValue::Kind::map) return;
  static const std::vector<std::string> kSources = sources();
  std::vector<std::string> given;
  for (const std::string& source : kSources) {
    if (motion->mentions(source)) given.push_back(source);
  }
  const FieldValue* convention = motion->find("convention");
  const bool stated = convention != nullptr && convention->given;
  if (given.size() > 1 || (given.empty() && (stated || motion->mentions("convention")))) {
    check.error(*motion, given.empty() ? "a convention without a motion" : join_words(given, "and"),
                "1 of " + join_words(kSources, "or"));
    return;
  }
  if (!stated || given.empty() || given.front() == word_of(VesselMotion::raos)) return;
  for (const FieldValue& key : convention->children) {
    if (key.given && (key.key != "reference" || given.front() == word_of(VesselMotion::coupled))) {
      check.warn(key, "has no meaning for a motion by " + given.front() + " and is not used");
    }
  }
}

}  // namespace overbend
