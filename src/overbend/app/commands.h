/// The commands of the program. Each prints results to stdout and complaints to stderr and returns the exit code.
#pragma once

#include <optional>
#include <string>

#include "app/unfinished_run.h"
#include "model/description.h"
#include "model/new_model.h"

namespace overbend {

/// The simulated time of --duration [s]; empty text: nothing. Throws std::invalid_argument, with what to tell, where it
/// is no time.
std::optional<double> duration_of(const std::string& text);

/// Reads a model; on failure every fault is told on stderr and nothing is returned.
std::optional<Description> load_model(const std::string& path);

int run_check(const std::string& model_file);
/// Statics of a model into the folder `output`; empty: "<stem>.results" in the current folder.
/// With `strict` it returns kCheckExceeded where a governing check is exceeded; the results are written all the same.
int run_static(const std::string& model_file, const std::string& output, bool strict);

struct DynamicArguments {
  std::string model_file;
  std::string output;              ///< Folder; empty: "<stem>.results" in the current folder.
  std::string duration;            ///< With its unit; empty: the model's.
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
  std::string of;                  ///< "tensioner" or "contact".
  std::string output;              ///< Folder; empty: "<stem>.comparison" in the current folder.
  std::string duration;            ///< With its unit; empty: the model's.
  TakeUp take_up;                  ///< Unfinished runs in `output`.
  double checkpoint_every = 30.0;  ///< Time between checkpoints [s].
  int threads = 0;                 ///< Variants at work at the same time; 0: as many as there are cores.
};

/// Dynamic runs of variants of one model, each in a separate folder, and their comparison. Interrupted, it
/// leaves checkpoints and returns kInterrupted.
int run_compare(const CompareArguments& arguments);

/// Writes report.html beside a results.h5, given that file or its folder.
int run_report(const std::string& place);

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
enum class SchemaForm { json, reference, types };
int run_schema(SchemaForm form);
/// Prints the licences of the program and of all that it brings along.
int run_licences();
int run_new(const NewOptions& options);

}  // namespace overbend
