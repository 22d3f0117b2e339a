#include "report/report.h"

#include <filesystem>
#include <iostream>

#include "app/commands.h"
#include "app/exit_code.h"
#include "io/results_reader.h"

namespace overbend {

namespace fs = std::filesystem;

int run_report(const std::string& place) {
  const fs::path h5 = fs::is_directory(place) ? fs::path(place) / "results.h5" : fs::path(place);
  std::optional<StoredStatics> stored;
  try {
    stored = read_static_results(h5);
  } catch (const std::runtime_error& fault) {
    std::cerr << "overbend: " << fault.what() << "\n";
    return kWrongInput;
  }
  const fs::path file = h5.parent_path() / "report.html";
  write_report(stored->results, stored->model_text, file);
  std::cout << "The report is " << file.string() << "\n";
  return kDone;
}

}  // namespace overbend
