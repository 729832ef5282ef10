// The loads of springs against a library's singular values: of all forces in equilibrium, those of
// equal springs that all push are the shortest.
#include <Eigen/SVD>
#include <algorithm>

#include "evenlift/load_models.h"
#include "kit/catch.h"
#include "robustness/robot_sets.h"

using namespace evenlift;

TEST_CASE("springs that all push share the weight as singular values say", "[robustness][models]") {
  constexpr int most = 6;
  int compared = 0;
  for (std::uint64_t number = 0; number < 3000; ++number) {
    const robot_sets::RobotSet set = robot_sets::make_set(number, most);
    const auto m = static_cast<Eigen::Index>(set.robots.size());
    Eigen::MatrixXd balance(3, m);  // of the weight, and of the moments about C in units of L
    for (Eigen::Index i = 0; i < m; ++i) {
      const Vec2 arm = (set.robots[static_cast<std::size_t>(i)] - set.centre) / set.diameter;
      balance.col(i) << 1, arm.x, arm.y;
    }
    Eigen::JacobiSVD<Eigen::MatrixXd> svd(balance, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const double least = svd.singularValues().minCoeff();
    if (least > 1e-12 && least < 1e-4) continue;  // whether it is 0 is a question of tolerance
    svd.setThreshold(1e-9);
    const Eigen::VectorXd shortest = svd.solve(Eigen::Vector3d(1, 0, 0));
    if ((balance * shortest - Eigen::Vector3d(1, 0, 0)).norm() > 1e-9) continue;  // it tips
    if (shortest.minCoeff() < 1e-6) continue;                                     // one would pull
    const auto loads = spring_loads(set.robots, set.centre, set.diameter, 1);
    INFO(number << ", " << set.kind << ", " << m << " robots");
    REQUIRE(loads);
    for (Eigen::Index i = 0; i < m; ++i)
      CHECK(std::abs(loads->loads[static_cast<std::size_t>(i)] - shortest(i)) < 1e-9);
    ++compared;
  }
  CHECK(compared > 500);
}
