// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/mistakes/identification.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

constexpr double explains = 0.93;   ///< share of the error, from which on a mistake is its cause
constexpr double as_well = 0.90;    ///< likewise, where another one is the cause already
constexpr double near_size = 0.15;  ///< of a size that people make, and of a factor from 1
constexpr double apart = 4;         ///< times the rest that the best leaves: a mistake that leaves more is another one

/// Sums over the first frames, weighted by the bins.
struct Products {
  double ee = 0, ed = 0, dd = 0, rest = 0;
  double factor() const { return dd > 0 ? ed / dd : 0; }
};

Products products_of(const CauseError& error, const std::vector<std::vector<Vector3>>& d, std::size_t frames) {
  Products sum;
  for (std::size_t k = 0; k < frames; ++k) {
    double in_bins = 0;
    for (std::size_t b = 0; b < error.X.size(); ++b) {
      const double w = error.weight[b];
      in_bins += w * dot_in_plane(error.e[k][b], error.e[k][b]);
      sum.ed += w * dot_in_plane(error.e[k][b], d[k][b]), sum.dd += w * dot_in_plane(d[k][b], d[k][b]);
    }
    sum.ee += in_bins;
    sum.rest += std::max(0.0, error.square[k] - in_bins);
  }
  return sum;
}

double explained_by(const Products& p) {
  const double whole = p.ee + p.rest;
  return whole > 0 ? 1 - (whole - 2 * p.ed + p.dd) / whole : 0;
}

/// Runs of one family on one mesh, compared with the error.
class Trial {
 public:
  Trial(const CauseError& error, const PerturbedMotion& motion, const PerturbedHistory& right)
      : error_(error), motion_(motion), right_(right) {}

  CauseCandidate of(const MistakeFamily& family, double size) const {
    CauseCandidate candidate{&family, size};
    const PerturbedHistory history = motion_.run(*family.plant(size));
    candidate.frames = std::min(history.x.size(), right_.x.size());
    for (std::size_t k = 0; k < candidate.frames; ++k)
      candidate.difference.push_back(motion_.difference(history, right_, k, error_.X));
    measure(candidate);
    return candidate;
  }

  void measure(CauseCandidate& candidate) const {
    if (candidate.frames < least_frames) return;
    const Products p = products_of(error_, candidate.difference, candidate.frames);
    candidate.explained = explained_by(p), candidate.factor = p.factor();
  }

  /// The size that fits best, from the best of those that people make.
  CauseCandidate best(const MistakeFamily& family) const {
    CauseCandidate best{&family, family.right};
    best.explained = -HUGE_VAL;
    for (const double size : family.sizes) take(of(family, size), best);
    if (family.small == 0) return best;
    for (const double sign : {1.0, -1.0}) take(of(family, family.right + sign * family.small), best);
    constexpr int most = 6;
    return fitted(std::move(best), most);
  }

  /// The same mistake, fitted on this mesh; of a usual size where that is near.
  CauseCandidate again(const CauseCandidate& candidate) const {
    const MistakeFamily& family = *candidate.family;
    constexpr int most = 3;
    CauseCandidate found = of(family, candidate.size);
    if (family.small > 0) found = fitted(std::move(found), most);
    found.held = candidate.held;
    for (const double usual : family.sizes) {
      const double ratio = (found.size - family.right) / (usual - family.right);
      if (found.size == usual || std::abs(ratio - 1) > near_size) continue;
      CauseCandidate there = of(family, usual);
      there.held = found.held;
      if (there.frames >= least_frames && there.explained >= explains && std::abs(there.factor - 1) <= near_size)
        return there;
    }
    return found;
  }

  /// The size that fits the error on the next coarser grid over that of a candidate; 0 where that is not known.
  double on_coarser(const CauseCandidate& candidate) const {
    const MistakeFamily& family = *candidate.family;
    if (error_.coarser.size() < candidate.frames || candidate.frames < least_frames || family.small == 0) return 0;
    CauseError coarser = error_;
    coarser.e = error_.coarser;
    CauseCandidate there = candidate;
    const Trial trial(coarser, motion_, right_);
    trial.measure(there);
    constexpr int most = 4;
    // Sizes of one kind of mistake are compared as they are; of others as their effect, which costs nothing.
    if (family.of_methods) there = trial.fitted(std::move(there), most);
    return there.factor * (there.size - family.right) / (candidate.factor * (candidate.size - family.right));
  }

 private:
  /// The difference is nearly proportional to the size.
  CauseCandidate fitted(CauseCandidate best, int most) const {
    const MistakeFamily& family = *best.family;
    for (int k = 0; k < most && best.factor > 0 && std::abs(best.factor - 1) > 0.01; ++k) {
      const double size = std::clamp(family.right + (best.size - family.right) * std::clamp(best.factor, 0.25, 4.0),
                                     family.range.first, family.range.second);
      CauseCandidate next = of(family, size);
      if (next.frames < least_frames || next.explained <= best.explained) break;
      best = std::move(next);
    }
    return best;
  }

  static void take(CauseCandidate&& next, CauseCandidate& best) {
    if (next.frames >= least_frames && next.explained > best.explained) best = std::move(next);
  }
  const CauseError& error_;
  const PerturbedMotion& motion_;
  const PerturbedHistory& right_;
};

/// Of two candidates over the frames that both have.
double explained_over(const CauseError& error, const CauseCandidate& candidate, std::size_t frames) {
  return explained_by(products_of(error, candidate.difference, std::min(frames, candidate.frames)));
}

std::string percent(double share) { return rounded_text(100 * share, 3) + " %"; }

/// Whether the mistake is about as large on the next coarser grid: what a method does falls with the grid.
bool is_as_large(const CauseError& error, const CauseCandidate& best) {
  const double half_an_order = std::sqrt(error.refined);
  return best.on_coarser < half_an_order && best.on_coarser * half_an_order > 1;
}

void conclude(const CauseError& error, Identification& found) {
  using enum Identification::Answer;
  const auto fits = [&](const CauseCandidate& c, double share) {
    return c.explained >= share && std::abs(c.factor - 1) <= near_size && c.size != c.family->right;
  };
  if (found.candidates.empty() || !fits(found.candidates.front(), explains)) {
    found.answer = unknown;
    found.sentence = "none of the mistakes that are known explains the error";
    if (!found.candidates.empty() && found.candidates.front().explained > 0)
      found.sentence += ": the best, " + std::string(found.candidates.front().family->name) + ", explains " +
                        percent(found.candidates.front().explained);
    return;
  }
  const CauseCandidate& best = found.candidates.front();
  std::string others;
  found.alike = 1;
  for (std::size_t k = 1; k < found.candidates.size(); ++k) {
    const CauseCandidate& other = found.candidates[k];
    const std::size_t frames = std::min(best.frames, other.frames);
    const double rest = 1 - explained_over(error, best, frames), its_rest = 1 - explained_over(error, other, frames);
    if (!fits(other, as_well) || its_rest > apart * rest) continue;
    std::swap(found.candidates[found.alike], found.candidates[k]);
    ++found.alike;
  }
  for (std::size_t k = 0; k < found.alike; ++k) others += (k > 0 ? "; or " : "") + found.candidates[k].words();
  const std::string share = percent(found.candidates.front().explained) + " of the error";
  // A factor that is near 1 is also what a coarse grid makes of a right code.
  const bool small_change =
      best.family->small > 0 && std::ranges::find(best.family->sizes, best.size) == best.family->sizes.end();
  if (small_change && (!error.from_ladder || best.family->of_methods) && !is_as_large(error, best)) {
    found.answer = doubtful;
    found.sentence = others + ". That would explain " + share + ", and so may the method itself: give a finer grid";
    return;
  }
  found.answer = found.alike == 1 ? named : alike;
  found.sentence = others + ". That explains " + share;
  if (found.alike > 1) found.sentence += "; this motion does not tell them apart";
}

}  // namespace

Identification of_the_method(const CauseError& error) {
  Identification found;
  found.answer = Identification::Answer::method;
  found.sentence = "no mistake shows: the error is that of the method on this grid";
  if (is_steady(error)) found.sentence = "no mistake is told: the error of the grids hides it, or there is none";
  if (!error.from_ladder) found.sentence += ", or hides in it. A finer grid tells more";
  return found;
}

Identification identified(const CauseError& error, const PerturbedProblem& problem, const PerturbedMotions& motions,
                          const std::function<void(double share)>& between) {
  Identification found;
  std::vector<const MistakeFamily*> families;
  for (const MistakeFamily& family : mistake_families()) {
    if (!family.applies || family.applies(problem)) families.push_back(&family);
  }
  double done = 0;
  for (std::size_t held = 0; held < motions.size(); ++held) {
    const PerturbedMotion& mesh = *motions[held].coarse;
    const PerturbedHistory right = mesh.run(Mistake());
    const Trial trial(error, mesh, right);
    for (const MistakeFamily* family : families) {
      if (between) between(done++ / static_cast<double>(families.size() * motions.size()));
      CauseCandidate candidate = trial.best(*family);
      candidate.held = held;
      if (candidate.frames >= least_frames) found.candidates.push_back(std::move(candidate));
    }
  }
  const auto sort = [&] { std::ranges::stable_sort(found.candidates, std::greater(), &CauseCandidate::explained); };
  sort();
  if (!found.candidates.empty()) {
    const std::size_t held = found.candidates.front().held;  // the body is held in one way
    std::erase_if(found.candidates, [&](const CauseCandidate& each) { return each.held != held; });
    const PerturbedMotion& mesh = *motions[held].fine;
    const PerturbedHistory right = mesh.run(Mistake());
    const Trial trial(error, mesh, right);
    constexpr std::size_t likely = 4;
    for (std::size_t k = 0; k < std::min(likely, found.candidates.size()); ++k) {
      if (between) between(1);
      found.candidates[k] = trial.again(found.candidates[k]);
    }
    sort();
    CauseCandidate& best = found.candidates.front();
    best.on_coarser = trial.on_coarser(best);
  }
  conclude(error, found);
  return found;
}

}  // namespace assay::drivers
