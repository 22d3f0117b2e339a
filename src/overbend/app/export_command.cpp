#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "app/commands.h"
#include "app/exit_code.h"
#include "orcaflex/export_orcaflex.h"
#include "runstore/replace_file.h"
#include "study/run/prepared_case.h"
#include "study/run/static_analysis.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

int reject(const std::string& why) {
  std::cerr << "overbend export: " << why << "\n";
  return kWrongInput;
}

/// Ends of the line: as given, or of the lay that is found.
std::variant<orcaflex::LineExtent, StaticFailure> line_extent(Model& model) {
  const PipeDescription& pipe = model.description.pipe;
  if (pipe.length && pipe.anchor) return orcaflex::LineExtent{*pipe.length, *pipe.anchor};
  const StaticRun run = run_statics(model);
  if (run.failure) return *run.failure;
  return orcaflex::LineExtent{run.results->total_length, run.results->stations.front().astern};
}

}  // namespace

int run_export(const ExportArguments& arguments) {
  const fs::path output(arguments.output.empty() ? fs::path(arguments.model_file).stem().string() + ".yml"
                                                 : arguments.output);
  const fs::path account = fs::path(output).replace_extension(".account.txt");
  std::error_code error;
  for (const fs::path& file : {output, account}) {
    if (fs::equivalent(file, arguments.model_file, error)) return reject("'" + file.string() + "' is the model itself");
    if (!arguments.force && fs::exists(file, error)) {
      return reject("'" + file.string() + "' exists already; --force overwrites it");
    }
  }
  const std::optional<Description> description = load_model(arguments.model_file);
  if (!description) return kWrongInput;
  Model model = build_model(*description);
  if (!description->has_pipe) return reject("the model has no pipe");
  const std::variant<orcaflex::LineExtent, StaticFailure> extent = line_extent(model);
  if (const StaticFailure* failure = std::get_if<StaticFailure>(&extent)) {
    return report_status(failure_result(*failure, model.description));
  }
  const orcaflex::ExportedModel exported = orcaflex::export_orcaflex(model, std::get<orcaflex::LineExtent>(extent));
  try {
    replace_file(output, exported.text);
    replace_file(account, exported.account.text());
  } catch (const std::runtime_error& failure) {
    return reject(failure.what());
  }
  std::cout << exported.account.text();
  std::cerr << "wrote " << output.string() << " and " << account.string() << "\n";
  return arguments.strict && !exported.account.is_complete() ? kCheckExceeded : kDone;
}

}  // namespace overbend
