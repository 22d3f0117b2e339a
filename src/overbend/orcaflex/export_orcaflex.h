/// Writes models as OrcaFlex text data files.
#pragma once

#include <optional>
#include <string>

#include "model/model.h"
#include "orcaflex/account.h"

namespace overbend::orcaflex {

/// Length of the line and position of its anchor [m].
struct LineExtent {
  double length = 0.0;  ///< Unstressed, from the tensioner to the anchor.
  double anchor = 0.0;  ///< Horizontal distance of the anchor astern of the stern shoe.
};

struct ExportedModel {
  std::string text;
  Account account;
};

/// Writes a lay: pipe, tensioner, supports one by one, vessel, water, seabed, current and waves, in SI units of
/// OrcaFlex (m, te, kN). A tensioner of given tension becomes a winch on the free end of the pipe.
///
/// The lay of an operation is written, not its stages. Throws std::invalid_argument for a model without a pipe.
ExportedModel export_orcaflex(const Model& model, const LineExtent& extent);

}  // namespace overbend::orcaflex
