#include "platform/machine.h"

#include <algorithm>
#include <thread>

#include "platform/windows/system.h"

namespace overbend {
namespace {

/// Returns a text of the system's description in the registry.
std::string version_text(const wchar_t* name) {
  wchar_t text[128] = {};
  DWORD size = sizeof text;
  const LSTATUS found = ::RegGetValueW(HKEY_LOCAL_MACHINE, L"SOFTWARE\\Microsoft\\Windows NT\\CurrentVersion", name,
                                       RRF_RT_REG_SZ, nullptr, text, &size);
  return found == ERROR_SUCCESS ? to_utf8(text) : "unknown";
}

}  // namespace

std::size_t hardware_threads() {
  return std::max(1U, std::thread::hardware_concurrency());
}

std::string machine_name() {
#if defined(_M_ARM64) || defined(__aarch64__)
  const char* const architecture = "aarch64";
#else
  const char* const architecture = "x86_64";
#endif
  return "Windows " + version_text(L"CurrentBuildNumber") + " " + architecture;
}

std::tm local_time(std::time_t time) {
  std::tm local{};
  ::localtime_s(&local, &time);
  return local;
}

}  // namespace overbend
