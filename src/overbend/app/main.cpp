#include <csignal>

#include "app/command_line.h"

int main(int count, char** words) {
  // A limit on the size of files is told as a full disk is; the signal would end the program without a word.
  std::signal(SIGXFSZ, SIG_IGN);
  return overbend::run_command_line(count, words);
}
