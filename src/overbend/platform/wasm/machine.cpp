#include "platform/machine.h"

namespace overbend {

std::size_t hardware_threads() {
  return 1;
}

std::string machine_name() {
  return "WebAssembly";
}

std::tm local_time(std::time_t time) {
  return *std::localtime(&time);  // there is one thread
}

}  // namespace overbend
