// Requests and answers as JSON, as far as the package needs them.
#pragma once

#include <string>
#include <string_view>

namespace evenlift {

// The answer to a request, one JSON text that ends in a newline. The request is an object:
//   command           "place", the usual one, "candidates", "svg", "link" or "version"
//   polygon or text   [[x, y], ...], or a text that read_polygon() (formats.h) or decode_link() (link.h) reads
//   centre_of_mass    [x, y], or null for the centroid
//   settings          an object of settings (settings_text.h), each a number or a word
//   candidates        whether `place` lists them and `svg` shows them
//   failures          whether `place` tells what happens if one robot fails
// What `place` answers is what `evenlift place --json` prints, byte for byte. A request that cannot be answered gets
// {"error": {"code", "message", "place"}}. Any bytes are a request, if a bad one; more than max_text_bytes are
// refused. The cost is that of what is asked for, and O(bytes).
std::string answer(std::string_view request);

}  // namespace evenlift
