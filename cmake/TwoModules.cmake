# The page's program as two modules of WebAssembly, NAME.wasm and NAME_rest.wasm: see two_modules.mjs.
include_guard()

function(evenlift_two_modules target)
  find_program(EVENLIFT_NODE NAMES node nodejs REQUIRED)
  find_program(EVENLIFT_WASM_SPLIT wasm-split HINTS "${EMSCRIPTEN_ROOT_PATH}/../bin" DOC "Divides the page's program into two modules")
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
endfunction()
