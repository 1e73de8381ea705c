// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/effects/passes_body_force.hpp"

#include "harness/exact/box_force.hpp"
#include "harness/exact/domain_average.hpp"
#include "harness/exact/frame_force.hpp"
#include "harness/exact/inertia.hpp"
#include "mpm/data/blocks.hpp"
#include "mpm/kernels/column_access.hpp"
#include "mpm/seeding/lattice.hpp"

namespace assay::mpm {

namespace {

ReferenceDomains domains_of_setup(const Setup<2>& setup) {
  return setup.seeds.domains ? *setup.seeds.domains : rectangles_of(setup.seeds, *ring_of(*setup.motion));
}

/// b = a: where F is the same everywhere, and where the virtual stress leaves no more of b.
Kernel acceleration_kernel(State<2>& s) {
  const std::span X(s.column(Column::reference_position, 0), s.particles),
      Y(s.column(Column::reference_position, 1), s.particles);
  auto field = std::make_shared<InertiaField>(*s.setup.motion, 0, X, Y);
  Kernel kernel;
  kernel.begin = [field](const Instant& now) { field->set_time(now.t); };
  kernel.block = [&s, field](const Instant&, const Block& block) {
    const auto b = components<2>(s, Column::body_force);
    for (std::size_t p = block.begin; p < block.end; ++p) {
      const auto a = field->at(p).a;
      for (std::size_t d = 0; d < 2; ++d) b[d][p] = a[d];
    }
    return none_bad;
  };
  return kernel;
}

/// Of the axis-aligned motion: its series, at points or on the mean over the domains.
Kernel box_kernel(State<2>& s, Evaluation evaluation) {
  const Point half = evaluation == Evaluation::point ? Point{} : s.setup.seeds.half_size;
  std::vector<Rectangle> places;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Point X{s.column(Column::reference_position, 0)[p], s.column(Column::reference_position, 1)[p]};
    places.push_back({{X[0] - half[0], X[1] - half[1]}, {X[0] + half[0], X[1] + half[1]}});
  }
  const auto stress = *s.setup.exact->box();
  auto force = std::make_shared<BoxForce>(*stress, s.setup.density, places);
  return [&s, stress, force](const Instant& now) {
    stress->set_time(now.t);
    force->evaluate(*stress, now.t, std::span(s.column(Column::body_force, 0), s.particles),
                    std::span(s.column(Column::body_force, 1), s.particles));
  };
}

[[maybe_unused]] Kernel averaged_kernel(State<2>& s) {
  if (is_box(*s.setup.motion)) return box_kernel(s, Evaluation::domain_average);
  auto field = std::make_shared<DomainAverage>(*s.setup.motion, s.setup.density, domains_of_setup(s.setup));
  const InPieces pieces = [threads = s.setup.threads](std::size_t n, const auto& body) {
    for_blocks(n, threads, body);
  };
  return [&s, field, pieces](const Instant& now) {
    field->evaluate(*s.setup.response, now.t, std::span(s.column(Column::body_force, 0), s.particles),
                    std::span(s.column(Column::body_force, 1), s.particles), pieces);
  };
}

}  // namespace

template <int Dim>
Pass<Dim> body_force_pass(Evaluation evaluation, bool is_acceleration) {
  Pass<Dim> pass;
  pass.name = "body_force";
  pass.effects = {Effect::body_force};
  pass.stages = Stages::kicks;
  pass.writes = {Column::body_force};
  if (is_acceleration) {
    pass.doc = "b of the exact motion, which is its acceleration";
    pass.called_for_by = "force.response";
    pass.reads = {Column::reference_position};
    pass.bind = acceleration_kernel;
    return pass;
  }
  if constexpr (compiled(Effect::averaging)) {
    if (evaluation == Evaluation::domain_average) {
      pass.doc = "b of the exact motion, averaged over the particles' reference domains";
      pass.called_for_by = "force.evaluation";
      pass.effects.push_back(Effect::averaging);
      pass.bind = averaged_kernel;
      return pass;
    }
  }
  pass.doc = "b of the exact motion at the particles' reference positions";
  pass.called_for_by = "force.response";
  pass.reads = {Column::reference_position};
  pass.bind = [](State<Dim>& s) -> Kernel {
    if (is_box(*s.setup.motion)) return box_kernel(s, Evaluation::point);
    const std::size_t n = s.particles;
    auto field = std::make_shared<BodyForceField>(*s.setup.motion, s.setup.density,
                                                  std::span(s.column(Column::reference_position, 0), n),
                                                  std::span(s.column(Column::reference_position, 1), n));
    return [&s, field, n](const Instant& now) {
      field->evaluate(*s.setup.response, now.t, std::span(s.column(Column::body_force, 0), n),
                      std::span(s.column(Column::body_force, 1), n));
    };
  };
  return pass;
}

template <int Dim>
Pass<Dim> moving_frame_pass(Evaluation evaluation) {
  Pass<Dim> pass;
  pass.name = "moving_frame";
  pass.stages = Stages::kicks;
  pass.doc = "b turned into the spinning frame, with its Coriolis and centrifugal terms";
  pass.called_for_by = "frame.spin";
  pass.effects = {Effect::moving_frame};
  pass.reads = {Column::reference_position, Column::body_force};
  pass.writes = {Column::body_force};
  pass.bind = [evaluation](State<Dim>& s) -> Kernel {
    const double spin = s.setup.frame->spin;
    const std::span X(s.column(Column::reference_position, 0), s.particles),
        Y(s.column(Column::reference_position, 1), s.particles);
    auto force = evaluation == Evaluation::point
                     ? std::make_shared<FrameForce>(*s.setup.motion, spin, X, Y)
                     : std::make_shared<FrameForce>(*s.setup.motion, spin, X, Y, domains_of_setup(s.setup));
    return [&s, force](const Instant& now) {
      force->apply(now.t, std::span(s.column(Column::body_force, 0), s.particles),
                   std::span(s.column(Column::body_force, 1), s.particles));
    };
  };
  return pass;
}

// The body force lives in the plane; three dimensions serve the property tests of transfer and stress.
template Pass<2> body_force_pass<2>(Evaluation, bool);
template Pass<2> moving_frame_pass<2>(Evaluation);

}  // namespace assay::mpm
