/// Ensures valid UTF-8 on the terminal.
#pragma once

#include <ostream>
#include <streambuf>
#include <string>

namespace overbend {

/// During its lifetime, writes bytes of a stream that are not UTF-8 as "\xc6".
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
