/// Says of a folder that the results in it are whole, and of which input: what --resume looks at first.
#pragma once

#include <filesystem>
#include <string>

namespace overbend {

/// `input` is that of the run: input_text() of study/dynamic_realisation.h.
void mark_finished(const std::filesystem::path& folder, const std::string& input);

/// Takes the mark away before the folder is written anew. Does not throw: where that fails, the run cannot be stored
/// either.
void unmark(const std::filesystem::path& folder);

/// Whether the run of this input is finished there. Throws std::runtime_error where a finished run of another model,
/// duration or version lies in the folder.
bool is_finished(const std::filesystem::path& folder, const std::string& input);

}  // namespace overbend
