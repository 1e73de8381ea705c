// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/judge/judged_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "drivers/judge/run_times.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

/// The columns of a quantity: of one array its components.
class Components {
 public:
  Components(const ParticleTable& table, const std::vector<std::string>& names, const std::string& quantity) {
    for (const std::string& name : names) {
      const ParticleArray* array = table.array(name);
      const auto words = table.words.find(name);
      if (words != table.words.end()) {
        throw InputError({table.file, 0, 0}, quantity,
                         "'" + shown(name, 40) + "' holds no numbers: '" + shown(words->second, 40) + "'" +
                             (words->second.find(',') == std::string::npos ? "" : ", a decimal comma?"));
      }
      if (!array) {
        throw InputError({table.file, 0, 0}, quantity, "there is no '" + shown(name, 40) + "' for it",
                         joined(table.arrays, [](const ParticleArray& each) { return shown(each.name, 40); }));
      }
      if (names.size() > 1 && array->components != 1)
        throw InputError({table.file, 0, 0}, quantity,
                         "'" + shown(name, 40) + "' has " + std::to_string(array->components) +
                             " components, and is one of several names: name it alone");
      for (std::size_t c = 0; c < array->components; ++c)
        columns_.push_back({array->values.data() + c, array->components});
    }
  }
  std::size_t count() const { return columns_.size(); }
  double operator()(std::size_t row, std::size_t component) const {
    const auto& [first, stride] = columns_[component];
    return first[row * stride];
  }

 private:
  std::vector<std::pair<const double*, std::size_t>> columns_;
};

[[noreturn]] void refuse_count(const ParticleTable& table, const std::string& quantity, std::size_t found,
                               const std::string& wanted) {
  throw InputError({table.file, 0, 0}, quantity, "has " + std::to_string(found) + " components, needs " + wanted);
}

/// Quantities of a table, of some of its rows.
class TableReader {
 public:
  TableReader(const ParticleTable& table, const JudgeMap& map, std::vector<std::size_t> rows)
      : table_(table), map_(map), rows_(std::move(rows)) {}

  std::vector<double> numbers(Judged quantity, double unit) const {
    if (map_.names(quantity).empty()) return {};
    const Components of(table_, map_.names(quantity), word(quantity));
    if (of.count() != 1) refuse_count(table_, word(quantity), of.count(), "1");
    std::vector<double> values;
    values.reserve(rows_.size());
    for (const std::size_t row : rows_) values.push_back(unit * of(row, 0));
    return values;
  }
  std::vector<Vector3> vectors(Judged quantity, double unit) const {
    if (map_.names(quantity).empty()) return {};
    const Components of(table_, map_.names(quantity), word(quantity));
    if (of.count() != 2 && of.count() != 3) refuse_count(table_, word(quantity), of.count(), "2 or 3");
    std::vector<Vector3> values;
    values.reserve(rows_.size());
    for (const std::size_t row : rows_)
      values.emplace_back(unit * of(row, 0), unit * of(row, 1), of.count() == 3 ? unit * of(row, 2) : 0);
    return values;
  }
  std::vector<Tensor> tensors(Judged quantity, double unit) const {
    if (map_.names(quantity).empty()) return {};
    const Components of(table_, map_.names(quantity), word(quantity));
    const std::vector<int> places = places_of(quantity, of.count());
    std::vector<Tensor> values;
    values.reserve(rows_.size());
    for (const std::size_t row : rows_) {
      Tensor value = Tensor::Constant(not_written);
      for (std::size_t c = 0; c < places.size(); ++c) {
        const int i = places[c] / 10 - 1, j = places[c] % 10 - 1;
        value(i, j) = unit * of(row, c);
        if (quantity == Judged::sigma && of.count() < 9) value(j, i) = value(i, j);
      }
      values.push_back(value);
    }
    return values;
  }

 private:
  static std::string word(Judged quantity) { return word_of(quantity); }
  std::vector<int> places_of(Judged quantity, std::size_t count) const {
    if (quantity == Judged::sigma && !map_.sigma_components.empty()) {
      if (map_.sigma_components.size() != count)
        refuse_count(table_, "sigma", count,
                     std::to_string(map_.sigma_components.size()) + ", as sigma_components says");
      return map_.sigma_components;
    }
    if (count == 9) return {11, 12, 13, 21, 22, 23, 31, 32, 33};
    if (quantity == Judged::F) {
      if (count != 4) refuse_count(table_, "F", count, "4 or 9");
      return {11, 12, 21, 22};
    }
    if (count == 3) return {11, 22, 12};
    if (count == 4) return {11, 22, 33, 12};
    if (count != 6) refuse_count(table_, "sigma", count, "3, 4, 6 or 9");
    return {11, 22, 33, 12, 13, 23};
  }

  const ParticleTable& table_;
  const JudgeMap& map_;
  std::vector<std::size_t> rows_;
};

JudgedFrame frame_of(const ParticleTable& table, const JudgeMap& map, std::vector<std::size_t> rows, double t) {
  const TableReader read(table, map, std::move(rows));
  JudgedFrame frame;
  frame.name = table.name();
  frame.t = t * map.time_unit;
  frame.t_velocity = table.velocity_time.value_or(t + map.time.velocity) * map.time_unit;
  frame.id = read.numbers(Judged::id, 1);
  frame.X = read.vectors(Judged::X, map.length);
  frame.x = read.vectors(Judged::x, map.length);
  frame.v = read.vectors(Judged::v, map.velocity.value_or(map.length / map.time_unit));
  frame.F = read.tensors(Judged::F, 1);
  frame.sigma = read.tensors(Judged::sigma, map.stress);
  frame.J = read.numbers(Judged::J, 1);
  frame.volume = read.numbers(Judged::volume, std::pow(map.length, 3));
  if (frame.x.empty()) {
    const std::vector<Vector3> u = read.vectors(Judged::u, map.length);
    if (!u.empty() && frame.X.empty())
      throw InputError({table.file, 0, 0}, "u", "displacements need X, the reference positions, beside them");
    for (std::size_t p = 0; p < u.size(); ++p) frame.x.push_back(frame.X[p] + u[p]);
  }
  return frame;
}

void require_three(const ParticleTable& table, const JudgeMap& map) {
  for (const Judged vector : {Judged::X, Judged::x, Judged::u, Judged::v}) {
    const Components of(table, map.names(vector), word_of(vector));
    if (of.count() == 2)
      throw InputError({table.file, 0, 0}, word_of(vector),
                       "has two components, and the scene has three dimensions: name the third too");
  }
}

/// Half of the last digit that numbers are written with: the fewest digits that some of them all have, or those of
/// single precision.
double rounding_of(const ParticleTable& table, const JudgeMap& map) {
  constexpr std::size_t looked_at = 200;
  const auto& names = map.names(map.names(Judged::x).empty() ? Judged::u : Judged::x);
  const Components of(table, names, "x");
  double largest = 0;
  int digits = 1;
  bool single = true;
  for (std::size_t k = 0; k < table.rows; k += 1 + table.rows / looked_at) {
    for (std::size_t c = 0; c < of.count(); ++c) {
      const double value = of(k, c);
      if (!std::isfinite(value)) continue;
      largest = std::max(largest, std::abs(value));
      single = single && static_cast<double>(static_cast<float>(value)) == value;
      constexpr int all = 17;  // that a double has
      while (digits < all && std::stod(fmt::format("{:.{}e}", value, digits - 1)) != value) ++digits;
    }
  }
  if (!(largest > 0)) return 0;
  const double first = std::pow(10, std::floor(std::log10(largest)));
  const double by_digits = 0.5 * first * std::pow(10, 1 - digits);
  return single ? std::max(by_digits, largest * std::exp2(-25)) : by_digits;
}

std::vector<std::size_t> all_rows(std::size_t n) {
  std::vector<std::size_t> rows(n);
  for (std::size_t k = 0; k < n; ++k) rows[k] = k;
  return rows;
}

std::vector<std::string> unread_of(const ParticleTable& table, const JudgeMap& map, const std::string& time) {
  std::vector<std::string> unread;
  for (const ParticleArray& array : table.arrays) {
    const bool is_read = array.name == time || std::ranges::any_of(map.of, [&](const auto& names) {
                           return std::ranges::find(names, array.name) != names.end();
                         });
    if (!is_read) unread.push_back(shown(array.name, 40));
  }
  return unread;
}

}  // namespace

JudgedRun read_judged_run(const std::string& name, const JudgeMap& map, int dimension) {
  JudgedRun run;
  run.name = name, run.map = map;
  run.map.seeds = seeds_file_of(name, map.seeds);
  if (const std::string cost = cost_file_of(name); !cost.empty()) run.map.cost = read_judge_cost(cost);
  TimeOf time_of(map.time);
  std::size_t number = 0;
  bool complete = false;
  double rounding = HUGE_VAL;  // of the file that shows most digits: at rest on a lattice positions have few
  const auto take = [&](ParticleTable&& table) {
    if (!complete) complete_map(run.map, table);
    if (!complete && dimension == 3) require_three(table, run.map);
    if (const double here = rounding_of(table, run.map); here > 0) rounding = std::min(rounding, map.length * here);
    auto rows_of_times = time_of(table, number);
    if (!complete) run.unread = unread_of(table, run.map, time_of.column());
    complete = true;
    for (auto& [t, rows] : rows_of_times) {
      JudgedFrame frame = frame_of(table, run.map, std::move(rows), t);
      if (!run.frames.empty()) {
        const JudgedFrame& before = run.frames.back();
        frame.id.share(before.id), frame.X.share(before.X), frame.volume.share(before.volume);
      }
      run.frames.push_back(std::move(frame));
    }
    ++number;
  };
  const RunFiles files = files_of_run(name);
  run.left_out = files.left_out;
  for (const std::string& file : files.files) read_particle_tables(file, take, map.columns);
  if (run.frames.empty()) throw InputError({name, 0, 0}, "", "holds no particles");
  if (std::isfinite(rounding)) run.rounding = rounding;
  std::ranges::stable_sort(run.frames, {}, &JudgedFrame::t);
  run.time_words = time_of.words();
  return run;
}

JudgedFrame read_seeds(const std::string& file, const JudgeMap& map) {
  JudgedFrame seeds;
  read_particle_tables(file, [&](ParticleTable&& table) {
    JudgeMap own = map;
    for (const Judged other : {Judged::x, Judged::u, Judged::v, Judged::F, Judged::J, Judged::sigma})
      own.names(other).clear();
    if (own.names(Judged::X).empty() || !table.array(own.names(Judged::X)[0])) own.names(Judged::X).clear();
    own.names(Judged::x) = {"none"};  // not wanted here
    complete_map(own, table);
    for (const Judged other : {Judged::x, Judged::u, Judged::v, Judged::F, Judged::J, Judged::sigma})
      own.names(other).clear();
    if (own.names(Judged::X).empty())
      throw InputError({file, 0, 0}, "X", "the seeds have no reference positions",
                       joined(table.arrays, [](const ParticleArray& array) { return shown(array.name, 40); }));
    seeds = frame_of(table, own, all_rows(table.rows), 0);
    seeds.x = seeds.X;
  });
  return seeds;
}

}  // namespace assay::drivers
