#include <iostream>
#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/exit_code.h"
#include "app/terminal_text.h"
#include "platform/process.h"

int main(int count, char** arguments) {
  try {
    const std::vector<std::string> command = overbend::prepare_process(count, arguments);
    std::vector<const char*> pointers;
    for (const std::string& argument : command) pointers.push_back(argument.c_str());
    if (pointers.size() == 1 && overbend::has_own_console()) pointers.push_back("serve");
    const overbend::TerminalText messages(std::cerr), answers(std::cout);
    return overbend::run_command_line(static_cast<int>(pointers.size()), pointers.data());
  } catch (...) {  // an exception while reporting another error cannot be reported
    return overbend::kInternalError;
  }
}
