// SPDX-License-Identifier: BSD-3-Clause
// What a point of an exact solution costs: of the plane vortex and of the one in three dimensions, whole and means.
#include <benchmark/benchmark.h>

#include <random>

#include "drivers/material/material_choice.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "harness/exact/hexahedra.hpp"
#include "harness/exact/places.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/kinds/vortex3d.hpp"

namespace {

using namespace assay;

constexpr double rho = 1000, end = 1;

std::shared_ptr<const Material> material_named(const std::string& text) {
  drivers::Scene scene = drivers::scene_from_text("motion: {type: vortex}\nmaterial: {density: 1000, " + text + "}\n",
                                                  "bench", {}, Interpolation::linear);
  std::string library;
  return drivers::material_of(scene, library);
}

const std::string elastic = "adapter: neo_hookean, parameters: {E: 1.0e+3, nu: 0.3}";
const std::string plastic =
    "adapter: j2_jaumann, parameters: {E: 1.0e+6, nu: 0.3, yield_stress: 1.5e+4, hardening_modulus: 1.0e+5}";
const std::string viscous = "adapter: zener, parameters: {E: 1.0e+4, nu: 0.3, relaxation_time: 0.1}";

/// tabulated: though there is a closed form.
std::shared_ptr<const Response> response_of(const std::string& text, const Path& path, bool tabulated = false) {
  const auto material = material_named(text);
  if (text == elastic && !tabulated) return std::make_shared<const Response>(*ClosedForm::of(material, path));
  return std::make_shared<const Response>(Sheet(*material, path, {.tolerance = 1e-8, .end = end}));
}

Vortex plane() { return {.profile_power = 4, .amplitude = {Amplitude::Type::sine, 0.1, 1}}; }
Vortex3d ball() { return {{.axis = {1, 2, 3}}, {}, {Amplitude::Type::sine, 0.1, 1}}; }

ExactSolutionPtr solution(const std::string& text, bool in_space, bool tabulated = false) {
  if (in_space) return exact_meridian(ball(), rho, response_of(text, ball().baseline(), tabulated));
  return exact_polar(plane(), rho, response_of(text, Motion(plane())->baseline(), tabulated));
}

/// Random points of the ring or of the ball: no two share a radius.
std::vector<Vector3> points_of(bool in_space, std::size_t n) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> place(-1.25, 1.25);
  std::vector<Vector3> points;
  while (points.size() < n) {
    const Vector3 X(place(generator), place(generator), in_space ? place(generator) : 0);
    if (in_space ? ball().place(X).has_value() : plane().moves(X)) points.push_back(X);
  }
  return points;
}

/// x, v, a, F, P, sigma and b of 10,000 points at one time.
void at_points(benchmark::State& state, const std::string& text, bool in_space) {
  constexpr std::size_t n = 10'000;
  const auto exact = solution(text, in_space);
  std::vector<PlaceAndTime> points;
  for (const Vector3& X : points_of(in_space, n)) points.push_back({X, 0.4});
  for (auto _ : state) {
    for (PlaceAndTime& point : points) point.t += 1e-6;
    benchmark::DoNotOptimize(exact->at(points));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(n) * state.iterations());
}

/// The same of the plane vortex as a run asks for it, through an instant of registered points.
void in_instant(benchmark::State& state, const std::string& text) {
  constexpr std::size_t n = 10'000;
  const auto exact = solution(text, false);
  std::vector<double> X, Y, b_x(n), b_y(n);
  for (const Vector3& at : points_of(false, n)) X.push_back(at.x()), Y.push_back(at.y());
  const auto now = exact->instant({X, Y}, {.motion = true, .stress = true, .inertia = true, .force = true});
  double t = 0.4;
  for (auto _ : state) {
    now->set_time(t += 1e-6);
    now->body_force(b_x, b_y);
    for (std::size_t p = 0; p < n; ++p) {
      benchmark::DoNotOptimize(now->state(p));
      benchmark::DoNotOptimize(now->inertia(p));
      benchmark::DoNotOptimize(now->first_piola_kirchhoff(p));
    }
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(n) * state.iterations());
}

/// b alone of 20,000 registered points, at a new time each, as another code asks for it.
void at_places(benchmark::State& state, const std::string& text, bool in_space) {
  constexpr std::size_t n = 20'000;
  const auto exact = solution(text, in_space, true);
  const auto places = exact->places(points_of(in_space, n));
  std::vector<double> b(3 * n);
  const FieldViews wanted{.b = {b.data(), 3, 1}};
  double t = 0.4;
  for (auto _ : state) {
    places->evaluate(*exact->slice(t += 1e-6), 0, n, wanted);
    benchmark::DoNotOptimize(b.data());
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(n) * state.iterations());
}

/// x, v, a, F, P, sigma and b of them.
void all_at_places(benchmark::State& state, const std::string& text, bool in_space) {
  constexpr std::size_t n = 20'000;
  const auto exact = solution(text, in_space, true);
  const auto places = exact->places(points_of(in_space, n));
  std::vector<PointFields> fields(n);
  FieldViews wanted = PointFields::views(fields.data());
  wanted.static_force = {};
  double t = 0.4;
  for (auto _ : state) {
    places->evaluate(*exact->slice(t += 1e-6), 0, n, wanted);
    benchmark::DoNotOptimize(fields.data());
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(n) * state.iterations());
}

/// Means of b over the cubes of a lattice in the ball.
void means_in_ball(benchmark::State& state, const std::string& text) {
  constexpr double edge = 1.0 / 16;
  const auto exact = solution(text, true);
  std::vector<Vector3> centres;
  for (double x = -1 + edge / 2; x < 1; x += edge) {
    for (double y = -1 + edge / 2; y < 1; y += edge) {
      for (double z = -1 + edge / 2; z < 1; z += edge) {
        if (ball().place({x, y, z})) centres.emplace_back(x, y, z);
      }
    }
  }
  const HexahedronAverage average(Hexahedra(boxes_around(centres, Vector3::Constant(edge / 2))), rho);
  for (auto _ : state) benchmark::DoNotOptimize(average.at(*exact->slice(0.4)));
  state.SetItemsProcessed(static_cast<std::int64_t>(centres.size()) * state.iterations());
}

/// A ball of a million points from the material on: one sheet, then b of all points at one time.
void million_points(benchmark::State& state) {
  constexpr std::size_t n = 1'000'000;
  const std::vector<Vector3> points = points_of(true, n);
  for (auto _ : state) {
    const auto exact = solution(plastic, true);
    const auto slice = exact->slice(0.4);
    Vector3 sum = Vector3::Zero();
    for (const Vector3& X : points) sum += slice->at(X).stress.body_force;
    benchmark::DoNotOptimize(sum);
    state.counters["material_calls"] = static_cast<double>(exact->response()->sheet()->material_calls());
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(n) * state.iterations());
}

BENCHMARK_CAPTURE(at_points, plane_neo_hookean, elastic, false);
BENCHMARK_CAPTURE(at_points, ball_neo_hookean, elastic, true);
BENCHMARK_CAPTURE(at_points, plane_j2, plastic, false);
BENCHMARK_CAPTURE(at_points, ball_j2, plastic, true);
BENCHMARK_CAPTURE(in_instant, plane_neo_hookean, elastic);
BENCHMARK_CAPTURE(in_instant, plane_j2, plastic);
BENCHMARK_CAPTURE(at_places, plane_neo_hookean, elastic, false);
BENCHMARK_CAPTURE(at_places, plane_zener, viscous, false);
BENCHMARK_CAPTURE(at_places, plane_j2, plastic, false);
BENCHMARK_CAPTURE(at_places, ball_neo_hookean, elastic, true);
BENCHMARK_CAPTURE(at_places, ball_zener, viscous, true);
BENCHMARK_CAPTURE(at_places, ball_j2, plastic, true);
BENCHMARK_CAPTURE(all_at_places, plane_neo_hookean, elastic, false);
BENCHMARK_CAPTURE(all_at_places, plane_zener, viscous, false);
BENCHMARK_CAPTURE(all_at_places, plane_j2, plastic, false);
BENCHMARK_CAPTURE(all_at_places, ball_neo_hookean, elastic, true);
BENCHMARK_CAPTURE(all_at_places, ball_zener, viscous, true);
BENCHMARK_CAPTURE(all_at_places, ball_j2, plastic, true);
BENCHMARK_CAPTURE(means_in_ball, neo_hookean, elastic)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(means_in_ball, j2, plastic)->Unit(benchmark::kMillisecond);
BENCHMARK(million_points)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
