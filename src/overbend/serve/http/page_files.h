/// Embedded files of the page, and the examples.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "serve/http/http.h"

namespace overbend {

/// Content security policy: the page may load its own files and images and workers that it creates.
inline constexpr const char* kPagePolicy =
    "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; font-src 'self' data:; "
    "worker-src 'self' blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Returns the file at an address; "/" is index.html.
HttpAnswer page_file(const std::string& path);

struct Example {
  std::string name;   ///< "bgl1"
  std::string title;  ///< Title of the model.
  std::string_view text;
};

/// Returns the example models.
const std::vector<Example>& examples();

/// Returns an embedded file by its path in the repository; empty if it does not exist.
std::string_view embedded_text(const std::string& path);

/// Returns the licence of the program and of the packages bundled with page and report.
std::string licence_texts();

}  // namespace overbend
