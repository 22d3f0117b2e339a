/// Code checks of stored results repeated with other settings, without a new analysis.
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

/// A key that cannot be set, or whose change requires a new analysis; one-line message.
class RecheckError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Rechecked {
  Description description;  ///< Model with the changed keys.
  StaticResults statics;
  std::optional<DynamicResults> dynamics;  ///< Results of a dynamic analysis; long data stay in its file.

  const CheckTable& checks() const { return dynamics ? dynamics->checks : statics.checks; }
  Findings findings() const { return dynamics ? all_findings(statics, *dynamics) : statics.findings; }
};

/// Reads results.h5 and repeats its table of checks with changed keys: "checks.safety_class=high", or without a value
/// to reset a key to its default. Without changes the table equals that of the analysis bit for bit. Throws
/// RecheckError, and std::runtime_error if the file is not a results file.
Rechecked recheck(const std::filesystem::path& h5, const std::vector<std::string>& changes);

/// Writes the results as the analysis writes them, with the repeated checks; `from` is the results.h5 they come from.
/// Throws UnusableFolder (runstore/staged_folder.h) if the folder cannot be used.
void write_rechecked(const Rechecked& again, const std::filesystem::path& from, const std::filesystem::path& folder);

/// The stages of a lay operation with repeated checks.
struct RecheckedOperation {
  Description description;  ///< Model with the changed keys.
  OperationResults results;
};

/// Applies recheck() to every stage that has an equilibrium.
RecheckedOperation recheck_operation(const std::filesystem::path& h5, const std::vector<std::string>& changes);

/// Returns the results.h5 files of a folder: its own, or those of the runs in it (several seeds, a comparison); empty
/// if it holds no results.
std::vector<std::filesystem::path> result_files(const std::filesystem::path& folder);

}  // namespace overbend
