# Flags for all object files are in the presets and in core/CMakeLists.txt.
include_guard()

if(EVENLIFT_EXPECT_EMSCRIPTEN AND NOT EMSCRIPTEN)
  message(FATAL_ERROR "The preset `wasm` needs Emscripten's toolchain: emcmake cmake --preset wasm")
endif()

# Debian's Emscripten needs a Node module in a folder that only Debian's Node searches by default.
if(EMSCRIPTEN AND EXISTS "/usr/share/nodejs/acorn")
  set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "\"${CMAKE_COMMAND}\" -E env NODE_PATH=/usr/share/nodejs")
endif()

# Emscripten 3.1.27 renamed this option and changed its default from 5 MB to 64 KB.
if(EMSCRIPTEN_VERSION VERSION_LESS 3.1.27)
  set(evenlift_stack "-sTOTAL_STACK=4MB")
else()
  set(evenlift_stack "-sSTACK_SIZE=4MB")
endif()

# WebAssembly is compiled for size, but work for every edge pair or candidate (core/CMakeLists.txt) for speed. Placing
# 20 teams by area on 1,000 vertices takes 6.9 ms, and 5.9 ms with the whole core at -O2. With -Os and -Oz, old
# Emscripten implies -fno-inline-functions, which makes code with many small functions, as those of vec.h, many times
# slower; -finline-functions undoes that. Link-time optimization made the page no smaller; Dear ImGui, QR codes and
# core/src/output without inlining made it 3,600 bytes larger.
set(evenlift_small "")
set(evenlift_quick "")
if(EMSCRIPTEN)
  set(evenlift_small -Oz -fno-rtti -fno-exceptions -finline-functions)
  set(evenlift_quick -Os -fno-rtti -fno-exceptions -finline-functions)
endif()

# Real files, standard streams byte for byte, its exit status, C++ exceptions.
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

# WebGL 2, no file system, no exceptions, and nothing that a content security policy without 'unsafe-eval' would refuse.
function(evenlift_page_program target)
  target_compile_options(${target} PRIVATE ${evenlift_small})
  target_link_options(
    ${target}
    PRIVATE
    ${evenlift_small}
    -sENVIRONMENT=web
    -sFILESYSTEM=0
    -sMALLOC=emmalloc
    # No support for browsers without WebGL 2 or TextDecoder, and no unused features.
    -sTEXTDECODER=2
    -sMIN_CHROME_VERSION=85
    -sMIN_FIREFOX_VERSION=79
    # No Edge before it was based on Chrome: new Emscripten accepts only this value.
    -sMIN_EDGE_VERSION=2147483647
    -sMIN_SAFARI_VERSION=150000
    -sGL_TRACK_ERRORS=0
    -sGL_POOL_TEMP_BUFFERS=0
    -sHTML5_SUPPORT_DEFERRING_USER_SENSITIVE_REQUESTS=0
    -sSUPPORT_ERRNO=0
    -sDYNAMIC_EXECUTION=0
    -sMIN_WEBGL_VERSION=2
    -sMAX_WEBGL_VERSION=2
    -sALLOW_MEMORY_GROWTH=1
    # 3,800 bytes less after compression.
    -sBINARYEN_EXTRA_PASSES=--flatten,--rereloop,-Oz,-Oz
    ${evenlift_stack})
endfunction()
