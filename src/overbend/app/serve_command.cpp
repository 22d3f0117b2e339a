#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <thread>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/interruption.h"
#include "serve/server.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

/// Opens the page in the user's browser, where there is a screen; what comes of it is the desktop's affair.
void open_browser(const std::string& url) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  const pid_t child = fork();
  if (child > 0) waitpid(child, nullptr, 0);
  if (child != 0) return;
  // A grandchild: nobody has to wait for a browser.
  if (fork() == 0) execlp("xdg-open", "xdg-open", url.c_str(), static_cast<char*>(nullptr));
  _exit(0);
}

ServeOptions options_of(const ServeArguments& arguments) {
  ServeOptions options;
  options.port = arguments.port;
  if (!arguments.folder.empty()) options.folder = arguments.folder;
  if (arguments.model_file.empty()) return options;
  const fs::path file(arguments.model_file);
  options.model = file.filename().string();
  if (arguments.folder.empty() && file.has_parent_path()) options.folder = file.parent_path();
  return options;
}

}  // namespace

int run_serve(const ServeArguments& arguments) {
  const ServeOptions options = options_of(arguments);
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
    Server server(options);
    std::cout << "Overbend is at " << server.url() << "\nCtrl-C ends it." << std::endl;
    if (arguments.browser) open_browser(server.one_time_url());
    while (!Interruption::wanted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::cout << "\nEnding; a run that is running leaves a checkpoint." << std::endl;
  } catch (const HttpFault& fault) {
    std::cerr << "overbend serve: " << fault.what() << "\n";
    return kWrongInput;
  } catch (const PortFault& fault) {
    std::cerr << "overbend serve: " << fault.what() << "\n";
    return kWrongInput;
  }
  return kDone;
}

}  // namespace overbend
