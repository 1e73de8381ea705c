// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/passes_mass.hpp"

#include <algorithm>
#include <cmath>

#include "mpm/bases.hpp"
#include "mpm/column_access.hpp"
#include "mpm/passes_grid.hpp"

namespace assay::mpm {

namespace {

constexpr double converged = 1e-12;  ///< residual of conjugate gradients over that at first
constexpr int most_iterations = 400;
/// Nodes of less mass [of rho0 h^Dim] lie at an edge of the body: with few particles around them M is as good as
/// singular there, and they keep their row sums.
constexpr double edge_mass = 0.75;

/// M and M_L on the nodes that are free to move and have mass.
template <class B, int Dim>
class MassMatrix {
 public:
  using Field = GridField<Dim>;

  MassMatrix(State<Dim>& s, const B& basis)
      : s_(&s),
        basis_(&basis),
        residual_(s.solver[2]),
        image_(s.solver[3]),
        direction_(last_of(s, 4)),
        scaled_(last_of(s, 5)),
        divided_(last_of(s, 6)),
        shared_(last_of(s, 7)) {
    free_.assign(s.setup.grid.nodes(), true);
    for (const std::uint32_t i : s.held_nodes) free_[i] = false;
  }

  bool is_free(std::size_t i) const { return free_[i] && s_->inertia.node(i)[0] > 0; }

  /// x = k terms of the series times q, which x holds at first.
  void apply_series(Field& x, int terms) {
    divide(x);
    residual_ = x;
    for (int l = 1; l < terms; ++l) {
      multiply(residual_, image_);
      divide(image_);
      for (std::size_t c = 0; c < size(); ++c) {
        residual_.data()[c] -= image_.data()[c];
        x.data()[c] += residual_.data()[c];
      }
    }
  }

  /// Finds the nodes at the edges, and what the others share with them: before `solve`, in every step.
  void find_edges() {
    const auto& setup = s_->setup;
    const double whole = setup.density * std::pow(setup.grid.spacing, Dim);
    edge_.assign(residual_.nodes(), false);
    image_.zero();
    for (std::size_t i = 0; i < edge_.size(); ++i) {
      edge_[i] = is_free(i) && s_->inertia.node(i)[0] < edge_mass * whole;
      if (edge_[i]) std::fill_n(image_.node(i), Dim, 1.0);
    }
    std::swap(image_, direction_);
    multiply_particles(direction_, image_);
    shared_ = image_;
  }

  /// x = M^-1 q, which x holds at first, M_ij = 0 between nodes at the edges and others, of the same row sums. False
  /// where it does not converge.
  bool solve(Field& x) {
    constrain(x);
    residual_ = x;
    x.zero();
    Field& z = divided_;
    z = residual_;
    divide(z);
    direction_ = z;
    double rho = dot(residual_, z);
    const double target = rho * converged * converged;
    for (int k = 0; k < most_iterations && rho > target; ++k) {
      multiply_inside(direction_, image_);
      const double alpha = rho / dot(direction_, image_);
      for (std::size_t c = 0; c < size(); ++c) {
        x.data()[c] += alpha * direction_.data()[c];
        residual_.data()[c] -= alpha * image_.data()[c];
      }
      z = residual_;
      divide(z);
      const double next = dot(residual_, z), beta = next / rho;
      rho = next;
      for (std::size_t c = 0; c < size(); ++c) {
        direction_.data()[c] = z.data()[c] + beta * direction_.data()[c];
      }
    }
    return rho <= target;
  }

  /// M_L^-1, zero on nodes that are not free.
  void divide(Field& x) const {
    for (std::size_t i = 0; i < x.nodes(); ++i) {
      const double inverse = is_free(i) ? 1 / s_->inertia.node(i)[0] : 0;
      for (std::size_t d = 0; d < Dim; ++d) x.node(i)[d] *= inverse;
    }
  }

 private:
  /// A series has no such fields.
  static Field& last_of(State<Dim>& s, std::size_t k) { return s.solver[std::min(k, s.solver.size() - 1)]; }

  std::size_t size() const { return residual_.nodes() * Dim; }

  void constrain(Field& x) const {
    for (std::size_t i = 0; i < x.nodes(); ++i) {
      if (!is_free(i)) std::fill_n(x.node(i), Dim, 0.0);
    }
  }

  double dot(const Field& a, const Field& b) const {
    double sum = 0;
    for (std::size_t c = 0; c < size(); ++c) sum += a.data()[c] * b.data()[c];
    return sum;
  }

  /// y = M x; particles that never move count by their row sums.
  void multiply(const Field& x, Field& y) const {
    multiply_particles(x, y);
    for (std::size_t i = 0; i < s_->held_mass.size(); ++i) {
      for (std::size_t d = 0; d < Dim; ++d) y.node(i)[d] += s_->held_mass[i] * x.node(i)[d];
    }
    constrain(y);
  }

  void multiply_inside(const Field& x, Field& y) {
    scaled_ = x;
    for (std::size_t i = 0; i < edge_.size(); ++i) {
      if (edge_[i]) std::fill_n(scaled_.node(i), Dim, 0.0);
    }
    multiply(scaled_, y);
    for (std::size_t i = 0; i < edge_.size(); ++i) {
      const double mass = s_->inertia.node(i)[0];
      for (std::size_t d = 0; d < Dim; ++d) {
        double& value = y.node(i)[d];
        value = edge_[i] ? mass * x.node(i)[d] : value + shared_.node(i)[d] * scaled_.node(i)[d];
      }
    }
  }

  void multiply_particles(const Field& x, Field& y) const {
    y.zero();
    const double* mass = s_->column(Column::mass);
    for (std::size_t p = 0; p < s_->particles; ++p) {
      std::array<double, Dim> value;
      std::array<double, 0> none;
      basis_->template gather<Dim, 0>(p, x, value, none);
      for (double& v : value) v *= mass[p];
      basis_->template scatter<Dim, 0>(p, value, {}, y);
    }
  }

  State<Dim>* s_;
  const B* basis_;
  Field &residual_, &image_;
  Field &direction_, &scaled_, &divided_;  ///< of conjugate gradients
  Field& shared_;                          ///< sum of M_ij over nodes j at the edges [kg]
  std::vector<bool> free_, edge_;
};

/// Momentum or force of every node.
template <int Dim>
void load_momentum(const State<Dim>& s, double kick, bool with_force, GridField<Dim>& x) {
  for (std::size_t i = 0; i < x.nodes(); ++i) {
    for (std::size_t d = 0; d < Dim; ++d) {
      x.node(i)[d] = s.inertia.node(i)[1 + d] + (with_force ? kick * s.force.node(i)[d] : 0);
    }
  }
}

/// Momentum that the particles gain against what the nodes were given.
template <int Dim>
void book_reaction(State<Dim>& s, const Reaction& share, double kick) {
  for (std::size_t i = 0; i < s.motion.nodes(); ++i) {
    const double m = s.inertia.node(i)[0] - (s.held_mass.empty() ? 0 : s.held_mass[i]);
    for (std::size_t d = 0; d < Dim; ++d) {
      const double force = kick * s.force.node(i)[d];
      s.ledger.impulse[d] += share.of_velocity * (m * s.motion.node(i)[d] - s.inertia.node(i)[1 + d] - force) +
                             share.of_acceleration * (m * kick * s.motion.node(i)[Dim + d] - force);
    }
  }
}

template <class B, int Dim>
Kernel mass_matrix_kernel(State<Dim>& s, const Method& method) {
  s.solver.assign(solver_fields(method), GridField<Dim>());
  for (auto& field : s.solver) field.allocate(s.setup.grid.nodes());
  auto matrix_of_run = std::make_shared<MassMatrix<B, Dim>>(s, basis_of<B>(s));
  return [&s, method, matrix_of_run](const Instant& now) {
    MassMatrix<B, Dim>& matrix = *matrix_of_run;
    GridField<Dim>&v = s.solver[0], &a = s.solver[1];
    const bool fmpm = method.transfer == Transfer::fmpm;
    bool solved = true;
    if (method.mass == Mass::consistent) matrix.find_edges();
    load_momentum(s, now.kick, fmpm, v);
    if (fmpm || method.transfer == Transfer::xpic) {
      matrix.apply_series(v, method.terms);
    } else if (method.mass == Mass::consistent && !method.is_affine()) {
      solved = matrix.solve(v);
    } else {
      matrix.divide(v);
    }
    std::copy_n(s.force.data(), a.nodes() * Dim, a.data());
    if (method.mass == Mass::series) {
      matrix.apply_series(a, method.terms);
    } else if (method.mass == Mass::consistent) {
      solved = matrix.solve(a) && solved;
    } else {
      matrix.divide(a);
    }
    for (std::size_t i = 0; i < v.nodes(); ++i) {
      for (std::size_t d = 0; d < Dim; ++d) {
        s.motion.node(i)[d] = v.node(i)[d] + (fmpm ? 0 : now.kick * a.node(i)[d]);
        s.motion.node(i)[Dim + d] = a.node(i)[d];
      }
    }
    book_reaction(s, reaction_of(method), now.kick);
    if (!solved) s.finding = Finding{Finding::Kind::unstable, "the consistent mass matrix could not be inverted", 0};
  };
}

}  // namespace

template <class B, int Dim>
Pass<Dim> mass_matrix_pass(const Method& method) {
  Pass<Dim> pass;
  pass.name = "grid_update";
  const std::string terms = std::to_string(method.terms) + " terms of the inverse mass matrix";
  pass.doc = method.mass == Mass::consistent ? "nodal acceleration and velocity by the consistent mass matrix"
                                             : "nodal acceleration and velocity by " + terms;
  pass.called_for_by = method.mass == Mass::lumped ? "method.transfer" : "method.mass";
  pass.reads = {Column::weights, Column::mass};
  pass.grid_fields = {"mass", "momentum", "force", "velocity", "acceleration"};
  pass.bind = [method](State<Dim>& s) -> Kernel { return mass_matrix_kernel<B>(s, method); };
  return pass;
}

#define ASSAY_PASSES(BASIS, DIM) template Pass<DIM> mass_matrix_pass<BASIS<DIM>, DIM>(const Method&);

ASSAY_FOR_EACH_BASIS(ASSAY_PASSES)
#undef ASSAY_PASSES

}  // namespace assay::mpm
