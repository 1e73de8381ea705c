// SPDX-License-Identifier: BSD-3-Clause
// Our own particle methods with a mistake in them. usage: planted_mpm SCENE OUT.csv MISTAKE SIZE [KEY.PATH=YAML...]
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "harness/perturbed/mistake.hpp"
#include "mpm/simulation.hpp"

namespace {

using namespace assay;
using mpm::Column;

Vector3 turned(const Vector3& v, double angle) {
  return {std::cos(angle) * v[0] - std::sin(angle) * v[1], std::sin(angle) * v[0] + std::cos(angle) * v[1], 0};
}

/// One mistake by its name; what it does to a force is `spoil`.
class Planted : public Mistake {
 public:
  std::string name;
  double size = 0;

  Vector3 initial_velocity(const Vector3& v) const override { return is("initial_velocity") ? Vector3(size * v) : v; }
  double load_time(double t) const override {
    if (is("load_delay")) return std::max(0.0, t - size);
    return is("load_clock") ? size * t : t;
  }
  double mass() const override { return is("mass") ? size : 1; }
  double damping() const override { return is("damping") ? size : 0; }
  Vector3 traction(const Vector3& T, const Vector3&) const override { return is("tractions") ? Vector3(size * T) : T; }

  /// b for the right a and b of the point X, whose right place is x.
  Vector3 spoil(const Vector3& X, const Vector3& x, const Vector3& a, const Vector3& b) const {
    if (is("body_force")) return size * b;
    if (is("inertia_term")) return size * a + (b - a);
    if (is("stress_term")) return a + size * (b - a);
    // 0: the force stays where it was at t = 0; 2: it is turned twice
    if (is("force_rotation")) return turned(b, (size - 1) * std::atan2(X[0] * x[1] - X[1] * x[0], X.dot(x)));
    if (is("gravity")) return b - Vector3(0, size, 0);
    if (is("no_y")) return {b[0], 0, 0};
    return b;
  }
  bool is(const char* other) const { return name == other; }
};

/// Of the solution, with the tractions of the mistake.
class SpoiltInstant : public ExactInstant {
 public:
  SpoiltInstant(const ExactPoints& points, std::unique_ptr<ExactInstant> own, const Planted& planted, double end)
      : ExactInstant(points.X, points.Y), own_(std::move(own)), planted_(planted), end_(end) {}
  void set_time(double t) override { own_->set_time(std::min(end_, planted_.load_time(t))); }
  PlaneState state(std::size_t k) const override { return own_->state(k); }
  Point velocity(std::size_t k) const override { return own_->velocity(k); }
  Plane F_rate(std::size_t k) const override { return own_->F_rate(k); }
  Plane first_piola_kirchhoff(std::size_t k) const override {
    Plane P = own_->first_piola_kirchhoff(k);
    for (double& value : P) value = planted_.traction({value, 0, 0}, {})[0];
    return P;
  }
  PlaneInertia inertia(std::size_t k) const override { return own_->inertia(k); }
  void body_force(std::span<double> x, std::span<double> y, const InPieces& pieces) override {
    own_->body_force(x, y, pieces);
  }
  bool moves(std::size_t k) const override { return own_->moves(k); }

 private:
  std::unique_ptr<ExactInstant> own_;
  const Planted& planted_;
  double end_;
};

class SpoiltSolution : public ExactSolution {
 public:
  SpoiltSolution(ExactSolutionPtr own, double density, const Planted& planted, double end)
      : ExactSolution(own->motion(), density), own_(std::move(own)), planted_(planted), end_(end) {}
  std::unique_ptr<ExactInstant> instant(const ExactPoints& points, const Asked& asked) const override {
    return std::make_unique<SpoiltInstant>(points, own_->instant(points, asked), planted_, end_);
  }

 private:
  ExactSolutionPtr own_;
  const Planted& planted_;
  double end_;
};

void plant(std::vector<mpm::Pass<2>>& passes, const std::string& behind,
           const std::function<void(mpm::State<2>&, const mpm::Instant&)>& act) {
  for (std::size_t k = 0; k < passes.size(); ++k) {
    if (passes[k].name.rfind(behind, 0) != 0) continue;
    mpm::Pass<2> pass;
    pass.name = "planted behind " + behind, pass.slot = passes[k].slot, pass.stages = passes[k].stages;
    pass.bind = [act](mpm::State<2>& s) -> mpm::Kernel { return [&s, act](const mpm::Instant& now) { act(s, now); }; };
    passes.insert(passes.begin() + static_cast<std::ptrdiff_t>(++k), pass);
  }
}

Vector3 vector_of(const mpm::State<2>& s, Column column, std::size_t p) {
  return {s.column(column, 0)[p], s.column(column, 1)[p], 0};
}

void write(std::FILE* file, const mpm::State<2>& s, double t) {
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Vector3 X = vector_of(s, Column::reference_position, p), x = vector_of(s, Column::position, p);
    std::fprintf(file, "%.10g,%zu,%.15g,%.15g,%.15g,%.15g\n", t, p, X[0], X[1], x[0], x[1]);
  }
}

int run(const std::string& scene, const char* out, const Planted& planted, const std::vector<std::string>& sets) {
  drivers::Problem problem = drivers::assemble(drivers::read_scene(scene, sets), 1);
  const double end = problem.scene.time.end;
  problem.setup.accounts = false;
  const auto exact = drivers::exact_solution_of(problem.scene, problem.material, end);
  problem.setup.exact = std::make_shared<SpoiltSolution>(exact, problem.setup.density, planted, end);
  problem.setup.density *= planted.mass();
  std::unique_ptr<ExactInstant> fields;  // of the particles
  auto passes = mpm::compose(problem.setup);
  plant(passes, "body_force", [&](mpm::State<2>& s, const mpm::Instant& now) {
    const double t = std::min(end, planted.load_time(now.t));
    std::vector<double> X(s.particles), Y(s.particles), bx(s.particles), by(s.particles);
    const Column at = planted.is("force_place") ? Column::position : Column::reference_position;
    for (std::size_t p = 0; p < s.particles; ++p) X[p] = s.column(at, 0)[p], Y[p] = s.column(at, 1)[p];
    if (!fields || planted.is("force_place")) fields = exact->instant({X, Y}, {true, false, true, true});
    fields->set_time(t);
    fields->body_force(bx, by);
    for (std::size_t p = 0; p < s.particles; ++p) {
      const auto x = fields->state(p).x, a = fields->inertia(p).a;
      const Vector3 b = planted.spoil({X[p], Y[p], 0}, {x[0], x[1], 0}, {a[0], a[1], 0}, {bx[p], by[p], 0});
      for (int d = 0; d < 2; ++d) s.column(Column::body_force, d)[p] = b[d];
    }
  });
  plant(passes, "stress", [&](mpm::State<2>& s, const mpm::Instant& now) {
    for (int c = 0; c < mpm::stress_components<2> && planted.is("stiffness"); ++c) {
      for (std::size_t p = 0; p < s.particles; ++p) s.column(Column::stress, c)[p] *= planted.size;
    }
    const double kept = 1 - planted.damping() * now.dt;
    for (int d = 0; d < 2; ++d) {
      for (std::size_t p = 0; p < s.particles; ++p) s.column(Column::velocity, d)[p] *= kept;
    }
  });
  mpm::Simulation<2> simulation(problem.setup, passes);
  mpm::State<2>& s = simulation.state();
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Vector3 v = planted.initial_velocity(vector_of(s, Column::velocity, p));
    for (int d = 0; d < 2; ++d) s.column(Column::velocity, d)[p] = v[d];
  }
  std::FILE* file = std::fopen(out, "w");
  if (!file) return 2;
  std::fputs("t,id,X,Y,x,y\n", file);
  write(file, s, 0);
  for (std::int64_t k = 0, next = 1; k < problem.steps; ++k) {
    const double t = problem.time_of_step(k), later = problem.time_of_step(k + 1);
    if (simulation.step(t, later - t)) break;
    if (later < end * static_cast<double>(next) / 20 - 1e-12) continue;
    write(file, s, later), ++next;
  }
  return std::fclose(file) ? 2 : 0;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 5) return std::fputs("usage: planted_mpm SCENE OUT.csv MISTAKE SIZE [KEY.PATH=YAML...]\n", stderr), 2;
  Planted planted;
  planted.name = argv[3], planted.size = std::atof(argv[4]);
  return run(argv[1], argv[2], planted, {argv + 5, argv + argc});
} catch (const std::exception& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 2;
}
