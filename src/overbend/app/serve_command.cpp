#include <chrono>
#include <filesystem>
#include <iostream>
#include <thread>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/interruption.h"
#include "platform/process.h"
#include "serve/server.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

ServiceOptions make_service_options(const ServeArguments& arguments) {
  ServiceOptions options;
  if (!arguments.folder.empty()) options.folder = arguments.folder;
  if (arguments.model_file.empty()) return options;
  const fs::path file(arguments.model_file);
  options.model = file.filename().string();
  if (arguments.folder.empty() && file.has_parent_path()) options.folder = file.parent_path();
  return options;
}

}  // namespace

int run_serve(const ServeArguments& arguments) {
  const ServiceOptions options = make_service_options(arguments);
  std::error_code ignored;
  const fs::path asked(arguments.model_file);
  if (!arguments.folder.empty() && asked.has_parent_path() &&
      !fs::equivalent(asked.parent_path(), options.folder, ignored)) {
    std::cerr << "overbend serve: " << asked.string() << " is not in the folder '" << options.folder.string()
              << "'; omit --folder to use the folder of the model\n";
    return kWrongInput;
  }
  if (!fs::is_directory(options.folder, ignored)) {
    std::cerr << "overbend serve: there is no folder '" << options.folder.string() << "'\n";
    return kWrongInput;
  }
  try {
    const Interruption interruption;
    Server server(options, arguments.port);
    std::cout << "Overbend is running at " << server.url() << "\nPress Ctrl-C to stop." << std::endl;
    if (arguments.browser) open_browser(server.one_time_url());
    while (!Interruption::wanted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::cout << "\nStopping; an active run leaves a checkpoint." << std::endl;
  } catch (const HttpError& error) {
    std::cerr << "overbend serve: " << error.what() << "\n";
    return kWrongInput;
  } catch (const PortError& error) {
    std::cerr << "overbend serve: " << error.what() << "\n";
    return kWrongInput;
  }
  return kDone;
}

}  // namespace overbend
