// The reader's language. English words and sentences are written where they are said, and are the
// keys by which they are found in the language of the reader: so the whole page is translated by one
// file (assets/words). Without such a file all is English. What a number stands for is named in
// braces, so that a translation may change the order.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace evenlift {

// From now on the English text or pattern reads like this. Called for all words before anything is
// said, since a sentence that was said stays as it is. Not for use by several threads. O(log n).
void add_translation(std::string english, std::string translated);

// English again. Results of translated() end.
void forget_translations();

// The text in the reader's language, and the text itself if it was not translated. The result lives
// as long as the program, or as the argument. O(log n).
std::string_view translated(std::string_view english);

// What is put into a sentence: a text, which is translated as well, or a whole number. It does not
// own its text, so it must not outlive the call for which it is made.
class Value {
 public:
  Value(const char* text) : text_(text) {}
  Value(std::string_view text) : text_(text) {}
  Value(const std::string& text) : text_(text) {}
  template <std::unsigned_integral Number>
  Value(Number number) : number_(number), is_text_(false) {}

  std::string written() const;

 private:
  std::string_view text_;
  std::uint64_t number_ = 0;
  bool is_text_ = true;
};

// The pattern in the reader's language with the values in their places. Each {name} of the English
// pattern takes the next value; a name that comes again takes its value again.
// "Robot {robot} carries {load}." with 3 and "16.7 kg". O(bytes of pattern and values).
std::string say(std::string_view english, std::initializer_list<Value> values = {});

// The same for values that are already written.
std::string say_written(std::string_view english, const std::string* values, std::size_t number);

}  // namespace evenlift
