// SPDX-License-Identifier: BSD-3-Clause
// Nodes that particles reach by their slopes alone.
#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "mpm/basis/basis.hpp"
#include "mpm/step/passes.hpp"

namespace assay::mpm {

namespace {

/// Nodes without mass where particles lie on lines between cells, and those with mass that they go with.
struct MasslessNodes {
  struct Share {
    std::size_t node = 0;
    double of_mass = 0;  ///< of all those of one node
  };
  struct Node {
    std::size_t node = 0, end = 0;  ///< of its shares, which begin where those of the node before end
  };
  std::vector<Node> nodes;
  std::vector<Share> shares;

  void clear() {
    nodes.clear();
    shares.clear();
  }

  /// body(node, shares)
  void each(const auto& body) const {
    std::size_t begin = 0;
    for (const Node& one : nodes) {
      body(one.node, std::span(shares).subspan(begin, one.end - begin));
      begin = one.end;
    }
  }
};

/// What rounding leaves of a cell's mass, rho0 h^Dim, to the nodes across from a particle on a line.
constexpr double least_share = on_line;

/// Whether a particle begins on the edge of the grid.
template <int Dim>
bool begins_on_edge(const Setup<Dim>& setup) {
  const GridGeometry<Dim>& grid = setup.grid;
  for (int d = 0; d < Dim; ++d) {
    const auto axis = static_cast<std::size_t>(d);
    const double lower = grid.coordinate(d, 0), upper = grid.coordinate(d, grid.count[axis] - 1);
    for (const double X : setup.seeds.X[axis]) {
      if (std::min(X - lower, upper - X) < on_line * grid.spacing) return true;
    }
  }
  return false;
}

template <int Dim>
struct Neighbour {
  std::array<std::int32_t, Dim> step{};  ///< along each axis
  std::ptrdiff_t distance = 0;           ///< of the nodes' numbers
  int steps = 0;                         ///< along all axes together
};

/// The nearest first: along the axes, then across the diagonals. On the edge of the grid quartic splines have slopes
/// two nodes away.
template <int Dim>
std::vector<Neighbour<Dim>> neighbours_of(const Setup<Dim>& setup) {
  const BasisTraits basis = traits_of<Dim>(setup.method.basis);
  const int reach = std::max(basis.is_spline() ? 2 : 1, basis.nodes_across / 2), across = 2 * reach + 1;
  int all = 1;
  for (int d = 0; d < Dim; ++d) all *= across;
  std::vector<Neighbour<Dim>> neighbours;
  for (int k = 0; k < all; ++k) {
    Neighbour<Dim> neighbour;
    std::ptrdiff_t stride = 1;
    int rest = k;
    for (std::size_t d = 0; d < Dim; ++d, rest /= across) {
      neighbour.step[d] = rest % across - reach;
      neighbour.distance += neighbour.step[d] * stride;
      neighbour.steps += std::abs(neighbour.step[d]);
      stride *= setup.grid.count[d];
    }
    if (neighbour.steps > 0) neighbours.push_back(neighbour);
  }
  std::stable_sort(neighbours.begin(), neighbours.end(),
                   [](const auto& a, const auto& b) { return a.steps < b.steps; });
  return neighbours;
}

/// Finds the nodes without mass that have neighbours with mass, and these.
template <int Dim>
class MasslessFinder {
 public:
  explicit MasslessFinder(State<Dim>& s)
      : s_(&s),
        images_(&s.template own<Images<Dim>>()),
        least_(least_share * s.setup.density * std::pow(s.setup.grid.spacing, Dim)),
        neighbours_(neighbours_of(s.setup)) {
    const Held& held = s.template own<Held>();
    if (held.nodes.empty()) return;
    held_.resize(s.setup.grid.nodes(), false);
    for (const std::uint32_t i : held.nodes) held_[i] = true;
  }

  void find(MasslessNodes& found) const {
    found.clear();
    const auto is_on_line = [](unsigned char block) { return block != 0; };
    if (std::none_of(s_->on_lines.begin(), s_->on_lines.end(), is_on_line)) return;
    s_->live.each([&](std::size_t i) {
      if (!has_mass(i) && (held_.empty() || !held_[i])) add(i, found);
    });
  }

 private:
  bool has_mass(std::size_t i) const { return s_->inertia.node(i)[0] >= least_; }

  void add(std::size_t i, MasslessNodes& found) const {
    const GridGeometry<Dim>& grid = s_->setup.grid;
    std::array<std::int32_t, Dim> at;
    for (std::size_t d = 0, rest = i; d < Dim; ++d) {
      const auto count = static_cast<std::size_t>(grid.count[d]);
      at[d] = static_cast<std::int32_t>(rest % count);
      rest /= count;
    }
    const std::size_t begin = found.shares.size();
    double mass = 0;
    int steps = 0;
    for (const Neighbour<Dim>& neighbour : neighbours_) {
      if (mass > 0 && neighbour.steps > steps) break;
      bool inside = true;
      for (std::size_t d = 0; d < Dim; ++d) {
        const std::int32_t there = at[d] + neighbour.step[d];
        inside = inside && there >= 0 && there < grid.count[d];
      }
      if (!inside) continue;
      // across a periodic end the node that has the mass
      const std::size_t node =
          images_->cell(static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + neighbour.distance));
      if (!s_->live.holds(node) || !has_mass(node)) continue;
      steps = neighbour.steps;
      found.shares.push_back({node, s_->inertia.node(node)[0]});
      mass += found.shares.back().of_mass;
    }
    if (!(mass > 0)) return;
    for (std::size_t k = begin; k < found.shares.size(); ++k) found.shares[k].of_mass /= mass;
    found.nodes.push_back({i, found.shares.size()});
  }

  const State<Dim>* s_;
  const Images<Dim>* images_;
  double least_;  ///< [kg]
  std::vector<Neighbour<Dim>> neighbours_;
  std::vector<bool> held_;  ///< of each node; empty where none is
};

template <int K>
void hand_over(GridField<K>& field, const MasslessNodes& massless) {
  massless.each([&](std::size_t i, const auto& shares) {
    double* own = field.node(i);
    for (const auto& share : shares) {
      double* to = field.node(share.node);
      for (int c = 0; c < K; ++c) to[c] += share.of_mass * own[c];
    }
    std::fill_n(own, K, 0.0);
  });
}

template <int K>
void take_over(GridField<K>& field, const MasslessNodes& massless) {
  massless.each([&](std::size_t i, const auto& shares) {
    double* own = field.node(i);
    std::fill_n(own, K, 0.0);
    for (const auto& share : shares) {
      const double* from = field.node(share.node);
      for (int c = 0; c < K; ++c) own[c] += share.of_mass * from[c];
    }
  });
}

}  // namespace

template <int Dim>
bool has_massless_nodes(const Setup<Dim>& setup) {
  const BasisTraits basis = traits_of<Dim>(setup.method.basis);
  return !basis.smooth || (basis.at_points && begins_on_edge(setup));
}

template <int Dim>
Pass<Dim> fold_massless_pass(Phase phase, Folded what) {
  Pass<Dim> pass{{.name = "fold_massless",
                  .slot = {phase, Part::hand_over},
                  .doc = "what nodes without mass were given, to their neighbours",
                  .called_for_by = "method.basis",
                  .grid_fields = {"mass", "momentum"}}};
  if (what != Folded::inertia) pass.grid_fields.push_back("force");
  pass.bind = [what](State<Dim>& s) -> Kernel {
    s.on_lines.resize(blocks_of(s.particles));
    auto finder = std::make_shared<MasslessFinder<Dim>>(s);
    return [&s, &massless = s.template own<MasslessNodes>(), what, finder](const Instant&) {
      finder->find(massless);
      if (what != Folded::forces) hand_over(s.inertia, massless);
      if (what != Folded::inertia) hand_over(s.force, massless);
    };
  };
  return pass;
}

template <int Dim>
Pass<Dim> unfold_massless_pass(Phase phase) {
  return {{.name = "unfold_massless",
           .slot = {phase, Part::take_over},
           .doc = "nodes without mass move as their neighbours",
           .called_for_by = "method.basis",
           .grid_fields = {"mass", "velocity", "acceleration"}},
          [](State<Dim>& s) -> Kernel {
            return [&s, &massless = s.template own<MasslessNodes>()](const Instant&) { take_over(s.motion, massless); };
          }};
}

template bool has_massless_nodes(const Setup<ASSAY_DIMENSION>&);
template Pass<ASSAY_DIMENSION> fold_massless_pass<ASSAY_DIMENSION>(Phase, Folded);
template Pass<ASSAY_DIMENSION> unfold_massless_pass<ASSAY_DIMENSION>(Phase);

}  // namespace assay::mpm
