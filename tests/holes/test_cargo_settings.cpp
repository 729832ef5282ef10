// Cargo as text: read, refused, and written as it is read.
#include <string>

#include "document/setting_values.h"
#include "evenlift/settings.h"
#include "kit/catch.h"

using namespace evenlift;

namespace {

std::vector<Cargo> read(const std::string& text) {
  std::vector<Cargo> cargo;
  REQUIRE(read_cargo(text, cargo));
  return cargo;
}

}  // namespace

TEST_CASE("cargo is read as it is written", "[settings][cargo]") {
  const std::vector<Cargo> cargo = {{Vec2(8, 8), 24, ""},
                                    {Vec2(-0.5, 1e9), 1e-3, "motor"},
                                    {Vec2(0, 0), 3, "a \"big\" box"},
                                    {Vec2(4, 4), 1, "5\"pipe"},
                                    {Vec2(1, 2), 1, "Küche:1"}};
  const std::string text = cargo_text(cargo);
  CHECK(text ==
        "8,8:24 -0.5,1000000000:0.001:motor 0,0:3:\"a \"\"big\"\" box\" 4,4:1:\"5\"\"pipe\" "
        "1,2:1:Küche:1");
  CHECK(read(text) == cargo);
  CHECK(read("\t8,8:24\n 1,2:3:\"\"") ==
        std::vector<Cargo>{{Vec2(8, 8), 24, ""}, {Vec2(1, 2), 3, ""}});
  CHECK(cargo_text({}) == "none");
  CHECK(read("none").empty());
}

TEST_CASE("what is no cargo is refused, and changes nothing", "[settings][cargo]") {
  const std::string long_name(61, 'x'), too_many = [] {
    std::string text;
    for (int i = 0; i < 1001; ++i) text += "0,0:1 ";
    return text;
  }();
  for (const std::string& text :
       {std::string(), std::string(" "), std::string("8,8"), std::string("8:24"),
        std::string("8,8:0"), std::string("8,8:-1"), std::string("8,8:nan"), std::string("2e9,8:1"),
        std::string("8,8:24:"), std::string("8,8:24:a\"b"), std::string("8,8:24:\"a"),
        std::string("8,8:24:\"a\"b\""), std::string("8,8:24:\"a\nb\""), std::string("8,8:24:\xff"),
        "8,8:24:" + long_name, too_many, std::string("none 8,8:24"), std::string("8,8:1e101")}) {
    std::vector<Cargo> cargo = {{Vec2(1, 1), 1, "kept"}};
    CAPTURE(text);
    CHECK_FALSE(read_cargo(text, cargo));
    CHECK(cargo.size() == 1);
  }
  Document document;
  const auto error = read_setting(Setting::cargo, "8,8:24 9,9", document);
  REQUIRE(error);
  CHECK(error->message.ends_with(", not \"9,9\""));
}
