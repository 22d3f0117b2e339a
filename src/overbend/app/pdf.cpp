#include "app/pdf.h"

#include <fmt/format.h>

#include <cctype>
#include <string_view>
#include <vector>

#include "platform/file.h"
#include "platform/process.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

/// Returns a file URL with percent-encoded special characters.
std::string file_url(const fs::path& file) {
  const std::string path = fs::absolute(file).generic_string();
  std::string url = path.starts_with("/") ? "file://" : "file:///";  // Windows: C:/folder/report.html
  for (const char c : path) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                       std::string_view("/-_.~:").find(c) != std::string_view::npos;
    url += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return url;
}

}  // namespace

fs::path find_browser() {
  if (const std::string chosen = environment_variable("OVERBEND_BROWSER"); !chosen.empty()) {
    return fs::path(chosen).has_parent_path() ? fs::path(chosen) : find_program(chosen);
  }
  for (const char* program :
       {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "microsoft-edge"}) {
    if (fs::path found = find_program(program); !found.empty()) return found;
  }
  for (const char* folder : {"ProgramFiles", "ProgramFiles(x86)", "LocalAppData"}) {  // Windows
    for (const char* program : {"Microsoft/Edge/Application/msedge.exe", "Google/Chrome/Application/chrome.exe",
                                "Chromium/Application/chrome.exe"}) {
      const std::string installed = environment_variable(folder);
      if (fs::path found = fs::path(installed) / program; !installed.empty() && fs::exists(found)) return found;
    }
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
  if (is_superuser()) command.emplace_back("--no-sandbox");  // Chromium does not run as root otherwise
  command.push_back(file_url(html));
  std::error_code none;
  fs::remove(part, none);
  if (run_program_silently(command) != 0 || fs::file_size(part, none) == 0 || none) {
    fs::remove(part, none);
    throw PdfError("the browser '" + browser.string() + "' wrote no file; print report.html from a browser");
  }
  if (const std::error_code error = rename_file(part, pdf)) {
    throw PdfError("the file '" + pdf.string() + "' cannot be written: " + error.message());
  }
}

}  // namespace overbend
