// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/mass/passes_mass.hpp"

#include "mpm/mass/mass_matrix.hpp"
#include "mpm/step/passes.hpp"

namespace assay::mpm {

namespace {

/// Whether v is M_L^-1 (m v) and a alone is inverted: v is then divided where it is written, and needs no field.
bool divides_velocity(const Method& method) { return method.mass == Mass::series && !method.has_stages(); }

/// Grid fields of Dim components that the inversion takes.
std::size_t solver_fields(const Method& method) {
  return method.mass == Mass::consistent ? 8 : divides_velocity(method) ? 3 : 4;
}

/// Momentum of every node.
template <int Dim>
void load_momentum(const State<Dim>& s, GridField<Dim>& x) {
  s.live.each([&](std::size_t i) {
    for (std::size_t d = 0; d < Dim; ++d) x.node(i)[d] = s.inertia.node(i)[1 + d];
  });
}

/// Momentum that the particles gain against what the nodes were given.
template <int Dim>
void book_reaction(State<Dim>& s, const Held& held, const Reaction& share, double kick) {
  if (!s.setup.accounts || s.setup.has_images()) return;  // of images the pass that unfolds them keeps the account
  s.live.each([&](std::size_t i) {
    const double m = s.inertia.node(i)[0] - (held.mass.empty() ? 0 : held.mass[i]);
    for (std::size_t d = 0; d < Dim; ++d) {
      const double force = kick * s.force.node(i)[d];
      s.ledger.impulse[d] += share.of_velocity * (m * s.motion.node(i)[d] - s.inertia.node(i)[1 + d] - force) +
                             share.of_acceleration * (m * kick * s.motion.node(i)[Dim + d] - force);
    }
  });
}

/// a as row sums give it, and v where it is kept: of XPIC, and of FMPM after the kick.
template <int Dim>
void divide_by_sums(const State<Dim>& s, const MassMatrix<Dim>& matrix, double kick, GridField<Dim>* v,
                    GridField<Dim>& a) {
  matrix.for_nodes([&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double inverse = matrix.inverse_sum(i);
      for (std::size_t d = 0; d < Dim; ++d) {
        if (v) v->node(i)[d] = inverse * (s.inertia.node(i)[1 + d] + kick * s.force.node(i)[d]);
        a.node(i)[d] = inverse * s.force.node(i)[d];
      }
    }
  });
}

/// v: null where it is divided later. False where M could not be inverted.
template <int Dim>
bool find_velocity(State<Dim>& s, const Method& method, double kick, MassMatrix<Dim>& matrix, GridField<Dim>* v,
                   GridField<Dim>& a) {
  if (method.mass != Mass::consistent) {
    divide_by_sums(s, matrix, method.transfer == Transfer::fmpm ? kick : 0, v, a);
    matrix.add_terms(v ? *v : a, method.terms);
    return true;
  }
  matrix.find_edges();
  load_momentum(s, *v);
  a.copy(s.force, s.live.runs());
  bool solved = true;
  if (method.is_affine()) {
    matrix.divide(*v);
  } else {
    solved = matrix.solve(*v);
  }
  return matrix.solve(a) && solved;
}

/// The matrix, the fields that it works on, and how both ways of the grid update end.
template <int Dim>
struct Inversion {
  Inversion(State<Dim>& state, const Method& m)
      : s(&state), method(m), held(&state.template own<Held>()), fields(fields_of(state, m)), matrix(state, *fields) {}

  GridField<Dim>& a() { return fields->vectors[2]; }
  /// Null where the velocity is divided.
  GridField<Dim>* v() { return divides_velocity(method) ? nullptr : &fields->vectors[3]; }

  void end(bool solved, bool kicks, double kick) {
    if (kicks) book_reaction(*s, *held, reaction_of(method), kick);
    if (!solved) s->finding = Finding{Finding::Kind::unstable, "the consistent mass matrix could not be inverted", 0};
  }

  static SolverFields<Dim>* fields_of(State<Dim>& state, const Method& m) {
    auto& found = state.template own<SolverFields<Dim>>();
    found.allocate(solver_fields(m), state.setup.grid.nodes());
    return &found;
  }

  State<Dim>* s;
  Method method;
  const Held* held;
  SolverFields<Dim>* fields;
  MassMatrix<Dim> matrix;
};

template <int Dim>
Kernel mass_matrix_kernel(State<Dim>& s, const Method& method) {
  return [&s, method, inversion = std::make_shared<Inversion<Dim>>(s, method)](const Instant& now) {
    MassMatrix<Dim>& matrix = inversion->matrix;
    matrix.assemble();
    matrix.invert_sums();
    GridField<Dim>*v = inversion->v(), &a = inversion->a();
    const bool solved = find_velocity(s, method, now.kick, matrix, v, a);
    const double kick = method.transfer == Transfer::fmpm ? 0 : now.kick;
    matrix.for_nodes([&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t d = 0; d < Dim; ++d) {
          const double before = v ? v->node(i)[d] : matrix.inverse_sum(i) * s.inertia.node(i)[1 + d];
          s.motion.node(i)[d] = before + kick * a.node(i)[d];
          s.motion.node(i)[Dim + d] = a.node(i)[d];
        }
      }
    });
    inversion->end(solved, true, now.kick);
  };
}

/// x = M^-1 q, which x holds at first. False where it could not be found.
template <int Dim>
bool invert(MassMatrix<Dim>& matrix, const Method& method, GridField<Dim>& x) {
  if (method.mass == Mass::consistent) return matrix.solve(x);
  matrix.apply_series(x, method.mass == Mass::series ? method.terms : 1);
  return true;
}

/// Momentum of the nodes that of the particles after they gained kick a.
template <int Dim>
void kick_momentum(State<Dim>& s, GridField<Dim>& a, double kick, MassMatrix<Dim>& matrix) {
  const GridField<Dim>& gained = matrix.image_of(a);
  s.live.each([&](std::size_t i) {
    for (std::size_t d = 0; d < Dim; ++d) s.inertia.node(i)[1 + d] += kick * gained.node(i)[d];
  });
}

/// Forces work with the mean of the velocities before and after the kick; the accounts take the one after it.
template <int Dim>
void book_kick(State<Dim>& s, const GridField<Dim>& v, double kick) {
  double power = 0;
  s.live.each([&](std::size_t i) {
    for (std::size_t d = 0; d < Dim; ++d) power += s.force.node(i)[d] * (v.node(i)[d] - s.motion.node(i)[d]);
  });
  s.ledger.internal_work += 0.5 * kick * power;
}

template <int Dim>
Kernel kick_kernel(State<Dim>& s, const Method& method) {
  return [&s, method, inversion = std::make_shared<Inversion<Dim>>(s, method)](const Instant& now) {
    MassMatrix<Dim>& matrix = inversion->matrix;
    GridField<Dim>&v = *inversion->v(), &a = inversion->a();
    const bool kicks = now.kick != 0;  // the first stage of a step does not
    bool solved = true;
    if (!kicks) {
      matrix.assemble();
      matrix.invert_sums();
      if (method.mass == Mass::consistent) matrix.find_edges();
      a.zero(s.live.runs());
    } else {
      a.copy(s.force, s.live.runs());
      solved = invert(matrix, method, a);
      kick_momentum(s, a, now.kick, matrix);
    }
    load_momentum(s, v);
    solved = invert(matrix, method, v) && solved;
    if (kicks) book_kick(s, v, now.kick);
    s.live.each([&](std::size_t i) {
      for (std::size_t d = 0; d < Dim; ++d) {
        s.motion.node(i)[d] = v.node(i)[d];
        s.motion.node(i)[Dim + d] = a.node(i)[d];
      }
    });
    inversion->end(solved, kicks, now.kick);
  };
}

std::string doc_of_inversion(const Method& method, bool kicks) {
  const std::string what = "nodal acceleration and velocity";
  if (kicks && method.mass == Mass::lumped) return what + ", and the particles' momentum after the kick";
  if (kicks) return what + " by the mass matrix, momentum after the kick";
  return what + " by " +
         (method.mass == Mass::consistent ? "the consistent mass matrix"
                                          : std::to_string(method.terms) + " terms of the inverse mass matrix");
}

}  // namespace

/// a = M^-1 f, v = M^-1 (m v) + dt a, on nodes that are not held. M_ij = sum m_p phi_ip phi_jp is inverted by k terms
/// of sum_l (I - M_L^-1 M)^l M_L^-1, M_L its row sums, or by conjugate gradients:
///   series:      of f; m v is divided by M_L
///   consistent:  of f; and of m v where particles do not carry the velocity around them, which M_L serves exactly
///   xpic(k):     series of m v; f is divided by M_L
///   fmpm(k):     series of m v + dt f
/// What holding takes from the particles' momentum enters the account.
///
/// Of an integrator with stages: a = M^-1 f, m v += dt sum m_p phi_ip phi_jp a_j, v = M^-1 (m v), the same M^-1 twice,
/// so that drifts and kicks are adjoint and the energy of the particles is that of the system. What the particles gain
/// reaches the nodes by the matrix: no transfer between the stages.
template <int Dim>
std::vector<Pass<Dim>> inversion_passes(const Setup<Dim>& setup) {
  const Method& method = setup.method;
  const bool kicks = method.has_stages();
  return {{{.name = "grid_update",
            .slot = {Phase::grid},
            .doc = doc_of_inversion(method, kicks),
            .called_for_by = kicks                         ? "method.integrator"
                             : method.mass == Mass::lumped ? "method.transfer"
                                                           : "method.mass",
            .reads = {Column::weights, Column::mass},
            .grid_fields = {"mass", "momentum", "force", "velocity", "acceleration"}},
           [method, kicks](State<Dim>& s) { return kicks ? kick_kernel(s, method) : mass_matrix_kernel(s, method); }}};
}

template <int Dim>
std::vector<GridFieldUse> inversion_fields(const Setup<Dim>& setup) {
  const int across = mass_nodes_across<Dim>(setup.method);
  const std::size_t number = sizeof(double), vector = GridField<Dim>::stride * number;
  const std::size_t entries = across == 0 ? 0 : MassStencil<Dim>::entries(across);
  return {{"solver", "vectors of the mass matrix's inversion", solver_fields(setup.method) * vector, {}, {}, true},
          {"inverse_mass", "1 / row sum of the mass matrix", number, {}, {}, true},
          {"mass_stencil", "the mass matrix, made once", entries * number, {}, {}, true}};
}

template std::vector<Pass<ASSAY_DIMENSION>> inversion_passes(const Setup<ASSAY_DIMENSION>&);
template std::vector<GridFieldUse> inversion_fields(const Setup<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
