// SPDX-License-Identifier: BSD-3-Clause
// The exact solution: a motion, the stress with which a material answers it, and the body force that the balance of
// momentum asks for. Forces, tractions, errors and tables are all made of it.
//
//   ExactSolution --at(points)------> x, v, a, F, P, sigma, b of any points and times
//     |
//     +--slice(t)-------------------> ExactSlice --at(point)--> the same of one time, at many points
//     |    places(X)                    ExactPlaces: what is wanted of fixed points, quickly
//     |                                 HexahedronAverage: their means over domains
//     +--instant(points, asked)-----> ExactInstant --set_time(t)--> the plane fields of many fixed points
//     +--SpaceInstant---------------> the same in space, from places and slices: harness/exact/space_instant.hpp
//
//   four families    polar.cpp     vortex, twisting ring: tau(xi, t) of a Response
//                    uniform.cpp   F is the same everywhere: P(t)
//                    box.cpp       F depends on cos(pi X), cos(pi Y): P is a cosine series
//                    meridian.cpp  vortex3d: tau(xi, t), in meridian planes
//   around any       framed.cpp    as a frame sees it
//
// A solution never changes, and any number of threads may ask it. An instant belongs to one thread.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/exact/reference_domain.hpp"
#include "harness/exact/response.hpp"
#include "harness/motion/frame.hpp"
#include "harness/motion/motion.hpp"
#include "harness/numeric/parallel.hpp"

namespace assay {

class ExactPlaces;
struct FieldViews;
struct AxisAligned;
struct Vortex3d;

/// What is where a point is, and of its stress: in the plane 11, 12, 21, 22, 33; in space 11, 22, 33, 12, 13, 23.
template <int Dim>
struct FieldState {
  std::array<double, Dim> x{}, v{};              ///< [m], [m/s]
  std::array<double, Dim * Dim> F{};             ///< row-major [1]
  std::array<double, Dim == 2 ? 5 : 6> sigma{};  ///< Cauchy stress [Pa]; 0 where no stress was asked for
};
using PlaneState = FieldState<2>;
using SpaceState = FieldState<3>;

template <int Dim>
struct FieldInertia {
  std::array<double, Dim> a{};               ///< [m/s^2]
  std::array<double, Dim * Dim> gradient{};  ///< d a_i / d X_j, row-major [1/s^2]
};
using PlaneInertia = FieldInertia<2>;
using SpaceInertia = FieldInertia<3>;

struct PlaneMean {
  Point x{}, v{};  ///< [m], [m/s]
};

/// Fixed reference points. With a half size or domains they stand for particles, over whose domains b is averaged.
struct ExactPoints {
  std::span<const double> X, Y;                             ///< [m]
  Point half{};                                             ///< half edges of the rectangle around each [m]
  std::shared_ptr<const ReferenceDomains> domains = {};     ///< in a ring, if they are not these rectangles
  bool averages() const { return half[0] > 0 || domains; }  ///< else all is taken at the points
};

/// What an instant is made for: the rest is not computed.
struct Asked {
  bool motion = false, stress = false, inertia = false, force = false;
};

/// The fields at fixed points, at the time that was set. What is const may be asked by many threads.
class ExactInstant {
 public:
  ExactInstant(std::span<const double> X, std::span<const double> Y) : X_(X.begin(), X.end()), Y_(Y.begin(), Y.end()) {}
  virtual ~ExactInstant() = default;

  /// To any time until the end of the solution. Where a history stands behind the stress, going back begins it anew.
  /// Throws MaterialFailure.
  virtual void set_time(double t) = 0;

  virtual PlaneState state(std::size_t point) const = 0;                    ///< of motion, or of stress
  virtual Point velocity(std::size_t point) const = 0;                      ///< of motion [m/s]
  virtual Plane F_rate(std::size_t point) const = 0;                        ///< of motion [1/s]
  virtual Plane first_piola_kirchhoff(std::size_t point) const = 0;         ///< of stress [Pa]
  virtual PlaneInertia inertia(std::size_t point) const = 0;                ///< of inertia
  Point acceleration(std::size_t point) const { return inertia(point).a; }  ///< of inertia [m/s^2]

  /// Of force: writes b of all points, or their means [m/s^2].
  virtual void body_force(std::span<double> b_x, std::span<double> b_y, const InPieces& pieces = in_one_piece) = 0;

  /// Of motion: the means of x and v over a point's domain.
  virtual PlaneMean mean(std::size_t point) const {
    const PlaneState s = state(point);
    return {s.x, s.v};
  }

  /// x - X in the body's own frame [m].
  virtual Point displacement(std::size_t point) const {
    const Point x = state(point).x;
    return {x[0] - X_[point], x[1] - Y_[point]};
  }

  /// Whether the exact motion moves the point.
  virtual bool moves(std::size_t) const { return true; }

  /// Of a point's own F: component 21 of r^T F q (17), gamma = 2 eps of the vortex; of other motions det F [1].
  virtual double measure(std::size_t, const Plane& F) const { return F[0] * F[3] - F[1] * F[2]; }

  /// What some of the points are asked of, as in space: the instant itself.
  const ExactInstant& window(std::size_t, std::size_t) const { return *this; }
  const ExactInstant& window(const ExactInstant&) const { return *this; }

 protected:
  std::vector<double> X_, Y_;
};

/// A reference point at a time.
struct PlaceAndTime {
  Vector3 X = Vector3::Zero();  ///< [m]
  double t = 0;                 ///< [s]
};

struct ExactPoint {
  ExactState state;
  ExactStress stress;
};

/// What stands behind a stress that is not tabulated.
struct StressSource {
  std::int64_t points = 0;
  double error = 0;      ///< estimated, relative to the largest stress
  std::string what, by;  ///< "a cosine series of 8 x 8 modes", "an update" at each node; or "one history", ""
  std::int64_t material_calls = 0;
};

/// The solution at one time, anywhere. It never changes, and any number of threads may ask it.
class ExactSlice {
 public:
  virtual ~ExactSlice() = default;

  virtual ExactPoint at(const Vector3& X) const = 0;
  virtual Tensor first_piola_kirchhoff(const Vector3& X) const { return at(X).stress.first_piola_kirchhoff; }
  virtual ExactState state(const Vector3& X) const = 0;

  /// d a_i / d X_j: of the motion's own by central differences, exact to ten digits, where it has no formula [1/s^2].
  virtual Tensor acceleration_gradient(const Vector3& X) const;
  /// Over which the motion changes its course [m].
  virtual double length() const { return HUGE_VAL; }
  /// Whether the exact motion moves the point.
  virtual bool moves(const Vector3&) const { return true; }
  /// x - X in the body's own frame [m].
  virtual Vector3 displacement(const Vector3& X) const { return state(X).x - X; }
  /// Of a point's own F: gamma = 2 eps of a vortex, the component 21 on its baseline; of other motions det F [1].
  virtual double measure(const Vector3&, const Tensor& F) const { return F.determinant(); }

  /// What is smooth in a part of the body: that of the motion ends at its edges, of the stress also at fronts.
  enum class Smooth { motion, stress };
  /// A number for each part.
  virtual std::size_t part(const Vector3&, Smooth) const { return 0; }
  virtual bool has_parts(Smooth) const { return false; }  ///< there is more than one
};

class ExactSolution {
 public:
  ExactSolution(Motion motion, double density) : motion_(std::move(motion)), density_(density) {}
  virtual ~ExactSolution() = default;

  const Motion& motion() const { return motion_; }

  /// Called between points: the share that is done, of what.
  using Between = std::function<void(double share, const char* of)>;

  /// What is wanted of points at times of their own. Throws MaterialFailure.
  virtual void evaluate(std::span<const PlaceAndTime> points, const FieldViews& out, const Between& between = {}) const;

  /// One for each point, in their order. Throws MaterialFailure.
  virtual std::vector<ExactPoint> at(std::span<const PlaceAndTime> points, const Between& between = {}) const;
  ExactPoint at(const Vector3& X, double t) const { return at(std::array{PlaceAndTime{X, t}}).front(); }

  virtual ExactState state(const Vector3& X, double t) const { return motion_->at(X, t); }

  /// The reference point that is at x at time t, to rounding; absent where no point of the motion is [m].
  virtual std::optional<Vector3> reference_of(const Vector3& x, double t) const { return motion_->reference_of(x, t); }

  /// Lives no longer than the solution. Throws MaterialFailure, as its members do.
  virtual std::unique_ptr<const ExactSlice> slice(double t) const;

  /// Reference points X [m] that are asked at many times. Lives no longer than the solution.
  virtual std::unique_ptr<const ExactPlaces> places(std::vector<Vector3> X) const;

  virtual std::unique_ptr<ExactInstant> instant(const ExactPoints& points, const Asked& asked) const = 0;

  /// Whether the solution is the same after a turn about the origin.
  virtual bool is_axisymmetric() const { return false; }

  virtual const Response* response() const { return nullptr; }  ///< of a polar motion, else null
  virtual std::optional<StressSource> source() const { return std::nullopt; }

 protected:
  Motion motion_;
  double density_;  ///< rho0 [kg/m^3]
};

using ExactSolutionPtr = std::shared_ptr<const ExactSolution>;

/// Of a polar motion. Without a response it knows the motion alone. initial_cauchy: at rest, everywhere, with equal
/// components 11 and 22 and no shear [Pa].
ExactSolutionPtr exact_polar(const Motion& motion, double density, std::shared_ptr<const Response> response,
                             const Tensor& initial_cauchy = Tensor::Zero());

/// Of the vortex in three dimensions. Without a response it knows the motion alone: b = a.
ExactSolutionPtr exact_meridian(const Vortex3d& motion, double density, std::shared_ptr<const Response> response);

/// Of a motion whose F is the same everywhere, with P at any time [Pa].
ExactSolutionPtr exact_uniform(const Motion& motion, double density, const std::function<Tensor(double t)>& P);

/// The same with P of a material: by one update where stress is a function of F, else by a history with error control.
/// path: its baseline; end: last time [s]; tolerance: of a step, relative to the largest stress. Throws
/// MaterialFailure.
ExactSolutionPtr exact_uniform(const Motion& motion, double density, std::shared_ptr<const Material> material,
                               const Path& path, double end, double tolerance);

struct BoxOptions {
  double tolerance = 1e-6;                      ///< of P, relative to the largest
  double end = 1;                               ///< last time that is asked for [s]
  std::array<double, 3> direction = {1, 0, 0};  ///< of the material, along the axes
  Tensor initial_cauchy = Tensor::Zero();       ///< at rest, diagonal [Pa]
  int most_modes = 64;                          ///< in each direction
};

/// Of the motions in the unit box. Its series is made when an instant or its source is first asked for; single points
/// have histories of their own.
ExactSolutionPtr exact_box(const AxisAligned& motion, double density, std::shared_ptr<const Material> material,
                           const BoxOptions& options);

/// As a frame sees it. Points are where the frame sees them at rest: X' = R(0) X.
ExactSolutionPtr seen_from(const Frame& frame, ExactSolutionPtr own);

/// Replaces the body's own b, of all points or their means, by what the frame sees:
/// b' = R(t) (b + 2 w x v + w x (w x x)). own: an instant of motion, at the time t.
void see_body_force(const Frame& frame, const ExactInstant& own, double t, std::span<double> b_x,
                    std::span<double> b_y);

}  // namespace assay
