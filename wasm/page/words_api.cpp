// Translations for the page (web/page/language.js).
#include <emscripten/emscripten.h>

#include "evenlift/wording.h"

extern "C" {

// `english` is a text or a pattern.
EMSCRIPTEN_KEEPALIVE void words_translate(const char* english, const char* translated) {
  evenlift::add_translation(english, translated);
}
}
