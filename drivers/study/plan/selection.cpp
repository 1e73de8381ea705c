// SPDX-License-Identifier: BSD-3-Clause
// Which cases a study samples, and which of them a selection means.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "drivers/format/yaml_values.hpp"
#include "drivers/format/yaml_writer.hpp"
#include "drivers/study/plan/study.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

bool fulfils(const Condition& condition, const std::string* value) {
  using Kind = Condition::Kind;
  const auto listed = [&] {
    return value &&
           std::ranges::any_of(condition.values, [&](const std::string& each) { return same_value(each, *value); });
  };
  if (condition.kind == Kind::one_of) return listed();
  if (condition.kind == Kind::none_of) return !listed();
  const auto number = value ? parse_number(*value) : std::nullopt;
  if (!number) return false;
  if (condition.kind == Kind::below) return *number < condition.upper;
  if (condition.kind == Kind::above) return *number > condition.lower;
  return condition.lower <= *number && *number <= condition.upper;
}

std::vector<std::string> values_of(const Tree& tree, const std::string& path) {
  if (tree.kind != Tree::Kind::sequence) return {flow_text(tree)};
  if (tree.items.empty()) throw InputError(tree.where, path, "names no value");
  return mapped(tree.items, flow_text);
}

void read_operator(const Tree& map, const std::string& path, Condition& condition) {
  static const std::vector<std::string> known{"below", "above", "between", "not"};
  refuse_unknown_keys(map, path, known);
  if (map.entries.size() != 1) throw InputError(map.where, path, "must hold exactly one operator", joined(known));
  const auto& [name, where, value] = map.entries.front();
  const std::string inner = key_path(path, name);
  if (name == "not") {
    condition.kind = Condition::Kind::none_of;
    condition.values = values_of(value, inner);
  } else if (name == "between") {
    condition.kind = Condition::Kind::between;
    const std::vector<double> bounds = numbers_value(value, inner, 1, 2);
    condition.lower = bounds[0], condition.upper = bounds[1];
    if (!(condition.lower <= condition.upper))
      throw InputError(value.where, inner, "the first must not exceed the second");
  } else {
    condition.kind = name == "below" ? Condition::Kind::below : Condition::Kind::above;
    condition.lower = condition.upper = number_value(value, inner);
  }
}

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
        const auto level = std::ranges::find_if(
            axis.levels, [&, &text = value](const Level& each) { return same_value(each.name, flow_text(text)); });
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

bool same_value(const std::string& a, const std::string& b) {
  const auto x = parse_number(a), y = parse_number(b);
  return a == b || (x && y && *x == *y);
}

std::string flow_text(const Tree& tree) {
  std::string text;
  switch (tree.kind) {
    case Tree::Kind::null:
      return "null";
    case Tree::Kind::scalar:
      return tree.text;
    case Tree::Kind::sequence:
      for (std::size_t i = 0; i < tree.items.size(); ++i) text += (i == 0 ? "" : ", ") + flow_text(tree.items[i]);
      return "[" + text + "]";
    case Tree::Kind::map:
      for (const Tree::Entry& entry : tree.entries) {
        text += (text.empty() ? "" : ", ") + yaml_scalar(entry.key) + ": " + flow_text(entry.value);
      }
      return "{" + text + "}";
  }
  return text;
}

bool Selection::holds(const std::vector<AxisValue>& values) const {
  return std::ranges::all_of(conditions, [&](const Condition& condition) {
    const auto found = std::ranges::find_if(values, [&](const AxisValue& each) { return each.axis == condition.axis; });
    return fulfils(condition, found == values.end() ? nullptr : &found->value);
  });
}

Selection read_selection(const Tree& map, const std::string& key) {
  require_map(map, key, "axes of the study");
  Selection selection{{}, map.where};
  for (const Tree::Entry& entry : map.entries) {
    Condition condition{entry.key, Condition::Kind::one_of, {}, 0, 0, entry.key_where};
    if (entry.value.kind == Tree::Kind::map) {
      read_operator(entry.value, key_path(key, entry.key), condition);
    } else {
      condition.values = values_of(entry.value, key_path(key, entry.key));
    }
    selection.conditions.push_back(std::move(condition));
  }
  return selection;
}

std::vector<Combination> combinations_of(const Study& study) {
  std::vector<Combination> all = study.sampling.type == Sampling::Type::product ? product(study)
                                 : study.sampling.type == Sampling::Type::list  ? listed(study)
                                                                                : hypercube(study);
  std::erase_if(all, [&](const Combination& each) {
    return std::ranges::any_of(study.excluded, [&](const Selection& excluded) { return excluded.holds(each.values); });
  });
  if (all.empty()) throw InputError({study.file, 0, 0}, "exclude", "leaves no case");
  return all;
}

}  // namespace assay::drivers
