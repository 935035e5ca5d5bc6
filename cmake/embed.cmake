# cmake -D NAMESPACE=… -D NAME=… -D INPUT=… -D OUTPUT=… -P embed.cmake: a file as an array of bytes.
# With SCHEMA: without descriptions and indentation, which only people read.
if(SCHEMA)
  file(READ ${INPUT} text)
  string(REGEX REPLACE "\"description\": \"([^\"\\\\]|\\\\.)*\",[ \n]*" "" text "${text}")
  string(REGEX REPLACE "\n *" "" text "${text}")
  file(WRITE ${OUTPUT}.json "${text}")
  set(INPUT_TO_EMBED ${OUTPUT}.json)
else()
  set(INPUT_TO_EMBED ${INPUT})
endif()
file(READ ${INPUT_TO_EMBED} bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
file(WRITE ${OUTPUT} "// Generated from ${INPUT}.
#include <string_view>
namespace ${NAMESPACE} {
namespace {
const char ${NAME}Bytes[] = {${bytes} 0};
}
extern const std::string_view ${NAME};
const std::string_view ${NAME}(${NAME}Bytes, sizeof ${NAME}Bytes - 1);
}  // namespace ${NAMESPACE}
")
