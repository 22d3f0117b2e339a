#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iostream>

#include "app/commands.h"
#include "io/yaml_reader.h"
#include "runs/exit_code.h"

namespace overbend {
namespace {

/// Asks on a terminal for what is missing; elsewhere leaves it missing.
void ask(const std::string& question, std::string& answer) {
  if (!answer.empty() || isatty(STDIN_FILENO) == 0 || isatty(STDERR_FILENO) == 0) return;
  std::cerr << question << ": ";
  std::getline(std::cin, answer);
}

int refuse(const std::string& why) {
  std::cerr << "overbend new: " << why << "\n";
  return kWrongInput;
}

int write_file(const std::string& path, const std::string& text) {
  const std::string beside = path + ".part";
  std::ofstream file(beside, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  std::error_code fault;
  if (file) std::filesystem::rename(beside, path, fault);
  if (!file || fault) {
    std::filesystem::remove(beside, fault);
    return refuse("the file '" + path + "' can not be written");
  }
  std::cerr << "wrote " << path << "; run it with: overbend static " << path << " -o DIR\n";
  return kDone;
}

}  // namespace

int run_new(const NewOptions& given) {
  NewOptions options = given;
  ask("Nominal pipe size in inches, or outside diameter with its unit", options.pipe);
  ask("Water depth with its unit", options.depth);
  std::error_code fault;
  if (!options.output.empty() && !options.force && std::filesystem::exists(options.output, fault)) {
    return refuse("'" + options.output + "' exists already; --force overwrites it");
  }
  const std::variant<NewModel, std::string> chosen = choose_model(options);
  if (const auto* why = std::get_if<std::string>(&chosen)) return refuse(*why);
  const std::string text = model_text(std::get<NewModel>(chosen));
  const ModelReading reading = read_model_text(text, options.output.empty() ? "model.yaml" : options.output);
  if (!reading.description) {
    return refuse("these values make no valid model:\n" + reading.diagnostics.lines(Severity::error).front());
  }
  if (!options.output.empty()) return write_file(options.output, text);
  std::cout << text;
  return kDone;
}

}  // namespace overbend
