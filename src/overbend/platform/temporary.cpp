#include "platform/temporary.h"

namespace overbend {
namespace fs = std::filesystem;

fs::path temporary_folder() {
  std::error_code error;
  fs::path folder = fs::temp_directory_path(error);
  return error ? fs::current_path() : folder;
}

ScratchFolder::ScratchFolder(std::error_code& error)
    : path_(make_unique_folder(temporary_folder(), "overbend-", error)) {
  if (error) path_ = make_unique_folder(fs::current_path(), "overbend-", error);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

}  // namespace overbend
