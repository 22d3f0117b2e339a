/// Commands of the program. Each prints results to stdout and errors to stderr, and returns the exit code.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/resume_option.h"
#include "model/description/description.h"
#include "model/new_model.h"
#include "study/run/run_status.h"

namespace overbend {

/// Returns the simulated time of --duration [s]; nothing for an empty text. Throws std::invalid_argument, with a
/// message for the user, if the text is not a valid time.
std::optional<double> parse_duration_option(const std::string& text);

/// Reads a model. On failure, prints every error on stderr and returns nothing.
std::optional<Description> load_model(const std::string& path);

/// Returns an error, before anything is computed, if results in `folder` would replace files of the user or the model
/// file itself (which a goal seek may have written there); nothing otherwise.
std::optional<RunResult> find_output_conflict(const std::string& model_file, const std::filesystem::path& folder,
                                              const std::vector<std::string>& results = {"summary.json", "report.html",
                                                                                         "results.h5"});

int run_check(const std::string& model_file);

struct StaticArguments {
  std::string model_file;
  std::string output;          ///< Folder; empty: "<stem>.results" in the current folder.
  std::string stage;           ///< Single stage of an operation, by number or name; empty: all.
  bool strict = false;         ///< Return kCheckExceeded if a governing check is exceeded; results are still written.
  bool sensitivities = false;  ///< Compute derivatives of the results with respect to the numbers of the model.
};

/// Static analysis of a model, or of all stages of its operation.
int run_static(const StaticArguments& arguments);

/// Goal seek of a model into the folder `output`; empty: "<stem>.results" in the current folder. Returns kNoSolution
/// if there is no solution within the bounds; the results of the search are still written.
int run_seek_command(const std::string& model_file, const std::string& output);

struct DynamicArguments {
  std::string model_file;
  std::string output;              ///< Folder; empty: "<stem>.results" in the current folder.
  std::string duration;            ///< With its unit; empty: the model's.
  std::string stage;               ///< Stage of an operation, by number or name; empty: the normal lay.
  ResumeOption resume_option;      ///< Treatment of an unfinished run in `output`.
  double checkpoint_every = 30.0;  ///< Time between checkpoints [s].
  int threads = 0;                 ///< Number of seeds run in parallel; 0: number of cores.
  bool strict = false;             ///< Return kCheckExceeded if a governing check is exceeded.
};

/// Static, then time-domain analysis for every seed of the model. If interrupted, leaves checkpoints and returns
/// kInterrupted.
int run_dynamic(const DynamicArguments& arguments);

struct CompareArguments {
  std::string model_file;
  std::vector<std::string> others;  ///< Further folders of results; `model_file` is then a folder of results too.
  std::string of;                   ///< Name of a ComparisonType; empty if folders are compared.
  std::string output;               ///< Folder; empty: "<stem>.comparison" in the current folder.
  std::string duration;             ///< With its unit; empty: the model's.
  ResumeOption resume_option;       ///< Treatment of unfinished runs in `output`.
  double checkpoint_every = 30.0;   ///< Time between checkpoints [s].
  int threads = 0;                  ///< Number of variants run in parallel; 0: number of cores.
};

/// Runs variants of one model, each in a separate folder, and compares them. If interrupted, leaves checkpoints and
/// returns kInterrupted. Without `of`, compares folders of results.
int run_compare(const CompareArguments& arguments);

/// Writes the differences of inputs and results of two or more folders of results to the folder `output`; empty:
/// "<name of the first>.comparison" in the current folder.
int run_compare_folders(const std::vector<std::string>& places, const std::string& output);

struct LayTableArguments {
  std::string model_file;
  std::string output;  ///< Folder; empty: "<stem>.lay-table" in the current folder.
  std::string tension, lay_back,
      depth;                 ///< At most one range such as "200 kN..400 kN/20"; none: the model's lay_table.
  std::string depths_file;   ///< Alternatively, a CSV file of depths along a route.
  bool min_tension = false;  ///< Along a route, use the minimum tension that passes instead of the model's.
};

/// Makes a lay table with its files and page.
int run_lay_table(const LayTableArguments& arguments);

/// Writes report.html next to a results.h5, given that file or its folder.
int run_report(const std::string& place, bool pdf);

struct CheckResultsArguments {
  std::string place;                 ///< A folder of results, or its results.h5.
  std::vector<std::string> changes;  ///< Keys below `checks` with their new values: "checks.safety_class=high".
  std::string output;                ///< Folder for the results with these checks; empty: they are only printed.
  bool strict = false;               ///< Return kCheckExceeded if a governing check is exceeded.
};

/// Repeats the code checks of stored results, for every run if the folder holds several.
int run_check_results(const CheckResultsArguments& arguments);

struct ServeArguments {
  std::string model_file;  ///< Model to open; may be empty.
  std::string folder;      ///< Folder of model files and runs; empty: the model's, or the current one.
  int port = 0;            ///< 0: any free port.
  bool browser = true;     ///< Open the page in a browser.
};

/// Serves the graphical interface until Ctrl-C.
int run_serve(const ServeArguments& arguments);

/// Output of the command `schema`.
enum class SchemaForm { json, reference, findings, types };
int run_schema(SchemaForm form);
/// Prints the licences of the program and of the bundled packages.
int run_licences();
int run_new(const NewOptions& options);

struct ImportArguments {
  std::string file;          ///< OrcaFlex text data file.
  std::string output;        ///< Model to write; empty: "<stem>.yaml" in the current folder.
  std::string yield_stress;  ///< With its unit, for pipes of which the file has none; may be empty.
  bool force = false;        ///< Overwrite existing files.
  bool strict = false;       ///< Return kCheckExceeded if something that matters was left out.
};

struct ExportArguments {
  std::string model_file;
  std::string output;       ///< OrcaFlex text data file; empty: "<stem>.yml" in the current folder.
  bool as_orcaflex = true;  ///< The only format so far.
  bool force = false;       ///< Overwrite existing files.
  bool strict = false;      ///< Return kCheckExceeded if something that matters was left out.
};

/// Writes the lay of a model as an OrcaFlex file, with an account as run_import() does. Solves its statics for the
/// length of the line where the model gives a tension.
int run_export(const ExportArguments& arguments);

/// Translates an OrcaFlex file into a model, with an account of what was translated, approximated and left out, printed
/// and written next to the model as "<stem>.account.txt".
int run_import(const ImportArguments& arguments);

}  // namespace overbend
