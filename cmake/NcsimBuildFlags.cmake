# Flags that our own targets are compiled with and that no consumer inherits.
add_library(ncsim_build_flags INTERFACE)

# Contraction of a*b+c into one fused operation is the compiler's choice and
# differs between targets; without this line two builds may disagree on the
# sign of a determinant, and then on the topology of a part.
# __int128 (the exact kernel) is an extension: -Wpedantic is told so by __extension__.
target_compile_options(ncsim_build_flags INTERFACE
  -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  # GCC 12 sees copies that overlap in "a" + std::string, or not, as it inlines: by the length of
  # the folder's name, even (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)

# What is an error must not hang on what the optimizer happens to inline.
if(NCSIM_WERROR)
  target_compile_options(ncsim_build_flags INTERFACE -Werror
    $<$<CXX_COMPILER_ID:GNU>:-Wno-error=maybe-uninitialized -Wno-error=array-bounds
      -Wno-error=stringop-overflow -Wno-error=stringop-overread>)
endif()

if(NCSIM_SANITIZE)
  target_compile_options(ncsim_build_flags INTERFACE
    -fsanitize=${NCSIM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    # GCC 12 sees uninitialised variables in instrumented code where there are none.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(ncsim_build_flags INTERFACE -fsanitize=${NCSIM_SANITIZE})
endif()

# For what sees CGAL, after the flags above: it casts faces of arrangements to classes that they are
# not, which Clang's check of vtables reports.
add_library(ncsim_cgal_flags INTERFACE)
if(NCSIM_SANITIZE)
  target_compile_options(ncsim_cgal_flags INTERFACE
    $<$<CXX_COMPILER_ID:Clang>:-fno-sanitize=vptr>)
endif()
# -O3 takes up to a quarter longer to compile CGAL, and nothing that was measured is faster for it.
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  target_compile_options(ncsim_cgal_flags INTERFACE $<$<CONFIG:Release>:-O2>)
endif()
