/// What the program prints is UTF-8, whatever bytes of files or of the command line are in its messages.
#pragma once

#include <ostream>
#include <streambuf>
#include <string>

namespace overbend {

/// While it lives, bytes written to a stream that are no UTF-8 come out as "\xc6".
class TerminalText : public std::streambuf {
 public:
  explicit TerminalText(std::ostream& stream);
  ~TerminalText() override;
  TerminalText(const TerminalText&) = delete;
  TerminalText& operator=(const TerminalText&) = delete;

 protected:
  int_type overflow(int_type letter) override;
  std::streamsize xsputn(const char* text, std::streamsize count) override;
  int sync() override;

 private:
  std::ostream& stream_;
  std::streambuf* const below_;
};

}  // namespace overbend
