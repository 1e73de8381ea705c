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
#include "mpm/seeding/gauss_lattice.hpp"

namespace assay::drivers {

namespace {

using mpm::Column;

/// Where component c of a column begins.
using ColumnView = std::function<const double*(Column, int)>;

/// Rearranges a column for VTK. The components of a particle stand side by side, and vectors and tensors have three
/// dimensions. A tensor in the plane brings its component 33 with it; if it has none, 33 is 1.
std::vector<double> interleaved(const ColumnView& of, std::size_t particles, const ShownColumn& shown) {
  constexpr std::size_t in_vector[] = {0, 1}, in_tensor[] = {0, 1, 3, 4, 8};
  const bool is_tensor = shown.components >= mpm::tensor_components<2>;
  const auto width = static_cast<std::size_t>(shown.width());
  std::vector<double> values(width * particles, 0.0);
  for (int c = 0; c < shown.components; ++c) {
    const double* from = of(shown.column, c);
    const std::size_t at = (is_tensor ? in_tensor : in_vector)[c];
    for (std::size_t p = 0; p < particles; ++p) values[width * p + at] = from[p];
  }
  const bool has_33 = !is_tensor || shown.components > mpm::tensor_components<2>;
  for (std::size_t p = 0; !has_33 && p < particles; ++p) values[width * p + 8] = 1;  // plane strain
  return values;
}

std::string particles_vtu(const std::vector<ShownColumn>& shown, const ColumnView& of, std::size_t particles,
                          const std::vector<VtuArray>& more, double t, const std::optional<double>& velocity_t = {}) {
  std::vector<std::int64_t> id(particles);
  for (std::size_t p = 0; p < particles; ++p) id[p] = static_cast<std::int64_t>(p);
  std::vector<std::vector<double>> values;
  for (const ShownColumn& one : shown) values.push_back(interleaved(of, particles, one));
  const std::vector<double>& position = values[1];
  std::vector<double> displacement(position);
  for (std::size_t k = 0; k < displacement.size(); ++k) displacement[k] -= values[0][k];
  std::vector<VtuArray> arrays{{"id", 1, std::span<const std::int64_t>(id)},
                               {"reference_position", 3, std::span<const double>(values[0])},
                               {"displacement", 3, std::span<const double>(displacement)}};
  for (std::size_t k = 2; k < shown.size(); ++k) {
    const std::string name(mpm::info(shown[k].column).name);
    arrays.push_back({name, shown[k].width(), std::span<const double>(values[k])});
  }
  arrays.insert(arrays.end(), more.begin(), more.end());
  return vtu_text(position, arrays, t, velocity_t);
}

/// What a comparison with the exact motion adds.
std::vector<VtuArray> compared_arrays(const Problem& problem, const std::vector<double>& error,
                                      const std::vector<double>& measure) {
  const bool vortex = is_vortex(problem.scene.motion);
  return {{"displacement_error", 1, std::span<const double>(error)},
          {vortex ? "shear" : "jacobian", 1, std::span<const double>(measure)}};
}

/// What pictures show: the ring with a margin; of a body whose outside moves all of it, on all of its way [m].
Box picture_box(const Problem& problem) {
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

Snapshots::Snapshots(const Problem& problem, OutputFolder& folder) : problem_(&problem), folder_(&folder) {
  const mpm::Setup<2>& setup = problem.setup;
  shown_ = {{Column::reference_position, 2}, {Column::position, 2}};
  for (const auto& use : mpm::columns_of(mpm::compose(setup), setup)) {
    if (mpm::info(use.column).roles & mpm::in_snapshots)
      shown_.push_back({use.column, static_cast<int>(use.bytes / sizeof(double))});
  }
}

void Snapshots::keep_good(const mpm::State<2>& s, double t) {
  good_t_ = t;
  good_particles_ = s.particles;
  good_.clear();  // keeps its memory
  for (const ShownColumn& part : shown_) {
    const double* from = s.column(part.column);
    good_.insert(good_.end(), from, from + static_cast<std::size_t>(part.components) * s.particles);
  }
}

std::string Snapshots::leave_last_good(const ExactSolutionPtr& exact) const {
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
    const auto field = as_seen(problem_->scene, exact)->instant({X(0), X(1)}, {.motion = true});
    field->set_time(good_t_);
    for (std::size_t p = 0; p < n; ++p) {
      const std::array<double, 2> x = field->state(p).x;
      error[p] = std::hypot(of(Column::position, 0)[p] - x[0], of(Column::position, 1)[p] - x[1]);
      std::array<double, 4> F{};
      for (int c = 0; c < 4; ++c) F[static_cast<std::size_t>(c)] = of(Column::deformation_gradient, c)[p];
      measure[p] = field->measure(p, F);
    }
    compared = compared_arrays(*problem_, error, measure);
  }
  std::string name = "last_good.vtu";
  folder_->write(name, particles_vtu(shown_, of, n, compared, good_t_));
  return name;
}

void Snapshots::write_vtu(const mpm::State<2>& s, const ErrorSampler* sampler, double t, double velocity_t) {
  std::vector<VtuArray> more;
  if (sampler) more = compared_arrays(*problem_, sampler->displacement_error(), sampler->measure());
  const auto of = [&s](Column which, int component) { return s.column(which, component); };
  const std::string name = particles_name(static_cast<int>(entries_.size()));
  folder_->write(name, particles_vtu(shown_, of, s.particles, more, t, velocity_t));
  entries_.push_back({t, name});
}

ParticleFrame Snapshots::frame_of(const mpm::State<2>& s, double t) const {
  ParticleFrame frame;
  frame.caption = "t = " + rounded_text(t, 4) + " s";
  const mpm::Seeds<2>& seeds = problem_->setup.seeds;
  // F is that of the edges, or of the diagonals
  const bool convects = mpm::traits_of<2>(problem_->setup.method.basis).convects;
  const double *x = s.column(Column::position, 0), *y = s.column(Column::position, 1);
  frame.x.assign(x, x + s.particles);
  frame.y.assign(y, y + s.particles);
  if (const auto& seen = problem_->scene.frame) {  // pictures follow the body's centre
    for (double& at : frame.x) at -= seen->velocity.x() * t;
    for (double& at : frame.y) at -= seen->velocity.y() * t;
  }
  std::optional<mpm::GaussCells> gauss;
  const Scene& scene = problem_->scene;
  if (scene.body.lattice == Body::Lattice::gauss) gauss.emplace(scene.grid->spacing, scene.body.per_cell);
  for (auto* edge : {&frame.r1x, &frame.r1y, &frame.r2x, &frame.r2y}) edge->resize(s.particles);
  for (std::size_t p = 0; p < s.particles; ++p) {
    std::array<double, 4> H{seeds.half_size[0], 0, 0, seeds.half_size[1]};
    if (!seeds.half_edges.empty()) H = seeds.half_edges[p];
    if (gauss) {  // the part of its cell that its weight stands for is not around it
      const std::array<double, 2> X = s.at<2>(Column::reference_position, p);
      const Rectangle r = gauss->rectangle_around(X);
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

void Snapshots::add(const mpm::State<2>& state, const ErrorSampler* sampler, double t, double velocity_t) {
  if (problem_->scene.output.writes_particles()) write_vtu(state, sampler, t, velocity_t);
  if (!problem_->scene.output.pictures || !sampler) return;
  show({t, frame_of(state, t), sampler->displacement_error(), sampler->measure()});
}

void Snapshots::remember(const mpm::State<2>& state, const ErrorSampler& sampler, double t) {
  if (!problem_->scene.output.pictures) return;
  latest_ = {t, frame_of(state, t), sampler.displacement_error(), sampler.measure()};
}

void Snapshots::show(Frame frame) {
  const double t = frame.t, half = 0.5 * problem_->period();
  const bool nearer = !frames_.empty() && std::abs(t - half) < std::abs(frames_.front().t - half);
  if (nearer) frames_.clear();
  if (frames_.size() > 1) frames_.resize(1);
  frames_.push_back(std::move(frame));
}

std::vector<Snapshots::Written> Snapshots::finish() {
  if (!entries_.empty()) folder_->write("particles.pvd", pvd_text(entries_));
  std::vector<Written> written;
  if (frames_.empty()) return written;
  if (!latest_.shape.x.empty() && latest_.t > frames_.back().t) show(std::move(latest_));
  ParticlePicture picture;
  const Motion& motion = problem_->scene.motion;
  const Box box = picture_box(*problem_);
  if (const auto ring = ring_of(motion)) picture.rings = {ring->inner, ring->outer};
  picture.lower = box.lower;
  picture.upper = box.upper;
  const auto add = [&](const std::string& name, const std::string& label, std::vector<double> Frame::*values,
                       const std::string& caption) {
    picture.value_label = label;
    picture.frames.clear();
    for (const Frame& frame : frames_) {
      picture.frames.push_back(frame.shape);
      picture.frames.back().value = frame.*values;
    }
    written.push_back({name, caption, png(picture)});
    folder_->write(name, written.back().png);
  };
  const auto farthest = [&](std::vector<double> Frame::*values, double from) {
    double most = 0;
    for (const Frame& frame : frames_) {
      for (const double value : frame.*values) most = std::max(most, std::isfinite(value) ? std::abs(value - from) : 0);
    }
    return most;
  };
  constexpr double rounding = 1e-9;  // of the range of colours: what is less is noise, and is not painted
  const double size = std::max(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
  picture.title = "Error of the displacement";
  picture.range = {0, std::max(farthest(&Frame::error, 0), rounding * size)};
  add("error.png", "|u − u_{exact}| [m]", &Frame::error,
      "Yellow particles are farthest from their exact positions. All moments have one scale.");
  picture.map = ColorMap::diverging;
  const bool vortex = is_vortex(motion);
  const double middle = vortex ? 0 : 1, most = std::max(farthest(&Frame::measure, middle), rounding);
  picture.title = vortex ? "Shear of the particles" : "Volume of the particles";
  picture.range = {middle - most, middle + most};
  if (vortex) {
    add("shear.png", "γ = 2ε [1]", &Frame::measure,
        "In the exact motion all particles of one radius have one colour. White particles are not sheared.");
  } else {
    add("jacobian.png", "J = det F [1]", &Frame::measure,
        "White particles have their initial volume. Red ones are larger, blue ones smaller.");
  }
  return written;
}

}  // namespace assay::drivers
