// The captions of the steps.
#pragma once

#include <cstdint>
#include <string>

#include "evenlift/trace.h"
#include "output/trace_words/trace_text.h"
#include "trace/step_rows.h"

namespace evenlift {

// Each step's row in step_words.cpp selects a caption.
class StepCaptions : LookedAtStep {
 public:
  StepCaptions(const Trace& trace, const StepDetail& detail) : LookedAtStep(trace, detail) {}

  std::string polygon() const;
  std::string centroid() const;
  std::string centre() const;
  std::string radial() const;
  std::string ray() const;
  std::string slopes() const;
  std::string sections() const;
  std::string sections_before_choice() const;
  std::string outcome() const;
  std::string opposite() const;
  std::string duplicates() const;
  std::string candidates() const;
  std::string directions() const;
  std::string scores() const;
  std::string team() const;
  std::string base() const;
  std::string fewer() const;
  std::string share() const;
  std::string loads() const;
  std::string coverage() const;
  std::string contacts() const;
  std::string cut() const;
  std::string slide() const;
  std::string closure() const;
  std::string second_order() const;
  std::string result() const;
  std::string lever() const;
  std::string three() const;
  std::string many() const;
  std::string rest() const;
  std::string mirror() const;
  std::string completion() const;
  std::string start() const;
  std::string exchange() const;
  std::string round() const;
  std::string settled() const;
  std::string failure() const;
  std::string failures() const;
  std::string pairs() const;
  std::string range() const;
  std::string swap() const;
  std::string held() const;
  std::string stands() const;
  std::string support() const;
  std::string equations() const;
  std::string by_lever() const;
  std::string by_areas() const;
  std::string by_springs() const;
  std::string extremes() const;
  std::string falls() const;
  std::string cargo() const;

 private:
  Piece load(double value) const;
  Piece ratio(double value) const;
  Piece least() const;
  Vec2 far_end(const Chord& chord, std::uint32_t vertex) const;
  std::string facing() const;
  std::string standing(const PairDetail& pair) const;
  std::string same_chord(std::uint32_t candidate) const;
  std::string sources() const;
  std::string ranking(const TeamScores& scores) const;
  static double neighbour(const TeamScores& scores, std::size_t i);
  std::string first_scores(const TeamScores& scores) const;
  std::string team_without_candidates() const;
  std::string moves_of_swap() const;
  std::string gain_of_swap() const;
  std::string own_centre() const;
  std::string with_all_cargo() const;
  std::string what_c_is() const;
  static std::string left(const char* sense, const FreeRegion& region, bool before);
};

}  // namespace evenlift
