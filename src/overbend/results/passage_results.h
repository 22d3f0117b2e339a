/// Maxima during the passage of a structure along the line, from the results of the stages.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/operation_results.h"

namespace overbend {

/// Maximum of a quantity over the stages, and the stage of its occurrence.
struct PassagePeak {
  double value = 0.0;
  std::string stage;    ///< Name of that stage; empty if the quantity is zero in all stages.
  double passed = 0.0;  ///< Distance from the tensioner to the middle of the structure in that stage [m].
};

struct PassageBox {
  std::string name;
  PassagePeak roller;    ///< Reaction of a single roller [N].
  PassagePeak reaction;  ///< Resultant of the box [N].
  PassagePeak strain;    ///< Maximum strain of the line over the box [-].
};

struct PassageResults {
  std::string structure;
  std::vector<PassageBox> boxes;  ///< From the tensioner astern.
  PassagePeak reaction;           ///< Maximum reaction of a roller under the structure [N].
  std::string support;            ///< Roller box of that maximum.
  PassagePeak bending_moment;     ///< In the structure [N m].
  PassagePeak strain;             ///< Strain of the pipe within two diameters of its ends [-].
  PassagePeak von_mises;          ///< Von Mises stress of the pipe within two diameters of its ends [Pa].
};

/// Returns the maxima over the stages of a passage with an equilibrium; nothing for another operation, or if no stage
/// contains the passing structure.
std::optional<PassageResults> find_passage_maxima(const OperationResults& operation);

}  // namespace overbend
