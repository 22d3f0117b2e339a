#include "app/terminal_text.h"

#include "base/utf8.h"

namespace overbend {

TerminalText::TerminalText(std::ostream& stream) : stream_(stream), below_(stream.rdbuf(this)) {}

TerminalText::~TerminalText() {
  stream_.rdbuf(below_);
}

TerminalText::int_type TerminalText::overflow(int_type letter) {
  if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
  const char text = traits_type::to_char_type(letter);
  return xsputn(&text, 1) == 1 ? letter : traits_type::eof();
}

std::streamsize TerminalText::xsputn(const char* text, std::streamsize count) {
  const std::string valid = valid_utf8({text, static_cast<std::size_t>(count)});
  const auto length = static_cast<std::streamsize>(valid.size());
  return below_->sputn(valid.data(), length) == length ? count : 0;
}

int TerminalText::sync() {
  return below_->pubsync();
}

}  // namespace overbend
