/// The files of the page, and the examples, from within the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "serve/http/http.h"

namespace overbend {

/// Resources that the page may load: its own files, and images and workers that it makes itself.
inline constexpr const char* kPagePolicy =
    "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; font-src 'self' data:; "
    "worker-src 'self' blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// The file at an address; "/" is index.html.
HttpAnswer page_file(const std::string& path);

struct Example {
  std::string name;   ///< "bgl1"
  std::string title;  ///< The model's own.
  std::string_view text;
};

const std::vector<Example>& examples();

/// An embedded file by its path in the repository; empty when it is not there.
std::string_view embedded_text(const std::string& path);

/// The program's own licence and those of the packages that its page and report bring along.
std::string licence_texts();

}  // namespace overbend
