# cmake -D NAMESPACE=… -D NAME=… -D INPUT=… -D OUTPUT=… -P embed.cmake: a file as an array of bytes.
file(READ ${INPUT} bytes HEX)
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
