#include "report/warning_weight.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>

namespace overbend {
namespace {

/// How the reader marks what it noticed: "folder/model.yaml:12: warning: key: ...".
constexpr const char* kOfReader = ": warning: ";

std::string without_folder(const std::string& warning, std::size_t mark) {
  const std::size_t folder = warning.rfind('/', mark);
  return folder == std::string::npos ? warning : warning.substr(folder + 1);
}

/// Which of the serious phrases it has.
std::optional<std::size_t> serious_kind(const std::string& warning) {
  const std::vector<std::string>& phrases = serious_phrases();
  for (std::size_t kind = 0; kind < phrases.size(); ++kind) {
    if (warning.find(phrases[kind]) != std::string::npos) return kind;
  }
  return std::nullopt;
}

WeighedWarning weigh(const std::string& warning) {
  const std::size_t mark = warning.find(kOfReader);
  const bool serious = serious_kind(warning).has_value();
  if (mark != std::string::npos) {
    return {serious ? WarningWeight::serious : WarningWeight::input, without_mark(without_folder(warning, mark))};
  }
  WeighedWarning weighed{serious ? WarningWeight::serious : WarningWeight::caution, warning};
  if (!warning.empty()) weighed.text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(warning[0])));
  return weighed;
}

}  // namespace

const std::vector<std::string>& serious_phrases() {
  static const std::vector<std::string> kPhrases = {
      "the run does not begin at rest",
      "the pipe has left '",
      "the pipe left '",
      "the fatigue budget at '",
      "compression: the effective tension falls to",
      "exceeds the yield stress of",
      "is too low: the pipe there yields",
      "rollers are below the seabed",
      "the radiation in time does not represent the hydrodynamic file",
      "nothing moves in the dynamic analysis",
      "the vessel, and with it the pipe, is thrown by it",
      "yaw is the deviation from vessel.heading",
      "the seabed leaves the water",
      "the line through its neighbours: a curvature",
      "the tensioner was at its travel limit",
      "the tensioner paid out",
      "are the conventions (vessel.motion.convention) right?",
      "more than its breaking load",
      "more than its holding power",
      "is slack: it holds nothing",
      "falls slack and snaps tight",
      "an element is folded",
      "lifts its anchor with",
      "lifted its anchor with",
      "fewer than three do not hold surge, sway and yaw",
      "swing up by itself",
      "there it neither holds nor damps",
      "times its breaking load",
      "serious warnings, which no ",
      kNotJudged,
  };
  return kPhrases;
}

std::vector<std::string> serious_warnings(const std::vector<std::string>& warnings) {
  std::vector<std::string> serious;
  for (const std::string& warning : warnings) {
    if (serious_kind(warning)) serious.push_back(warning);
  }
  return serious;
}

std::string without_mark(const std::string& warning) {
  const std::size_t mark = warning.find(kOfReader);
  if (mark == std::string::npos) return warning;
  return warning.substr(0, mark) + ": " + warning.substr(mark + std::string(kOfReader).size());
}

const char* word(WarningWeight weight) {
  constexpr std::array<const char*, 3> kWords = {"Serious", "Caution", "Input"};
  return kWords[static_cast<std::size_t>(weight)];
}

std::vector<WeighedWarning> weighed(const std::vector<std::string>& warnings) {
  std::vector<WeighedWarning> firsts, others;
  std::set<std::size_t> kinds;
  for (const std::string& warning : warnings) {
    const std::optional<std::size_t> kind = serious_kind(warning);
    const bool again = kind && !kinds.insert(*kind).second;
    (again ? others : firsts).push_back(weigh(warning));
  }
  firsts.insert(firsts.end(), others.begin(), others.end());
  std::stable_sort(firsts.begin(), firsts.end(),
                   [](const WeighedWarning& a, const WeighedWarning& b) { return a.weight < b.weight; });
  return firsts;
}

std::string weight_words(const std::vector<WeighedWarning>& warnings) {
  constexpr std::array<const char*, 3> kKinds = {"{} serious", "{} caution", "{} input"};
  std::string words;
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    const auto count = std::count_if(warnings.begin(), warnings.end(), [&](const WeighedWarning& w) {
      return w.weight == static_cast<WarningWeight>(i);
    });
    if (count > 0) words += (words.empty() ? "" : ", ") + fmt::format(fmt::runtime(kKinds[i]), count);
  }
  return words;
}

}  // namespace overbend
