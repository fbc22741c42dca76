// What a hard case must keep, and what it does: one row for each quantity, one column for each way of computing it.
#pragma once
#include <array>
#include <string>
#include <vector>

namespace nicol::hard {

constexpr int ways = 8;  // float, double x 1, 8 lanes x generic, specialised

struct Row {
  std::string name, quantity, reason;
  // The error that took the largest share of its bound, and that bound; bound < 0: not asked.
  std::array<double, ways> error{}, bound;
  Row() { bound.fill(-1); }
  bool kept() const;
};

class Table {
 public:
  // error: not-a-number breaks every bound. reason: where the bound comes from.
  void hold(int way, const std::string& name, const std::string& quantity, const std::string& reason, double bound,
            double error);
  // Rows as text, and what they come to.
  std::string text() const;
  bool kept() const;
  std::size_t cells() const;
  std::size_t broken() const;
  double largest_share() const;
  const std::vector<Row>& rows() const { return rows_; }

 private:
  std::vector<Row> rows_;
};

}  // namespace nicol::hard
