/// First model file with calculated margins: statics and code checks set what rules of thumb leave open.
#pragma once

#include <string>
#include <variant>

#include "model/new_model.h"

namespace overbend {

struct NewLay {
  NewModel model;
  std::string text;  ///< Text of the model file.
};

/// Chooses wall thickness, tension and stinger radius, as far as not given, such that the static checks of the model
/// pass. Given values are kept; if a check is exceeded with them, the note of the model names it. Returns a message if
/// the options are invalid or no permitted choice passes.
std::variant<NewLay, std::string> choose_lay(const NewOptions& options);

}  // namespace overbend
