// Close pairs among many boxes: sorted along the axis on which they spread most, and swept.
#pragma once
#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "parts.hpp"

namespace nicol::solids {

inline int sweep_axis(const std::vector<Bounds>& boxes) {
  std::array<double, 3> spread{};
  for (int k = 0; k < 3; ++k) {
    double mean = 0, square = 0;
    for (const Bounds& b : boxes)
      mean += (b.low[k] + b.high[k]) / 2 / static_cast<double>(boxes.size());
    for (const Bounds& b : boxes) {
      const double off = (b.low[k] + b.high[k]) / 2 - mean;
      square += off * off;
    }
    spread[k] = square;
  }
  return static_cast<int>(std::max_element(spread.begin(), spread.end()) - spread.begin());
}

// Every two boxes (i < j) that come as close as `margin`, in order.
inline std::vector<std::pair<int, int>> close_pairs(const std::vector<Bounds>& boxes,
                                                    double margin) {
  std::vector<std::pair<int, int>> pairs;
  if (boxes.empty()) return pairs;
  const int axis = sweep_axis(boxes);
  std::vector<int> order(boxes.size()), active;
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::make_pair(boxes[a].low[axis], a) < std::make_pair(boxes[b].low[axis], b);
  });
  const auto apart = [&](int a, int b, int k) {
    return boxes[a].high[k] + margin < boxes[b].low[k] ||
           boxes[b].high[k] + margin < boxes[a].low[k];
  };
  for (int box : order) {
    std::size_t kept = 0;
    for (int other : active) {
      if (apart(other, box, axis)) continue;
      active[kept++] = other;
      if (!apart(other, box, (axis + 1) % 3) && !apart(other, box, (axis + 2) % 3)) {
        pairs.push_back(std::minmax(other, box));
      }
    }
    active.resize(kept);
    active.push_back(box);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace nicol::solids
