// For robots with a size: the usable boundary, and what obstructs the rest.
#include <algorithm>

#include "evenlift/stands.h"
#include "trace/step_figures.h"
#include "trace/step_numbers.h"

namespace evenlift {
namespace {

double size_of(const Stretch& stretch) { return stretch.to - stretch.from; }

LiftingPoint contact_at(const Polygon& polygon, std::uint32_t edge, const Stretch& stretch) {
  const Vec2 &p = polygon.edge_start(edge), &q = polygon.edge_end(edge);
  return {p + (stretch.from + stretch.to) / 2 / length(q - p) * (q - p), edge};
}

// The middle of the longest usable range.
LiftingPoint roomiest(const Polygon& polygon, const Stands& stands) {
  std::uint32_t edge = 0;
  Stretch longest;
  for (std::uint32_t e = 0; e < polygon.size(); ++e)
    for (const Stretch& stretch : stands.room(e))
      if (size_of(stretch) > size_of(longest)) {
        longest = stretch;
        edge = e;
      }
  return contact_at(polygon, edge, longest);
}

}  // namespace

StandsDetail look_at_stands(const Trace& trace) {
  const Stands& stands = *trace.placement.stands;
  const std::vector<UnusablePart>& parts = stands.unusable();
  StandsDetail detail;
  for (std::uint32_t edge = 0; edge < trace.polygon().size(); ++edge) {
    detail.boundary += length(trace.polygon().edge_end(edge) - trace.polygon().edge_start(edge));
    for (const Stretch& stretch : stands.room(edge)) detail.usable += size_of(stretch);
  }
  std::array<std::uint32_t, why_unusable_count> longest;
  longest.fill(no_index);
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const auto why = static_cast<std::size_t>(parts[i].why);
    detail.lost[why] += size_of(parts[i].part);
    if (longest[why] == no_index || size_of(parts[i].part) > size_of(parts[longest[why]].part))
      longest[why] = i;
  }
  if (!stands.has_body()) return detail;
  detail.fits = roomiest(trace.polygon(), stands);
  for (const WhyUnusable why : {WhyUnusable::body, WhyUnusable::arm, WhyUnusable::corner,
                                WhyUnusable::hand, WhyUnusable::hole, WhyUnusable::near_no_go}) {
    const std::uint32_t part = longest[static_cast<std::size_t>(why)];
    if (part == no_index) continue;
    detail.misfits.push_back(
        {part, contact_at(trace.polygon(), parts[part].edge, parts[part].part)});
  }
  return detail;
}

void StepNumbers::stands() {
  const StandsDetail& stands = *detail_.stands;
  add("boundary", stands.boundary);
  add("usable", stands.usable / stands.boundary);
  for (std::size_t why = 0; why < why_unusable_count; ++why)
    if (stands.lost[why] > 0)
      add(name(static_cast<WhyUnusable>(why)), stands.lost[why] / stands.boundary);
}

void StepFigures::stands() {
  const std::vector<UnusablePart>& parts = placement_.stands->unusable();
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const Vec2 &p = trace_.polygon().edge_start(parts[i].edge),
               &q = trace_.polygon().edge_end(parts[i].edge);
    const Vec2 along = (q - p) / length(q - p);
    add(FigureKind::unusable, Points{p + parts[i].part.from * along, p + parts[i].part.to * along},
        i);
  }
  for (const auto& [part, contact] : detail_.stands->misfits) add_body(contact, part);
  if (detail_.stands->fits) add_body(*detail_.stands->fits, {});
}

void StepFigures::add_body(const LiftingPoint& contact, std::optional<std::uint32_t> part) {
  const RobotSize& robot = placement_.stands->robot();
  const LiftingPoint lifting = placement_.stands->lifting_point(contact);
  const Vec2 stand = placement_.stands->stand(lifting);
  const Vec2 &p = trace_.polygon().edge_start(contact.edge),
             &q = trace_.polygon().edge_end(contact.edge);
  const Vec2 aside = robot.width / 2 / length(q - p) * (q - p);
  if (robot.reach > 0) add(FigureKind::hand, Points{stand, contact.position}, part);
  if (robot.depth > 0 && robot.width > 0)
    add(FigureKind::hand,
        Points{contact.position - aside, contact.position + aside, lifting.position + aside,
               lifting.position - aside},
        part);
  else if (robot.depth > 0)
    add(FigureKind::hand, Points{contact.position, lifting.position}, part);
  else if (robot.width > 0)
    add(FigureKind::hand, Points{contact.position - aside, contact.position + aside}, part);
  if (robot.radius > 0) add(FigureKind::body, Points{stand}, part, robot.radius);
}

}  // namespace evenlift
