/// Prints a report as PDF with an installed browser.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace overbend {

/// Thrown if there is no browser or it wrote no file; what() states what to do.
class PdfError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns the browser to print with: the program named by the environment variable OVERBEND_BROWSER, otherwise the
/// first of chromium, chromium-browser, google-chrome, google-chrome-stable and microsoft-edge in the PATH; empty if
/// none is found.
std::filesystem::path find_browser();

/// Writes `pdf` from the page `html`; an existing file is kept until the new one is complete. Throws PdfError.
void print_pdf(const std::filesystem::path& html, const std::filesystem::path& pdf);

}  // namespace overbend
