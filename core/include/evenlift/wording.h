// The reader's language. The code contains each English text where the text is used, and the
// English text is the key to its translation. So one file for each language (assets/words)
// translates the whole page; without this file, texts are in English. In a pattern, names in braces
// stand for values, so that a translation can change the order of the values.
#pragma once

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace evenlift {

// Adds or replaces the translation of an English text or pattern. Add all translations before you
// use any text, since sentences already returned do not change. Not thread-safe. O(log n) for n
// translations.
void add_translation(std::string english, std::string translated);

// Removes all translations, so texts are in English again. Translations that translated() returned
// become invalid.
void forget_translations();

// The translation of a text, or the text itself if it has no translation. A returned translation is
// valid until it is replaced or forgotten; the text itself is valid as long as the argument is.
// O(log n).
std::string_view translated(std::string_view english);

// A number that is written with a point, as the reader writes it: with the translation of "." in its
// place, which is one character of ASCII. O(bytes).
std::string as_read(std::string number);

// The y of a place as texts write it: that of evenlift's coordinates, or, once y points down in texts, the
// negative of it, as in the user's file. JSON, links and settings are never affected. Not thread-safe. O(1).
void write_y_down();
double written_y(double y);

// While one exists, translated() returns each text itself, for texts that users typed: a weight
// that is named "area" keeps its name in every language. Not thread-safe.
class AsTyped {
 public:
  AsTyped();
  ~AsTyped();
  AsTyped(const AsTyped&) = delete;
  AsTyped& operator=(const AsTyped&) = delete;
};

// A value in a sentence: a whole number or a text, which is also translated. A Value does not own
// its text, so use it only in the call for which it is made.
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

// Returns the pattern in the reader's language, with the values in their places. Each new {name} of
// the English pattern takes the next value; a repeated name takes the same value again. For
// example, "Robot {robot} carries {load}." with 3 and "16.7 kg" becomes "Robot 3 carries 16.7 kg."
// O(bytes of pattern and values).
std::string say(std::string_view english, std::initializer_list<Value> values = {});

// Works like say(), but the values are an array of `number` texts, which are not translated.
std::string say_written(std::string_view english, const std::string* values, std::size_t number);

// "a", "a and b", "a, b and c": the items, which are not translated. O(bytes).
std::string listed(const std::vector<std::string>& items);

}  // namespace evenlift
