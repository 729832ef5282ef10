# The page's program as two modules of WebAssembly (two_modules.mjs), or as one if there is no wasm-split.
include_guard()

find_program(EVENLIFT_WASM_SPLIT wasm-split HINTS "${EMSCRIPTEN_ROOT_PATH}/../bin" DOC "Divides the page's program into two modules")

# evenlift_two_modules(TARGET REST): sets REST to the name of the second file, or to nothing.
function(evenlift_two_modules target rest)
  set(${rest} "" PARENT_SCOPE)
  if(NOT EVENLIFT_WASM_SPLIT)
    message(STATUS "No wasm-split: the page loads its whole program before the first picture")
    return()
  endif()
  find_program(EVENLIFT_NODE NAMES node nodejs REQUIRED)
  get_target_property(name ${target} OUTPUT_NAME)
  set(folder "$<TARGET_FILE_DIR:${target}>")
  set(script "${PROJECT_SOURCE_DIR}/cmake/two_modules.mjs")
  add_custom_command(
    TARGET ${target}
    POST_BUILD
    COMMAND
      "${EVENLIFT_NODE}" "${script}" "${EVENLIFT_WASM_SPLIT}" "$<TARGET_FILE:${target}>" "${folder}/${name}.wasm"
      "${folder}/${name}_rest.wasm" "${PROJECT_SOURCE_DIR}/assets" "${CMAKE_CURRENT_BINARY_DIR}/two_modules"
    VERBATIM)
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${script}")
  set(${rest} ${name}_rest.wasm PARENT_SCOPE)
endfunction()
