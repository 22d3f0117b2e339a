/// What is largest while a structure passes along the line: made from the results of the stages.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/operation_results.h"

namespace overbend {

/// The largest of a quantity over the stages, with the stage in which it occurs.
struct PassagePeak {
  double value = 0.0;
  std::string stage;    ///< Its name; empty where the quantity is nought in all of them.
  double passed = 0.0;  ///< Tensioner to the middle of the structure then [m].
};

struct PassageBox {
  std::string name;
  PassagePeak roller;    ///< Reaction of a single roller [N].
  PassagePeak reaction;  ///< Resultant of the box [N].
  PassagePeak strain;    ///< Of the line over the box [-].
};

struct PassageResults {
  std::string structure;
  std::vector<PassageBox> boxes;  ///< From the tensioner astern.
  PassagePeak reaction;           ///< Of a roller under the structure [N].
  std::string support;            ///< Box of that roller.
  PassagePeak bending_moment;     ///< In the structure [N m].
  PassagePeak strain;             ///< Of the pipe within two diameters of its ends [-].
  PassagePeak von_mises;          ///< Likewise [Pa].
};

/// Of the stages of a passage that have an equilibrium; nothing of another operation, or where the structure that
/// passes is in none of them.
std::optional<PassageResults> passage_of(const OperationResults& operation);

}  // namespace overbend
