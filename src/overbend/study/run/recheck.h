/// The code checks of stored results made again with other settings, without a new analysis.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/description/description.h"
#include "results/dynamic_results.h"
#include "results/findings.h"
#include "results/operation_results.h"
#include "results/static_results.h"

namespace overbend {

/// A key that cannot be set, or whose change asks for a new analysis; one sentence.
class RecheckFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Rechecked {
  Description description;  ///< Of the model with the changed keys.
  StaticResults statics;
  std::optional<DynamicResults> dynamics;  ///< Of a dynamic analysis; long data stay in its file.

  const CheckTable& checks() const { return dynamics ? dynamics->checks : statics.checks; }
  Findings findings() const { return dynamics ? all_findings(statics, *dynamics) : statics.findings; }
};

/// Reads results.h5 and makes its table of checks again with keys set anew: "checks.safety_class=high", or without a
/// value to leave a key to its default. Without changes it is the table of the analysis, bit for bit. Throws
/// RecheckFault, and std::runtime_error where the file is none of ours.
Rechecked recheck(const std::filesystem::path& h5, const std::vector<std::string>& changes);

/// Writes the results as the analysis writes them, with the checks made again; `from` is the results.h5 they come from.
/// Throws UnusableFolder (runstore/staged_folder.h) when the folder cannot be.
void write_rechecked(const Rechecked& again, const std::filesystem::path& from, const std::filesystem::path& folder);

/// The stages of an operation on the line with their checks made again.
struct RecheckedOperation {
  Description description;  ///< Of the model with the changed keys.
  OperationResults results;
};

/// The same as recheck() of every stage that has an equilibrium.
RecheckedOperation recheck_operation(const std::filesystem::path& h5, const std::vector<std::string>& changes);

/// Files results.h5 of a folder: its own, or those of the runs within (several seeds, a comparison); none where it
/// holds no results.
std::vector<std::filesystem::path> result_files(const std::filesystem::path& folder);

}  // namespace overbend
