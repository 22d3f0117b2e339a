/// Identification of the sources of the build.
#pragma once

namespace overbend {

/// Digest of all sources that take part in computing (tools/source_digest.cmake): twelve hexadecimal digits. Another
/// build of the same sources has the same.
const char* source_digest();

}  // namespace overbend
