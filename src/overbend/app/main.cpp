#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <initializer_list>
#include <iostream>

#include "app/command_line.h"
#include "app/exit_code.h"
#include "app/terminal_text.h"

namespace {

/// Opens standard streams that the calling program has closed. Otherwise the next files opened would get their numbers,
/// and text meant for the terminal would be written into results.
void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) == -1) ::open("/dev/null", O_RDWR);  // uses the lowest free descriptor
  }
}

}  // namespace

int main(int count, char** arguments) {
  open_standard_streams();
  // A file size limit is reported like a full disk; the signal would end the program without a message.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const overbend::TerminalText messages(std::cerr), answers(std::cout);
    return overbend::run_command_line(count, arguments);
  } catch (...) {  // an exception while reporting another error cannot be reported
    return overbend::kInternalError;
  }
}
