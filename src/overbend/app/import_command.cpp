#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "app/commands.h"
#include "app/exit_code.h"
#include "base/text.h"
#include "base/units.h"
#include "orcaflex/import_orcaflex.h"
#include "runstore/replace_file.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

int reject(const std::string& why) {
  std::cerr << "overbend import: " << why << "\n";
  return kWrongInput;
}

}  // namespace

int run_import(const ImportArguments& arguments) {
  const fs::path model(arguments.output.empty() ? fs::path(arguments.file).stem().string() + ".yaml"
                                                : arguments.output);
  const fs::path account = fs::path(model).replace_extension(".account.txt");
  std::error_code error;
  for (const fs::path& file : {model, account}) {
    if (fs::equivalent(file, arguments.file, error)) return reject("'" + file.string() + "' is the file to import");
    if (!arguments.force && fs::exists(file, error)) {
      return reject("'" + file.string() + "' exists already; --force overwrites it");
    }
  }
  orcaflex::ImportOptions options;
  options.model_folder = model.parent_path().empty() ? fs::path(".") : model.parent_path();
  if (!arguments.yield_stress.empty()) {
    const QuantityReading yield = parse_quantity(arguments.yield_stress, "Pa");
    if (!yield.value || !(*yield.value > 0.0)) {
      return reject("--yield: found '" + for_display(arguments.yield_stress) +
                    "', expected a stress such as '450 MPa'");
    }
    options.yield_stress = *yield.value;
  }
  Diagnostics diagnostics;
  const std::optional<orcaflex::ImportedModel> imported =
      orcaflex::import_orcaflex(arguments.file, options, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.sorted()) std::cerr << render(diagnostic) << "\n";
  if (!imported) return kWrongInput;
  try {
    replace_file(model, imported->text);
    replace_file(account, imported->account.text());
  } catch (const std::runtime_error& failure) {
    return reject(failure.what());
  }
  std::cout << imported->account.text();
  std::cerr << "wrote " << model.string() << " and " << account.string() << "; run it with: overbend static "
            << shell_word(model.string()) << " -o DIR\n";
  return arguments.strict && !imported->account.is_complete() ? kCheckExceeded : kDone;
}

}  // namespace overbend
