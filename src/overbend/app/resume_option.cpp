#include "app/resume_option.h"

#include <fmt/format.h>

#include <iostream>
#include <string>

#include "platform/process.h"
#include "runstore/run_store.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

struct Unfinished {
  fs::path folder;
  StoredRun run;
};

std::optional<Unfinished> find_unfinished(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    if (const std::optional<StoredRun> run = RunStore::find(folder)) return Unfinished{folder, *run};
  }
  return std::nullopt;
}

std::string unfinished_run_text(const Unfinished& found) {
  if (found.run.active) {
    return fmt::format("a run is active in '{}', at t = {:.1f} s by its last checkpoint", found.folder.string(),
                       found.run.time);
  }
  const std::string where = fmt::format("there is an unfinished run in '{}'", found.folder.string());
  return found.run.error.empty() ? fmt::format("{}, stopped at t = {:.1f} s", where, found.run.time)
                                 : fmt::format("{}, which cannot be resumed: {}", where, found.run.error);
}

std::optional<bool> ask(const Unfinished& found) {
  const bool sound = found.run.error.empty();
  std::cerr << "overbend: " << unfinished_run_text(found) << "\n"
            << (sound ? "Continue it (c), discard it and start again (a), or leave it (any other key)? "
                      : "Discard it and start again (a), or leave it (any other key)? ")
            << std::flush;
  std::string answer;
  std::getline(std::cin, answer);
  if (sound && (answer == "c" || answer == "C" || answer == "g" || answer == "G")) return true;
  if (answer == "a" || answer == "A") return false;
  return std::nullopt;
}

}  // namespace

std::optional<bool> resume_requested(const std::vector<fs::path>& folders, const ResumeOption& option) {
  if (option.resume || option.restart) return option.resume;
  const std::optional<Unfinished> found = find_unfinished(folders);
  if (!found) return false;
  if (found->run.active) {
    std::cerr << "overbend: " << unfinished_run_text(*found) << "; wait for it, or choose another folder with -o\n";
    return std::nullopt;
  }
  if (is_terminal(StandardStream::input) && is_terminal(StandardStream::error)) return ask(*found);
  std::cerr << "overbend: " << unfinished_run_text(*found) << "; "
            << (found->run.error.empty() ? "continue with --resume, or discard it and start again with --restart"
                                         : "discard it and start again with --restart")
            << "\n";
  return std::nullopt;
}

}  // namespace overbend
