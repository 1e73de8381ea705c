// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/passes_affine.hpp"

#include "mpm/affine.hpp"
#include "mpm/bases.hpp"
#include "mpm/blocks.hpp"
#include "mpm/column_access.hpp"

namespace assay::mpm {

namespace {

/// L (I + dt L)^-1.
template <int Dim>
Mat<Dim> convected(const Mat<Dim>& L, double dt) {
  Mat<Dim> step;
  for (std::size_t c = 0; c < Dim * Dim; ++c) step[c] = (c % (Dim + 1) == 0 ? 1 : 0) + dt * L[c];
  return product<Dim>(L, inverse<Dim>(step));
}

}  // namespace

template <class B, int Dim>
Pass<Dim> affine_pass(const Method& method, bool knows_gradient) {
  Pass<Dim> pass;
  const bool moment = method.affine == Affine::moment, total = method.is_total(), fits = fits_gradient(method);
  pass.name = "affine";
  pass.doc = moment  ? "first moment of the grid velocity around the particles"
             : total ? "gradient of the grid velocity"
             : fits  ? "gradient fitted to the grid velocity around the particles, convected"
                     : "gradient of the grid velocity, convected";
  pass.called_for_by = "method.transfer";
  const bool from_column = knows_gradient && !moment && !fits;
  if (from_column) {
    pass.reads = {Column::velocity_gradient};
  } else {
    pass.reads = {Column::weights};
    pass.grid_fields = {"velocity"};
  }
  pass.writes = {Column::affine};
  pass.bind = [=](State<Dim>& s) -> Kernel {
    const B& basis = basis_of<B>(s);
    return [&s, &basis, moment, total, fits, from_column](const Instant& now) {
      const auto C = components<Dim * Dim>(s, Column::affine);
      const auto L = from_column ? components<Dim * Dim>(s, Column::velocity_gradient) : C;
      for_blocks(s.particles, s.setup.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
          Mat<Dim> found = moment || fits ? first_moment<Dim>(basis, p, s.motion)
                           : from_column  ? load(L, p)
                                          : velocity_gradient<Dim>(basis, p, s.motion);
          if (fits) found = product<Dim>(found, inverse<Dim>(second_moment<Dim>(basis, p)));
          if (!moment && !total) found = convected<Dim>(found, now.dt);
          for (std::size_t c = 0; c < Dim * Dim; ++c) C[c][p] = found[c];
        }
      });
    };
  };
  return pass;
}

template <class B, int Dim>
Pass<Dim> first_affine_moment_pass() {
  Pass<Dim> pass;
  pass.name = "first_affine_moment";
  pass.doc = "first moment of the initial velocity around the particles";
  pass.called_for_by = "method.affine";
  pass.once = true;
  pass.reads = {Column::weights, Column::affine};
  pass.writes = {Column::affine};
  pass.bind = [](State<Dim>& s) -> Kernel {
    const B& basis = basis_of<B>(s);
    return [&s, &basis](const Instant&) {
      const auto C = components<Dim * Dim>(s, Column::affine);
      for (std::size_t p = 0; p < s.particles; ++p) {
        const Mat<Dim> moment = product<Dim>(load(C, p), second_moment<Dim>(basis, p));
        for (std::size_t c = 0; c < Dim * Dim; ++c) C[c][p] = moment[c];
      }
    };
  };
  return pass;
}

#define ASSAY_PASSES(BASIS, DIM)                                        \
  template Pass<DIM> affine_pass<BASIS<DIM>, DIM>(const Method&, bool); \
  template Pass<DIM> first_affine_moment_pass<BASIS<DIM>, DIM>();

ASSAY_FOR_EACH_BASIS(ASSAY_PASSES)
#undef ASSAY_PASSES

}  // namespace assay::mpm
