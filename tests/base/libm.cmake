# cmake -DSOURCE=… -P libm.cmake: fails where a source of lib/ or apps/ calls a function of the C
# library that is not the same to the last bit on every system, and is not known below. What IEEE 754
# says to the last bit may be called: sqrt, fma, remainder, rounding, ldexp. lib/base has the rest.
cmake_minimum_required(VERSION 3.25)

set(functions "sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot|erf|erfc|tgamma|lgamma|sincos")

# FILE: why. One that calls none any more has to be struck off.
set(known
  "lib/gcode/src/text/expression.cpp: EXP, LN, POW and ** of programs, which the language has"
  "lib/gcode/src/klartext/q_parameters.cpp: EXP, LN, LOG and ^ of programs, which the language has"
  "lib/gcode/src/sinumerik/formula.cpp: EXP, LN and powers of ten of programs, which the language has")

set(faults "")
set(met "")
file(GLOB_RECURSE files RELATIVE ${SOURCE} ${SOURCE}/lib/*.h ${SOURCE}/lib/*.cpp ${SOURCE}/apps/*.h ${SOURCE}/apps/*.cpp)
foreach(file IN LISTS files)
  # Semicolons and brackets would be read as lists.
  file(READ ${SOURCE}/${file} text)
  string(REGEX REPLACE "[][;\\]" " " text "${text}")
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  string(REGEX MATCHALL "(std)?::(${functions})[fl]? *\\(|using +std::(${functions})[fl]?[^a-z0-9_]" calls "${text}")
  # Of any name: what is a member, or a function of ours, has a dot or a name before it.
  string(REGEX MATCHALL "[=(,*+/<>!&|?{}-] *(${functions})[fl]? *\\([^)]" bare "${text}")
  list(APPEND calls ${bare})
  if(NOT calls)
    continue()
  endif()
  set(reason ${known})
  list(FILTER reason INCLUDE REGEX "^${file}: ")
  if(reason)
    list(APPEND met ${reason})
  else()
    list(GET calls 0 call)
    list(APPEND faults "${file}: ${call} is not the same on every system: lib/base has what is")
  endif()
endforeach()
foreach(file IN LISTS known)
  if(NOT file IN_LIST met)
    list(APPEND faults "libm.cmake: strike off ${file}")
  endif()
endforeach()
if(NOT files)
  list(APPEND faults "there are no sources in ${SOURCE}")
endif()
if(faults)
  list(JOIN faults "\n  " text)
  message(FATAL_ERROR "The C library reaches an output:\n  ${text}")
endif()
