// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/export/force_expressions.hpp"

#include <algorithm>

#include "drivers/export/expression_text.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

/// Keeps R from zero at the axis, where it divides; far below the rounding of the radii of the ring [m^2].
constexpr const char* tiny = "1e-30";

Interval interval(const std::vector<double>& edges, std::size_t k) { return {edges[k], edges[k + 1]}; }

/// (1 - s^2)^m, s from -1 to 1 over the ring.
std::string profile_words(const ExpressionText& say, const Vortex& vortex, const std::string& R) {
  const std::string s = say.mapped({vortex.inner, vortex.outer}, R);
  return "(1-" + s + "*" + s + ")^" + std::to_string(vortex.profile_power);
}

AmplitudeWords amplitude_words(const ExpressionText& say) {
  AmplitudeWords words;
  words.number = [&say](double value) { return "(" + say.number(value) + ")"; };
  words.least = [](const std::string& t, const std::string& T) {
    return "(" + t + "*(" + t + "<" + T + ")+" + T + "*(" + t + ">=" + T + "))";
  };
  return words;
}

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

/// v = g'(0) h E_z x X.
std::array<std::string, 2> velocity_words(const ExpressionText& say, const Vortex& vortex,
                                          const std::string& omega_of_h, const std::string& X, const std::string& Y) {
  const std::string rate = say.number(vortex.amplitude.at(0).rate);
  return {"0-(" + rate + ")*" + omega_of_h + "*" + Y, "(" + rate + ")*" + omega_of_h + "*" + X};
}

/// Whether t lies in a slab, as a factor: the first one has no beginning, and the last one no end.
std::string in_slab(const ForcePieces& pieces, std::size_t slab, const ExpressionText& say, const std::string& t) {
  std::string text;
  if (slab > 0) text = "(" + t + ">=" + say.number(pieces.times[slab]) + ")";
  if (slab + 1 < pieces.slabs())
    text += (text.empty() ? "" : "*") + ("(" + t + "<" + say.number(pieces.times[slab + 1]) + ")");
  return text;
}

/// Whether R lies in a ring.
std::string in_ring(const ForcePieces& pieces, std::size_t ring, const ExpressionText& say, const std::string& R) {
  const bool last = ring + 1 == pieces.rings();
  return "(" + R + ">=" + say.number(pieces.radii[ring]) + ")*(" + R + (last ? "<=" : "<") +
         say.number(pieces.radii[ring + 1]) + ")";
}

/// Variables of LAMMPS. What depends on the time alone is equal-style, so an atom has one polynomial of R to do.
class LammpsLines {
 public:
  explicit LammpsLines(const ForcePieces& pieces) : pieces_(pieces), say_(numbers_) {}

  std::string text(ForceCoordinates at) {
    const bool reference = at == ForceCoordinates::reference;
    const std::string X = reference ? "f_ref[1]" : "x", Y = reference ? "f_ref[2]" : "y";
    equal("b_t", "step*dt");
    for (std::size_t slab = 0; slab < pieces_.slabs(); ++slab)
      equal("b_u" + std::to_string(slab), say_.mapped(interval(pieces_.times, slab), "v_b_t"));
    atom("b_R", "sqrt(" + X + "*" + X + "+" + Y + "*" + Y + "+" + tiny + ")");
    for (std::size_t ring = 0; ring < pieces_.rings(); ++ring)
      atom("b_s" + std::to_string(ring), say_.mapped(interval(pieces_.radii, ring), "v_b_R"));
    for (std::size_t c = 0; c < 2; ++c) component(c);
    if (reference) {
      atom("b_alpha", without_blanks(amplitude_expression(pieces_.vortex.amplitude, "v_b_t", amplitude_words(say_))) +
                          "*" + profile_words(say_, pieces_.vortex, "v_b_R"));
      atom("b_c", "(" + X + "*cos(v_b_alpha)-" + Y + "*sin(v_b_alpha))/v_b_R");
      atom("b_d", "(" + Y + "*cos(v_b_alpha)+" + X + "*sin(v_b_alpha))/v_b_R");
    } else {
      atom("b_c", "x/v_b_R");
      atom("b_d", "y/v_b_R");
    }
    atom("b_x", "v_b_c*v_b_along0-v_b_d*v_b_along1");
    atom("b_y", "v_b_d*v_b_along0+v_b_c*v_b_along1");
    if (!pieces_.quasi_static) velocities();
    return lines_;
  }

 private:
  void equal(const std::string& name, const std::string& formula) {
    lines_ += "variable " + name + " equal " + formula + "\n";
  }
  void atom(const std::string& name, const std::string& formula) {
    lines_ += "variable " + name + " atom " + formula + "\n";
  }

  /// The coefficient of s^p is the sum over slabs and terms of P_p Q(u).
  void component(std::size_t c) {
    std::string sum;
    for (std::size_t ring = 0; ring < pieces_.rings(); ++ring) {
      const std::string here = std::to_string(c) + "_" + std::to_string(ring);
      std::vector<std::string> powers;
      for (std::size_t slab = 0; slab < pieces_.slabs(); ++slab) {
        const ForceSeries& series = pieces_.piece(slab, ring)[c];
        for (std::size_t m = 0; m < series.size(); ++m) {
          const std::string name = "b_q" + here + "_" + std::to_string(slab) + "_" + std::to_string(m);
          const std::string now = in_slab(pieces_, slab, say_, "v_b_t");
          const std::string Q = say_.horner(series[m].Q, "v_b_u" + std::to_string(slab));
          equal(name, now.empty() ? Q : now + "*(" + Q + ")");
          powers.resize(std::max(powers.size(), series[m].P.size()));
          for (std::size_t p = 0; p < series[m].P.size(); ++p)
            powers[p] = say_.plus(powers[p], series[m].P[p], "v_" + name);
        }
      }
      if (powers.empty()) continue;
      for (std::size_t p = 0; p < powers.size(); ++p)
        equal("b_a" + here + "_" + std::to_string(p), powers[p].empty() ? "0" : powers[p]);
      std::string horner = "v_b_a" + here + "_" + std::to_string(powers.size() - 1);
      for (std::size_t p = powers.size() - 1; p-- > 0;)
        horner = (p + 2 == powers.size() ? horner : "(" + horner + ")") + "*v_b_s" + std::to_string(ring) + "+v_b_a" +
                 here + "_" + std::to_string(p);
      sum += (sum.empty() ? "" : "+") + in_ring(pieces_, ring, say_, "v_b_R") + "*(" + horner + ")";
    }
    atom("b_along" + std::to_string(c), sum.empty() ? "0" : sum);
  }

  void velocities() {
    const Vortex& vortex = pieces_.vortex;
    atom("v_R", "sqrt(x*x+y*y)");
    atom("v_h", "(v_v_R>=" + say_.number(vortex.inner) + ")*(v_v_R<=" + say_.number(vortex.outer) + ")*" +
                    profile_words(say_, vortex, "v_v_R"));
    const auto v = velocity_words(say_, vortex, "v_v_h", "x", "y");
    atom("v_x", v[0]);
    atom("v_y", v[1]);
  }

  const ForcePieces& pieces_;
  ExpressionNumbers numbers_;
  ExpressionText say_;
  std::string lines_;
};

/// Along r or theta, of variables s0, s1, ... and u0, u1, ..., with a factor for each ring and slab.
std::string along_words(const ForcePieces& pieces, std::size_t c, const ExpressionText& say_P,
                        const ExpressionText& say_Q, const std::function<std::string(std::size_t)>& s,
                        const std::function<std::string(std::size_t)>& u,
                        const std::function<std::string(std::size_t slab, std::size_t ring)>& factor) {
  std::string sum;
  for (std::size_t slab = 0; slab < pieces.slabs(); ++slab)
    for (std::size_t ring = 0; ring < pieces.rings(); ++ring) {
      std::string piece;
      for (const ForceTerm& term : pieces.piece(slab, ring)[c])
        piece += (piece.empty() ? "" : "+") +
                 ("(" + say_P.horner(term.P, s(ring)) + ")*(" + say_Q.horner(term.Q, u(slab))) + ")";
      if (piece.empty()) continue;
      const std::string here = factor(slab, ring);
      sum += (sum.empty() ? "" : "+") + (here.empty() ? piece : here + "*(" + piece + ")");
    }
  return sum.empty() ? "0" : sum;
}

}  // namespace

std::string lammps_force(const ForcePieces& pieces, ForceCoordinates at) { return LammpsLines(pieces).text(at); }

std::string karamelo_force(const ForcePieces& pieces, ForceCoordinates at) {
  constexpr double least = 1e-9;  // of the largest b, below the rounding of all that is single
  const SingleNumbers numbers, rough_numbers(least * pieces.largest);
  const ExpressionText say(numbers), rough(rough_numbers);
  std::string lines = "bR = sqrt(x0*x0+y0*y0)\n";
  for (std::size_t ring = 0; ring < pieces.rings(); ++ring)
    lines += "bs" + std::to_string(ring) + " = " + say.mapped(interval(pieces.radii, ring), "bR") + "\n";
  for (std::size_t slab = 0; slab < pieces.slabs(); ++slab)
    lines += "bu" + std::to_string(slab) + " = " + say.mapped(interval(pieces.times, slab), "time") + "\n";
  for (std::size_t c = 0; c < 2; ++c)
    lines += (c == 0 ? "br = " : "bt = ") +
             along_words(
                 pieces, c, rough, say, [](std::size_t ring) { return "bs" + std::to_string(ring); },
                 [](std::size_t slab) { return "bu" + std::to_string(slab); },
                 [&](std::size_t slab, std::size_t ring) {
                   const std::string now = in_slab(pieces, slab, say, "time");
                   const std::string here = pieces.rings() > 1 ? in_ring(pieces, ring, say, "bR") : "";
                   return now + (now.empty() || here.empty() ? "" : "*") + here;
                 }) +
             "\n";
  if (at == ForceCoordinates::reference) {
    lines += "ba = " + without_blanks(amplitude_expression(pieces.vortex.amplitude, "time", amplitude_words(say))) +
             "*" + profile_words(say, pieces.vortex, "bR") + "\n";
    lines += "bc = (x0*cos(ba)-y0*sin(ba))/bR\nbd = (y0*cos(ba)+x0*sin(ba))/bR\n";
  } else {
    lines += "bc = x0/bR\nbd = y0/bR\n";
  }
  lines += "bx = bc*br-bd*bt\nby = bd*br+bc*bt\n";
  if (pieces.quasi_static) return lines;
  lines += "vh = " + profile_words(say, pieces.vortex, "bR") + "\n";
  const auto v = velocity_words(say, pieces.vortex, "vh", "x0", "y0");
  return lines + "vx0 = " + v[0] + "\nvy0 = " + v[1] + "\n";
}

NairnFunctions nairn_force(const ForcePieces& pieces) {
  const ExpressionNumbers numbers;
  const ExpressionText say(numbers);
  const std::string R = std::string("sqrt(x*x+y*y+") + tiny + ")";
  // sign(x) is 1 above 0, else 0
  const auto between = [&](const std::string& x, double lower, double upper) {
    return "(sign(" + say.plus(x, -lower) + ")-sign(" + say.plus(x, -upper) + "))";
  };
  const auto factor = [&](std::size_t slab, std::size_t ring) {
    std::string here = between(R, pieces.radii[ring], pieces.radii[ring + 1]);
    const bool first = slab == 0, last = slab + 1 == pieces.slabs();
    if (first && last) return here;
    const std::string later = "sign(" + say.plus("t", -pieces.times[slab]) + ")";
    const std::string over = "sign(" + say.plus("t", -pieces.times[slab + 1]) + ")";
    return here + "*(" + (first ? "1" : later) + (last ? "" : "-" + over) + ")";
  };
  std::array<std::string, 2> along;
  for (std::size_t c = 0; c < 2; ++c)
    along[c] = along_words(
        pieces, c, say, say, [&](std::size_t ring) { return say.mapped(interval(pieces.radii, ring), R); },
        [&](std::size_t slab) { return say.mapped(interval(pieces.times, slab), "t"); }, factor);
  NairnFunctions all;
  all.b = {"(x*(" + along[0] + ")-y*(" + along[1] + "))/" + R, "(y*(" + along[0] + ")+x*(" + along[1] + "))/" + R};
  const Vortex& vortex = pieces.vortex;
  all.v = velocity_words(say, vortex, between(R, vortex.inner, vortex.outer) + "*" + profile_words(say, vortex, R), "x",
                         "y");
  return all;
}

}  // namespace assay::drivers
