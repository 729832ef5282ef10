# All libraries. Each is the system's package, or else the sources in ./dev's cache or in
# FETCHCONTENT_SOURCE_DIR_<NAME>, or else fetched at a pinned commit.
include_guard()
include(FetchContent)

if(NOT EVENLIFT_DOWNLOADS)
  set(FETCHCONTENT_FULLY_DISCONNECTED ON)
endif()

# The cache of `./dev`, at the same three locations.
set(EVENLIFT_CACHE "$ENV{EVENLIFT_CACHE}")
if(NOT EVENLIFT_CACHE AND DEFINED ENV{XDG_CACHE_HOME} AND NOT "$ENV{XDG_CACHE_HOME}" STREQUAL "")
  set(EVENLIFT_CACHE "$ENV{XDG_CACHE_HOME}/evenlift")
endif()
if(NOT EVENLIFT_CACHE)
  set(EVENLIFT_CACHE "$ENV{HOME}/.cache/evenlift")
endif()

# Sets the variable to the newest matching folder of the cache, unless it already is an existing folder.
function(evenlift_cached variable pattern)
  if(IS_DIRECTORY "${${variable}}")
    return()
  endif()
  file(GLOB found LIST_DIRECTORIES true "${EVENLIFT_CACHE}/${pattern}")
  if(found)
    list(SORT found COMPARE NATURAL ORDER DESCENDING)
    list(GET found 0 newest)
    set(${variable} "${newest}" CACHE PATH "" FORCE)
  endif()
endfunction()

# Sets <name>_SOURCE_DIR (in lower case) to the sources; builds nothing.
macro(evenlift_fetch name repository commit)
  string(TOUPPER ${name} evenlift_upper)
  if(NOT EVENLIFT_DOWNLOADS AND NOT FETCHCONTENT_SOURCE_DIR_${evenlift_upper})
    message(
      FATAL_ERROR
        "evenlift needs ${name}, which is neither installed nor in ${EVENLIFT_CACHE}, and EVENLIFT_DOWNLOADS is OFF. "
        "Install it, run ./dev build once, or give its sources with -DFETCHCONTENT_SOURCE_DIR_${evenlift_upper}=FOLDER.")
  endif()
  # Does not exist, so that the library's own build is not used.
  FetchContent_Declare(
    ${name} GIT_REPOSITORY ${repository} GIT_TAG ${commit} SOURCE_SUBDIR evenlift-does-not-build-this)
  FetchContent_MakeAvailable(${name})
endmacro()

# A header-only library for every platform. A cross-compiler has its own C library and must not see the system's
# headers: for a package among them, it gets a folder with a link to <folder>.
function(evenlift_headers package version target folder repository commit include)
  string(TOUPPER ${package} upper)
  if(NOT FETCHCONTENT_SOURCE_DIR_${upper})
    find_package(${package} ${version} QUIET CONFIG NO_CMAKE_FIND_ROOT_PATH PATHS /usr/local /usr)
  endif()
  if(TARGET ${target})
    set_target_properties(${target} PROPERTIES IMPORTED_GLOBAL TRUE)
    if(CMAKE_CROSSCOMPILING)
      get_target_property(directories ${target} INTERFACE_INCLUDE_DIRECTORIES)
      list(GET directories 0 directory)
      set(links "${PROJECT_BINARY_DIR}/headers/${package}")
      file(MAKE_DIRECTORY "${links}")
      file(CREATE_LINK "${directory}/${folder}" "${links}/${folder}" SYMBOLIC)
      set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${links}")
    endif()
  else()
    evenlift_fetch(${package} ${repository} ${commit})
    string(TOLOWER ${package} lower)
    add_library(${target} INTERFACE IMPORTED GLOBAL)
    set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${${lower}_SOURCE_DIR}/${include}")
  endif()
endfunction()

# --- Headers only: Eigen (linear equations), nlohmann-json (reading JSON), CLI11 (command line) ---------------------------------
evenlift_headers(
  Eigen3 3.4 Eigen3::Eigen Eigen
  https://gitlab.com/libeigen/eigen.git 3147391d946bb4b6c68edd901f2add6ac1f31f8c # 3.4.0
  .)
evenlift_headers(
  nlohmann_json 3.10 nlohmann_json::nlohmann_json nlohmann
  https://github.com/nlohmann/json.git bc889afb4c5bf1c0d8ee29ef35eaaf4c8bef8a5d # v3.11.2
  include)

if(EVENLIFT_PROGRAM OR EVENLIFT_TESTS)
  evenlift_headers(
    CLI11 2.1 CLI11::CLI11 CLI
    https://github.com/CLIUtils/CLI11.git 291c58789c031208f08f4f261a858b5b7083e8e2 # v2.3.2
    include)
endif()

# --- pugixml, which reads the XML of SVG files: the system's library, and its sources for WebAssembly -------------------
if(EVENLIFT_IMPORT)
  if(NOT EMSCRIPTEN AND NOT FETCHCONTENT_SOURCE_DIR_PUGIXML)
    find_package(pugixml 1.11 QUIET CONFIG)
  endif()
  if(NOT TARGET pugixml::pugixml)
    evenlift_cached(FETCHCONTENT_SOURCE_DIR_PUGIXML "pugixml-*")
    evenlift_fetch(pugixml https://github.com/zeux/pugixml.git a0e064336317c9347a91224112af9933598714e9) # v1.13
    add_library(pugixml STATIC EXCLUDE_FROM_ALL "${pugixml_SOURCE_DIR}/src/pugixml.cpp")
    add_library(pugixml::pugixml ALIAS pugixml)
    target_include_directories(pugixml SYSTEM PUBLIC "$<BUILD_INTERFACE:${pugixml_SOURCE_DIR}/src>")
    # PUBLIC: the header must match the build.
    target_compile_definitions(pugixml PUBLIC PUGIXML_NO_XPATH PUGIXML_NO_EXCEPTIONS PUGIXML_NO_STL)
    target_compile_options(pugixml PRIVATE -fno-exceptions -w ${evenlift_small})
  endif()
  # Linked statically, so that the program needs no installed pugixml.
  set(EVENLIFT_PUGIXML pugixml::pugixml)
  if(TARGET pugixml::static)
    set(EVENLIFT_PUGIXML pugixml::static)
  endif()
endif()

# --- Dear ImGui: the sources, built with our configuration (wasm/ui/imgui_config.h) -------------------------------------
# Without a backend: wasm/page/webgl_renderer.cpp draws its output, wasm/page/sdl_input.cpp passes it the pointer, and
# the tests use it without a window.
if(EVENLIFT_VIEW)
  evenlift_cached(FETCHCONTENT_SOURCE_DIR_IMGUI "imgui-*")
  evenlift_fetch(
    imgui https://github.com/ocornut/imgui.git 512c54bbc062c41c74f8a8bd8ff1fd6bebd1e6d0) # v1.86
  add_library(
    imgui STATIC EXCLUDE_FROM_ALL
    "${imgui_SOURCE_DIR}/imgui.cpp" "${imgui_SOURCE_DIR}/imgui_draw.cpp" "${imgui_SOURCE_DIR}/imgui_tables.cpp"
    "${imgui_SOURCE_DIR}/imgui_widgets.cpp")
  add_library(imgui::imgui ALIAS imgui)
  target_include_directories(imgui SYSTEM PUBLIC "${imgui_SOURCE_DIR}")
  # PUBLIC: the configuration changes types, so all files must see the same one.
  target_compile_definitions(imgui PUBLIC "IMGUI_USER_CONFIG=\"${PROJECT_SOURCE_DIR}/wasm/ui/imgui_config.h\"")
  target_compile_options(imgui PRIVATE -fno-exceptions -w ${evenlift_small})
  if(EMSCRIPTEN)
    target_compile_options(imgui PRIVATE -fno-inline-functions) # smaller, and not performance-critical
  elseif(CMAKE_BUILD_TYPE STREQUAL "Release")
    target_compile_options(imgui PRIVATE -O1) # only tests have it
  endif()
endif()

# --- Inter, the typeface, and fonttools, which extracts the page's characters ------------------------------------------
# EVENLIFT_FONT_DIR contains Inter-Regular.otf and Inter-SemiBold.otf; EVENLIFT_PYTHON runs assets/fonts/subset.py.
if(EVENLIFT_VIEW)
  find_path(
    EVENLIFT_FONT_DIR NAMES Inter-Regular.otf
    PATHS /usr/share/fonts/opentype/inter /usr/share/fonts/inter /usr/share/fonts/OTF /usr/local/share/fonts
    DOC "Folder with Inter-Regular.otf and Inter-SemiBold.otf"
    NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH)
  if(NOT EVENLIFT_FONT_DIR)
    if(NOT EVENLIFT_DOWNLOADS AND NOT FETCHCONTENT_SOURCE_DIR_INTER)
      message(FATAL_ERROR "evenlift needs the typeface Inter, and EVENLIFT_DOWNLOADS is OFF. Install fonts-inter, or "
                          "name the folder of Inter-Regular.otf with -DEVENLIFT_FONT_DIR=FOLDER.")
    endif()
    FetchContent_Declare(
      inter
      URL https://github.com/rsms/inter/releases/download/v4.1/Inter-4.1.zip
      URL_HASH SHA256=9883fdd4a49d4fb66bd8177ba6625ef9a64aa45899767dde3d36aa425756b11e
      SOURCE_SUBDIR evenlift-does-not-build-this)
    FetchContent_MakeAvailable(inter)
    set(EVENLIFT_FONT_DIR "${inter_SOURCE_DIR}/extras/otf")
  endif()

  evenlift_find_python(EVENLIFT_PYTHON "fontTools" "Python with fonttools")
  if(NOT EVENLIFT_PYTHON)
    message(FATAL_ERROR "evenlift cuts its fonts with fonttools for Python 3: please install python3-fonttools (or "
                        "`pip install fonttools`, and name that Python with -DEVENLIFT_PYTHON=PROGRAM).")
  endif()
endif()

# --- SDL2: the page only ------------------------------------------------------------------------------------------
if(EVENLIFT_VIEW AND EMSCRIPTEN)
  evenlift_cached(SDL2_DIR "sdl2-*-plain-emscripten-${EMSCRIPTEN_VERSION}/lib/cmake/SDL2")
  find_package(SDL2 QUIET CONFIG)
  if(NOT TARGET SDL2::SDL2-static)
    if(NOT EVENLIFT_DOWNLOADS AND NOT FETCHCONTENT_SOURCE_DIR_SDL2)
      message(FATAL_ERROR "evenlift's page needs SDL2 for Emscripten ${EMSCRIPTEN_VERSION}, which is not in "
                          "${EVENLIFT_CACHE}, and EVENLIFT_DOWNLOADS is OFF. Run ./dev build, or give a build of it "
                          "with -DSDL2_DIR=FOLDER or its sources with -DFETCHCONTENT_SOURCE_DIR_SDL2=FOLDER.")
    endif()
    set(SDL_SHARED OFF CACHE BOOL "" FORCE)
    set(SDL_STATIC ON CACHE BOOL "" FORCE)
    # The parts that the page does not use, as in ./dev.
    foreach(
      part
      TEST
      AUDIO
      RENDER
      OPENGL
      OPENGLES
      HAPTIC
      JOYSTICK
      HIDAPI
      SENSOR
      POWER
      FILESYSTEM
      LOADSO
      LOCALE
      MISC
      DUMMYVIDEO
      OFFSCREEN)
      set(SDL_${part} OFF CACHE BOOL "" FORCE)
    endforeach()
    # From 3.1.31 on, Emscripten omits JavaScript functions without references; SDL2 references them from 2.28.4 on,
    # with a syntax that older Emscripten does not support.
    if(EMSCRIPTEN_VERSION VERSION_LESS 3.1.31)
      set(commit ac13ca9ab691e13e8eebe9684740ddcb0d716203) # release-2.26.5
    else()
      set(commit 5d249570393f7a37e037abf22cd6012a4cc56a71) # release-2.32.10
    endif()
    FetchContent_Declare(SDL2 GIT_REPOSITORY https://github.com/libsdl-org/SDL.git GIT_TAG ${commit})
    FetchContent_MakeAvailable(SDL2)
    target_compile_definitions(SDL2-static PRIVATE SDL_LEAN_AND_MEAN=1)
  endif()
endif()

# --- QR codes of links: the page only; Nayuki's generator, its C version, which neither throws nor allocates -----------
if(EVENLIFT_VIEW AND EMSCRIPTEN)
  evenlift_cached(FETCHCONTENT_SOURCE_DIR_QRCODEGEN "qr-code-generator-*")
  evenlift_fetch(
    qrcodegen https://github.com/nayuki/QR-Code-generator.git 720f62bddb7226106071d4728c292cb1df519ceb) # v1.8.0
  enable_language(C)
  add_library(qrcodegen STATIC EXCLUDE_FROM_ALL "${qrcodegen_SOURCE_DIR}/c/qrcodegen.c")
  add_library(qrcodegen::qrcodegen ALIAS qrcodegen)
  target_include_directories(qrcodegen SYSTEM PUBLIC "${qrcodegen_SOURCE_DIR}/c")
  target_compile_options(qrcodegen PRIVATE -w ${evenlift_small})
endif()

# --- Tests: Catch2, RapidCheck (properties), Boost.Multiprecision (exact oracle) -------------------------------------
if(EVENLIFT_TESTS AND NOT EMSCRIPTEN)
  # Catch2 2 and 3 have different headers and macros; tests/kit/catch.h distinguishes them by EVENLIFT_CATCH2_MAJOR.
  find_package(Catch2 QUIET CONFIG)
  if(Catch2_FOUND)
    set(EVENLIFT_CATCH2_MAJOR ${Catch2_VERSION_MAJOR})
    set(EVENLIFT_CATCH2_MODULE "${Catch2_DIR}/Catch.cmake")
  else()
    evenlift_fetch(
      Catch2 https://github.com/catchorg/Catch2.git 182c910b4b63ff587a3440e08f84f70497e49a81) # v2.13.10
    set(EVENLIFT_CATCH2_MAJOR 2)
    set(EVENLIFT_CATCH2_MODULE "${catch2_SOURCE_DIR}/contrib/Catch.cmake")
    add_library(Catch2::Catch2 INTERFACE IMPORTED GLOBAL)
    set_target_properties(
      Catch2::Catch2 PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${catch2_SOURCE_DIR}/single_include")
  endif()
  if(NOT TARGET Catch2::Catch2WithMain)
    file(WRITE "${PROJECT_BINARY_DIR}/catch_main.cpp.in" "#define CATCH_CONFIG_MAIN\n#include <catch2/catch.hpp>\n")
    configure_file("${PROJECT_BINARY_DIR}/catch_main.cpp.in" "${PROJECT_BINARY_DIR}/catch_main.cpp" COPYONLY)
    add_library(evenlift_catch_main STATIC "${PROJECT_BINARY_DIR}/catch_main.cpp")
    target_link_libraries(evenlift_catch_main PUBLIC Catch2::Catch2)
    add_library(Catch2::Catch2WithMain ALIAS evenlift_catch_main)
  endif()

  find_package(rapidcheck QUIET CONFIG)
  if(NOT TARGET rapidcheck)
    evenlift_fetch(
      rapidcheck https://github.com/emil-e/rapidcheck.git ff6af6fc683159deb51c543b065eba14dfcf329b) # has no tags
    add_subdirectory("${rapidcheck_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/rapidcheck" EXCLUDE_FROM_ALL SYSTEM)
  endif()

  find_package(Boost 1.70)
  if(NOT Boost_FOUND)
    message(FATAL_ERROR "evenlift's tests need Boost's headers (Boost.Multiprecision): install libboost-dev or boost, "
                        "or configure with -DEVENLIFT_TESTS=OFF.")
  endif()
endif()

# --- Benchmarks: Google Benchmark ------------------------------------------------------------------------------------
if(EVENLIFT_BENCH)
  if(NOT EMSCRIPTEN)
    find_package(benchmark QUIET CONFIG)
  endif()
  if(NOT TARGET benchmark::benchmark)
    evenlift_cached(FETCHCONTENT_SOURCE_DIR_BENCHMARK "benchmark-*")
    evenlift_fetch(
      benchmark https://github.com/google/benchmark.git d572f4777349d43653b21d6c2fc63020ab326db2) # v1.7.1
    foreach(part TESTING GTEST_TESTS INSTALL WERROR)
      set(BENCHMARK_ENABLE_${part} OFF CACHE BOOL "" FORCE)
    endforeach()
    add_subdirectory("${benchmark_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/benchmark" EXCLUDE_FROM_ALL)
  endif()
endif()
