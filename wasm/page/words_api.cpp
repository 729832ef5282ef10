// The reader's language, for the page and its modules (web/page/language.js).
#include <emscripten/emscripten.h>

#include "evenlift/wording.h"

extern "C" {

// From now on the English text or pattern reads like this.
EMSCRIPTEN_KEEPALIVE void words_translate(const char* english, const char* translated) {
  evenlift::add_translation(english, translated);
}
}
