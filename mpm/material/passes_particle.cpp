// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/material/passes_particle.hpp"

#include <cmath>

#include "mpm/data/dimension.hpp"
#include "mpm/material/material_batch.hpp"
#include "mpm/material/offload.hpp"

namespace assay::mpm {

namespace {

template <int Dim>
void end_stress(State<Dim>& s, BlockOutcome outcome) {
  s.material_calls += static_cast<std::int64_t>(s.particles);
  if (outcome.inverted) {
    const std::size_t p = *outcome.inverted;
    bool number = true;
    for (int c = 0; c < tensor_components<Dim>; ++c) {
      number = number && std::isfinite(s.column(Column::deformation_gradient, c)[p]);
    }
    s.finding = Finding{
        Finding::Kind::unstable, number ? "det F <= 0" : "F is not a finite number", static_cast<std::int64_t>(p), {}};
  } else if (outcome.refused) {
    s.finding = Finding{Finding::Kind::material_failed, outcome.message, static_cast<std::int64_t>(*outcome.refused),
                        std::move(outcome.step)};
  }
}

template <int Dim>
Kernel stress_kernel(State<Dim>& s) {
  auto materials = std::make_shared<MaterialBatches<Dim>>(s);
  if (s.setup.offload) {
    return [&s, materials](const Instant& now) { end_stress(s, materials->update_elsewhere(now)); };
  }
  Kernel kernel;
  kernel.block = [materials](const Instant& now, const Block& block) {
    return materials->update(block.begin, block.end, now);
  };
  kernel.end = [&s, materials](const Instant&, std::optional<std::size_t>) { end_stress(s, materials->take_first()); };
  return kernel;
}

}  // namespace

template <int Dim>
Pass<Dim> stress_pass(bool with_history) {
  Pass<Dim> pass;
  pass.name = "stress";
  pass.updates_material = true;
  pass.doc = "deformation gradient from L, Cauchy stress from the material";
  pass.called_for_by = "material.adapter";
  pass.reads = {Column::velocity_gradient, Column::deformation_gradient};
  pass.writes = {Column::deformation_gradient, Column::stress};
  if (with_history) {
    pass.reads.push_back(Column::history);
    pass.writes.push_back(Column::history);
  }
  pass.bind = stress_kernel<Dim>;
  return pass;
}

template Pass<ASSAY_DIMENSION> stress_pass<ASSAY_DIMENSION>(bool);

}  // namespace assay::mpm
