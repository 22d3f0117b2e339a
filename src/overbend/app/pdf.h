/// Prints a report as PDF with a browser of the machine.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace overbend {

/// No browser, or one that gave no file; what() says what to do.
class PdfError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The browser that prints: the program that the environment variable OVERBEND_BROWSER names, else the first of
/// chromium, chromium-browser, google-chrome, google-chrome-stable and microsoft-edge in the PATH; empty without.
std::filesystem::path find_browser();

/// Writes `pdf` from the page `html`; an earlier file stays until the new one is complete. Throws PdfError.
void print_pdf(const std::filesystem::path& html, const std::filesystem::path& pdf);

}  // namespace overbend
