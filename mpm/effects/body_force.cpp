// SPDX-License-Identifier: BSD-3-Clause
// b of the exact motion at the particles' reference positions, at the time at which the step begins.
#include "mpm/effects/body_force.hpp"

#include <exception>
#include <mutex>
#include <stdexcept>

#include "mpm/data/blocks.hpp"
#include "mpm/kernels/kernel_state.hpp"
#include "mpm/seeding/lattice.hpp"

namespace assay::mpm {

namespace {

void require_exact(const ExactSolutionPtr& exact) {
  if (!exact) throw std::invalid_argument("what a step needs of the exact motion has no exact solution");
}

template <int Dim>
std::array<std::span<const double>, Dim> reference_positions(const State<Dim>& s) {
  std::array<std::span<const double>, Dim> X;
  for (std::size_t d = 0; d < Dim; ++d) X[d] = std::span(s.column(Column::reference_position, d), s.particles);
  return X;
}

}  // namespace

template <int Dim>
std::shared_ptr<InstantOf<Dim>> fields_at(const State<Dim>& s, const std::array<std::span<const double>, Dim>& X,
                                          const Asked& asked) {
  require_exact(s.setup.exact);
  if constexpr (Dim == 2) {
    return s.setup.exact->instant({X[0], X[1]}, asked);
  } else {
    const auto& frame = s.setup.frame;
    return std::make_shared<SpaceInstant>(frame ? seen_from(*frame, s.setup.exact) : s.setup.exact, X, asked);
  }
}

template <int Dim>
std::shared_ptr<InstantOf<Dim>> fields_of_particles(const State<Dim>& s, const Asked& asked, Evaluation evaluation) {
  const auto X = reference_positions(s);
  if constexpr (Dim == 2) {
    require_exact(s.setup.exact);
    ExactPoints points{X[0], X[1]};
    if (evaluation == Evaluation::domain_average) {
      points.half = s.setup.seeds.half_size;
      points.domains = s.setup.seeds.domains;
    }
    return s.setup.exact->instant(points, asked);
  } else {
    return fields_at<Dim>(s, X, asked);
  }
}

namespace {

/// What a block of a loop threw, for the thread that began the loop.
class FromBlocks {
 public:
  void keep() {
    const std::lock_guard lock(guard_);
    if (!thrown_) thrown_ = std::current_exception();
  }
  void throw_again() {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  std::mutex guard_;
  std::exception_ptr thrown_;
};

/// Block by block at points.
template <int Dim>
Kernel body_force_in_space(State<Dim>& s) {
  const auto fields = fields_of_particles<Dim>(s, {.force = true}, Evaluation::point);
  const auto thrown = std::make_shared<FromBlocks>();
  Kernel kernel;
  kernel.begin = [fields](const Instant& now) { fields->set_time(now.t); };
  kernel.block = [&s, fields, thrown](const Instant&, const Block& block) {
    try {
      fields->body_force(block.begin, block.end, components<Dim>(s, Column::body_force));
    } catch (const std::exception&) {
      thrown->keep();
    }
    return none_bad;
  };
  kernel.end = [thrown](const Instant&, std::optional<std::size_t>) { thrown->throw_again(); };
  return kernel;
}

/// The domains of the seeds, or the boxes around them.
template <int Dim>
Hexahedra domains_of_seeds(const Seeds<Dim>& seeds) {
  if (seeds.domains) return *seeds.domains;
  std::vector<Vector3> X;
  for (std::size_t p = 0; p < seeds.size(); ++p) X.emplace_back(seeds.X[0][p], seeds.X[1][p], seeds.X[2][p]);
  return Hexahedra(boxes_around(X, {seeds.half_size[0], seeds.half_size[1], seeds.half_size[2]}));
}

template <int Dim>
Kernel mean_force_in_space(State<Dim>& s) {
  require_exact(s.setup.exact);
  const ExactSolutionPtr seen = s.setup.frame ? seen_from(*s.setup.frame, s.setup.exact) : s.setup.exact;
  const auto average = std::make_shared<HexahedronAverage>(domains_of_seeds(s.setup.seeds), s.setup.density);
  const InPieces pieces = [threads = s.setup.threads](std::size_t n, const auto& body) {
    for_blocks(n, threads, body);
  };
  return [&s, seen, average, pieces](const Instant& now) {
    const auto forces = average->at(*seen->slice(now.t), pieces);
    const auto b = components<Dim>(s, Column::body_force);
    for (std::size_t p = 0; p < s.particles; ++p) {
      for (std::size_t d = 0; d < Dim; ++d) b[d][p] = forces[p].b[static_cast<int>(d)];
    }
  };
}

}  // namespace

template <int Dim>
Kernel body_force_kernel(State<Dim>& s, Evaluation evaluation) {
  if constexpr (Dim == 3) {
    return evaluation == Evaluation::domain_average ? mean_force_in_space(s) : body_force_in_space(s);
  } else {
    const auto fields = fields_of_particles(s, {.force = true}, evaluation);
    const InPieces pieces = [threads = s.setup.threads](std::size_t n, const auto& body) {
      for_blocks(n, threads, body);
    };
    return [&s, fields, pieces](const Instant& now) {
      fields->set_time(now.t);
      fields->body_force(std::span(s.column(Column::body_force, 0), s.particles),
                         std::span(s.column(Column::body_force, 1), s.particles), pieces);
    };
  }
}

template <int Dim>
Pass<Dim> unbound_body_force() {
  Pass<Dim> pass;
  pass.name = "body_force";
  pass.slot = {Phase::body_force};
  pass.stages = Stages::kicks;
  pass.writes = {Column::body_force};
  return pass;
}

namespace {

/// b = a: where F is the same everywhere, and where the virtual stress leaves no more of b.
template <int Dim>
Kernel acceleration_kernel(State<Dim>& s) {
  const auto fields = fields_of_particles<Dim>(s, {.inertia = true});
  Kernel kernel;
  kernel.begin = [fields](const Instant& now) { fields->set_time(now.t); };
  kernel.block = [&s, fields](const Instant&, const Block& block) {
    const auto b = components<Dim>(s, Column::body_force);
    const auto& here = fields->window(block.begin, block.end);
    for (std::size_t p = block.begin; p < block.end; ++p) {
      const auto a = here.acceleration(p);
      for (std::size_t d = 0; d < Dim; ++d) b[d][p] = a[d];
    }
    return none_bad;
  };
  return kernel;
}

template <int Dim>
std::vector<Pass<Dim>> body_force_passes(const Setup<Dim>& setup) {
  Pass<Dim> pass = unbound_body_force<Dim>();
  const bool is_acceleration = setup.force_is_acceleration();  // no stress is left in it
  pass.doc = is_acceleration ? "b of the exact motion, which is its acceleration"
                             : "b of the exact motion at the particles' reference positions";
  pass.reads = {Column::reference_position};
  pass.bind = [is_acceleration](State<Dim>& s) {
    return is_acceleration ? acceleration_kernel(s) : body_force_kernel(s, Evaluation::point);
  };
  return {pass};
}

}  // namespace

template <int Dim>
EffectRecord<Dim> body_force_effect() {
  EffectRecord<Dim> effect{10, "the body force b of the exact motion acts on the particles", "force.response"};
  effect.called_for = [](const Setup<Dim>& s) { return s.body_force; };
  effect.passes = body_force_passes<Dim>;
  effect.columns = {{Column::body_force, "body_force", "m/s^2", "b of the exact motion",
                     [](const Setup<Dim>&) { return doubles(Dim); }}};
  effect.around = "the response from which b is computed";
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> body_force_effect();
template Pass<ASSAY_DIMENSION> unbound_body_force();
template Kernel body_force_kernel(State<ASSAY_DIMENSION>&, Evaluation);
template std::shared_ptr<InstantOf<ASSAY_DIMENSION>> fields_of_particles(const State<ASSAY_DIMENSION>&, const Asked&,
                                                                         Evaluation);
template std::shared_ptr<InstantOf<ASSAY_DIMENSION>> fields_at<ASSAY_DIMENSION>(
    const State<ASSAY_DIMENSION>&, const std::array<std::span<const double>, ASSAY_DIMENSION>&, const Asked&);

}  // namespace assay::mpm
