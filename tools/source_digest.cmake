# Writes OUTPUT, which gives the program a digest of the sources below ROOT that take part in computing.
file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/*.cpp ${ROOT}/*.h)
list(FILTER sources EXCLUDE REGEX "^(app|platform|report|study|serve)/")
list(SORT sources)
set(digests "")
foreach(source IN LISTS sources)
  file(SHA256 ${ROOT}/${source} digest)
  string(APPEND digests "${source} ${digest}\n")
endforeach()
string(SHA256 digest "${digests}")
string(SUBSTRING ${digest} 0 12 digest)
file(WRITE ${OUTPUT} "#include \"base/source_digest.h\"

namespace overbend {

const char* source_digest() {
  return \"${digest}\";
}

}  // namespace overbend
")
