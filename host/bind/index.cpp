// index { }: the refractive index as a formula or a table; and the sampling of formulas at the
// scene's wavelengths, with an error that names the wavelengths where a formula has no value.
#include <cmath>

#include "host/bind/parts.hpp"
#include "host/bind/plugin_values.hpp"

namespace nicol {

std::vector<std::pair<double, double>> table_points(Context& context, const Args& args) {
  std::vector<double> numbers = args.numbers;
  if (args.block) {
    const Schema list{
        "table", {{"", "N", [&](const Args& a) { numbers = a.numbers; }, "pairs"}}, {}};
    read_block(context, *args.block, list);
  }
  std::vector<std::pair<double, double>> points;
  if (numbers.size() % 2 || numbers.empty()) {
    context.error(args.where, "a table is a list of pairs (wavelength in nm, value), " +
                                  std::to_string(numbers.size()) + " numbers found instead");
    return points;
  }
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    if (!points.empty() && numbers[i] <= points.back().first) {
      context.error(args.where, "the wavelengths of a table must ascend; " + to_text(numbers[i]) +
                                    " comes after " + to_text(points.back().first));
      return {};
    }
    points.emplace_back(numbers[i], numbers[i + 1]);
  }
  return points;
}

Samples sample(Context& context, Location where, const std::string& what,
               const std::function<double(double)>& value_at_nm) {
  Samples samples;
  std::vector<double> without;
  for (double lambda_nm : context.scene.lambda_nm) {
    samples.push_back(value_at_nm(lambda_nm));
    if (!std::isfinite(samples.back())) without.push_back(lambda_nm);
  }
  if (!without.empty())
    context.error(where, what + " has no value at " + to_text(without.front()) + " nm" +
                             (without.size() > 1 ? " and " + std::to_string(without.size() - 1) +
                                                       " more of the scene's wavelengths"
                                                 : ""));
  return samples;
}

Samples sample_index(Context& context, const IndexFormula& formula, Location where,
                     const std::string& what) {
  const std::string wrong = check(formula);
  if (!wrong.empty()) {
    context.error(where, what + ": " + wrong);
    return Samples(context.scene.lambda_nm.size(), 1.0);
  }
  return sample(context, where, what,
                [&](double lambda_nm) { return refractive_index(formula, lambda_nm); });
}

Schema index_schema(Context& context, const char* name, IndexFormula& formula) {
  using Kind = IndexFormula::Kind;
  Context* c = &context;
  IndexFormula* f = &formula;
  const auto set = [f](Kind kind) {
    return [f, kind](const Args& a) {
      *f = {};
      f->kind = kind;
      f->coefficients = a.numbers;
    };
  };
  const auto set_table = [=](const Args& a) {
    *f = {};
    f->kind = Kind::table;
    f->points = table_points(*c, a);
  };
  return {
      name,
      {{"constant", "n", set(Kind::constant), "n"},
       {"cauchy", "N", set(Kind::cauchy), "A, B, C, ...: n = A + B/l^2 + C/l^4 + ... (l in um)"},
       {"sellmeier", "N", set(Kind::sellmeier),
        "B1, C1, B2, C2, ...: n^2 = 1 + sum B l^2/(l^2 - C), C in um^2"},
       {"formula", "nN",
        [=](const Args& a) {
          *f = {};
          f->kind = Kind::numbered;
          f->number = static_cast<int>(a.numbers[0]);
          if (f->number != a.numbers[0]) f->number = 0;
          f->coefficients.assign(a.numbers.begin() + 1, a.numbers.end());
        },
        "K, c1, c2, ...: formula 1..9 of refractiveindex.info"},
       {"table", "{}", set_table, "nm, n, nm, n, ..."},
       {"table", "N", set_table, "the same without braces"},
       {"mean", "",
        [=](const Args&) {
          *f = {};
          f->kind = Kind::mean;
        },
        "arithmetic mean of the `index { }` blocks that follow"},
       {"plugin", "{}",
        [=](const Args& a) {
          const auto index = plugin_index(*c, *a.block);
          *f = {};
          f->kind = Kind::constant;
          f->coefficients = {index && !index->n.empty() ? index->n[0].second : 1.0};
          if (!index || index->n.size() < 2) return;
          f->kind = Kind::table;
          f->points = index->n;
        },
        "`\"NAME\" parameter value ...`: a formula that a plugin brings"},
       {"index", "{}",
        [=](const Args& a) {
          IndexFormula part;
          bind_index(*c, "index", *a.block, part);
          if (f->kind == Kind::mean) f->parts.push_back(part);
          else *f = part;
        },
        "a declared index, or a part of a mean"}},
      {}};
}

void bind_index(Context& context, const char* name, const sdl::Block& block,
                IndexFormula& formula) {
  formula = {};
  const std::size_t errors_before = context.error_count();
  read_block(context, block, index_schema(context, name, formula));
  if (formula.kind == IndexFormula::Kind::constant && formula.coefficients.empty() &&
      context.error_count() == errors_before)
    context.error(block.where, std::string("Expected a formula or table in '") + name + "'");
}

}  // namespace nicol
