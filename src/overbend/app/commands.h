/// The commands of the program. Each prints results to stdout and complaints to stderr and returns the exit code.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/unfinished_run.h"
#include "model/description/description.h"
#include "model/new_model.h"
#include "study/run/run_ending.h"

namespace overbend {

/// The simulated time of --duration [s]; empty text: nothing. Throws std::invalid_argument, with what to tell, where it
/// is no time.
std::optional<double> duration_of(const std::string& text);

/// Reads a model; on failure every fault is told on stderr and nothing is returned.
std::optional<Description> load_model(const std::string& path);

/// Results in `folder` would replace files of the user, or the model itself, because a goal seek wrote it there: an end
/// with what to tell, before anything is computed; nothing where they leave them alone.
std::optional<RunEnd> files_in_the_way(const std::string& model_file, const std::filesystem::path& folder,
                                       const std::vector<std::string>& results = {"summary.json", "report.html",
                                                                                  "results.h5"});

int run_check(const std::string& model_file);

struct StaticArguments {
  std::string model_file;
  std::string output;   ///< Folder; empty: "<stem>.results" in the current folder.
  std::string stage;    ///< Of an operation on the line, by number or name: this one alone; empty: all.
  bool strict = false;  ///< kCheckExceeded where a governing check is exceeded; results are written all the same.
  bool sensitivities = false;  ///< Derivatives of the results by the numbers of the model.
};

/// Statics of a model, or of all stages of its operation on the line.
int run_static(const StaticArguments& arguments);

/// Goal seek of a model into the folder `output`; empty: "<stem>.results" in the current folder. Returns kNoSolution
/// where nothing within the bounds is an answer; what was seen on the way is written all the same.
int run_seek_command(const std::string& model_file, const std::string& output);

struct DynamicArguments {
  std::string model_file;
  std::string output;              ///< Folder; empty: "<stem>.results" in the current folder.
  std::string duration;            ///< With its unit; empty: the model's.
  std::string stage;               ///< Of an operation on the line, by number or name; empty: the lay as such.
  TakeUp take_up;                  ///< An unfinished run in `output`.
  double checkpoint_every = 30.0;  ///< Time between checkpoints [s].
  int threads = 0;                 ///< Seeds at work at the same time; 0: as many as there are cores.
  bool strict = false;             ///< kCheckExceeded where a governing check is exceeded.
};

/// Statics, then the time domain, for every seed of the model. Interrupted, it leaves checkpoints and returns
/// kInterrupted.
int run_dynamic(const DynamicArguments& arguments);

struct CompareArguments {
  std::string model_file;
  std::vector<std::string> others;  ///< Folders of results that are compared with `model_file`, then such a folder.
  std::string of;                   ///< A word of ComparisonOf; empty where folders are compared.
  std::string output;               ///< Folder; empty: "<stem>.comparison" in the current folder.
  std::string duration;             ///< With its unit; empty: the model's.
  TakeUp take_up;                   ///< Unfinished runs in `output`.
  double checkpoint_every = 30.0;   ///< Time between checkpoints [s].
  int threads = 0;                  ///< Variants at work at the same time; 0: as many as there are cores.
};

/// Dynamic runs of variants of one model, each in a separate folder, and their comparison. Interrupted, it
/// leaves checkpoints and returns kInterrupted. Without `of`: results of folders beside each other.
int run_compare(const CompareArguments& arguments);

/// Differences of inputs and results of two or more folders of results, written to the folder `output`; empty:
/// "<name of the first>.comparison" in the current folder.
int run_compare_folders(const std::vector<std::string>& places, const std::string& output);

struct LayTableArguments {
  std::string model_file;
  std::string output;                    ///< Folder; empty: "<stem>.lay-table" in the current folder.
  std::string tension, lay_back, depth;  ///< At most one: "200 kN..400 kN/20". None: the model's lay_table.
  std::string depths_file;               ///< Or CSV of depths along a route.
  bool least = false;                    ///< Along a route the least tension that passes, not that of the model.
};

/// A table of lays with its files and page.
int run_lay_table(const LayTableArguments& arguments);

/// Writes report.html beside a results.h5, given that file or its folder.
int run_report(const std::string& place, bool pdf);

struct CheckResultsArguments {
  std::string place;                 ///< A folder of results, or its results.h5.
  std::vector<std::string> changes;  ///< Keys below `checks` with their new values: "checks.safety_class=high".
  std::string output;                ///< Folder for the results with these checks; empty: they are only printed.
  bool strict = false;               ///< kCheckExceeded where a governing check is exceeded.
};

/// Makes the code checks of stored results again, of each run where the folder holds several.
int run_check_results(const CheckResultsArguments& arguments);

struct ServeArguments {
  std::string model_file;  ///< Opened at the start; may be empty.
  std::string folder;      ///< Of model files and runs; empty: the model's, or the current one.
  int port = 0;            ///< 0: any that is free.
  bool browser = true;     ///< Open one at the page.
};

/// The graphical interface, until Ctrl-C.
int run_serve(const ServeArguments& arguments);

/// What `schema` prints.
enum class SchemaForm { json, reference, findings, types };
int run_schema(SchemaForm form);
/// Prints the licences of the program and of all that it brings along.
int run_licences();
int run_new(const NewOptions& options);

}  // namespace overbend
