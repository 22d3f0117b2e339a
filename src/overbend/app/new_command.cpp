#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/new_questions.h"
#include "platform/process.h"
#include "runstore/replace_file.h"
#include "study/run/new_lay.h"

namespace overbend {
namespace {

int reject(const std::string& why) {
  std::cerr << "overbend new: " << why << "\n";
  return kWrongInput;
}

int write_file(const std::string& path, const std::string& text) {
  try {
    replace_file(path, text);
  } catch (const std::runtime_error& error) {
    return reject(error.what());
  }
  std::cerr << "wrote " << path << "; run it with: overbend static " << path << " -o DIR\n";
  return kDone;
}

}  // namespace

int run_new(const NewOptions& requested) {
  NewOptions options = requested;
  const bool terminal = is_terminal(StandardStream::input) && is_terminal(StandardStream::error);
  if (terminal && (options.pipe.empty() || options.depth.empty())) ask_new_options(options, std::cin, std::cerr);
  std::error_code error;
  if (!options.output.empty() && !options.force && std::filesystem::exists(options.output, error)) {
    return reject("'" + options.output + "' exists already; --force overwrites it");
  }
  const std::variant<NewLay, std::string> chosen = choose_lay(options);
  if (const auto* why = std::get_if<std::string>(&chosen)) return reject(*why);
  const NewLay& lay = std::get<NewLay>(chosen);
  if (!lay.model.note.empty()) std::cerr << "overbend new: note: " << lay.model.note << "\n";
  if (!options.output.empty()) return write_file(options.output, lay.text);
  std::cout << lay.text;
  return kDone;
}

}  // namespace overbend
