// What a step shows, as shapes with a meaning.
#include <algorithm>

#include "evenlift/tolerance.h"
#include "evenlift/trace.h"

namespace evenlift {
namespace {

constexpr std::string_view kind_names[] = {
    "object",     "triangle",      "centroid",    "centre",
    "vertex",     "radial_edge",   "ray",         "chord",
    "edge",       "section",       "reflected",   "section_end",
    "bisecting",  "chosen",        "candidate",   "team",
    "robot",      "gain_triangle", "gain_part",   "gain_circle",
    "arm_before", "arm_after",     "base_before", "base",
    "contact",    "normal",        "clockwise",   "counterclockwise",
    "translation"};

class Scene {
 public:
  Scene(const Trace& trace, const StepDetail& detail) : trace_(trace), detail_(detail) {}

  std::vector<Figure> make() && {
    const std::uint32_t item = detail_.step.item;
    switch (detail_.step.kind) {
      case StepKind::polygon:
        object();
        break;
      case StepKind::centroid:
        triangles();
        break;
      case StepKind::centre:
        centroid();
        break;
      case StepKind::radial:
        for (const std::uint32_t edge : trace_.radial_edges)
          whole_edge(FigureKind::radial_edge, edge);
        break;
      case StepKind::ray:
        ray(item);
        break;
      case StepKind::slopes:
        for (const std::uint32_t chord : chords_by_slope(trace_)) vertex_chord(chord);
        break;
      case StepKind::sections:
      case StepKind::outcome:
        pair(*detail_.pair, detail_.step.kind == StepKind::outcome);
        break;
      case StepKind::opposite:
        opposite(*detail_.opposite);
        break;
      case StepKind::duplicates:
      case StepKind::candidates:
        candidates(no_index);
        break;
      case StepKind::scores:
        base(FigureKind::base_before, detail_.base_before);
        candidates(item);
        break;
      case StepKind::team:
        base(FigureKind::base_before, detail_.base_before);
        if (detail_.scores && item > 0) {
          const std::uint32_t winner = trace_.placement.team_candidates[item];
          for (Figure& f : gain_figures(trace_, *detail_.scores, winner))
            out_.push_back(std::move(f));
        }
        team(item, false);
        break;
      case StepKind::base:
        base(FigureKind::base_before, detail_.base_before);
        base(FigureKind::base, detail_.base);
        team(item, false);
        break;
      case StepKind::share:
        team(item, true);
        break;
      case StepKind::loads:
        teams();
        break;
      case StepKind::coverage:
        object();
        base(FigureKind::base, trace_.placement.lifting_base);
        break;
      case StepKind::contacts:
      case StepKind::cut:
        regions(detail_.clockwise, detail_.counterclockwise);
        contacts();
        break;
      case StepKind::slide:
        slide();
        break;
      case StepKind::closure:
      case StepKind::second_order:
        final_regions();
        contacts();
        break;
      case StepKind::result:
        object();
        base(FigureKind::base, trace_.placement.lifting_base);
        final_regions();
        teams();
        break;
      case StepKind::directions:
      case StepKind::fewer:
        break;
    }
    add(FigureKind::centre, {trace_.centre});
    return std::move(out_);
  }

 private:
  void add(FigureKind kind, Points points, std::uint32_t item = no_index, double value = 0) {
    if (!points.empty()) out_.push_back({kind, std::move(points), item, value});
  }
  void chord(FigureKind kind, const Chord& chord, std::uint32_t item, double value) {
    add(kind, {chord.r1.position, chord.r2.position}, item, value);
  }

  void object() { add(FigureKind::object, trace_.polygon.vertices()); }
  void centroid() { add(FigureKind::centroid, {trace_.polygon.centroid()}); }

  // A fan from vertex 1; those that fold back are subtracted.
  void triangles() {
    const Points& v = trace_.polygon.vertices();
    const double whole = (trace_.polygon.counter_clockwise() ? 2 : -2) * trace_.polygon.area();
    for (std::size_t i = 1; i + 1 < v.size(); ++i)
      add(FigureKind::triangle, {v[0], v[i], v[i + 1]}, static_cast<std::uint32_t>(i),
          cross(v[i] - v[0], v[i + 1] - v[0]) / whole);
    centroid();
  }

  void whole_edge(FigureKind kind, std::uint32_t edge) {
    add(kind, {trace_.polygon.edge_start(edge), trace_.polygon.edge_end(edge)}, edge);
  }

  void vertex_chord(std::uint32_t index) {
    const Chord& c = trace_.rays.chords[index].chord;
    chord(FigureKind::chord, c, index, c.ratio);
  }

  void ray(std::uint32_t index) {
    const std::uint32_t vertex = trace_.rays.vertices[index];
    const Vec2 &from = trace_.polygon.vertex(vertex), away = trace_.centre - from;
    add(FigureKind::ray, {from, trace_.centre + trace_.polygon.diagonal() / length(away) * away},
        vertex);
    for (std::uint32_t i = trace_.rays.begins[index]; i < trace_.rays.begins[index + 1]; ++i)
      vertex_chord(i);
    add(FigureKind::vertex, {from}, vertex);
  }

  void pair(const PairDetail& pair, bool decided) {
    whole_edge(FigureKind::edge, pair.pair.a);
    whole_edge(FigureKind::edge, pair.pair.b);
    add(FigureKind::section, {pair.a[0], pair.a[1]}, pair.pair.a);
    add(FigureKind::section, {pair.b[0], pair.b[1]}, pair.pair.b);
    if (decided) add(FigureKind::reflected, {pair.reflected[0], pair.reflected[1]}, pair.pair.b);
    for (std::uint32_t end = 0; end < 2; ++end)
      chord(FigureKind::section_end, pair.ends[end], end, pair.ends[end].ratio);
    if (!decided) return;
    if (pair.meeting)
      add(FigureKind::bisecting, {*pair.meeting, 2 * trace_.centre - *pair.meeting}, no_index, 1);
    chord(FigureKind::chosen, pair.chosen, pair.candidate, pair.chosen.ratio);
  }

  void opposite(const OppositeDetail& opposite) {
    chord(FigureKind::chosen, opposite.chord, opposite.candidate, opposite.chord.ratio);
    for (const std::uint32_t vertex : {opposite.vertices.v, opposite.vertices.w})
      add(FigureKind::vertex, {trace_.polygon.vertex(vertex)}, vertex);
  }

  // All of them with their ratios, or those left for a team with their scores.
  void candidates(std::uint32_t for_team) {
    const std::vector<Candidate>& all = trace_.placement.candidates;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      if (for_team == no_index) {
        chord(FigureKind::candidate, all[i].chord, i, all[i].chord.ratio);
      } else if (const Score& score = detail_.scores->of_candidate[i]; !score.taken) {
        chord(FigureKind::candidate, all[i].chord, i, score.value);
      }
    }
  }

  void base(FigureKind kind, const Points& corners) { add(kind, corners); }

  void team(std::uint32_t index, bool loaded) {
    const Team& team = trace_.placement.teams[index];
    chord(FigureKind::team, team.chord, index, team.chord.ratio);
    add(FigureKind::robot, {team.chord.r1.position}, 2 * index, loaded ? team.loads[0] : 0);
    add(FigureKind::robot, {team.chord.r2.position}, 2 * index + 1, loaded ? team.loads[1] : 0);
  }
  void teams() {
    for (std::uint32_t i = 0; i < trace_.placement.teams.size(); ++i) team(i, true);
  }

  void regions(const FreeRegion& clockwise, const FreeRegion& counterclockwise) {
    add(FigureKind::clockwise, clockwise.clipped);
    add(FigureKind::counterclockwise, counterclockwise.clipped);
  }
  void final_regions() {
    regions(trace_.placement.closure.clockwise, trace_.placement.closure.counterclockwise);
  }

  // All contacts; of a cut those up to its own, with its normal line.
  void contacts() {
    const bool cut = detail_.step.kind == StepKind::cut;
    const std::uint32_t last = detail_.step.item;
    for (std::uint32_t i = 0; i < trace_.contacts.size() && !(cut && i > last); ++i) {
      const Contact& contact = trace_.contacts[i];
      if (cut && i == last) {
        whole_edge(FigureKind::edge, contact.edge);
        const Vec2 reach =
            100 * trace_.polygon.diagonal() * inward_normal(trace_.polygon, contact.edge);
        add(FigureKind::normal, {contact.position - reach, contact.position + reach}, i);
      }
      add(FigureKind::contact, {contact.position}, i);
    }
  }

  void slide() {
    contacts();
    if (const auto& way = trace_.placement.closure.translation)
      add(FigureKind::translation,
          {trace_.centre, trace_.centre + 0.25 * trace_.polygon.diagonal() * *way});
  }

  const Trace& trace_;
  const StepDetail& detail_;
  std::vector<Figure> out_;
};

}  // namespace

std::string_view name(FigureKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

std::vector<Figure> figures(const Trace& trace, const StepDetail& detail) {
  return Scene(trace, detail).make();
}

// The sweep turns from the direction of the x axis to the left; slopes run from the vertical, which
// is last, to it. So the order is that of the sweep, begun after the vertical.
std::vector<std::uint32_t> chords_by_slope(const Trace& trace) {
  std::vector<std::uint32_t> falling, others;
  for (std::uint32_t i = 0; i < trace.rays.vertices.size(); ++i) {
    const std::uint32_t vertex = trace.rays.vertices[i];
    const Vec2 u = trace.polygon.vertex(vertex) - trace.centre;
    const bool falls = u.x() * u.y() < 0 && !is_vertical(u);
    for (std::uint32_t c = trace.rays.begins[i]; c < trace.rays.begins[i + 1]; ++c) {
      // Listed at an earlier ray already?
      const VertexChord& chord = trace.rays.chords[c];
      if (chord.vertex == vertex) (falls ? falling : others).push_back(c);
    }
  }
  falling.insert(falling.end(), others.begin(), others.end());
  return falling;
}

}  // namespace evenlift
