# How programs are linked for WebAssembly: for Node, and for the page. Flags that hold for every object file are
# in the presets and in core/CMakeLists.txt.
include_guard()

if(EVENLIFT_EXPECT_EMSCRIPTEN AND NOT EMSCRIPTEN)
  message(FATAL_ERROR "The preset `wasm` needs Emscripten's toolchain: emcmake cmake --preset wasm")
endif()

# Debian's Emscripten looks for a Node module where only Debian's Node looks by itself.
if(EMSCRIPTEN AND EXISTS "/usr/share/nodejs/acorn")
  set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "\"${CMAKE_COMMAND}\" -E env NODE_PATH=/usr/share/nodejs")
endif()

# Emscripten's name for it changed in 3.1.27, and its default from 5 MB to 64 KB.
if(EMSCRIPTEN_VERSION VERSION_LESS 3.1.27)
  set(evenlift_stack "-sTOTAL_STACK=4MB")
else()
  set(evenlift_stack "-sSTACK_SIZE=4MB")
endif()

# What draws is compiled for size on WebAssembly (8 % off the page), what computes for speed. Link-time optimization
# was measured too, and made the page no smaller.
set(evenlift_small "")
if(EMSCRIPTEN)
  set(evenlift_small -Oz -fno-rtti)
endif()

# A program for Node: real files, standard streams byte for byte, its exit status, C++ exceptions.
function(evenlift_node_program target)
  target_compile_options(${target} PRIVATE -fexceptions)
  target_link_options(
    ${target}
    PRIVATE
    -fexceptions
    -sENVIRONMENT=node
    -sNODERAWFS=1
    -sEXIT_RUNTIME=1
    -sALLOW_MEMORY_GROWTH=1
    ${evenlift_stack}
    "SHELL:--pre-js \"${PROJECT_SOURCE_DIR}/cmake/node_pre.js\"")
  set_target_properties(${target} PROPERTIES LINK_DEPENDS "${PROJECT_SOURCE_DIR}/cmake/node_pre.js")
endfunction()

# A program for a web page: WebGL 2, no file system, no exceptions, and nothing that a content security policy
# without 'unsafe-eval' refuses.
function(evenlift_page_program target)
  target_compile_options(${target} PRIVATE -fno-exceptions ${evenlift_small})
  target_link_options(
    ${target}
    PRIVATE
    ${evenlift_small}
    -fno-exceptions
    -sENVIRONMENT=web
    -sFILESYSTEM=0
    -sMALLOC=emmalloc
    -sDYNAMIC_EXECUTION=0
    -sMIN_WEBGL_VERSION=2
    -sMAX_WEBGL_VERSION=2
    -sALLOW_MEMORY_GROWTH=1
    ${evenlift_stack})
endfunction()
