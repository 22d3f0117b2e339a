#include "platform/process.h"

#include <cstdlib>

namespace overbend {

std::vector<std::string> prepare_process(int count, char** arguments) {
  return {arguments, arguments + count};
}

void set_interrupt_handler(void (* /*handler*/)()) {}

bool is_terminal(StandardStream /*stream*/) {
  return false;
}

bool has_own_console() {
  return false;
}

bool is_superuser() {
  return false;
}

std::string environment_variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

std::filesystem::path executable_path() {
  return {};
}

long process_number() {
  return 1;
}

std::string process_start(long number) {
  return number == 1 ? "1" : "";
}

std::string process_namespace() {
  return "wasm";
}

std::filesystem::path find_program(const std::string& /*name*/) {
  return {};
}

std::optional<ProgramOutput> run_program(const std::vector<std::string>& /*command*/) {
  return std::nullopt;
}

std::optional<int> run_program_silently(const std::vector<std::string>& /*command*/) {
  return std::nullopt;
}

void open_browser(const std::string& /*url*/) {}

}  // namespace overbend
