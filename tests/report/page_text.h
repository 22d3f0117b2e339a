/// Looking into a page.
#pragma once

#include <string>

namespace overbend::testing {

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) {
    ++found;
  }
  return found;
}

/// The part before the scripts and after the style: what a reader without scripts sees.
inline std::string visible(const std::string& page) {
  const std::size_t body = page.find("<body>");
  return page.substr(body, page.find("<script", body) - body);
}

}  // namespace overbend::testing
