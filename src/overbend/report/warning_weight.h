/// How much a warning weighs: whoever signs reads the heavy ones first.
#pragma once

#include <string>
#include <vector>

namespace overbend {

enum class WarningWeight {
  serious,  ///< The lay is not feasible as given, or the numbers do not mean what they seem to.
  caution,  ///< To be looked at before the pipe is laid.
  input,    ///< The reader noticed something unusual in the model file or in one that it names.
};

struct WeighedWarning {
  WarningWeight weight = WarningWeight::caution;
  std::string text;  ///< Files without their folders: a report is sent on.
};

/// A warning of the reader without its mark: "folder/model.yaml:12: key: ..."; others as they are.
std::string without_mark(const std::string& warning);

/// "Serious", "Caution", "Input".
const char* word(WarningWeight weight);

/// The heaviest first, otherwise in the order given; but of serious ones the first of each kind before the others, so
/// that six boxes which the pipe left do not stand before compression.
std::vector<WeighedWarning> weighed(const std::vector<std::string>& warnings);

/// "1 serious, 2 to look at, 1 on the input"; empty without any.
std::string weight_words(const std::vector<WeighedWarning>& warnings);

/// Those that are serious, as they are and in their order.
std::vector<std::string> serious_warnings(const std::vector<std::string>& warnings);

/// Phrases that identify a serious warning; each occurs in a message of the program.
const std::vector<std::string>& serious_phrases();

}  // namespace overbend
