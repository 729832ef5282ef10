// What Emscripten's JavaScript libraries would bring along although nothing here uses it: a main loop (the page asks
// for each frame by itself), full screen, pointer lock, decoders of pictures and sounds. EGL names these two parts of
// it; 5 KB of the page after compression.
mergeInto(LibraryManager.library, {
  $Browser__deps: [],
  $Browser__postset: '',
  $Browser: { moduleContextCreatedCallbacks: [] },
  emscripten_set_main_loop_timing__deps: [],
  emscripten_set_main_loop_timing: function(mode, value) {
    return 0;
  },
});
