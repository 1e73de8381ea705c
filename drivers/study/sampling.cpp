// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "drivers/text/number_format.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

constexpr int digits_of_sample = 6;

void take(const StudyAxis& axis, const Level& level, Combination& combination) {
  combination.values.push_back({axis.name, level.name});
  combination.settings.insert(combination.settings.end(), level.settings.begin(), level.settings.end());
}

std::vector<Combination> product(const Study& study) {
  std::vector<Combination> all(1);
  for (const StudyAxis& axis : study.axes) {
    if (all.size() * axis.levels.size() > most_combinations) {
      throw InputError(axis.where, "axes", "more than " + std::to_string(most_combinations) + " cases");
    }
    std::vector<Combination> more;
    for (const Combination& before : all) {
      for (const Level& level : axis.levels) {
        more.push_back(before);
        take(axis, level, more.back());
      }
    }
    all = std::move(more);
  }
  return all;
}

std::vector<Combination> listed(const Study& study) {
  std::vector<Combination> all;
  for (const auto& values : study.listed) {
    all.emplace_back();
    for (const StudyAxis& axis : study.axes) {
      for (const auto& [name, value] : values) {
        if (name != axis.name) continue;
        const auto level = std::find_if(axis.levels.begin(), axis.levels.end(), [&, &text = value](const Level& each) {
          return same_value(each.name, flow_text(text));
        });
        take(axis, *level, all.back());
      }
    }
  }
  return all;
}

/// In [0,1), the same on every platform, which the distributions of the standard library are not.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

std::vector<std::size_t> shuffled(std::size_t count, std::mt19937_64& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

/// The value at a share of the way; of whole numbers the way ends where the next one would begin.
double value_at(const Span& span, double share) {
  const double end = span.to + (span.whole ? 1 : 0);
  return span.logarithmic ? span.from * std::pow(end / span.from, share) : span.from + (end - span.from) * share;
}

/// Rounded where that stays within the part of the span between two shares.
std::string sample_text(const Span& span, double share, double lower, double upper) {
  const double value = value_at(span, share);
  if (span.whole) return std::to_string(std::llround(std::clamp(std::floor(value), span.from, span.to)));
  const std::string text = rounded_text(value, digits_of_sample);
  const double rounded = parse_number(text).value_or(value);
  return value_at(span, lower) <= rounded && rounded < value_at(span, upper) ? text : number_text(value);
}

Level sampled(const StudyAxis& axis, const std::string& text) {
  Tree tree;
  tree.kind = Tree::Kind::scalar, tree.text = text, tree.where = axis.where;
  return {text, {{axis.name, std::move(tree), axis.where}}};
}

std::vector<Combination> hypercube(const Study& study) {
  const auto count = static_cast<std::size_t>(study.sampling.count);
  std::mt19937_64 random(static_cast<std::uint64_t>(study.sampling.seed));
  std::vector<Combination> all(count);
  for (const StudyAxis& axis : study.axes) {
    const std::vector<std::size_t> part = shuffled(count, random);
    for (std::size_t i = 0; i < count; ++i) {
      const auto lower = static_cast<double>(part[i]), cases = static_cast<double>(count);
      const double share = (lower + uniform(random)) / cases;
      if (axis.span) {
        take(axis, sampled(axis, sample_text(*axis.span, share, lower / cases, (lower + 1) / cases)), all[i]);
      } else {
        take(axis, axis.levels[part[i] * axis.levels.size() / count], all[i]);
      }
    }
  }
  return all;
}

}  // namespace

std::vector<Combination> combinations_of(const Study& study) {
  std::vector<Combination> all = study.sampling.type == Sampling::Type::product ? product(study)
                                 : study.sampling.type == Sampling::Type::list  ? listed(study)
                                                                                : hypercube(study);
  std::erase_if(all, [&](const Combination& each) {
    return std::any_of(study.excluded.begin(), study.excluded.end(),
                       [&](const Selection& excluded) { return excluded.holds(each.values); });
  });
  if (all.empty()) throw InputError({study.file, 0, 0}, "exclude", "leaves no case");
  return all;
}

}  // namespace assay::drivers
