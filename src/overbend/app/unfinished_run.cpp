#include "app/unfinished_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>
#include <string>

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

std::string words(const Unfinished& found) {
  if (found.run.active) {
    return fmt::format("a run is active in '{}', at t = {:.1f} s by its last checkpoint", found.folder.string(),
                       found.run.time);
  }
  const std::string where = fmt::format("there is an unfinished run in '{}'", found.folder.string());
  return found.run.fault.empty() ? fmt::format("{}, stopped at t = {:.1f} s", where, found.run.time)
                                 : fmt::format("{}, which cannot be resumed: {}", where, found.run.fault);
}

std::optional<bool> ask(const Unfinished& found) {
  const bool sound = found.run.fault.empty();
  std::cerr << "overbend: " << words(found) << "\n"
            << (sound ? "Go on with it (g), discard it and start again (a), or leave it (any other key)? "
                      : "Discard it and start again (a), or leave it (any other key)? ")
            << std::flush;
  std::string answer;
  std::getline(std::cin, answer);
  if (sound && (answer == "g" || answer == "G")) return true;
  if (answer == "a" || answer == "A") return false;
  return std::nullopt;
}

}  // namespace

std::optional<bool> goes_on(const std::vector<fs::path>& folders, const TakeUp& wish) {
  if (wish.resume || wish.restart) return wish.resume;
  const std::optional<Unfinished> found = find_unfinished(folders);
  if (!found) return false;
  if (found->run.active) {
    std::cerr << "overbend: " << words(*found) << "; wait for it, or choose another folder with -o\n";
    return std::nullopt;
  }
  if (isatty(STDIN_FILENO) == 1 && isatty(STDERR_FILENO) == 1) return ask(*found);
  std::cerr << "overbend: " << words(*found) << "; "
            << (found->run.fault.empty() ? "continue with --resume, or discard it and start again with --restart"
                                         : "discard it and start again with --restart")
            << "\n";
  return std::nullopt;
}

}  // namespace overbend
