/// A first model that has been calculated: statics and code checks decide what the rules of thumb leave open.
#pragma once

#include <string>
#include <variant>

#include "model/new_model.h"

namespace overbend {

struct NewLay {
  NewModel model;
  std::string text;  ///< Of the model file.
};

/// Chooses wall, tension and stinger radius, as far as they were not said, such that the static checks of the model are
/// passed. What was said is taken as it is: where a check is exceeded for it, the model's note says which. A sentence
/// where the options are wrong or nothing that may be chosen passes.
std::variant<NewLay, std::string> choose_lay(const NewOptions& options);

}  // namespace overbend
