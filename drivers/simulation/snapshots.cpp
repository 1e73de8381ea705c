// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/snapshots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "drivers/scene/body_box.hpp"
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

/// What pictures show: the ring with a margin; of a body whose outside moves all of it, on all of its way [m].
Box picture_box(const PosedScene& problem) {
  const Scene& scene = problem.scene;
  if (!ring_of(scene.motion)) {
    Box box = swept_box(scene);
    const double margin = 0.05 * std::max(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
    for (std::size_t d = 0; d < 2; ++d) box.lower[d] -= margin, box.upper[d] += margin;
    return box;
  }
  double reach = 1.1 * ring_of(scene.motion)->outer;
  if (scene.body.domain != Body::Domain::ring && scene.body.outside != Body::Outside::held) {
    for (const double x : {scene.body.lower[0], scene.body.upper[0]}) {
      for (const double y : {scene.body.lower[1], scene.body.upper[1]}) {
        reach = std::max(reach, 1.03 * (scene.frame ? std::hypot(x, y) : std::max(std::abs(x), std::abs(y))));
      }
    }
  }
  return {{-reach, -reach}, {reach, reach}};
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
void Snapshots<Dim>::keep_good(const mpm::State<Dim>& s, double t) {
  good_t_ = t;
  good_particles_ = s.particles;
  good_.clear();  // keeps its memory
  for (const ShownColumn& part : shown_) {
    const double* from = s.column(part.column);
    good_.insert(good_.end(), from, from + static_cast<std::size_t>(part.components) * s.particles);
  }
}

template <int Dim>
std::string Snapshots<Dim>::leave_last_good(const ExactSolutionPtr& exact) const {
  const std::size_t n = good_particles_;
  const auto of = [&](Column which, int component) {
    auto before = static_cast<std::size_t>(component);
    for (auto part = shown_.begin(); part->column != which; ++part)
      before += static_cast<std::size_t>(part->components);
    return good_.data() + before * n;
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
  folder_->write(name, particles_vtu<Dim>(shown_, of, n, compared, good_t_));
  return name;
}

template <int Dim>
void Snapshots<Dim>::write_vtu(const mpm::State<Dim>& s, const ErrorSampler<Dim>* sampler, double t,
                               double velocity_t) {
  std::vector<VtuArray> more;
  if (sampler) more = compared_arrays(*problem_, sampler->displacement_error(), sampler->measure());
  const auto of = [&s](Column which, int component) { return s.column(which, component); };
  const std::string name = particles_name(static_cast<int>(entries_.size()));
  folder_->write(name, particles_vtu<Dim>(shown_, of, s.particles, more, t, velocity_t));
  entries_.push_back({t, name});
}

namespace {

/// The particles of a body in the plane, as their domains are.
ParticleFrame plane_frame(const Problem& problem, const mpm::State<2>& s, double t) {
  ParticleFrame frame;
  frame.caption = "t = " + rounded_text(t, 4) + " s";
  const mpm::Seeds<2>& seeds = problem.setup.seeds;
  // F is that of the edges, or of the diagonals
  const bool convects = mpm::traits_of<2>(problem.setup.method.basis).convects;
  const double *x = s.column(Column::position, 0), *y = s.column(Column::position, 1);
  frame.x.assign(x, x + s.particles);
  frame.y.assign(y, y + s.particles);
  if (const auto& seen = problem.scene.frame) {  // pictures follow the body's centre
    for (double& at : frame.x) at -= seen->velocity.x() * t;
    for (double& at : frame.y) at -= seen->velocity.y() * t;
  }
  std::optional<mpm::GaussCells<2>> gauss;
  const Scene& scene = problem.scene;
  if (scene.body.lattice == Body::Lattice::gauss) gauss.emplace(scene.grid->spacing, scene.body.per_cell.in<2>());
  for (auto* edge : {&frame.r1x, &frame.r1y, &frame.r2x, &frame.r2y}) edge->resize(s.particles);
  for (std::size_t p = 0; p < s.particles; ++p) {
    std::array<double, 4> H{seeds.half_size[0], 0, 0, seeds.half_size[1]};
    if (!seeds.half_edges.empty()) H = seeds.half_edges[p];
    if (gauss) {  // the part of its cell that its weight stands for is not around it
      const std::array<double, 2> X = s.at<2>(Column::reference_position, p);
      const Rectangle r = gauss->box_around(X);
      H = {0.5 * (r.upper[0] - r.lower[0]), 0, 0, 0.5 * (r.upper[1] - r.lower[1])};
      frame.x[p] += 0.5 * (r.lower[0] + r.upper[0]) - X[0];
      frame.y[p] += 0.5 * (r.lower[1] + r.upper[1]) - X[1];
    }
    std::array<double, 4> F{1, 0, 0, 1};
    if (convects) F = s.at<4>(Column::deformation_gradient, p);
    frame.r1x[p] = F[0] * H[0] + F[1] * H[2];
    frame.r2x[p] = F[0] * H[1] + F[1] * H[3];
    frame.r1y[p] = F[2] * H[0] + F[3] * H[2];
    frame.r2y[p] = F[2] * H[1] + F[3] * H[3];
  }
  return frame;
}

}  // namespace

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
    written.push_back({prefix + name, seen + caption, png(picture)});
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
    const Box box = picture_box(*problem_);
    if (const auto ring = ring_of(problem_->scene.motion)) picture.rings = {ring->inner, ring->outer};
    picture.lower = box.lower, picture.upper = box.upper;
    draw(0, "", picture, "", written);
  } else {
    constexpr double margin = 1.08;
    const double reach = margin * space_->reach();
    picture.lower.fill(-reach), picture.upper.fill(reach);
    const auto labels = space_->labels();
    picture.x_label = labels[0], picture.y_label = labels[1];
    draw(0, "cut_", picture, "A cut through the middle of the body. ", written);
    const double wide = 1.25 * reach;  // a box seen over its corner
    picture.lower.fill(-wide), picture.upper.fill(wide);
    picture.x_label = picture.y_label = "";
    draw(1, "view_", picture, "The body from aside. A quarter is left out, so that the inside is seen. ", written);
  }
  return written;
}

template class Snapshots<2>;
template class Snapshots<3>;

}  // namespace assay::drivers
