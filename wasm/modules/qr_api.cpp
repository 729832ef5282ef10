// QR codes (web/windows/qr.js): a separate WebAssembly module, loaded on first use.
#include <emscripten/emscripten.h>
#include <qrcodegen.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "page/hand_over.h"

extern "C" {

// A line for each row of modules, with 1 for dark and 0 for light, without the quiet zone; empty if
// the text is too long. The generator chooses version, mask, and the strongest error correction
// that fits it.
EMSCRIPTEN_KEEPALIVE const char* qr_code(const char* text) {
  static std::array<std::uint8_t, qrcodegen_BUFFER_LEN_MAX> code, work;
  if (!qrcodegen_encodeText(text, work.data(), code.data(), qrcodegen_Ecc_LOW,
                            qrcodegen_VERSION_MIN, qrcodegen_VERSION_MAX, qrcodegen_Mask_AUTO,
                            true))
    return evenlift::view::hand_over({});
  const int size = qrcodegen_getSize(code.data());
  std::string rows;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) rows += qrcodegen_getModule(code.data(), x, y) ? '1' : '0';
    rows += '\n';
  }
  return evenlift::view::hand_over(std::move(rows));
}

}  // extern "C"
