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

# Puts sources into `united` that include those of `sources` whose names begin with test_, several each, in namespaces
# of their own, since each names its helpers as it likes; what they include comes before. All other sources stay, and
# so do those with conditions or macros.
function(evenlift_unite_tests united sources)
  set(at_once 8)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${sources})
  set(rest)
  set(tests)
  foreach(file IN LISTS sources)
    file(STRINGS "${file}" conditions REGEX "^#(if|define)")
    if(conditions OR NOT file MATCHES "/test_[a-z0-9_]+[.]cpp$")
      list(APPEND rest "${file}")
    else()
      list(APPEND tests "${file}")
    endif()
  endforeach()
  list(LENGTH tests count)
  set(first 0)
  while(first LESS count)
    list(SUBLIST tests ${first} ${at_once} batch)
    set(headers)
    set(bodies)
    foreach(file IN LISTS batch)
      file(STRINGS "${file}" includes REGEX "^#include ")
      list(APPEND headers ${includes})
      string(MAKE_C_IDENTIFIER "${file}" name)
      string(APPEND bodies "namespace in_${name} {\n#include \"${CMAKE_CURRENT_SOURCE_DIR}/${file}\"\n}\n")
    endforeach()
    list(REMOVE_DUPLICATES headers)
    list(JOIN headers "\n" headers)
    set(source "${CMAKE_CURRENT_BINARY_DIR}/united/tests_${first}.cpp")
    file(CONFIGURE OUTPUT "${source}" CONTENT "${headers}\n\n${bodies}" @ONLY)
    list(APPEND rest "${source}")
    math(EXPR first "${first} + ${at_once}")
  endwhile()
  set(${united} ${rest} PARENT_SCOPE)
endfunction()
