# Writes a C++ source that takes files into the program: cmake -DOUT=x.cpp -DPAGE=dir -DLICENCES=file -DROOT=dir -P embed_files.cmake
# By the assembler's incbin: a page of megabytes written as numbers would take the compiler minutes.
set(symbols "")
set(table "")
set(count 0)

macro(embed name file)
  string(APPEND symbols "asm(R\"(.section .rodata\n.global overbend_embedded_${count}\noverbend_embedded_${count}:\n.incbin \"${file}\"\n.byte 0\n.previous)\");\nextern \"C\" const char overbend_embedded_${count}[];\n")
  file(SIZE "${file}" bytes)
  string(APPEND table "      {\"${name}\", {overbend_embedded_${count}, ${bytes}}},\n")
  math(EXPR count "${count} + 1")
endmacro()

file(GLOB_RECURSE page RELATIVE ${PAGE} ${PAGE}/*)
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
