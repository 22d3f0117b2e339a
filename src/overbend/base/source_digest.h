/// Identification of the sources of the build.
#pragma once

namespace overbend {

/// Digest of all sources that affect results (tools/source_digest.cmake): twelve hexadecimal digits. Equal for all
/// builds of the same sources.
const char* source_digest();

}  // namespace overbend
