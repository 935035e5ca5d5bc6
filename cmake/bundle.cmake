# cmake -D FOLDER=… -D OUTPUT=… -P bundle.cmake: all files below FOLDER as one text. Each file is a line
# "=== name", then its content. Meshes have no content.
file(GLOB_RECURSE names RELATIVE ${FOLDER} ${FOLDER}/*)
list(SORT names)
set(all "")
foreach(name IN LISTS names)
  set(content "")
  if(NOT name MATCHES "\\.(stl|obj)$")
    file(READ ${FOLDER}/${name} content)
  endif()
  string(APPEND all "=== ${name}\n${content}")
endforeach()
file(WRITE ${OUTPUT} "${all}")
