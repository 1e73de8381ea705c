// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/snapshots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "drivers/picture/author_units.hpp"
#include "drivers/simulation/picture_frames.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "mpm/seeding/gauss_lattice.hpp"

namespace assay::drivers {

namespace {

using mpm::Column;

/// Whether the measure of its particles is their shear, else their volume.
bool shows_shear(const Motion& motion) { return is_vortex(motion) || motion.as<Vortex3d>(); }

/// What a comparison with the exact motion adds.
std::vector<VtuArray> compared_arrays(const PosedScene& problem, const std::vector<double>& error,
                                      const std::vector<double>& measure) {
  const bool vortex = shows_shear(problem.scene.motion);
  return {{"displacement_error", 1, std::span<const double>(error)},
          {vortex ? "shear" : "jacobian", 1, std::span<const double>(measure)}};
}

}  // namespace

template <int Dim>
Snapshots<Dim>::Snapshots(const ProblemIn<Dim>& problem, OutputFolder& folder) : problem_(&problem), folder_(&folder) {
  const mpm::Setup<Dim>& setup = problem.setup;
  if constexpr (Dim == 3) {
    if (problem.scene.output.pictures && problem.compared) space_.emplace(problem);
  }
  shown_ = {{Column::reference_position, Dim}, {Column::position, Dim}};
  for (const auto& use : mpm::columns_of(mpm::compose(setup), setup)) {
    if (mpm::info(use.column).roles & mpm::in_snapshots)
      shown_.push_back({use.column, static_cast<int>(use.bytes / sizeof(double))});
  }
}

template <int Dim>
std::size_t Snapshots<Dim>::each_that_changes(std::size_t particles, const auto& kept) const {
  std::size_t at = 0;
  for (const ShownColumn& part : shown_) {
    if (part.column == Column::reference_position || part.column == Column::volume) continue;  // the seeds have them
    kept(part, at);
    at += static_cast<std::size_t>(part.components) * particles;
  }
  return at;
}

template <int Dim>
void Snapshots<Dim>::keep_good(const mpm::State<Dim>& s, double t) {
  good_t_ = t;
  good_particles_ = s.particles;
  each_that_changes(s.particles, [&](const ShownColumn& part, std::size_t at) {
    good_.put(at, {s.column(part.column), static_cast<std::size_t>(part.components) * s.particles});
  });
}

template <int Dim>
std::string Snapshots<Dim>::leave_last_good(const ExactSolutionPtr& exact) const {
  const std::size_t n = good_particles_;
  const mpm::Seeds<Dim>& seeds = problem_->setup.seeds;
  const std::vector<double> good = good_.first(each_that_changes(n, [](const ShownColumn&, std::size_t) {}));
  std::vector<double> volume(n);
  for (std::size_t p = 0; p < n; ++p) volume[p] = seeds.volume(p);
  const auto of = [&](Column which, int component) -> const double* {
    const auto c = static_cast<std::size_t>(component);
    if (which == Column::reference_position) return seeds.X[c].data();
    if (which == Column::volume) return volume.data();
    const double* found = nullptr;
    each_that_changes(n, [&](const ShownColumn& part, std::size_t at) {
      if (part.column == which) found = good.data() + at + c * n;
    });
    return found;
  };
  std::vector<double> error(n), measure(n);
  std::vector<VtuArray> compared;
  if (exact && n > 0) {
    const auto X = [&](int d) { return std::span(of(Column::reference_position, d), n); };
    const ExactSolutionPtr seen = as_seen(problem_->scene, exact);
    std::unique_ptr<InstantOf<Dim>> field;
    if constexpr (Dim == 2) field = seen->instant({X(0), X(1)}, {.motion = true});
    if constexpr (Dim == 3)
      field = std::make_unique<SpaceInstant>(seen, SpaceInstant::Points{X(0), X(1), X(2)}, Asked{.motion = true});
    field->set_time(good_t_);
    const auto& here = field->window(0, n);
    for (std::size_t p = 0; p < n; ++p) {
      const std::array<double, Dim> x = here.state(p).x;
      std::array<double, Dim * Dim> F{};
      for (int c = 0; c < Dim * Dim; ++c) F[static_cast<std::size_t>(c)] = of(Column::deformation_gradient, c)[p];
      const auto off = [&](int d) { return of(Column::position, d)[p] - x[static_cast<std::size_t>(d)]; };
      if constexpr (Dim == 2) error[p] = std::hypot(off(0), off(1));
      if constexpr (Dim == 3) error[p] = std::hypot(off(0), off(1), off(2));
      measure[p] = here.measure(p, F);
    }
    compared = compared_arrays(*problem_, error, measure);
  }
  std::string name = "last_good.vtu";
  write_particles(name, of, n, compared, good_t_, {}, false);
  return name;
}

template <int Dim>
void Snapshots<Dim>::write_particles(const std::string& name, const ColumnView& of, std::size_t particles,
                                     const std::vector<VtuArray>& more, double t,
                                     const std::optional<double>& velocity_t, bool is_state) const {
  if constexpr (Dim == 2) folder_->write(name, particles_vtu(shown_, of, particles, more, t, velocity_t));
  if constexpr (Dim == 3) {
    const SpaceDomains all(*problem_);
    const SpaceDomains::Now domains = all.now(of, is_state);
    folder_->write_pieces(
        name, [&](const PutBytes& put) { put_particles(put, shown_, of, domains, particles, more, t, velocity_t); });
  }
}

template <int Dim>
void Snapshots<Dim>::write_vtu(const mpm::State<Dim>& s, const ErrorSampler<Dim>* sampler, double t,
                               double velocity_t) {
  std::vector<VtuArray> more;
  if (sampler) more = compared_arrays(*problem_, sampler->displacement_error(), sampler->measure());
  const auto of = [&s](Column which, int component) { return s.column(which, component); };
  const std::string name = particles_name(static_cast<int>(entries_.size()));
  write_particles(name, of, s.particles, more, t, velocity_t, true);
  entries_.push_back({t, name});
}

template <int Dim>
typename Snapshots<Dim>::Frame Snapshots<Dim>::frame_of(const mpm::State<Dim>& s, const ErrorSampler<Dim>& sampler,
                                                        double t) const {
  const std::vector<double>&error = sampler.displacement_error(), &measure = sampler.measure();
  Frame frame{t, {}, 0, 0};
  const double at_rest = shows_shear(problem_->scene.motion) ? 0 : 1;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const auto size = [](double value) { return std::isfinite(value) ? std::abs(value) : 0; };
    frame.largest_error = std::max(frame.largest_error, size(error[p]));
    frame.farthest_measure = std::max(frame.farthest_measure, size(measure[p] - at_rest));
  }
  if constexpr (Dim == 2) {
    frame.drawn.push_back({plane_frame(*problem_, s, t), error, measure});
  } else {
    for (SpaceShapes shapes : {space_->cut(s, t), space_->view(s, t)}) {
      Drawn drawn{std::move(shapes.frame), {}, {}};
      for (const std::uint32_t p : shapes.particles)
        drawn.error.push_back(error[p]), drawn.measure.push_back(measure[p]);
      frame.drawn.push_back(std::move(drawn));
    }
  }
  return frame;
}

template <int Dim>
void Snapshots<Dim>::add(const mpm::State<Dim>& state, const ErrorSampler<Dim>* sampler, double t, double velocity_t) {
  if (problem_->scene.output.writes_particles()) write_vtu(state, sampler, t, velocity_t);
  if (problem_->scene.output.pictures && sampler) show(frame_of(state, *sampler, t));
}

template <int Dim>
void Snapshots<Dim>::remember(const mpm::State<Dim>& state, const ErrorSampler<Dim>& sampler, double t) {
  if (problem_->scene.output.pictures) latest_ = frame_of(state, sampler, t);
}

template <int Dim>
void Snapshots<Dim>::show(Frame frame) {
  const double t = frame.t, half = 0.5 * problem_->period();
  const bool nearer = !frames_.empty() && std::abs(t - half) < std::abs(frames_.front().t - half);
  if (nearer) frames_.clear();
  if (frames_.size() > 1) frames_.resize(1);
  frames_.push_back(std::move(frame));
}

template <int Dim>
void Snapshots<Dim>::draw(std::size_t way, const std::string& prefix, ParticlePicture picture, const std::string& seen,
                          std::vector<Written>& written) {
  const auto add = [&](const std::string& name, const std::string& label, std::vector<double> Drawn::*values,
                       const std::string& caption) {
    picture.value_label = label;
    picture.frames.clear();
    for (const Frame& frame : frames_) {
      picture.frames.push_back(frame.drawn[way].shape);
      picture.frames.back().value = frame.drawn[way].*values;
    }
    written.push_back({prefix + name, seen + caption, png(in_units(picture, problem_->scene.units))});
    folder_->write(written.back().name, written.back().png);
  };
  double largest_error = 0, farthest_measure = 0;
  for (const Frame& frame : frames_) {
    largest_error = std::max(largest_error, frame.largest_error);
    farthest_measure = std::max(farthest_measure, frame.farthest_measure);
  }
  constexpr double rounding = 1e-9;  // of the range of colours: what is less is noise, and is not painted
  const double size = std::max(picture.upper[0] - picture.lower[0], picture.upper[1] - picture.lower[1]);
  picture.title = "Error of the displacement";
  picture.range = {0, std::max(largest_error, rounding * size)};
  add("error.png", "|u − u_{exact}| [m]", &Drawn::error,
      "Yellow particles are farthest from their exact positions. All moments have one scale.");
  picture.map = ColorMap::diverging;
  const bool vortex = shows_shear(problem_->scene.motion);
  const double middle = vortex ? 0 : 1, most = std::max(farthest_measure, rounding);
  picture.title = vortex ? "Shear of the particles" : "Volume of the particles";
  picture.range = {middle - most, middle + most};
  if (vortex) {
    add("shear.png", "γ = 2ε [1]", &Drawn::measure,
        std::string("In the exact motion all particles of one radius have one colour") +
            (Dim == 3 ? " in the cut across the axis" : "") + ". White particles are not sheared.");
  } else {
    add("jacobian.png", "J = det F [1]", &Drawn::measure,
        "White particles have their initial volume. Red ones are larger, blue ones smaller.");
  }
}

template <int Dim>
std::vector<typename Snapshots<Dim>::Written> Snapshots<Dim>::finish() {
  if (!entries_.empty()) folder_->write("particles.pvd", pvd_text(entries_));
  std::vector<Written> written;
  if (frames_.empty()) return written;
  if (!latest_.drawn.empty() && latest_.t > frames_.back().t) show(std::move(latest_));
  ParticlePicture picture;
  if constexpr (Dim == 2) {
    const Box box = plane_window(*problem_);
    if (const auto ring = ring_of(problem_->scene.motion)) picture.rings = {ring->inner, ring->outer};
    picture.lower = box.lower, picture.upper = box.upper;
    draw(0, "", picture, "", written);
  } else {
    const auto shapes = [&](std::size_t way) {
      std::vector<const ParticleFrame*> all;
      for (const Frame& frame : frames_) all.push_back(&frame.drawn[way].shape);
      return all;
    };
    const auto labels = space_->labels();
    picture.x_label = labels[0], picture.y_label = labels[1];
    show_all(shapes(0), space_->reach_of_cut(), picture);
    draw(0, "cut_", picture, "A cut through the middle of the body, " + space_->cut_words() + ". ", written);
    picture.x_label = picture.y_label = "";
    picture.space_axes = space_->axes_of_view();
    show_all(shapes(1), space_->reach_of_view(), picture);
    draw(1, "view_", picture,
         "The body from aside, without a quarter of it, so that the inside is seen. Faces turned from the light are "
         "darker. ",
         written);
  }
  return written;
}

template class Snapshots<2>;
template class Snapshots<3>;

}  // namespace assay::drivers
