#include "app/finished_mark.h"

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "resultfiles/results_writer.h"
#include "runstore/append_file.h"
#include "runstore/run_record.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMark = ".finished";

std::string mark_text(const std::string& input) {
  return text_hash(input) + " " + program_identity() + "\n";
}

}  // namespace

void mark_finished(const fs::path& folder, const std::string& input) {
  write_text(folder / ".finished.new", mark_text(input));
  fs::rename(folder / ".finished.new", folder / kMark);
}

void unmark(const fs::path& folder) {
  std::error_code ignored;
  fs::remove(folder / kMark, ignored);
}

bool is_finished(const fs::path& folder, const std::string& input) {
  std::ifstream stream(folder / kMark, std::ios::binary);
  if (!stream) return false;
  const std::string found((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (found == mark_text(input)) return true;
  throw std::runtime_error(
      "'" + folder.string() +
      "' has results of another model file or another build of the program; start again with --restart");
}

}  // namespace overbend
