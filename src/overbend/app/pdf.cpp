#include "app/pdf.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <vector>

namespace overbend {
namespace {

namespace fs = std::filesystem;

/// Returns the path of a program found in PATH; empty if not found.
fs::path find_in_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    fs::path file = fs::path(folder) / program;
    if (access(file.c_str(), X_OK) == 0) return file;
  }
  return {};
}

/// Returns a file URL with percent-encoded special characters.
std::string file_url(const fs::path& file) {
  std::string url = "file://";
  for (const char c : fs::absolute(file).string()) {
    const bool plain =
        std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string_view("/-_.~").find(c) != std::string_view::npos;
    url += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return url;
}

/// Runs a program with its output discarded. Returns true if its exit code is 0.
bool run(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& word : command) {
    arguments.push_back(const_cast<char*>(word.c_str()));
  }  // posix_spawn only reads them
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", 1 /* O_WRONLY */, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", 1, 0);
  pid_t child = 0;
  const int failed = posix_spawn(&child, command.front().c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 1;
  return failed == 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

fs::path find_browser() {
  if (const char* chosen = std::getenv("OVERBEND_BROWSER"); chosen != nullptr && *chosen != '\0') {
    return fs::path(chosen).has_parent_path() ? fs::path(chosen) : find_in_path(chosen);
  }
  for (const char* program :
       {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "microsoft-edge"}) {
    if (fs::path found = find_in_path(program); !found.empty()) return found;
  }
  return {};
}

void print_pdf(const fs::path& html, const fs::path& pdf) {
  const fs::path browser = find_browser();
  if (browser.empty()) {
    throw PdfError(
        "no browser was found: install Chromium, set OVERBEND_BROWSER to the path of a browser, or print report.html "
        "from "
        "a browser");
  }
  const fs::path part = pdf.string() + ".part";
  std::vector<std::string> command = {browser.string(),
                                      "--headless",
                                      "--disable-gpu",
                                      "--no-pdf-header-footer",
                                      "--virtual-time-budget=20000",
                                      "--print-to-pdf=" + fs::absolute(part).string()};
  if (geteuid() == 0) command.emplace_back("--no-sandbox");  // Chromium does not run as root otherwise
  command.push_back(file_url(html));
  std::error_code none;
  fs::remove(part, none);
  if (!run(command) || fs::file_size(part, none) == 0 || none) {
    fs::remove(part, none);
    throw PdfError("the browser '" + browser.string() + "' wrote no file; print report.html from a browser");
  }
  fs::rename(part, pdf);
}

}  // namespace overbend
