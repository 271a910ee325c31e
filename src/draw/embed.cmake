# SPDX-License-Identifier: Apache-2.0
# cmake -DOUT=file.cpp -DDIR=folder -P embed.cmake: viewer.html and viewer.js as arrays of bytes.
set(text "// Made from viewer.html and viewer.js by embed.cmake.\n#include \"draw/viewer_assets.h\"\n\nnamespace aresta::draw {\n\n")
foreach(name html js)
  file(READ ${DIR}/viewer.${name} bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
  string(REGEX REPLACE "((0x..,){24})" "\\1\n" bytes "${bytes}")
  string(APPEND text "static const unsigned char ${name}_bytes[] = {\n${bytes}};\n"
    "extern const std::string_view viewer_${name}(reinterpret_cast<const char*>(${name}_bytes), sizeof ${name}_bytes);\n\n")
endforeach()
file(WRITE ${OUT} "${text}}  // namespace aresta::draw\n")
