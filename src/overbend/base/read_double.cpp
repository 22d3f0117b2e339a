#include "base/read_double.h"

#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <string>

namespace overbend {

#if defined(__cpp_lib_to_chars)

std::from_chars_result read_double(const char* first, const char* last, double& value) {
  return std::from_chars(first, last, value);
}

#else

std::from_chars_result read_double(const char* first, const char* last, double& value) {
  const std::string text(first, last);  // strtod needs an end
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  const bool hexadecimal = text.size() > sign + 1 && text[sign] == '0' && std::tolower(text[sign + 1]) == 'x';
  if (hexadecimal) {  // from_chars reads the zero
    value = sign != 0 ? -0.0 : 0.0;
    return {first + sign + 1, std::errc()};
  }
  if (text.empty() || text.front() == '+' || std::isspace(static_cast<unsigned char>(text.front())) != 0) {
    return {first, std::errc::invalid_argument};
  }
  char* end = nullptr;
  errno = 0;
  const double read = std::strtod(text.c_str(), &end);
  if (end == text.c_str()) return {first, std::errc::invalid_argument};
  const char* stop = first + (end - text.c_str());
  if (errno == ERANGE && (std::isinf(read) || read == 0.0)) return {stop, std::errc::result_out_of_range};
  value = read;
  return {stop, std::errc()};
}

#endif

}  // namespace overbend
