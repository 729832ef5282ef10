// A tree over candidates whose nodes know the greatest values below them.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace evenlift {

// Finds among m items the greatest value of those that pass a test. An item has several values, a
// struct `Values` whose default is the least and whose raise_to() keeps the greater of each. A leaf
// is a block of items, so that the tree is small beside them. values(i) returns the values of item
// i. A test must pass all values that are greater than passing ones.
template <class Values>
class MaxTree {
 public:
  using Index = std::uint32_t;

  explicit MaxTree(std::size_t items)
      : items_(items),
        leaves_(std::bit_ceil((items + block - 1) / block)),
        nodes_(2 * leaves_),
        is_stale_(leaves_, true) {
    for (Index leaf = 0; leaf < leaves_; ++leaf) stale_.push_back(leaf);
  }

  // Must be called when an item's values have changed. O(1).
  void touch(Index item) {
    const Index leaf = item / block;
    if (!is_stale_[leaf]) stale_.push_back(leaf);
    is_stale_[leaf] = true;
  }

  // Must be called after touch() and before a question. O(log m) per touched item, and O(m) at most.
  template <class Of>
  void update(const Of& values) {
    for (const Index leaf : stale_) {
      nodes_[leaves_ + leaf] = of_leaf(leaf, values);
      is_stale_[leaf] = false;
    }
    if (stale_.size() * std::bit_width(leaves_) > leaves_) {
      for (std::size_t node = leaves_ - 1; node > 0; --node) join_children(node);
    } else {
      for (const Index leaf : stale_)
        for (std::size_t node = (leaves_ + leaf) / 2; node > 0; node /= 2) join_children(node);
    }
    stale_.clear();
  }

  // The greatest of each value over all items. O(1).
  const Values& greatest() const { return nodes_[1]; }

  // The greatest value(v) over the items with passing values v, or minus infinity. Usually
  // O(log m); O(m) if many items beside each other pass different parts of the test.
  template <class Of, class Value, class Passes>
  double greatest(const Of& values, Value value, Passes passes) const {
    double greatest = -std::numeric_limits<double>::infinity();
    const auto look = [&](const Values& v) { return value(v) > greatest && passes(v); };
    const auto visit = [&](const auto& self, std::size_t node) -> void {
      if (!look(nodes_[node])) return;
      if (node >= leaves_) {
        for_items_of(node - leaves_, [&](Index i) {
          const Values v = values(i);
          if (look(v)) greatest = value(v);
        });
        return;
      }
      const bool right_first = value(nodes_[2 * node + 1]) > value(nodes_[2 * node]);
      self(self, 2 * node + right_first);
      self(self, 2 * node + !right_first);
    };
    visit(visit, 1);
    return greatest;
  }

  // Calls visit(i) for each item with passing values. The cost is that of greatest() for each.
  template <class Of, class Passes, class Visit>
  void for_each(const Of& values, Passes passes, Visit visit) const {
    const auto look = [&](const auto& self, std::size_t node) -> void {
      if (!passes(nodes_[node])) return;
      if (node >= leaves_) {
        for_items_of(node - leaves_, [&](Index i) {
          if (passes(values(i))) visit(i);
        });
        return;
      }
      self(self, 2 * node);
      self(self, 2 * node + 1);
    };
    look(look, 1);
  }

 private:
  static constexpr std::size_t block = 16;

  template <class Visit>
  void for_items_of(std::size_t leaf, Visit visit) const {
    const std::size_t end = std::min((leaf + 1) * block, items_);
    for (std::size_t i = leaf * block; i < end; ++i) visit(static_cast<Index>(i));
  }

  template <class Of>
  Values of_leaf(std::size_t leaf, const Of& values) const {
    Values greatest;
    for_items_of(leaf, [&](Index i) { greatest.raise_to(values(i)); });
    return greatest;
  }

  void join_children(std::size_t node) {
    nodes_[node] = nodes_[2 * node];
    nodes_[node].raise_to(nodes_[2 * node + 1]);
  }

  std::size_t items_, leaves_;
  std::vector<Values> nodes_;  // the root is node 1, the children of i are 2 i and 2 i + 1
  std::vector<bool> is_stale_;
  std::vector<Index> stale_;  // leaves
};

}  // namespace evenlift
