// The picture's colours, and its sizes in CSS pixels at the picture's natural size.
#pragma once

#include <string_view>

namespace evenlift::svg {

inline constexpr double largest_width = 720, largest_height = 520;    // of the object
inline constexpr double smallest_width = 680, smallest_height = 300;  // of the ground around it
inline constexpr double margin = 72;          // width of ground around the object; loads fit there
inline constexpr double caption_margin = 24;  // width of the panel around the caption

inline constexpr std::string_view ground_colour = "#EEF1F4";
inline constexpr std::string_view panel_colour = "#FFFFFF";
inline constexpr std::string_view line_colour = "#D5DBE1";
inline constexpr std::string_view text_colour = "#1B232B";
inline constexpr std::string_view second_text_colour = "#55616D";
inline constexpr std::string_view object_colour = "#FFFFFF";
inline constexpr std::string_view outline_colour = "#2B3540";
inline constexpr std::string_view hull_colour = "#2FA36B";
inline constexpr std::string_view hull_outline_colour = "#1F7A4E";
inline constexpr std::string_view clockwise_colour = "#D1495B";
inline constexpr std::string_view counterclockwise_colour = "#2D6CDF";
inline constexpr std::string_view chord_colour = "#55616D";
inline constexpr std::string_view overload_colour = "#9A5B00";
inline constexpr std::string_view unusable_colour = "#8592A0";
inline constexpr std::string_view no_go_colour = "#9A5B00";
inline constexpr std::string_view slide_colour = "#9A5B00";
inline constexpr std::string_view body_colour = "#1B232B";
inline constexpr std::string_view cargo_colour = "#55616D";
inline constexpr std::string_view candidate_colour = "#66727E";

}  // namespace evenlift::svg
