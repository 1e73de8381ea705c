// SPDX-License-Identifier: BSD-3-Clause
// The sections of a result, each with what it says of its figures (drivers/result/fields.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace assay::drivers {

using Figure = std::optional<double>;

/// In the file, null stands for a text that is empty.
inline std::optional<std::string> or_null(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

/// L2 (volume-weighted over the particles that the exact motion moves) and L-infinity of one field at one time.
struct FieldError {
  double l2 = 0, linf = 0;
};

/// One row of errors.csv.
struct ErrorSample {
  double t = 0;                     ///< [s]
  FieldError displacement;          ///< [m]
  double rms36 = 0;                 ///< (36) verbatim, over all particles [m]
  FieldError velocity;              ///< [m/s]
  FieldError deformation_gradient;  ///< Frobenius norm [1]
  FieldError jacobian;              ///< [1]
  FieldError stress;                ///< Cauchy, Frobenius norm [Pa]
};

struct FieldMaximum {
  Figure l2_max, linf_max;
};

struct ErrorFigures {
  Figure l2_half, l2_end, l2_max, linf_max;
  Figure rms36_half, rms36_end, rms36_max;
  FieldMaximum velocity, deformation_gradient, jacobian, stress;
  Figure relative;

  static void fields(auto& self, auto& archive) {
    archive("l2_half", self.l2_half, "m", "L2 error of the displacement at T/2",
            "of the nearest sample; null if none is within 5 %");
    archive("l2_end", self.l2_end, "m", "L2 error of the displacement at T", "the end of the run");
    archive("l2_max", self.l2_max, "m", "largest L2 error of the displacement", "over the samples");
    archive("linf_max", self.linf_max, "m", "largest error of a particle's displacement", "over the samples");
    archive("rms36_half", self.rms36_half, "m", "rms error of the displacement at T/2",
            "by equation (36), over all particles of the body");
    archive("rms36_end", self.rms36_end, "m", "rms error of the displacement at T",
            "by equation (36), at the end of the run");
    archive("rms36_max", self.rms36_max, "m", "largest rms error of the displacement",
            "by equation (36), over the samples");
    const auto field = [&](const char* key, auto& maximum, const char* unit, const std::string& of, const char* how) {
      archive.section(key, [&](auto& inner) {
        inner("l2_max", maximum.l2_max, unit, "largest L2 error of " + of, how);
        inner("linf_max", maximum.linf_max, unit, "largest error of " + of + " at a particle");
      });
    };
    field("velocity", self.velocity, "m/s", "the velocity", "over the samples");
    field("deformation_gradient", self.deformation_gradient, "1", "F", "in the Frobenius norm, over the samples");
    field("jacobian", self.jacobian, "1", "J", "with J = det F, over the samples");
    field("stress", self.stress, "Pa", "the Cauchy stress", "against that of the exact motion, in the Frobenius norm");
    archive("relative", self.relative, "1", "relative L2 error of the displacement",
            "that is error.l2_max divided by the largest L2 norm of the exact displacement in the body's own frame");
  }
};

struct PassFigures {
  std::string name;
  double seconds = 0;
  double bytes_per_particle = 0;

  static void fields(auto& self, auto& archive) {
    archive("name", self.name, "", "name of a pass: those of the step, then error_sampling and snapshots");
    archive("seconds", self.seconds, "s", "time of the pass");
    archive("bytes_per_particle", self.bytes_per_particle, "B",
            "bytes that it reads and writes in particle columns, a particle and step");
  }
};

struct SheetFigures {
  std::int64_t points = 0;
  double error_tau = 0;
  Figure error_dtau;
  Figure error_b;
  double wall_s = 0;
  bool cached = false;
  std::string along = {};  ///< what was taken along the run instead of a sheet: "400 shadow histories"; empty: nothing
  double asked = 0;        ///< force.tolerance

  static void fields(auto& self, auto& archive) {
    archive("points", self.points, "1", "number of points of the sheet, or of shadow histories");
    archive("error_tau", self.error_tau, "1", "stated error of the stress, relative to the largest component");
    archive("error_dtau", self.error_dtau, "1",
            "stated error of the slope of the stress, relative to the largest component; null for shadow histories");
    archive("error_b", self.error_b, "1",
            "estimated error of the body force of a vortex or twisting ring, divided by its largest value");
    archive("wall_s", self.wall_s, "s", "time to make or read the sheet");
    archive("cached", self.cached, "", "whether the sheet was read from disk");
  }
};

/// The stability screen; absent figures: not found.
struct ScreenFigures {
  std::string verdict;
  Figure t, xi, gamma;
  Figure smallest;
  int unjudged = 0;
  Figure largest_safe_amplitude;
  double wall_s = 0;

  static void fields(auto& self, auto& archive) {
    archive("verdict", self.verdict, "",
            "whether the motion is a stable solution for the model: stable; unstable; neutral, for a fluid");
    archive("t", self.t, "s", "time at which strong ellipticity is lost first; null if it is not lost");
    archive("xi", self.xi, "1", "place on the path at which strong ellipticity is lost first");
    archive("gamma", self.gamma, "1", "shear at which strong ellipticity is lost first");
    archive("smallest", self.smallest, "1",
            "smallest eigenvalue of the acoustic tensor of dP/dF on the path, divided by the largest at rest");
    archive("unjudged", self.unjudged, "1",
            "number of places on the path at which the screen could not judge; they count as stable");
    archive("largest_safe_amplitude", self.largest_safe_amplitude, "that of the peak",
            "largest peak amplitude for which strong ellipticity is not lost; null if it is not lost anyway");
    archive("wall_s", self.wall_s, "s", "time of the screen");
  }
};

/// A tabulated response against independent references: relative differences; absent where there is none.
struct ReferenceFigures {
  Figure closed_form, rate_form;

  static void fields(auto& self, auto& archive) {
    archive("closed_form", self.closed_form, "1",
            "largest relative difference of the tabulated stress to the closed form of the material; null without one");
    archive("rate_form", self.rate_form, "1",
            "largest relative difference of the increments to the rate form of the material; null without one");
  }
};

/// The narrowest zone in which a material with kinks has left its first regime, at the time of the peak.
struct RimFigures {
  double width = 0, cells = 0;

  static void fields(auto& self, auto& archive) {
    archive(
        "width", self.width, "m",
        "width of the narrowest zone of the ring that has left its first regime at the peak time; null without kinks");
    archive("cells", self.cells, "1", "rim.width divided by h");
  }
};

/// Exponential growth of the displacement's error under tractions.
struct GrowthFigures {
  double rate = 0, from = 0, to = 0;

  static void fields(auto& self, auto& archive) {
    archive("rate", self.rate, "1/s",
            "growth rate of the displacement's error under tractions; null if it does not grow exponentially");
    archive("from", self.from, "s", "begin of the time in which the error grows so");
    archive("to", self.to, "s", "end of the time in which the error grows so");
  }
};

/// One run of the comparison of traction algorithms.
struct TractionRun {
  std::string algorithm, form;    ///< words of the scene's keys; no form of undeformed_edges, which is neither
  double spacing = 0;             ///< of the grid
  std::array<double, 3> cells{};  ///< across the body; in the plane 0 along the third axis
  std::string outcome;
  Figure t;
  Figure l2_end, l2_max;
  bool exact = false, own = false;  ///< uses the exact solution; is of the scene's own algorithm

  static void fields(auto& self, auto& archive) {
    archive("algorithm", self.algorithm, "", "traction.algorithm with which the scene was run again");
    archive("form", or_null(self.form), "", "traction.form; null for undeformed_edges, which is neither");
    archive("spacing", self.spacing, "m", "node spacing of the grid: 4h, 2h or h");
    archive("outcome", self.outcome, "", "as outcome of the run; refused if it would exceed the limits");
    archive("t", self.t, "s", "time reached");
    archive("l2_end", self.l2_end, "m", "as error.l2_end of the run");
    archive("l2_max", self.l2_max, "m", "as error.l2_max of the run");
  }
};

struct TractionTable {
  std::vector<TractionRun> runs;  ///< algorithm by algorithm, from the coarsest grid to the scene's own
  bool of_paper = false;          ///< the problem of the paper's table 1
  double wall_s = 0;
};

struct DriftFigures {
  Figure mass, momentum, angular_momentum, energy;

  static void fields(auto& self, auto& archive) {
    archive("mass", self.mass, "1", "largest relative difference between the masses of the grid and of the particles");
    archive("momentum", self.momentum, "1",
            "largest difference of the momentum to initial value plus impulse, relative to the largest sum of m|v|");
    archive("angular_momentum", self.angular_momentum, "1",
            "largest difference of the angular momentum about the origin, relative to the largest sum of |x × m v|");
    archive(
        "energy", self.energy, "1",
        "kinetic energy plus work of the stress less work of the forces, relative to the largest of these energies");
  }
};

/// The worst that the watch over a run saw; absent: not looked for.
struct HealthFigures {
  Figure jacobian_min, fastest, courant, domain_extent, energy;

  static void fields(auto& self, auto& archive) {
    archive("jacobian_min", self.jacobian_min, "1", "smallest det F during the run");
    archive("fastest", self.fastest, "m/s", "speed of the fastest particle");
    archive("courant", self.courant, "1",
            "largest Courant number, from the fastest wave on the path and the speeds of the particles");
    archive("domain_extent", self.domain_extent, "cells",
            "farthest corner of a deformed domain (cpdi, cpdi2) from its particle; null for other bases");
    archive("energy", self.energy, "1",
            "kinetic energy divided by the largest kinetic energy that the known forces can have produced");
  }
};

}  // namespace assay::drivers
