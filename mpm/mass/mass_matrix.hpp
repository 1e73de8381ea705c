// SPDX-License-Identifier: BSD-3-Clause
// The mass matrix M_ij = sum m_p phi_ip phi_jp and ways to invert it.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "mpm/kernels/mass_stencil.hpp"
#include "mpm/mass/mass_preconditioner.hpp"
#include "mpm/step/run_kernels.hpp"

namespace assay::mpm {

/// Residual of conjugate gradients over that at first: 1e-12, 1e-13 and 1e-14 leave errors of 2e-12, 2e-13 and 1e-13 in
/// the translation of a body.
inline constexpr double converged = 1e-14;
inline constexpr int most_iterations = 400;
/// Nodes of less mass [of rho0 h^Dim] lie at an edge of the body: with few particles around them M is as good as
/// singular there, and they keep their row sums.
inline constexpr double edge_mass = 0.75;

/// Over how many nodes in each direction a particle reaches, where the matrix is made once; 0 where it is not.
template <int Dim>
int mass_nodes_across(const Method& method) {
  return method.is_total() && !method.is_lumped() ? traits_of<Dim>(method.basis).nodes_across : 0;
}

/// Of all nodes.
template <int Dim>
struct SolverFields {
  std::vector<GridField<Dim>> vectors;
  std::vector<double> inverse_mass;  ///< 1 / row sum of a node that moves, or 0 [1/kg]

  void allocate(std::size_t count, std::size_t nodes) {
    vectors.resize(count);
    for (auto& field : vectors) field.allocate(nodes);
    inverse_mass.assign(nodes, 0.0);
  }
};

/// M and M_L on the nodes that are free to move and have mass.
template <int Dim>
class MassMatrix {
 public:
  using Field = GridField<Dim>;

  /// The third and fourth of the vectors are left to the caller.
  MassMatrix(State<Dim>& s, SolverFields<Dim>& fields)
      : s_(&s),
        images_(&s.template own<Images<Dim>>()),
        held_(&s.template own<Held>()),
        multiply_block_(kernels_for(s).multiply_mass),
        residual_(fields.vectors[0]),
        image_(fields.vectors[1]),
        direction_(last_of(fields, 4)),
        scaled_(last_of(fields, 5)),
        divided_(last_of(fields, 6)),
        shared_(last_of(fields, 7)),
        inverse_(fields.inverse_mass) {}

  /// Weights that never change make the matrix of nodes once: call when they are placed.
  void assemble() {
    const int across = mass_nodes_across<Dim>(s_->method);
    if (across == 0 || stencil_) return;
    const auto add_rows = [&](const MassRows<Dim>& rows) {
      kernels_for(*s_).add_mass_rows(*s_, Block{0, s_->particles, nullptr, nullptr}, rows);
    };
    stencil_.emplace(
        s_->setup.grid, across, [&](const Field& x, Field& y) { multiply_by_particles(x, y); }, add_rows);
    if (s_->method.mass == Mass::consistent) inside_.emplace(s_->setup.grid, stencil_->means());
  }

  /// M_L^-1 of every node: at the beginning of each step.
  void invert_sums() {
    s_->live.each([&](std::size_t i) {
      const double mass = s_->inertia.node(i)[0];
      inverse_[i] = mass > 0 ? 1 / mass : 0;
    });
    for (const std::uint32_t i : held_->nodes) inverse_[i] = 0;
  }

  bool is_free(std::size_t i) const { return inverse_[i] > 0; }

  /// body(begin, end) for all nodes that have mass, and maybe others.
  void for_nodes(const auto& body) const {
    if (stencil_) {
      stencil_->for_nodes(s_->setup.threads, body);
    } else {
      for (const NodeRange& run : s_->live.runs()) body(run.first, run.end);
    }
  }

  /// M_L^-1, zero on nodes that are not free.
  double inverse_sum(std::size_t i) const { return inverse_[i]; }

  /// x = k terms of the series times q, where x = M_L^-1 q at first.
  void add_terms(Field& x, int terms) {
    copy(x, residual_);
    const bool held = !held_->mass.empty();
    for (int l = 1; l < terms; ++l) {
      multiply_then(residual_, image_, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          double *of_x = x.node(i), *next = image_.node(i);
          const double *rest = residual_.node(i), mass = held ? held_->mass[i] : 0;
          for (std::size_t d = 0; d < Dim; ++d) {
            next[d] = rest[d] - inverse_[i] * (next[d] + mass * rest[d]);
            of_x[d] += next[d];
          }
        }
      });
      std::swap(residual_, image_);
    }
  }

  /// x = k terms of the series times q, which x holds at first.
  void apply_series(Field& x, int terms) {
    divide(x);
    add_terms(x, terms);
  }

  /// Finds the nodes at the edges, and what the others share with them: before `solve`, in every step.
  void find_edges() {
    const auto& setup = s_->setup;
    const double whole = setup.density * std::pow(setup.grid.spacing, Dim);
    edge_.resize(residual_.nodes(), false);
    image_.zero(s_->live.runs());
    s_->live.each([&](std::size_t i) {
      edge_[i] = is_free(i) && s_->inertia.node(i)[0] < edge_mass * whole * images_->share(i);
      if (edge_[i]) std::fill_n(image_.node(i), Dim, 1.0);
    });
    scale_.resize(edge_.size());
    for (std::size_t i = 0; i < edge_.size(); ++i) scale_[i] = edge_[i] ? 0 : std::sqrt(inverse_[i]);
    std::swap(image_, direction_);
    multiply_particles(direction_, image_);
    copy(image_, shared_);
  }

  /// x = M^-1 q, which x holds at first, M_ij = 0 between nodes at the edges and others, of the same row sums. False
  /// where it does not converge.
  bool solve(Field& x) {
    constrain(x);
    copy(x, residual_);
    x.zero(s_->live.runs());
    Field& z = divided_;
    copy(residual_, z);
    precondition(z);
    copy(z, direction_);
    double rho = dot(residual_, z);
    const double target = rho * converged * converged;
    for (int k = 0; k < most_iterations && rho > target; ++k) {
      multiply_inside(direction_, image_);
      const double alpha = rho / dot(direction_, image_);
      each_value([&](std::size_t c) {
        x.data()[c] += alpha * direction_.data()[c];
        residual_.data()[c] -= alpha * image_.data()[c];
      });
      copy(residual_, z);
      precondition(z);
      const double next = dot(residual_, z), beta = next / rho;
      rho = next;
      each_value([&](std::size_t c) { direction_.data()[c] = z.data()[c] + beta * direction_.data()[c]; });
    }
    return rho <= target;
  }

  /// M x of the particles that move, until the next use of the matrix.
  const Field& image_of(Field& x) {
    multiply_particles(x, image_);
    return image_;
  }

  /// M_L^-1, zero on nodes that are not free.
  void divide(Field& x) const {
    s_->live.each([&](std::size_t i) {
      for (std::size_t d = 0; d < Dim; ++d) x.node(i)[d] *= inverse_[i];
    });
  }

 private:
  /// A series has no such fields.
  static Field& last_of(SolverFields<Dim>& fields, std::size_t k) {
    return fields.vectors[std::min(k, fields.vectors.size() - 1)];
  }

  /// body(c) for the values of all nodes.
  void each_value(const auto& body) const {
    for (const NodeRange& run : s_->live.runs()) {
      for (std::size_t c = run.first * Field::stride; c < run.end * Field::stride; ++c) body(c);
    }
  }

  void copy(const Field& from, Field& to) const { to.copy(from, s_->live.runs()); }

  void constrain(Field& x) const {
    s_->live.each([&](std::size_t i) {
      if (!is_free(i)) std::fill_n(x.node(i), Dim, 0.0);
    });
  }

  double dot(const Field& a, const Field& b) const {
    double sum = 0;
    each_value([&](std::size_t c) { sum += a.data()[c] * b.data()[c]; });
    return sum;
  }

  /// x = P x, P symmetric, positive definite and near M^-1: row sums, and between nodes inside, where weights never
  /// change, the inverse of their mean matrix.
  void precondition(Field& x) {
    if (!inside_) return divide(x);
    copy(x, image_);
    scale_inside(x);
    inside_->solve(x);
    scale_inside(x);
    s_->live.each([&](std::size_t i) {
      for (std::size_t d = 0; edge_[i] && d < Dim; ++d) x.node(i)[d] = inverse_[i] * image_.node(i)[d];
    });
  }

  /// All nodes: the mean matrix is one of the whole grid.
  void scale_inside(Field& x) const {
    for (std::size_t i = 0; i < scale_.size(); ++i) {
      for (std::size_t d = 0; d < Dim; ++d) x.node(i)[d] *= scale_[i];
    }
  }

  /// y = M x; particles that never move count by their row sums.
  void multiply(Field& x, Field& y) const {
    multiply_particles(x, y);
    if (!held_->mass.empty()) {
      s_->live.each([&](std::size_t i) {
        for (std::size_t d = 0; d < Dim; ++d) y.node(i)[d] += held_->mass[i] * x.node(i)[d];
      });
    }
    constrain(y);
  }

  void multiply_inside(const Field& x, Field& y) {
    copy(x, scaled_);
    s_->live.each([&](std::size_t i) {
      if (edge_[i]) std::fill_n(scaled_.node(i), Dim, 0.0);
    });
    multiply(scaled_, y);
    s_->live.each([&](std::size_t i) {
      const double mass = s_->inertia.node(i)[0];
      for (std::size_t d = 0; d < Dim; ++d) {
        double& value = y.node(i)[d];
        value = edge_[i] ? mass * x.node(i)[d] : value + shared_.node(i)[d] * scaled_.node(i)[d];
      }
    });
  }

  /// y = M x of the particles that move. Images in x are given what their nodes have, and those in y are zero.
  void multiply_particles(Field& x, Field& y) const {
    images_->unfold(x);
    if (stencil_) {
      y.zero(s_->live.runs());
      stencil_->multiply(x, y, s_->setup.threads, [](std::size_t, std::size_t) {});
    } else {
      multiply_by_particles(x, y);
    }
    images_->fold(y);
  }

  /// The same on nodes that have mass, and after(begin, end) as soon as it is known there.
  void multiply_then(Field& x, Field& y, const auto& after) const {
    if (stencil_ && images_->empty()) {
      stencil_->multiply(x, y, s_->setup.threads, after);
    } else {
      multiply_particles(x, y);
      for (const NodeRange& run : s_->live.runs()) after(run.first, run.end);
    }
  }

  void multiply_by_particles(const Field& x, Field& y) const {
    y.zero(s_->live.runs());
    for_tiles(*s_, nullptr, y.data(), [&](std::size_t first, std::size_t end, double*, double* sums) {
      const Block all{first * block_size, std::min(s_->particles, end * block_size), nullptr, sums};
      multiply_block_(*s_, all, x.data());
    });
  }

  State<Dim>* s_;
  const Images<Dim>* images_;
  const Held* held_;
  void (*multiply_block_)(const KernelState<Dim>&, const Block&, const double*);
  Field &residual_, &image_;
  Field &direction_, &scaled_, &divided_;  ///< of conjugate gradients
  Field& shared_;                          ///< sum of M_ij over nodes j at the edges [kg]
  std::vector<double>& inverse_;           ///< of M_L; zero where a node is not free [1/kg]
  std::vector<bool> edge_;
  std::vector<double> scale_;  ///< root of M_L^-1, zero at the edges
  std::optional<MassStencil<Dim>> stencil_;
  std::optional<MassPreconditioner<Dim>> inside_;
};

}  // namespace assay::mpm
