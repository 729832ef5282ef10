#include "shapes/small_polygons.h"

namespace small_polygons {
namespace {

using oracle::Point;
using oracle::Problem;
using Points = std::vector<Point>;

const Points square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
const Points u_shape{{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
const Points cross_shape{{-1, -3}, {1, -3}, {1, -1}, {3, -1}, {3, 1},   {1, 1},
                         {1, 3},   {-1, 3}, {-1, 1}, {-3, 1}, {-3, -1}, {-1, -1}};
const Points arrow{{0, 0}, {4, 6}, {0, 4}, {-4, 6}};
const Points thesis_sample{{539, 220}, {403, 115}, {386, 219}, {278, 306}, {149, 187}, {263, 124},
                           {88, 101},  {82, 320},  {133, 437}, {546, 446}, {665, 426}};

Points moved(Points p, double dx, double dy) {
  for (Point& q : p) q = {q[0] + dx, q[1] + dy};
  return p;
}
Points scaled(Points p, double kx, double ky) {
  for (Point& q : p) q = {q[0] * kx, q[1] * ky};
  return p;
}

}  // namespace

std::vector<Case> hand_made() {
  const auto at = [](Points v, double x, double y, double min_ratio = 0.5, int teams = 4) {
    Problem p;
    p.vertices = std::move(v);
    p.centre_of_mass = Point{x, y};
    p.min_ratio = min_ratio;
    p.teams = teams;
    return p;
  };
  const auto about_centroid = [](Points v, double min_ratio = 0.5, int teams = 4) {
    Problem p;
    p.vertices = std::move(v);
    p.min_ratio = min_ratio;
    p.teams = teams;
    return p;
  };
  std::vector<Case> cases{
      {"square", about_centroid(square)},
      {"square, everything even enough", about_centroid(square, 0)},
      {"square off centre", at(square, 0.75, 1)},
      {"square off both axes", at(square, 0.75, 1.25, 0)},
      {"thesis sample", at(thesis_sample, 278, 227, 0.8, 3)},
      {"thesis sample about its centroid", about_centroid(thesis_sample, 0.8, 3)},
      {"U about its centroid", about_centroid(u_shape)},
      {"U, C at a reflex vertex", at(u_shape, 2, 2)},
      {"U, C on an edge", at(u_shape, 3, 2)},
      {"U, C at mid height of the notch, outside", at(u_shape, 3, 3)},
      {"U, C in line with an inner edge, outside", at(u_shape, 2.5, 2.5, 0)},
      {"U, C in line with two edges", at(u_shape, 1, 2)},
      {"U, C a hair from an edge's line, closer than the tolerance", at(u_shape, 3, 2 + 1e-12)},
      {"U, C a hair from an edge's line, farther than the tolerance", at(u_shape, 3, 2 + 1e-7)},
      {"U, C a hair from a vertex", at(u_shape, 2 + 1e-13, 2 - 1e-13)},
      {"cross", about_centroid(cross_shape)},
      {"cross, C at a reflex vertex", at(cross_shape, 1, 1)},
      {"cross, C in line with edges", at(cross_shape, 1, 0)},
      {"cross, C outside", at(cross_shape, 1.5, 1.5, 0)},
      {"arrow, C outside", at(arrow, 0, 5)},
      {"arrow, C at the notch", at(arrow, 0, 4)},
      {"arrow, no pair is even", at(arrow, 0.25, 4.75, 0)},
      {"nearly parallel by less than the tolerance",
       at({{-3, -1}, {3, -1 - 1e-11}, {3, 1}, {-3, 1}}, 0, 0)},
      {"nearly parallel by more than the tolerance",
       at({{-3, -1}, {3, -1 - 1e-7}, {3, 1}, {-3, 1}}, 0, 0)},
      {"nearly parallel, uneven", at({{-3, -1}, {3, -1 - 1e-11}, {3, 1}, {-3, 1}}, 0, 0.25, 0)},
      {"needle", at({{0, 0}, {1000, 1}, {2000, 0}, {1000, -1e-3}}, 1000, 0.25)},
      {"sliver triangle", about_centroid({{0, 0}, {1, 1e-8}, {1e-3, 1e-8}}, 0)},
      {"very flat rectangle", about_centroid({{0, 0}, {1e6, 0}, {1e6, 1e-3}, {0, 1e-3}})},
      {"square far from the origin", about_centroid(moved(square, 999999990, -999999990))},
      {"thesis sample far from the origin",
       at(moved(thesis_sample, 9e8, -9e8), 9e8 + 278, -9e8 + 227, 0.8, 3)},
      {"tiny cross", about_centroid(scaled(cross_shape, 1e-9, 1e-9))},
      {"cross with unlike axes", about_centroid(scaled(cross_shape, 1e6, 1e-2))},
      {"straight vertices on every side",
       about_centroid(
           {{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 1}, {4, 2}, {4, 4}, {3, 4}, {0, 4}, {0, 2}})},
      {"straight vertex opposite a vertex", about_centroid({{0, 0}, {2, 0}, {4, 0}, {2, 6}}, 0)},
      {"two chords of one vertex",
       at({{-6, 0}, {6, -2}, {6, 2}, {3, 0.5}, {6, 6}, {-5, 6}}, 0, 0.25, 0, 5)},
      {"vertical bisecting chords",
       at({{-2, -4}, {2, -4}, {3, 0}, {2, 4}, {-2, 4}, {-1, 0}}, 0.5, 0, 0, 6)},
      {"vertical but for rounding", about_centroid({{0.1, 0.1}, {0.7, 0.1}, {0.4, 0.9}}, 0, 6)},
      {"two chords of one vertex whose lengths and arms tie",
       at({{-8.4742969541260528e-09, 1.929011929175881e-09},
           {9.9999999901857457, -6.8999136253853478e-09},
           {9.9999999962582251, 5.9999999906369688},
           {8.9999999950836536, 5.9999999973117264},
           {7.9999999973747045, 6.0000000006018617},
           {8.0000000033518273, 9.9999999968775004},
           {2.0000000037683168, 9.999999997747743},
           {1.9999999967011253, 8.0000000061424874},
           {2.0000000041412553, 6.0000000019437856},
           {6.8981258521322735e-09, 6.0000000095628749}},
          2.4837316980879702, 9.3953353773900368, 0, 3)},
      {"the tip of a lifting base 10^-8 as thin as long",
       at({{9.4979018249369584, -1.4510527348816019e-07},
           {8.3641702165600833, -2.5418484020286635e-07},
           {8.3269381257811688, -2.5680051661570009e-07},
           {1.2225210727588758, -4.6028311918276629e-07},
           {-9.3873228251839524, -1.5983419809377592e-07},
           {-9.9042243521347277, -6.4031711953621123e-08},
           {-9.9988427823092287, -7.0551280443183896e-09},
           {-9.8703603302716978, 7.443321266609099e-08},
           {-7.9156161024373475, 2.8339988102414314e-07},
           {-3.6914083308246832, 4.3100787523810008e-07},
           {9.958471751445364, 4.2221181710075369e-08}},
          5, 0, 0.8, 3)},
      {"the tip of a thin lifting base with eight teams",
       at({{-3.6772602966953278, -3.4952785192561296e-07},
           {-4, 1.9999999999999999e-07},
           {-1, 3.9999999999999998e-07},
           {3.6772602966953278, 3.4952785192561296e-07},
           {4, -1.9999999999999999e-07},
           {1, -3.9999999999999998e-07}},
          0.66538757067077481, -2.6615502826830993e-07, 0.5, 8)},
      {"one team only", about_centroid(square, 0.5, 1)},
      {"no candidate", at(arrow, 0.25, 4.75, 1)},
  };
  std::vector<Case> all;
  for (const Case& c : cases) {
    for (oracle::Metric metric :
         {oracle::Metric::area, oracle::Metric::circle, oracle::Metric::distance}) {
      all.push_back(c);
      all.back().problem.metric = metric;
    }
  }
  return all;
}

}  // namespace small_polygons
