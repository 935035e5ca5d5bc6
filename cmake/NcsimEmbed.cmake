# ncsim_embed(<target> <name> <file>): <file> becomes part of <target>, ncsim_LIBRARY, as
#     extern const std::string_view <name>;   (namespace ncsim::LIBRARY, unless NAMESPACE names it)
# Made anew when the file changes.
function(ncsim_embed target name file)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "NAMESPACE" "")
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded/${name}.cpp)
  string(REPLACE "ncsim_" "ncsim::" namespace ${target})
  if(arg_NAMESPACE)
    set(namespace ${arg_NAMESPACE})
  endif()
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -D NAMESPACE=${namespace} -D NAME=${name} -D INPUT=${file} -D OUTPUT=${source}
      -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${file} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    COMMENT "Embedding ${file}"
    VERBATIM)
  set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${target} PRIVATE ${source})
endfunction()
