# Observable Plot, which ./dev installs from npm in web/charts, bundled by esbuild. Without either, the program and the
# page have a message in the charts' place.
include_guard()
find_program(EVENLIFT_ESBUILD esbuild DOC "Makes the page's scripts and styles small, and the report's charts")
set(EVENLIFT_CHARTS_DIR "${PROJECT_SOURCE_DIR}/web/charts")
set(EVENLIFT_CHARTS OFF)
if(EVENLIFT_ESBUILD AND EXISTS "${EVENLIFT_CHARTS_DIR}/node_modules/@observablehq/plot/package.json")
  set(EVENLIFT_CHARTS ON)
else()
  message(STATUS "No charts: they need esbuild, and `npm ci` in web/charts. ./dev build installs both")
endif()
set(EVENLIFT_CHARTS_LICENCE
    "/*! Charts by Observable Plot, (c) Observable, Inc., with D3, (c) Mike Bostock: ISC licence */")

# Bundles web/charts/<entry> with its imports.
function(evenlift_charts output entry format)
  file(GLOB sources CONFIGURE_DEPENDS "${EVENLIFT_CHARTS_DIR}/*.js")
  add_custom_command(
    OUTPUT "${output}"
    COMMAND "${EVENLIFT_ESBUILD}" "${EVENLIFT_CHARTS_DIR}/${entry}" --bundle --minify --format=${format} --charset=utf8
            --legal-comments=none "--banner:js=${EVENLIFT_CHARTS_LICENCE}" --log-level=warning "--outfile=${output}"
    DEPENDS ${sources} "${PROJECT_SOURCE_DIR}/web/words/words.js" "${EVENLIFT_CHARTS_DIR}/package-lock.json"
    VERBATIM)
endfunction()
