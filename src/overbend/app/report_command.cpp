#include "report/report.h"
#include "report/stages/operation_report.h"

#include <filesystem>
#include <iostream>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/pdf.h"
#include "resultfiles/dynamic/dynamic_reader.h"
#include "resultfiles/stages/operation_reader.h"
#include "resultfiles/static/results_reader.h"

namespace overbend {

namespace fs = std::filesystem;

namespace {

void write_again(const fs::path& h5, const fs::path& file) {
  if (has_lay_operation(h5)) {
    const StoredOperation stored = read_operation_results(h5);
    write_operation_report(stored.results, stored.model_text, file);
  } else if (has_dynamic(h5)) {
    const StoredDynamics stored = read_dynamic_results(h5);
    write_report(stored.statics.results, stored.results, stored.statics.model_text, file);
  } else {
    const StoredStatics stored = read_static_results(h5);
    write_report(stored.results, stored.model_text, file,
                 {.sensitivities = stored.sensitivities ? &*stored.sensitivities : nullptr});
  }
}

}  // namespace

int run_report(const std::string& place, bool pdf) {
  const fs::path h5 = fs::is_directory(place) ? fs::path(place) / "results.h5" : fs::path(place);
  const fs::path file = h5.parent_path() / "report.html";
  try {
    write_again(h5, file);
  } catch (const std::runtime_error& error) {
    std::cerr << "overbend: " << error.what() << "\n";
    return kWrongInput;
  }
  std::cout << "The report is " << file.string() << "\n";
  if (!pdf) return kDone;
  const fs::path printed = fs::path(file).replace_extension(".pdf");
  try {
    print_pdf(file, printed);
  } catch (const PdfError& error) {
    std::cerr << "overbend: " << error.what() << "\n";
    return kInternalError;
  }
  std::cout << "Printed as " << printed.string() << "\n";
  return kDone;
}

}  // namespace overbend
