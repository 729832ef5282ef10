#include "robustness/simplex.h"

#include <cstddef>

namespace simplex {
namespace {

// Rows with right sides in the last column; each row's basic variable has its own column. The last
// row holds the reduced costs and their negated value.
class Tableau {
 public:
  Tableau(std::vector<Row> rows, std::vector<std::size_t> basis)
      : rows_(std::move(rows)), basis_(std::move(basis)) {}

  Exact minimize(const Row& cost) {
    rows_.push_back(cost);
    rows_.back().resize(rows_.front().size(), 0);
    for (std::size_t i = 0; i < basis_.size(); ++i) eliminate(rows_.size() - 1, i, basis_[i]);
    while (const std::optional<std::size_t> column = entering()) pivot(*leaving(*column), *column);
    Exact value = -rows_.back().back();
    rows_.pop_back();
    return value;
  }

  // Removes the variables from `first` on. Basic ones among them are 0.
  void forbid(std::size_t first) {
    for (std::size_t i = basis_.size(); i-- > 0;) {
      if (basis_[i] < first) continue;
      std::size_t column = 0;
      while (column < first && rows_[i][column] == 0) ++column;
      if (column < first) {
        pivot(i, column);
      } else {  // the row follows from the others
        rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(i));
        basis_.erase(basis_.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
    for (Row& row : rows_)
      row.erase(row.begin() + static_cast<std::ptrdiff_t>(first), row.end() - 1);
  }

 private:
  std::optional<std::size_t> entering() const {
    for (std::size_t j = 0; j + 1 < rows_.back().size(); ++j)
      if (rows_.back()[j] < 0) return j;
    return std::nullopt;
  }

  std::optional<std::size_t> leaving(std::size_t column) const {
    std::optional<std::size_t> best;
    Exact least;
    for (std::size_t i = 0; i < basis_.size(); ++i) {
      if (rows_[i][column] <= 0) continue;
      const Exact ratio = rows_[i].back() / rows_[i][column];
      if (best && (ratio > least || (ratio == least && basis_[i] > basis_[*best]))) continue;
      best = i;
      least = ratio;
    }
    return best;
  }

  void eliminate(std::size_t from, std::size_t by, std::size_t column) {
    const Exact factor = rows_[from][column];
    if (factor == 0) return;
    for (std::size_t j = 0; j < rows_[from].size(); ++j) rows_[from][j] -= factor * rows_[by][j];
  }

  void pivot(std::size_t i, std::size_t column) {
    const Exact divisor = rows_[i][column];
    for (Exact& value : rows_[i]) value /= divisor;
    for (std::size_t other = 0; other < rows_.size(); ++other)
      if (other != i) eliminate(other, i, column);
    basis_[i] = column;
  }

  std::vector<Row> rows_;
  std::vector<std::size_t> basis_;
};

}  // namespace

std::optional<Exact> least(const std::vector<Row>& rows, const Row& right, const Row& cost) {
  const std::size_t variables = cost.size();
  // First with another variable for each row; these must vanish.
  std::vector<Row> extended;
  std::vector<std::size_t> basis;
  Row missing(variables, 0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row row = rows[i];
    row.resize(variables + rows.size(), 0);
    row.push_back(right[i]);
    if (right[i] < 0)
      for (Exact& value : row) value = -value;
    row[variables + i] = 1;
    extended.push_back(row);
    basis.push_back(variables + i);
    missing.push_back(1);
  }
  Tableau tableau(std::move(extended), std::move(basis));
  if (tableau.minimize(missing) != 0) return std::nullopt;
  tableau.forbid(variables);
  return tableau.minimize(cost);
}

}  // namespace simplex
