#include "tests/hard/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nicol::hard {
namespace {

double share_of(double error, double bound) {
  if (std::isnan(error)) return INFINITY;
  if (error <= 0) return 0;
  return bound > 0 ? error / bound : INFINITY;
}

// The bound of one precision: that of the way that used most of it.
double bound_of(const Row& row, int first) {
  double share = -1, bound = -1;
  for (int way = first; way < first + ways / 2; ++way) {
    if (row.bound[way] < 0 || share_of(row.error[way], row.bound[way]) <= share) continue;
    share = share_of(row.error[way], row.bound[way]);
    bound = row.bound[way];
  }
  return bound;
}

std::string number(double value) { return value < 0 ? "" : value == 0 ? "0" : fmt::format("{:.1e}", value); }

}  // namespace

bool Row::kept() const {
  for (int way = 0; way < ways; ++way)
    if (bound[way] >= 0 && !(share_of(error[way], bound[way]) <= 1)) return false;
  return true;
}

void Table::hold(int way, const std::string& name, const std::string& quantity, const std::string& reason, double bound,
                 double error) {
  const auto same = [&](const Row& row) { return row.name == name && row.quantity == quantity; };
  auto at = std::find_if(rows_.begin(), rows_.end(), same);
  if (at == rows_.end()) {
    at = rows_.emplace(rows_.end());
    at->name = name;
    at->quantity = quantity;
    at->reason = reason;
  }
  if (at->bound[way] >= 0 && share_of(error, bound) <= share_of(at->error[way], at->bound[way])) return;
  at->error[way] = std::isnan(error) ? INFINITY : std::max(0.0, error);
  at->bound[way] = bound;
}

std::string Table::text() const {
  std::size_t name_width = 4, quantity_width = 8;
  for (const Row& row : rows_) {
    name_width = std::max(name_width, row.name.size());
    quantity_width = std::max(quantity_width, row.quantity.size());
  }
  std::string out = fmt::format("{:{}} {:{}} {:>7} {:>7} {:>35} {:>37}\n", "", name_width, "", quantity_width,
      "bound", "bound",
                                "error in float:  1 lane     8 lanes", "error in double:  1 lane     8 lanes");
  out += fmt::format("{:{}} {:{}} {:>7} {:>7} ", "case", name_width, "quantity", quantity_width, "float", "double");
  for (int way = 0; way < ways; ++way)
    out += fmt::format("{:>{}}", way % 2 ? "special" : "generic", way == ways / 2 ? 11 : 9);
  out += "  where the bound comes from\n";
  std::string last;
  for (const Row& row : rows_) {
    out += fmt::format("{:{}} {:{}} {:>7} {:>7} ", row.name == last ? "" : row.name, name_width, row.quantity,
        quantity_width,
                       number(bound_of(row, 0)), number(bound_of(row, ways / 2)));
    for (int way = 0; way < ways; ++way)
      out += fmt::format("{:>{}}", row.bound[way] < 0 ? "-" : number(row.error[way]), way == ways / 2 ? 11 : 9);
    out += fmt::format("  {}{}\n", row.kept() ? "" : "BROKEN: ", row.reason);
    last = row.name;
  }
  return out;
}

bool Table::kept() const {
  return std::all_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.kept(); });
}

std::size_t Table::cells() const {
  std::size_t count = 0;
  for (const Row& row : rows_)
    for (int way = 0; way < ways; ++way) count += row.bound[way] >= 0;
  return count;
}

std::size_t Table::broken() const {
  return static_cast<std::size_t>(std::count_if(rows_.begin(), rows_.end(),
      [](const Row& row) { return !row.kept(); }));
}

double Table::largest_share() const {
  double largest = 0;
  for (const Row& row : rows_)
    for (int way = 0; way < ways; ++way)
      if (row.bound[way] >= 0) largest = std::max(largest, share_of(row.error[way], row.bound[way]));
  return largest;
}

}  // namespace nicol::hard
