#include <filesystem>
#include <iostream>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/finding_lines.h"
#include "app/seek_lines.h"
#include "modelfile/reading/seek_reader.h"
#include "runstore/staged_folder.h"
#include "study/goal_seek/seek_run.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

ExitCode tell_run(const SeekRun& run, const Description& description, const fs::path& folder) {
  write_seek_run(run, description, folder);
  std::cout << description.title << "\n" << seek_lines(run.results);
  if (run.results.found) std::cout << finding_lines(run.findings());
  std::cout << "Results are in " << folder.string() << "\n";
  return run.results.found ? kDone : tell({RunEnding::no_solution, run.results.why});
}

}  // namespace

int run_seek_command(const std::string& model_file, const std::string& output) {
  const std::optional<Description> description = load_model(model_file);
  if (!description) return kWrongInput;
  const std::optional<SeekDescription> wanted = read_seek(*description);
  if (!wanted) {
    return tell({RunEnding::wrong_input, model_file + ": seek: nothing (the key is missing), expected what to vary and "
                                                      "until when; docs/guide/seek.md has examples"});
  }
  const fs::path folder =
      output.empty() ? fs::path(fs::path(model_file).stem().string() + ".results") : fs::path(output);
  if (const std::optional<RunEnd> lost = files_in_the_way(model_file, folder)) return tell(*lost);
  try {
    return tell_run(run_seek(*description, *wanted), *description, folder);
  } catch (const SeekFault& fault) {
    return tell({RunEnding::wrong_input, model_file + ": seek: " + fault.what()});
  } catch (const UnusableFolder& fault) {
    return tell({RunEnding::wrong_input, fault.what()});
  }
}

}  // namespace overbend
