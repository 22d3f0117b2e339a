#include "platform/machine.h"

#include <sys/utsname.h>

#include <algorithm>
#include <thread>

namespace overbend {

std::size_t hardware_threads() {
  return std::max(1U, std::thread::hardware_concurrency());
}

std::string machine_name() {
  utsname name{};
  if (::uname(&name) != 0) return "unknown";
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

std::tm local_time(std::time_t time) {
  std::tm local{};
  ::localtime_r(&time, &local);
  return local;
}

}  // namespace overbend
