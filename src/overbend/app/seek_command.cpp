#include <filesystem>
#include <iostream>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/print_findings.h"
#include "app/print_seek.h"
#include "modelfile/reading/seek_reader.h"
#include "runstore/staged_folder.h"
#include "study/goal_seek/seek_run.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

ExitCode report_seek(const SeekRun& run, const Description& description, const fs::path& folder) {
  write_seek_run(run, description, folder);
  std::cout << description.title << "\n" << seek_lines(run.results);
  if (run.results.found) std::cout << finding_lines(run.findings());
  std::cout << "Results are in " << folder.string() << "\n";
  return run.results.found ? kDone : report_status({RunStatus::no_solution, run.results.why});
}

}  // namespace

int run_seek_command(const std::string& model_file, const std::string& output) {
  const std::optional<Description> description = load_model(model_file);
  if (!description) return kWrongInput;
  const std::optional<SeekDescription> wanted = read_seek(*description);
  if (!wanted) {
    return report_status(
        {RunStatus::wrong_input, model_file + ": seek: the key is missing, expected what to vary and which results to "
                                              "reach; docs/guide/seek.md has examples"});
  }
  const fs::path folder =
      output.empty() ? fs::path(fs::path(model_file).stem().string() + ".results") : fs::path(output);
  if (const std::optional<RunResult> lost = find_output_conflict(model_file, folder)) return report_status(*lost);
  try {
    return report_seek(run_seek(*description, *wanted), *description, folder);
  } catch (const SeekError& error) {
    return report_status({RunStatus::wrong_input, model_file + ": seek: " + error.what()});
  } catch (const UnusableFolder& error) {
    return report_status({RunStatus::wrong_input, error.what()});
  }
}

}  // namespace overbend
