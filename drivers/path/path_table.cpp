// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/path/path_table.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "drivers/format/csv.hpp"
#include "drivers/format/npz.hpp"
#include "harness/material/offer.hpp"
#include "harness/material/state_variable.hpp"

namespace assay::drivers {

namespace {

constexpr const char* nine[] = {"11", "12", "13", "21", "22", "23", "31", "32", "33"};
constexpr double end_share = 1e-9;  ///< of the path: a measured value this near to its end lies on it
constexpr int six_places[] = {0, 4, 8, 1, 2, 5};

double mises_of(const Tensor& sigma) {
  const Tensor s = sigma - sigma.trace() / 3 * Tensor::Identity();
  return std::sqrt(1.5) * s.norm();
}

/// "back_stress_12": of a variable with several components.
std::vector<std::string> names_of_state(const assay_material& table) {
  constexpr const char *vector[] = {"1", "2", "3"}, *symmetric[] = {"11", "22", "33", "12", "13", "23"};
  std::vector<std::string> names;
  for (const StatePlace& place : state_of(table)) {
    for (std::size_t k = 0; k < place.size; ++k) {
      const char* index = place.size == 3 ? vector[k] : place.size == 6 ? symmetric[k] : nine[k];
      names.push_back(place.size == 1 ? place.name : std::string(place.name) + "_" + index);
    }
  }
  return names;
}

/// Collects columns row by row.
class Columns {
 public:
  explicit Columns(PathTable& table) : table_(table) {}
  void operator()(const std::string& name, const char* unit, double value) {
    if (first_) {
      table_.names.push_back(name), table_.units.emplace_back(unit), table_.si_units.emplace_back(unit);
      table_.columns.emplace_back();
    }
    table_.columns[next_++].push_back(value);
  }
  void tensor(const std::string& family, const char* unit, const Tensor& A) {
    for (int c = 0; c < 9; ++c) (*this)(family + nine[c], unit, component(A, c));
  }
  void symmetric(const std::string& family, const char* unit, const Tensor& A) {
    for (const int c : six_places) (*this)(family + nine[c], unit, component(A, c));
  }
  void end_row() { first_ = false, next_ = 0; }

 private:
  PathTable& table_;
  bool first_ = true;
  std::size_t next_ = 0;
};

}  // namespace

Tensor log_of_stretch(const Tensor& F) {
  const Eigen::SelfAdjointEigenSolver<Tensor> spectrum(F.transpose() * F);
  const Tensor& N = spectrum.eigenvectors();
  return N * (0.5 * spectrum.eigenvalues().array().log()).matrix().asDiagonal() * N.transpose();
}

const std::vector<double>* PathTable::column(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? nullptr : &columns[static_cast<std::size_t>(found - names.begin())];
}

bool PathTable::moves(const std::string& name) const {
  const auto* values = column(name);
  return values && std::ranges::any_of(*values, [&](double value) { return value != values->front(); });
}

PathTable path_table(const Material& material, const std::vector<ControlledRow>& rows) {
  PathTable table;
  Columns add(table);
  const Offer<assay_energy> energy_of(material);
  const std::vector<std::string> state_names = names_of_state(material.table());
  const std::vector<StatePlace> places = state_of(material.table());
  double first_energy = 0;
  for (const ControlledRow& row : rows) {
    const Tensor& sigma = row.s;
    const double J = row.F.determinant();
    add("t", "s", row.t);
    add.tensor("F", "1", row.F);
    add.symmetric("e", "1", log_of_stretch(row.F));
    add.symmetric("s", "Pa", sigma);
    add.symmetric("tau", "Pa", J * sigma);
    add.tensor("P", "Pa", first_piola_kirchhoff(sigma, row.F));
    add("J", "1", J);
    add("pressure", "Pa", -sigma.trace() / 3);
    add("mises", "Pa", mises_of(sigma));
    add("work", "J/m^3", row.work);
    if (energy_of) {
      double energy = 0;
      const auto F = nine_of(row.F);
      const bool good = energy_of(1, F.data(), row.state.data(), &energy) != ASSAY_FAILED;
      if (&row == &rows.front()) first_energy = energy;
      add("energy", "J/m^3", good ? energy : NAN);
      add("dissipation", "J/m^3", good ? row.work - (energy - first_energy) : NAN);
    }
    add("acoustic", "1", row.acoustic);
    add("residual", "1", row.residual);
    add("error", "1", row.error);
    std::size_t k = 0;
    for (const StatePlace& place : places) {
      for (std::size_t c = 0; c < place.size; ++c, ++k) add(state_names[k], place.unit ? place.unit : "", row.state[k]);
    }
    add.end_row();
  }
  return table;
}

PathTable in_units(PathTable si, const Units& units) {
  for (std::size_t k = 0; k < si.names.size(); ++k) {
    const Scale scale = units.scale(si.si_units[k]);
    for (double& value : si.columns[k]) value = scale.from_si(value);
    si.units[k] = units.name(si.si_units[k]);
  }
  return si;
}

PathTable path_table(const Material& material, const ControlledHistory& history, const Control& control) {
  std::vector<ControlledRow> rows = history.rows;
  for (ControlledRow& row : rows) row.s = cauchy_of(control.stress, row.s, row.F);
  return path_table(material, rows);
}

std::string path_csv(const PathTable& table) {
  std::string remark = "# units:";
  for (std::size_t k = 0; k < table.names.size(); ++k)
    remark += (k == 0 ? " " : ", ") + table.names[k] + " [" + table.units[k] + "]";
  CsvText csv(table.names);
  std::vector<double> row(table.names.size());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    for (std::size_t k = 0; k < row.size(); ++k) row[k] = table.columns[k][i];
    csv.row(row);
  }
  return remark + "\n" + csv.text();
}

std::string path_npz(const PathTable& table) {
  std::vector<NpzArray> arrays;
  for (std::size_t k = 0; k < table.names.size(); ++k)
    arrays.push_back({table.names[k], {table.rows()}, table.columns[k]});
  return npz_bytes(arrays);
}

double largest_difference(const PathTable& one, const PathTable& other) {
  double difference = 0, largest = 0;
  const std::vector<double>&t = *one.column("t"), &t_other = *other.column("t");
  for (const int c : six_places) {
    const std::vector<double>&s = *one.column(std::string("s") + nine[c]),
          &s_other = *other.column(std::string("s") + nine[c]);
    for (std::size_t i = 0, k = 0; i < t.size(); ++i) {
      largest = std::max(largest, std::abs(s[i]));
      while (k < t_other.size() && t_other[k] < t[i]) ++k;
      if (k == t_other.size() || t_other[k] != t[i]) continue;
      difference = std::max(difference, std::abs(s[i] - s_other[k++]));  // at a jump two rows are at one time
    }
  }
  return largest > 0 ? difference / largest : difference > 0 ? INFINITY : 0;
}

/// At each measured abscissa the path's value, straight between its rows: by time, or by a quantity that grows or falls
/// all along the path.
std::optional<double> misfit(const PathComparison& compare, const PathTable& table, std::string& fault) {
  const auto values_of = [&](const PathQuantity& quantity) {
    std::vector<double> values(table.rows(), 0.0);
    for (const PathTerm& term : quantity.terms) {
      const auto* column = table.column(term.of_J() ? "J" : term.name());
      for (std::size_t i = 0; column && i < values.size(); ++i)
        values[i] += term.factor * (term.family == "lnJ" ? std::log((*column)[i]) : (*column)[i]);
    }
    return values;
  };
  std::vector<double> x = compare.x.terms.empty() ? *table.column("t") : values_of(compare.x);
  const std::vector<double> y = values_of(compare.y);
  const bool falls = x.back() < x.front();
  if (falls) {
    for (double& value : x) value = -value;
  }
  if (!std::is_sorted(x.begin(), x.end())) {
    fault = compare.x.text + " turns back along the path: compare by x: t";
    return std::nullopt;
  }
  double sum = 0, largest = 0;
  std::size_t counted = 0;
  for (std::size_t k = 0; k < compare.y_of_x.times.size(); ++k) {
    const double given = (falls ? -1 : 1) * compare.y_of_x.times[k], measured = compare.y_of_x.values[k];
    const double at = std::clamp(given, x.front(), x.back());
    if (std::abs(at - given) > end_share * (x.back() - x.front())) continue;
    const auto behind = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end() - 1, at) - x.begin());
    const std::size_t before = behind == 0 ? 0 : behind - 1;
    const double width = x[behind] - x[before], share = width > 0 ? (at - x[before]) / width : 1;
    const double difference = y[before] + share * (y[behind] - y[before]) - measured;
    sum += difference * difference;
    largest = std::max(largest, std::abs(measured));
    ++counted;
  }
  if (counted == 0 || largest == 0) {
    fault = counted == 0 ? "no measured value lies on the path" : "all measured values are zero";
    return std::nullopt;
  }
  const std::size_t all = compare.y_of_x.times.size();
  if (counted < all)
    fault = std::to_string(all - counted) + " of " + std::to_string(all) + " measured values lie beyond the path";
  return std::sqrt(sum / static_cast<double>(counted)) / largest;
}

}  // namespace assay::drivers
