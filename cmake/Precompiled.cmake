# Reading headers takes most of the time of compiling a small file. Every file still includes all that it uses:
# `./dev tidy` compiles each alone, without precompiled headers (CMAKE_DISABLE_PRECOMPILE_HEADERS).
include_guard()

# The target reads the headers that it names, and these, only once. For WebAssembly it would read them to no use: a
# library is two or three units there (below).
function(evenlift_precompile target)
  if(EMSCRIPTEN)
    return()
  endif()
  target_precompile_headers(
    ${target}
    PRIVATE
    <algorithm>
    <optional>
    <string>
    <vector>
    ${ARGN})
endfunction()

# A large library is also compiled many files at a time, so the names in their unnamed namespaces must differ: eight
# natively, where one changed file should not mean much to compile, and 48 for WebAssembly.
function(evenlift_compile_together)
  if(EVENLIFT_UNITY)
    set(files 8)
    if(EMSCRIPTEN)
      set(files 48)
    endif()
    set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${files})
  endif()
endfunction()
