# Writes a C++ source that takes files into the program: cmake -DOUT=x.cpp -DPAGE=dir -DLICENCES=file -DROOT=dir -DSYSTEM=Linux -P embed_files.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../../../../cmake/embed_bytes.cmake)
set(symbols "")
set(table "")
set(count 0)

macro(embed name file)
  embed_bytes(symbol overbend_embedded_${count} "${file}")
  string(APPEND symbols "${symbol}")
  file(SIZE "${file}" bytes)
  string(APPEND table "      {\"${name}\", {overbend_embedded_${count}, ${bytes}}},\n")
  math(EXPR count "${count} + 1")
endmacro()

if(PAGE)
  file(GLOB_RECURSE page RELATIVE ${PAGE} ${PAGE}/*)
endif()
foreach(name IN LISTS page)
  if(NOT name MATCHES "\\.map$")
    embed("page/${name}" "${PAGE}/${name}")
  endif()
endforeach()
file(GLOB examples RELATIVE ${ROOT} ${ROOT}/examples/*.yaml ${ROOT}/data/bgl1/rao.csv
     ${ROOT}/data/bgl1/bgl1.1 ${ROOT}/data/bgl1/bgl1.3 ${ROOT}/data/bgl1/bgl1.8 ${ROOT}/data/bgl1/bgl1.hst)
foreach(name IN LISTS examples)
  embed("${name}" "${ROOT}/${name}")
endforeach()
embed("licences.txt" "${LICENCES}")
embed("LICENSE" "${ROOT}/LICENSE")

file(WRITE "${OUT}" "// Made by serve/embedded/embed_files.cmake; do not edit.\n#include \"serve/http/embedded_files.h\"\n\n${symbols}
namespace overbend {

const std::vector<EmbeddedFile>& embedded_files() {
  static const std::vector<EmbeddedFile> kFiles = {
${table}  };
  return kFiles;
}

}  // namespace overbend
")
