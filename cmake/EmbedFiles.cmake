# geodesic_embed_page(<target> <folder>)
#
# Builds the files of a folder into a target, which then has PageFiles()
# (server/web/page_file.h). A changed file is taken up by the next build. Needs
# the language ASM.
function(geodesic_embed_page target folder)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/*)
  set(bytes "    .section .rodata\n")
  set(declarations "")
  set(entries "")
  set(number 0)
  foreach(file IN LISTS files)
    cmake_path(GET file EXTENSION LAST_ONLY ending)
    set(types html text/html css text/css js text/javascript
              svg image/svg+xml png image/png ico image/x-icon
              webmanifest application/manifest+json txt text/plain
              json application/json wasm application/wasm woff2 font/woff2)
    string(REPLACE "." "" ending "${ending}")
    list(FIND types "${ending}" place)
    if(place EQUAL -1)
      message(FATAL_ERROR "${folder}/${file}: no content type is known for it; "
                          "add it in cmake/EmbedFiles.cmake")
    endif()
    math(EXPR place "${place} + 1")
    list(GET types ${place} type)
    if(type MATCHES "^text/")
      string(APPEND type "; charset=utf-8")
    endif()
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
                 ${folder}/${file})
    file(SHA256 ${folder}/${file} digest)
    string(SUBSTRING ${digest} 0 32 tag)
    set(symbol page_file_${number})
    string(APPEND bytes
      "    .global ${symbol}\n${symbol}:\n    .incbin \"${folder}/${file}\"\n"
      "    .global ${symbol}_end\n${symbol}_end:\n    .byte 0\n")
    string(APPEND declarations "extern const char ${symbol}[], ${symbol}_end[];\n")
    string(APPEND entries
      "      {\"/${file}\", \"${type}\", \"\\\"${tag}\\\"\",\n"
      "       {${symbol}, static_cast<size_t>(${symbol}_end - ${symbol})}},\n")
    math(EXPR number "${number} + 1")
  endforeach()
  # The stack stays one that no code can be run from.
  string(APPEND bytes "    .section .note.GNU-stack,\"\",%progbits\n")
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${target}_page)
  file(CONFIGURE OUTPUT ${out}.S CONTENT "${bytes}" @ONLY)
  file(CONFIGURE OUTPUT ${out}.cc CONTENT
"#include \"server/web/page_file.h\"

extern \"C\" {
${declarations}}

namespace geodesic::server {

std::span<const PageFile> PageFiles() {
  static const PageFile kFiles[] = {
${entries}  };
  return kFiles;
}

}  // namespace geodesic::server
" @ONLY)
  foreach(file IN LISTS files)
    set_property(SOURCE ${out}.S APPEND PROPERTY OBJECT_DEPENDS ${folder}/${file})
  endforeach()
  target_sources(${target} PRIVATE ${out}.S ${out}.cc)
endfunction()
