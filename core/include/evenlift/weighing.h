// The weight and the centre of mass from what the supports read.
//
// Supports at places p_i, not all on one line, carry the object and read f_i >= 0, without tare.
// Moments balance, so W is the sum of the f_i, and C = sum f_i p_i / W. This presumes that the
// lifting points are in a level plane and that readings are vertical; stiffness, bending, and forces
// in that plane do not matter.
//
// Each reading may be off by d_i. Then W is off by at most the sum of the d_i, and C by at most
// E = max over unit vectors v of sum d_i |v . (p_i - C)| / (W - sum d_i), which needs sum d_i < W.
//
// If m > 3 supports that carry are equally stiff and on even ground, the readings are an affine
// function of their places, and r = P f is 0, with P as in uncertainty.h. Errors of readings make it
// at most sum_j |P_ij| d_j in size.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

// Whether the readings give the weight and the centre of mass: with the method `given`, if there are
// readings. O(1).
bool is_weighed(const Settings& settings);

struct Weighing {
  double weight = 0;        // W, of the object with its cargo
  double weight_error = 0;  // how far W may be off, if each reading is off by at most its error
  Vec2 centre;              // C, of the object with its cargo
  double radius = 0;        // E
  // What follows if equally stiff supports stand on even ground. The vectors have an entry for each
  // support, and are empty if fewer than four supports read more than 0, or if those are on one line
  // within tau. Entries of supports that read 0 are 0.
  std::vector<double> residuals;  // r
  std::vector<double> slack;      // sum_j |P_ij| d_j: the size that errors of readings explain
  std::vector<double> spread;     // sum_j |P_ij|
  std::vector<double> own_part;   // P_ii
  // The height of C from a second weighing on a slope; empty without one. With u the unit vector
  // uphill, C moves by h tan(slope) downhill, so h = (C - C') . u / tan(slope).
  struct Height {
    double height = 0;
    double error = 0;  // (E + E') / tan(slope), with E' as E for the second readings
    // Whether these add up to W, or to W cos(slope), within the errors of both weighings.
    bool fits = true;
  };
  std::optional<Height> height;
};

// Weighs with these supports, the lifting points of the supports of `settings` in their order, on an
// object of diameter L. The errors name the setting: as many readings as supports; at least three
// supports that are not on one line within tau L; a sum of readings, less their errors, above 0 and
// above the weight of the cargo; C inside the supports' hull by more than tau L; second readings
// with their slope and direction. O(m log m), and O(m^2) if more than three supports carry.
Result<Weighing> weigh(const Points& supports, const Settings& settings, double diameter);

// What the readings say about the supports, within the errors of readings and, if both are given,
// heights that are off by up to `uneven` at supports that give way by `give` under the mean load.
struct ReadingsFit {
  bool fit = true;
  // The support whose wrong reading would explain most: that with the greatest |r_i| / sqrt(P_ii),
  // if there is only one and at least five supports carry.
  std::optional<std::size_t> suspect;
  // By how much each support reads too little if its reading alone is wrong: -r_i / P_ii; negative
  // if too much. 0 if its reading alone explains nothing. Empty if the readings fit.
  std::vector<double> too_little;
};
// O(m).
ReadingsFit fit_of(const Weighing& weighing, const Carrying& carrying);

// The C uncertainty that the weighing leaves, E + accuracy + height * level_error: robots that are off
// their places by up to the accuracy shift C by up to that much, and a slope shifts it by the height
// of C times the slope. O(1).
double radius_of(const Weighing& weighing, const Settings& settings, double height);

// What the weighing tells about C in place of what is given, unless that is greater: the height h of C
// up to `height + error`, the C uncertainty radius_of(), and as the uncertainty of the weight the part
// of it that the readings may be off in all. O(size of shown).
Shown as_weighed(const Weighing& weighing, const Settings& settings, Shown shown);

// The document in which the weight, the centre of mass, its uncertainty and its height are what the
// weighing found, and which has no readings: any method may place robots next. O(document).
Document taken_over(Document document, const Weighing& weighing);

// After an edit, readings no longer apply if robots were added or removed, places are no longer given,
// cargo changed, or the weight or C is given now. Then this returns the edited document with what
// they told taken over, except what the edit gives; otherwise nothing. `before` is the weighed
// document. O(document).
std::optional<Document> settled_after_edit(const Document& edited, const Document& before,
                                           const Weighing& weighing);

// The weight and the centre of mass of the object alone, without the cargo of `settings`. The
// weighing's weight must be more than that of the cargo. O(items).
struct OwnMass {
  double weight = 0;
  Vec2 centre;
};
OwnMass own_mass(const Weighing& weighing, const Settings& settings);

}  // namespace evenlift
