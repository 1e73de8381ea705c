// SPDX-License-Identifier: BSD-3-Clause
// Another code: finite elements in the plane, which know nothing of rings, or on a coarse mesh of their own.
#pragma once

#include <string>
#include <vector>

#include "drivers/mistakes/perturbed_scene.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers {

/// Which runs a scene, and is told what is wrong with it.
class ForeignCode {
 public:
  static constexpr int outputs = 20;

  explicit ForeignCode(const std::string& text) : scene_(read_scene(scratch_.write("scene.yaml", text), {})) {
    std::string library;
    material_ = material_of(scene_, library);
    problem_ = perturbed_problem(scene_, material_, scene_.time.end);
    for (int k = 0; k <= outputs; ++k) times_.push_back(scene_.time.end * k / outputs);
  }

  const Scene& scene() const { return scene_; }
  const PerturbedProblem& problem() const { return problem_; }

  /// Errors of its nodes, of n elements along an edge of the body; of a ring along its radius.
  MeasuredErrors run(const Mistake& mistake, int n) const {
    const bool ring = scene_.body.domain == Body::Domain::ring;
    const PerturbedMotion motion(problem_,
                                 ring ? perturbed_ring(scene_.motion, RingSupport::free, n, 0)
                                      : perturbed_box(scene_.motion, scene_.body.lower, scene_.body.upper, n),
                                 times_);
    const PerturbedHistory history = motion.run(mistake);
    MeasuredErrors found{1.0 / n, bins_of(scene_)};
    for (std::size_t k = 0; k < history.x.size(); ++k) {
      found.errors.begin_frame(times_[k]);
      for (std::size_t i = 0; i < history.x[k].size(); ++i) {
        const Vector3& X = motion.body().nodes[i];
        const Vector3 x = problem_.exact->state(X, times_[k]).x, error = history.x[k][i] - x;
        if (is_vortex(scene_.motion) && !ring_of(scene_.motion)->holds(X.norm()))
          found.errors.add_at_rest(X, error);
        else
          found.errors.add(X, error, x, 1);
      }
    }
    found.errors.finish();
    return found;
  }

  Identification identify(const std::vector<MeasuredErrors>& runs) const {
    CauseError error = cause_error_of(runs);
    if (!error.from_ladder)
      error.discretisation =
          std::max(error.discretisation, error_of_grid(scene_, problem_, runs.back().errors, runs.back().h));
    if (!is_beyond_the_grid(error)) return of_the_method(error);
    return identified(error, problem_, perturbed_motions(scene_, problem_, runs.back().errors, error.t));
  }

  Identification identify(const Mistake& mistake, const std::vector<int>& grids) const {
    std::vector<MeasuredErrors> runs;
    for (const int n : grids) runs.push_back(run(mistake, n));
    return identify(runs);
  }

 private:
  ScratchFolder scratch_;
  Scene scene_;
  std::shared_ptr<const Material> material_;
  PerturbedProblem problem_;
  std::vector<double> times_;
};

/// For messages of tests.
inline std::string shown_of(const Identification& found) {
  std::string text = std::string(names_of(Identification::Answer{})[static_cast<std::size_t>(found.answer)]) + ": " +
                     found.sentence + "\n";
  for (const CauseCandidate& c : found.candidates)
    text += "  " + std::string(c.family->name) + " of size " + std::to_string(c.size) + " explains " +
            std::to_string(c.explained) + ", factor " + std::to_string(c.factor) + ", " + std::to_string(c.frames) +
            " frames\n";
  return text;
}

}  // namespace assay::drivers
