# Text of C++ that has the bytes of a file as `const char symbol[]`, with a zero behind them, by the assembler's incbin: a
# page of megabytes written as numbers would take the compiler minutes.
#
#   embed_bytes(VARIABLE SYMBOL FILE)     SYSTEM, given to the script that includes this one, is CMAKE_SYSTEM_NAME
function(embed_bytes variable symbol file)
  file(SIZE "${file}" bytes)
  math(EXPR all "${bytes} + 1")
  if(SYSTEM STREQUAL "Windows")
    set(section ".section .rdata,\"dr\"\n")
    set(end ".text\n")
  elseif(SYSTEM STREQUAL "Emscripten")
    set(section ".section .rodata.${symbol},\"\",@\n.type ${symbol},@object\n.size ${symbol}, ${all}\n")
    set(end ".text\n")
  else()
    set(section ".section .rodata\n")
    set(end ".previous\n")
  endif()
  set(${variable} "asm(R\"(${section}.globl ${symbol}\n${symbol}:\n.incbin \"${file}\"\n.byte 0\n${end})\");\nextern \"C\" const char ${symbol}[];\n" PARENT_SCOPE)
endfunction()
