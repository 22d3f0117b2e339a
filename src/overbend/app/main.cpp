#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <initializer_list>
#include <iostream>

#include "app/command_line.h"
#include "app/exit_code.h"
#include "app/terminal_text.h"

namespace {

/// Whoever starts the program may have closed its standard streams. The next files opened would get their numbers, and
/// text meant for a terminal would land in results.
void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) == -1) ::open("/dev/null", O_RDWR);  // takes the lowest number that is free
  }
}

}  // namespace

int main(int count, char** words) {
  open_standard_streams();
  // A limit on the size of files is told as a full disk is; the signal would end the program without a word.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const overbend::TerminalText messages(std::cerr), answers(std::cout);
    return overbend::run_command_line(count, words);
  } catch (...) {  // in the middle of telling of another fault: there is nothing left to tell it with
    return overbend::kInternalFault;
  }
}
