// Links to lessons: docs/link-format.md, "Lessons".
#include "evenlift/lesson_link.h"

#include <filesystem>
#include <string>
#include <vector>

#include "evenlift/random.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/data_table.h"
#include "kit/lessons.h"
#include "kit/link_checksum.h"
#include "link/lesson_primer.h"

using namespace evenlift;
using evenlift::testing::from_json_string;
using evenlift::testing::is_one_sentence;
using evenlift::testing::lessons_folder;
using evenlift::testing::link_characters;
using evenlift::testing::read_table;
using evenlift::testing::with_checksum;

namespace {

std::string encode(const std::string& lesson) {
  const Result<std::string> link = encode_lesson_link(lesson);
  REQUIRE(link.ok());
  return *link;
}

std::string decode(const std::string& link) {
  const Result<std::string> lesson = decode_lesson_link(link);
  INFO((lesson ? "" : lesson.error().message));
  REQUIRE(lesson.ok());
  return *lesson;
}

InputError refusal(const std::string& link) {
  const Result<std::string> lesson = decode_lesson_link(link);
  INFO(link.substr(0, 100));
  REQUIRE_FALSE(lesson.ok());
  CHECK(lesson.error().place.kind == Place::Kind::link);
  CHECK(is_one_sentence(lesson.error().message));
  return lesson.error();
}

std::vector<std::string> ready_made_texts() {
  std::vector<std::string> texts;
  for (const auto& file : std::filesystem::directory_iterator(lessons_folder()))
    if (file.path().extension() == ".txt") texts.push_back(corpus::read_file(file.path()));
  return texts;
}

std::string random_bytes(Rng& random, std::size_t length) {
  std::string bytes;
  while (bytes.size() < length) bytes += static_cast<char>(random.below(256));
  return bytes;
}

}  // namespace

TEST_CASE("a lesson comes back from its link byte for byte", "[lesson][link]") {
  std::vector<std::string> texts = ready_made_texts();
  CHECK(texts.size() > 30);
  texts.insert(texts.end(), {"", "a", std::string(3, '\0'), "title: Größe\r\n\xF0\x9F\xA4\x96\n",
                             std::string(max_lesson_bytes, 'x')});
  Rng random(7);
  for (int i = 0; i < 50; ++i) texts.push_back(random_bytes(random, random.below(400)));
  texts.push_back(random_bytes(random, max_lesson_bytes));
  for (const std::string& text : texts) CHECK(decode(encode(text)) == text);
}

TEST_CASE("a link to a lesson takes about half as many characters as the lesson has bytes",
          "[lesson][link]") {
  std::size_t bytes = 0, characters = 0;
  for (const std::string& text : ready_made_texts()) {
    bytes += text.size();
    characters += encode(text).size();
  }
  CHECK(static_cast<double>(characters) < 0.51 * static_cast<double>(bytes));
}

TEST_CASE("links to lessons that were published stay readable, and are written again alike",
          "[lesson][link]") {
  for (const auto& row : read_table("lesson_links.txt", 2)) {
    const auto text = from_json_string(row[1]);
    CHECK(decode(row[0]) == text);
    CHECK(encode(text) == row[0]);
  }
}

TEST_CASE("a link to a lesson is found in an address, after a document or alone, and among words",
          "[lesson][link]") {
  const std::string text = "title: A lesson\n", link = encode(text);
  for (const std::string& around :
       {link, "  " + link + "\n", "#" + link, "https://example.org/page/#" + link,
        "https://example.org/?number=7#2.abcd&" + link, "https://example.org/#" + link + "&utm=1",
        "<https://example.org/#" + link + ">.", "(https://example.org/#" + link + ")"}) {
    INFO(around);
    CHECK(has_lesson_link(around));
    CHECK(decode(around) == text);
  }
  for (const std::string& other :
       {std::string("2.abcd"), std::string("L-shape.txt"), std::string("Lesson 1. Levers"),
        std::string("my L1.txt"), std::string("")})
    CHECK_FALSE(has_lesson_link(other));
}

TEST_CASE(
    "a damaged link to a lesson is refused in one sentence, and one of a later version says so",
    "[lesson][link]") {
  const std::string link = encode(ready_made_texts().front());
  for (std::size_t at = 3; at < link.size(); at += 7) {
    std::string changed = link;
    changed[at] = changed[at] == 'A' ? 'B' : 'A';
    CHECK(refusal(changed).code == ErrorCode::bad_checksum);
    CHECK(refusal(link.substr(0, at)).code == ErrorCode::bad_checksum);
  }
  CHECK(refusal("L2." + link.substr(3)).code == ErrorCode::unknown_version);
  CHECK(refusal("2.abcd").code == ErrorCode::bad_link);
  CHECK(refusal("").code == ErrorCode::bad_link);
  CHECK(refusal("L1.ab%20cd").message.find("escaped") != std::string::npos);
  CHECK(refusal("L1." + std::string(max_link_bytes, 'A')).code == ErrorCode::text_too_long);
  CHECK(encode_lesson_link(std::string(max_lesson_bytes + 1, 'x')).error().code ==
        ErrorCode::text_too_long);
}

TEST_CASE("no payload makes a reader of lessons' links write more than a lesson has",
          "[lesson][link]") {
  Rng random(11);
  int read = 0;
  for (int i = 0; i < 300; ++i) {
    std::string payload = "L1.";
    for (std::uint64_t n = random.below(60); n > 0; --n)
      payload += link_characters[random.below(64)];
    const Result<std::string> lesson = decode_lesson_link(with_checksum(payload));
    if (!lesson) continue;
    ++read;
    CHECK(lesson->size() <= max_lesson_bytes);
    CHECK(decode(encode(*lesson)) == *lesson);
  }
  CHECK(read > 0);
}

TEST_CASE("the primer of lessons' links is the one in the documentation", "[lesson][link]") {
  const auto file =
      std::filesystem::path(EVENLIFT_TESTS_DIR).parent_path() / "docs" / "lesson-primer.txt";
  CHECK(corpus::read_file(file) == lesson_primer);
}
