// The reader's language. The code contains each English text where it is used, and this text is the
// key to its translation. So one file for each language (assets/words) translates the whole page;
// without it, texts are in English. In a pattern, names in braces stand for values, so that a
// translation can change their order.
#pragma once

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>

namespace evenlift {

// Adds or replaces the translation of an English text or pattern. Call it for all texts before any
// is used, since sentences already returned do not change. Not thread-safe. O(log n).
void add_translation(std::string english, std::string translated);

// Removes all translations, so texts are in English again. Results of translated() become invalid.
void forget_translations();

// The translation of a text, or the text itself if it has no translation. A translation stays valid
// until it is replaced or forgotten, the text itself as long as the argument. O(log n).
std::string_view translated(std::string_view english);

// A value in a sentence: a text, which is also translated, or a whole number. It does not own its
// text, so it must not outlive the call for which it is made.
class Value {
 public:
  Value(const char* text);
  Value(std::string_view text);
  Value(const std::string& text);
  template <std::unsigned_integral Number>
  requires(sizeof(Number) <= sizeof(std::size_t)) Value(Number number) : size_(number) {}

  std::string written() const;

 private:
  // Values are kept small, since the page has a thousand of them.
  const char* text_ = nullptr;  // null for a number
  std::size_t size_;            // the length of the text, or the number
};

// The pattern in the reader's language with the values in their places. Each new {name} of the
// English pattern takes the next value; a repeated name takes the same value again: "Robot {robot}
// carries {load}." with 3 and "16.7 kg" becomes "Robot 3 carries 16.7 kg."
// O(bytes of pattern and values).
std::string say(std::string_view english, std::initializer_list<Value> values = {});

// The same as say(), with `number` values that are texts and are not translated.
std::string say_written(std::string_view english, const std::string* values, std::size_t number);

}  // namespace evenlift
