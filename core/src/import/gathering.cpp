#include "import/gathering.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "evenlift/angles.h"
#include "evenlift/numbers.h"
#include "evenlift/predicates.h"
#include "evenlift/wording.h"
#include "formats/readers.h"
#include "import/joining/joining.h"
#include "import/projection/projection.h"
#include "numbers/number_text.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

// Nearer to the equator widths are right within 0.5 %.
constexpr double low_latitude = 5;

// Numbers beyond these are not degrees, whatever the text says.
bool can_be_degrees(const Box& box) {
  return box.low.x >= -360 && box.high.x <= 360 && box.low.y >= -90 && box.high.y <= 90;
}

// Names the factor at the middle latitude.
std::string degrees_note(std::string_view note, const Box& box) {
  const double latitude = (box.low.y + box.high.y) / 2;
  const Vec2 degree = degree_at(latitude);
  const double shrinking = degree.x / degree.y;
  if (std::abs(latitude) > low_latitude && shrinking > 1e-3)
    return say("{note}: at latitude {latitude} widths come out {factor} times too large",
               {note, short_number(latitude), short_number(1 / shrinking)});
  return std::string(note);
}

}  // namespace

void Gathering::add_notes(const RingNotes& notes) {
  if (notes.heights > 0) note("coordinates beyond x and y were left out");
  note_count(notes.repeated, "{count} vertex at the place of the one before it was left out",
             "{count} vertices at the place of the one before them were left out");
  if (!notes.are_degrees || import.shapes.empty()) return;
  const Box box = box_of(import.shapes);
  if (!can_be_degrees(box) || options_.project) return;
  import.in_degrees = true;
  note(degrees_note(notes.in_degrees, box));
}

Box box_of(const std::vector<ImportedShape>& shapes) {
  Points corners;
  for (const ImportedShape& shape : shapes) {
    if (shape.document.vertices.empty()) continue;
    const Box box = bounding_box(shape.document.vertices);
    corners.push_back(box.low);
    corners.push_back(box.high);
  }
  return bounding_box(corners);
}

namespace {

constexpr std::size_t longest_name = 80;  // in characters

double default_tolerance(double side) {
  // A shape without size has no curves: any tolerance above 0 will do.
  if (!(side > 0)) return 1;
  const Decimal decimal = shortest_decimal(side / 1000);
  std::uint64_t digits = decimal.digits;
  int exponent = decimal.exponent;
  for (; digits >= 10; digits /= 10) ++exponent;
  const char* round = digits >= 5 ? "5e" : digits >= 2 ? "2e" : "1e";
  return read_number(round + std::to_string(exponent)).value_or(side / 1000);
}

bool within_bounds(const Box& box) {
  const auto small = [](double x) { return std::abs(x) <= max_coordinate; };
  return small(box.low.x) && small(box.low.y) && small(box.high.x) && small(box.high.y);
}

// Minima and maxima ignore NaN, so bounds do not reveal it.
bool all_finite(const Outline& outline) {
  const auto finite = [](const CurvePiece& p) {
    return is_finite(p.end) && is_finite(p.first) && is_finite(p.second);
  };
  return is_finite(outline.start) &&
         std::all_of(outline.pieces.begin(), outline.pieces.end(), finite);
}

// Whether the outline runs from b back along the way from a, to c.
bool turns_back(const Vec2& a, const Vec2& b, const Vec2& c, double near) {
  const Vec2 way = b - a;
  const double size = length(way);
  if (!(size > near)) return false;
  const double on = dot(c - b, way) / size;
  // Rounding alone may part the ways; a narrow tooth is not a spike.
  return on < -near && std::abs(cross(way, c - b) / size) <= 1e-9 * near;
}

// Drops spikes of no width: ways out and back. Returns their number. O(n).
std::size_t drop_spikes(Points& ring, double near) {
  std::size_t dropped = 0;
  const auto is_same = [&](const Vec2& a, const Vec2& b) { return length(a - b) <= 1e-9 * near; };
  Points kept;
  for (const Vec2& next : ring) {
    kept.push_back(next);
    while (kept.size() >= 3 &&
           turns_back(kept[kept.size() - 3], kept[kept.size() - 2], kept.back(), near)) {
      kept.erase(kept.end() - 2);
      ++dropped;
      if (kept.size() >= 2 && is_same(kept[kept.size() - 2], kept.back())) kept.pop_back();
    }
  }
  // Around the first vertex: from either end of what is left.
  std::size_t low = 0, high = kept.size();
  while (high - low >= 3) {
    const Vec2 &first = kept[low], &last = kept[high - 1];
    const bool at_first = turns_back(last, first, kept[low + 1], near);
    if (!at_first && !turns_back(kept[high - 2], last, first, near)) break;
    ++dropped;
    low += at_first;
    high -= !at_first;
    if (is_same(kept[low], kept[high - 1])) --high;
  }
  if (dropped > 0)
    ring.assign(kept.begin() + static_cast<std::ptrdiff_t>(low),
                kept.begin() + static_cast<std::ptrdiff_t>(high));
  return dropped;
}

}  // namespace

double larger_side(const Box& box) { return std::max(box.size().x, box.size().y); }

std::string short_number(double value) {
  const Decimal decimal = shortest_decimal(value);
  std::uint64_t digits = decimal.digits;
  int exponent = decimal.exponent;
  for (; digits >= 100000; digits /= 10) ++exponent;
  if (digits >= 10000) {
    digits = (digits + 5) / 10;
    ++exponent;
  }
  const auto number = read_number((decimal.negative ? "-" : "") + std::to_string(digits) + "e" +
                                  std::to_string(exponent));
  return shortest(number.value_or(value));
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(translated(count == 1 ? one : many));
}

std::string in_quotes(std::string_view text) {
  const std::string written(text);
  return say_written("\"{text}\"", &written, 1);
}

std::string clean_name(std::string_view name) {
  std::string clean;
  std::size_t characters = 0;
  while (!name.empty() && characters < longest_name) {
    const std::size_t length = utf8_length(name);
    const bool plain = length > 1 || (length == 1 && name[0] > ' ' && name[0] != 0x7f);
    if (plain) {
      clean += name.substr(0, length);
      ++characters;
    } else if (!clean.empty() && clean.back() != ' ') {  // invalid bytes separate words
      clean += ' ';
      ++characters;
    }
    name.remove_prefix(std::max<std::size_t>(length, 1));
  }
  while (!clean.empty() && clean.back() == ' ') clean.pop_back();
  return clean;
}

void LeftOut::add(std::string_view one, std::string_view many, std::size_t count) {
  if (count == 0) return;
  for (Kind& kind : counts_) {
    if (kind.one != one) continue;
    kind.count += count;
    return;
  }
  // A text may contain any number of names.
  constexpr std::size_t most_names = 19;
  if (counts_.size() < most_names)
    counts_.push_back({std::string(one), std::string(many), count});
  else if (counts_.size() == most_names)
    counts_.push_back({"thing of another kind", "things of other kinds", count});
  else
    counts_.back().count += count;
}

std::string LeftOut::list() const {
  std::vector<std::string> items;
  for (const Kind& kind : counts_) items.push_back(counted(kind.count, kind.one, kind.many));
  return listed(items);
}

std::size_t LeftOut::total() const {
  std::size_t all = 0;
  for (const Kind& kind : counts_) all += kind.count;
  return all;
}

void LeftOut::remove(std::string_view one, std::size_t count) {
  for (Kind& kind : counts_)
    if (kind.one == one) kind.count -= std::min(count, kind.count);
  std::erase_if(counts_, [](const Kind& kind) { return kind.count == 0; });
}

bool Gathering::has_room(std::size_t vertices) {
  if (full_) return false;
  if (outlines_ == max_shapes)
    full_ = InputError{ErrorCode::unsupported, "the text has more than 10000 shapes"};
  else if (vertices > max_vertices - vertices_)
    full_ = InputError{ErrorCode::too_many_vertices,
                       "the shapes have more than 1048576 vertices together"};
  static_assert(max_shapes == 10000 && max_vertices == 1048576, "the messages name the numbers");
  return !full_;
}

struct Gathering::Flattened {
  ImportedShape shape;
  std::size_t part;
};

// nullopt if it is not a polygon or there is no room for it.
std::optional<ImportedShape> Gathering::flattened(const Outline& outline) {
  if (full_) return std::nullopt;
  const Box box = control_box(outline);
  if (!all_finite(outline) || !within_bounds(box)) {
    add_problem({ErrorCode::bad_coordinate, "a coordinate is beyond 1,000,000,000"});
    return std::nullopt;
  }
  const double side = larger_side(box);
  ImportedShape shape;
  double tolerance = 1;
  if (outline.curved()) {
    tolerance = options_.tolerance.value_or(default_tolerance(side));
    shape.tolerance = tolerance;
  }
  const std::size_t room = max_vertices - vertices_;
  std::optional<Points> points = flatten(outline, tolerance, room + 1);  // one more may close it
  if (!points) {
    const bool curved = outline.curved();
    full_ = InputError{
        ErrorCode::too_many_vertices,
        curved ? "the shapes have more than 1048576 vertices together; with a greater distance "
                 "between curves and edges they have fewer"
               : "the shapes have more than 1048576 vertices together"};
    return std::nullopt;
  }
  while (points->size() > 1 &&
         larger_side(bounding_box({points->front(), points->back()})) <= same_point * side)
    points->pop_back();
  spikes_ += drop_spikes(*points, same_point * side);
  if (points->size() < 3) {
    ++without_area_;
    return std::nullopt;
  }
  if (!has_room(points->size())) return std::nullopt;
  vertices_ += points->size();
  ++outlines_;
  shape.document.vertices = *std::move(points);
  return shape;
}

namespace {

void take_hole(ImportedShape& shape, ImportedShape& hole) {
  shape.document.holes.push_back(std::move(hole.document.vertices));
  if (hole.tolerance) shape.tolerance = std::max(shape.tolerance.value_or(0), *hole.tolerance);
}

}  // namespace

// A ring inside another of its path or polygon that runs the same way round changes nothing in the
// picture: whoever drew it meant a hole.
std::vector<OutlineWithHoles> Gathering::shapes_meant(const std::vector<const Points*>& rings,
                                                      Fill fill) {
  std::vector<OutlineWithHoles> shapes = filled_shapes(rings, fill);
  if (fill != Fill::nonzero) return shapes;
  std::vector<OutlineWithHoles> with_holes = filled_shapes(rings, Fill::even_odd);
  if (with_holes.size() >= shapes.size()) return shapes;
  same_way_ += shapes.size() - with_holes.size();
  return with_holes;
}

void Gathering::add_filled(const DrawnShape& drawn, std::vector<Flattened> rings) {
  std::vector<const Points*> points;
  for (const Flattened& ring : rings) points.push_back(&ring.shape.document.vertices);
  for (const OutlineWithHoles& filled : shapes_meant(points, drawn.fill)) {
    Flattened& outline = rings[filled.outline];
    for (const std::size_t hole : filled.holes) take_hole(outline.shape, rings[hole].shape);
    import.shapes.push_back(std::move(outline.shape));
    drawn_.push_back({true, drawn.white, paths_, outline.part, drawn.copy});
  }
}

void Gathering::add(const DrawnShape& drawn) {
  ++paths_;
  std::vector<Flattened> rings;
  for (std::size_t i = 0; i < drawn.parts.size(); ++i) {
    std::optional<ImportedShape> shape = flattened(drawn.parts[i]);
    if (!shape) continue;
    shape->name = clean_name(drawn.name);
    shape->kind = drawn.kind;
    rings.push_back({*std::move(shape), i + 1});
  }
  if (drawn.fill != Fill::none) return add_filled(drawn, std::move(rings));
  for (Flattened& ring : rings) {
    import.shapes.push_back(std::move(ring.shape));
    drawn_.push_back({false, false, paths_, ring.part, drawn.copy});
  }
}

namespace {

std::string point_in_words(const Vec2& p) {
  return "(" + short_number(p.x) + ", " + short_number(written_y(p.y) + 0.0) + ")";
}

bool is_line(const DrawnPiece& piece) {
  return piece.outline.pieces.size() == 1 && !piece.outline.curved();
}

// Names the first two lines that cross; empty if none do. Among the first few only, as all pairs are
// compared.
std::string crossing_in_words(const std::vector<DrawnPiece>& pieces) {
  const std::size_t count = std::min<std::size_t>(pieces.size(), 500);
  const auto parts = [](const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const double one = orient(a, b, c), other = orient(a, b, d);
    return (one > 0 && other < 0) || (one < 0 && other > 0);
  };
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count && is_line(pieces[i]); ++j) {
      if (!is_line(pieces[j])) continue;
      const Vec2 &a = pieces[i].outline.start, b = pieces[i].outline.end(),
                 &c = pieces[j].outline.start, d = pieces[j].outline.end();
      if (parts(a, b, c, d) && parts(c, d, a, b))
        return say("the line from {a} to {b} crosses that from {c} to {d}",
                   {point_in_words(a), point_in_words(b), point_in_words(c), point_in_words(d)});
    }
  return {};
}

}  // namespace

void Gathering::add_joined(const std::vector<DrawnPiece>& pieces, bool closes_alone) {
  if (pieces.empty() || full_) return;
  Joining joining = join(pieces, options_.join);
  for (const JoinedOutline& joined : joining.outlines)
    add({{joined.outline},
         joined.name,
         joined.parts == 1 ? "closed line" : say("{parts} lines and arcs, joined", {joined.parts}),
         Fill::none,
         false,
         joined.copy});
  if (closes_alone) {
    // An open line without a fill encloses nothing, unless the drawing has nothing else.
    const bool has_closed = !import.shapes.empty() || !drawn_.empty() ||
                            std::any_of(joining.alone.begin(), joining.alone.end(),
                                        [&](std::size_t piece) { return pieces[piece].filled; });
    std::vector<std::size_t> closed;
    for (const std::size_t piece : joining.alone) {
      const DrawnPiece& alone = pieces[piece];
      if (has_closed && !alone.filled) continue;
      closed.push_back(piece);
      if (alone.outline.pieces.size() > 1 || alone.outline.curved())
        add({{alone.outline},
             alone.layer,
             "open path, closed by a straight edge",
             alone.filled ? Fill::nonzero : Fill::none});
    }
    std::vector<std::size_t> open;
    std::set_difference(joining.open.begin(), joining.open.end(), closed.begin(), closed.end(),
                        std::back_inserter(open));
    joining.open = std::move(open);
  }
  if (joining.outlines.empty() && !joining.apart) gap_ = crossing_in_words(pieces);
  left_open_ = joining.greatest_open;
  for (const std::size_t piece : joining.open) keep_open(pieces[piece].outline);
  note_joining(joining);
}

void Gathering::keep_open(const Outline& line) {
  const Box box = control_box(line);
  if (!all_finite(line) || !within_bounds(box)) return;
  const auto points =
      flatten(line, default_tolerance(larger_side(box)), most_open_points - open_points_);
  if (!points || points->size() < 2) return;
  open_points_ += points->size();
  import.left_open.push_back(*points);
}

void Gathering::note_joining(const Joining& joining) {
  if (joining.gap_is_seen)
    note(say("ends up to {distance} apart were joined", {short_number(joining.gap)}));
  if (std::any_of(joining.outlines.begin(), joining.outlines.end(),
                  [](const JoinedOutline& joined) { return joined.across_layers; }))
    note("lines on different layers were joined, since they do not close within their layers");
  note_count(joining.repeated, "{count} line that lies on another was left out",
             "{count} lines that lie on another were left out");
  const std::size_t open = joining.open.size();
  if (open == 0) return;
  if (joining.apart)
    gap_ = say("the nearest open ends, {first} and {second}, are {distance} apart",
               {point_in_words(joining.apart->first), point_in_words(joining.apart->second),
                short_number(length(joining.apart->second - joining.apart->first))});
  note(say(open == 1 ? "{count} line or arc does not close and was left out"
                     : "{count} lines and arcs do not close and were left out",
           {open}) +
       (gap_.empty() ? "" : ": " + gap_));
}

std::size_t Gathering::add_block(const std::string& name) {
  const auto [at, is_new] = numbers_of_blocks_.emplace(name, blocks_.size());
  if (is_new) blocks_.push_back(clean_name(name));
  return at->second;
}

std::size_t Gathering::add_copy(std::size_t block) {
  copies_.push_back(block);
  return copies_.size();
}

void Gathering::name_by_blocks(const Nesting& nesting) {
  const auto copy_of = [&](const OutlineWithHoles& part) { return drawn_[part.outline].copy; };
  const auto first = nesting.shapes.begin(),
             end = nesting.shapes.end() - static_cast<std::ptrdiff_t>(nesting.sheets);
  if (std::all_of(first, end,
                  [&](const OutlineWithHoles& part) { return copy_of(part) == copy_of(*first); }))
    return;
  for (auto part = first; part != end; ++part)
    if (const std::size_t copy = copy_of(*part); copy > 0)
      import.shapes[part->outline].name = block_of(copy);
}

void Gathering::name_parts(const std::vector<OutlineWithHoles>& shapes) {
  std::vector<std::size_t> shapes_of(paths_ + 1);
  for (const OutlineWithHoles& shape : shapes) ++shapes_of[drawn_[shape.outline].path];
  for (const OutlineWithHoles& shape : shapes) {
    const Drawn& drawn = drawn_[shape.outline];
    if (shapes_of[drawn.path] == 1) continue;
    std::string& name = import.shapes[shape.outline].name;
    name += (name.empty() ? "" : ", ") + say("part {number}", {drawn.part});
  }
}

namespace {

// Layers and names of sheets, as whole words.
constexpr WordList words_of_sheets =
    "frame border sheet titleblock title page paper canvas background rahmen zeichnungsrahmen blatt "
    "blattrahmen schriftfeld schriftkopf cadre cartouche feuille marco hoja cajetin cornice foglio "
    "cartiglio squadratura folha moldura kader blad ramka arkusz ram рамка лист 图框 図枠"_words;

bool names_sheet(std::string_view name) {
  std::string word;
  for (const char c : name) {
    if (is_letter(c) || static_cast<unsigned char>(c) >= 0x80) {
      word += lower_case(c);
    } else {
      if (words_of_sheets.has(word)) return true;
      word.clear();
    }
  }
  return words_of_sheets.has(word);
}

// As large as the page, within a hundredth.
bool is_of_size(const Points& outline, const std::optional<Vec2>& paper) {
  if (!paper) return false;
  const Vec2 size = bounding_box(outline).size();
  return std::abs(size.x - paper->x) <= paper->x / 100 &&
         std::abs(size.y - paper->y) <= paper->y / 100;
}

}  // namespace

void Gathering::nest_outlines() {
  // A name tells a sheet only from outlines of another name: a plate and its holes may all be on one
  // layer, whatever its name.
  const auto& all = import.shapes;
  const bool names_differ = std::any_of(all.begin(), all.end(), [&](const ImportedShape& shape) {
    return shape.name != all.front().name;
  });
  const auto block_number = [&](const Drawn& drawn) {
    return drawn.copy == 0 ? blocks_.size() : copies_[drawn.copy - 1];
  };
  const bool blocks_differ = std::any_of(drawn_.begin(), drawn_.end(), [&](const Drawn& drawn) {
    return block_number(drawn) != block_number(drawn_.front());
  });
  std::vector<ClosedOutline> outlines;
  for (std::size_t i = 0; i < import.shapes.size(); ++i) {
    const ImportedShape& shape = import.shapes[i];
    const Document& document = shape.document;
    const std::size_t copy = drawn_[i].copy;
    const bool is_named = (names_differ && names_sheet(shape.name)) ||
                          (blocks_differ && copy > 0 && names_sheet(block_of(copy)));
    outlines.push_back({&document.vertices, &document.holes, drawn_[i].filled,
                        drawn_[i].white || is_named, is_of_size(document.vertices, paper)});
  }
  const Nesting nesting = nest(outlines);
  name_by_blocks(nesting);
  name_parts(nesting.shapes);
  // Holes of sheets are shapes, too.
  std::vector<ImportedShape> sheets;
  for (std::size_t i = nesting.shapes.size() - nesting.sheets; i < nesting.shapes.size(); ++i) {
    const OutlineWithHoles& nested = nesting.shapes[i];
    sheets.push_back(std::move(import.shapes[nested.outline]));
    sheets.back().sheet = true;
    sheets.back().within = nested.within;
    for (const std::size_t hole : nested.holes) {
      const Points& ring = import.shapes[hole].document.vertices;
      vertices_ += ring.size();
      if (vertices_ <= max_vertices) sheets.back().document.holes.push_back(ring);
    }
  }
  std::vector<ImportedShape> shapes;
  for (std::size_t i = 0; i + nesting.sheets < nesting.shapes.size(); ++i) {
    const OutlineWithHoles& nested = nesting.shapes[i];
    shapes.push_back(std::move(import.shapes[nested.outline]));
    shapes.back().within = nested.within;
    for (const std::size_t hole : nested.holes) take_hole(shapes.back(), import.shapes[hole]);
  }
  for (ImportedShape& sheet : sheets) shapes.push_back(std::move(sheet));
  import.shapes = std::move(shapes);
  note_count(nesting.sheets,
             "{count} rectangle around all else was read as the sheet, and comes last",
             "{count} rectangles around all else were read as sheets, and come last");
  note_count(nesting.repeated, "{count} outline that repeats another was left out",
             "{count} outlines that repeat another were left out");
  if (options_.holes)
    note_count(nesting.holes, "{count} outline inside another was read as a hole",
               "{count} outlines inside others were read as holes");
  import.doubtful =
      left_open_ > 1.01 * bounding_box(import.shapes.front().document.vertices).area();
}

void Gathering::add(Document document, std::string_view name, std::string_view kind) {
  drop_closing_vertex(document.vertices);
  std::size_t vertices = document.vertices.size();
  for (Points& hole : document.holes) {
    drop_closing_vertex(hole);
    vertices += hole.size();
  }
  if (!has_room(vertices)) return;
  vertices_ += vertices;
  ++outlines_;
  import.shapes.push_back({std::move(document), clean_name(name), std::string(kind), {}});
}

void Gathering::add_text(const Vec2& at, std::string_view words, std::string_view kind) {
  constexpr std::size_t most_texts = 10000;
  std::string clean = clean_name(words);
  if (texts_.size() < most_texts && !clean.empty())
    texts_.push_back({at, std::move(clean), std::string(kind)});
}

namespace {

double distance(const Box& box, const Vec2& p) {
  return length(Vec2(std::max({box.low.x - p.x, p.x - box.high.x, 0.0}),
                     std::max({box.low.y - p.y, p.y - box.high.y, 0.0})));
}

// By the number of edges that a ray crosses; a text on an edge may be on either side. O(n).
bool is_around(const Points& ring, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

// The part to which a text belongs: the smallest one around it, or the nearest one that is not farther
// off than half its own size.
struct Labelled {
  std::size_t part;
  bool inside;
  double far;  // from the middle of the part, or from its box
};
std::optional<Labelled> labelled(const std::vector<ImportedShape>& shapes,
                                 const std::vector<Box>& boxes, const Vec2& at) {
  std::optional<Labelled> found;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes[i].sheet) continue;
    const double far = distance(boxes[i], at);
    const bool inside = far == 0 && is_around(shapes[i].document.vertices, at);
    if (!inside && 2 * far > larger_side(boxes[i])) continue;
    const bool better = !found || (inside && !found->inside) ||
                        (inside && boxes[i].area() < boxes[found->part].area()) ||
                        (!inside && !found->inside && far < found->far);
    if (better) found = Labelled{i, inside, far};
  }
  if (found && found->inside) found->far = length(at - boxes[found->part].middle());
  return found;
}

}  // namespace

// O(texts x shapes), plus O(n) for each part around a text.
void Gathering::name_by_texts() {
  std::vector<ImportedShape>& shapes = import.shapes;
  const auto parts = std::count_if(shapes.begin(), shapes.end(),
                                   [](const ImportedShape& shape) { return !shape.sheet; });
  if (parts < 2) return;
  std::vector<Box> boxes;
  for (const ImportedShape& shape : shapes) boxes.push_back(bounding_box(shape.document.vertices));
  std::vector<std::pair<const Text*, Labelled>> names(shapes.size(), {nullptr, {}});
  for (const Text& text : texts_) {
    const auto found = labelled(shapes, boxes, text.at);
    if (!found) continue;
    auto& [known, label] = names[found->part];
    const bool nearer = found->inside != label.inside ? found->inside : found->far < label.far;
    if (!known || nearer) {
      known = &text;
      label = *found;
    }
  }
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (!names[i].first) continue;
    shapes[i].name = names[i].first->words;
    left_out.remove(names[i].first->kind, 1);
  }
}

void Gathering::add_problem(InputError error) {
  ++problems_;
  if (!first_problem_) first_problem_ = std::move(error);
}

void Gathering::note(std::string_view sentence) {
  if (import.notes.size() < 20) import.notes.emplace_back(translated(sentence));
}

void Gathering::note_count(std::size_t count, std::string_view one, std::string_view many) {
  if (count > 0) note(say(count == 1 ? one : many, {count}));
}

// Cutters cut one hole where two of them touch or overlap.
void Gathering::unite_holes() {
  std::size_t united = 0;
  for (ImportedShape& shape : import.shapes) {
    if (shape.document.holes.size() < 2 || shape.document.holes.size() > max_holes) continue;
    Uniting uniting = unite_touching(shape.document.holes);
    united += uniting.united;
    shape.document.holes = std::move(uniting.rings);
  }
  if (united > 0 && options_.holes)
    note(say("{count} holes that touch or overlap were united", {united}));
}

Result<Import> Gathering::finish(InputError nothing) {
  if (full_) return *std::move(full_);
  if (import.shapes.empty()) {
    if (first_problem_) return *std::move(first_problem_);
    return nothing;
  }
  for (std::size_t i = 0; i < import.shapes.size(); ++i) import.shapes[i].order = i;
  if (!drawn_.empty()) nest_outlines();
  if (!texts_.empty()) name_by_texts();
  note_count(same_way_,
             "{count} ring that runs the same way round as the ring around it was "
             "read as a hole, although the file fills it",
             "{count} rings that run the same way round as the rings around them "
             "were read as holes, although the file fills them");
  unite_holes();
  if (!left_out.empty())
    note(say(left_out.total() == 1 ? "{things} was left out" : "{things} were left out",
             {left_out.list()}));
  note_count(spikes_, "{count} spike without a width was left out",
             "{count} spikes without a width were left out");
  note_count(without_area_, "{count} line without an area was left out",
             "{count} lines without an area were left out");
  if (problems_ > 0) {
    const std::string place = describe(first_problem_->place), &problem = first_problem_->message;
    const bool one = problems_ == 1;
    note(place.empty()
             ? say(one ? "{count} shape was left out, the first because of this: {problem}"
                       : "{count} shapes were left out, the first because of this: {problem}",
                   {problems_, problem})
             : say(one ? "{count} shape was left out, the first because of {place}: {problem}"
                       : "{count} shapes were left out, the first because of {place}: {problem}",
                   {problems_, place, problem}));
  }
  return std::move(import);
}

}  // namespace evenlift
