// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/simulate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "adapters/worker/remote_table.hpp"
#include "drivers/simulation/health.hpp"
#include "drivers/simulation/stress_offload.hpp"
#include "drivers/simulation/time_steps.hpp"
#include "drivers/simulation/warnings.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/text/numbers.hpp"
#include "mpm/simulation.hpp"

namespace assay::drivers {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// How often what a snapshot shows is kept: a copy takes as long as a tenth of a step.
constexpr std::int64_t fewest_steps_of_good = 64, most_goods = 200;

/// One run's moving parts, so that the loop itself reads as it is.
template <int Dim>
class Run {
 public:
  Run(ProblemIn<Dim>& problem, const ExactSolutionPtr& exact, Snapshots<Dim>& snapshots, Result& result)
      : problem_(problem),
        snapshots_(snapshots),
        result_(result),
        workers_(workers_of(problem)),
        simulation_(setup_of(problem, exact, workers_)),
        health_(problem, simulation_.state()),
        good_interval_(std::max(fewest_steps_of_good, problem.steps / most_goods)) {
    if (problem.scene.time.control == TimeChoice::Control::current) control_.emplace(problem, simulation_.state());
    snapshots_.keep_good(simulation_.state(), 0);
    if (exact) sampler_.emplace(problem, exact, simulation_.state());
    if (problem.setup.accounts) accounts_.emplace(simulation_.state());
    due_ = observations_of(problem);
  }

  void loop(Progress& progress) {
    const auto start = Clock::now();
    observe(-1, 0, 0);
    const double cpu_at_start = cpu_seconds();
    observing_cpu_s_ = 0;
    std::int64_t k = 0;
    double t = 0;
    while (t < problem_.scene.time.end) {
      stop_if_interrupted();
      const double next = control_ ? control_->next(simulation_.state(), t) : problem_.time_of_step(k + 1);
      if (control_ && control_->stuck()) {
        record({mpm::Finding::Kind::unstable, "waves have become too fast to follow", 0, {}});
        break;
      }
      const auto& finding = simulation_.step(t, next - t);
      ++k;
      result_.t = next;
      if (finding) {
        record(*finding);
        break;
      }
      if (const auto ill = health_.look(simulation_.state(), k, next, next - t, wave_speed())) {
        record(*ill);
        break;
      }
      if (k % good_interval_ == 0) snapshots_.keep_good(simulation_.state(), next);
      observe(planned_step(t), planned_step(next), next);
      t = next;
      progress.update(t / problem_.scene.time.end, "t = " + problem_.scene.units.text(next, "s", 3));
    }
    result_.step_cpu_s = cpu_seconds() - cpu_at_start - observing_cpu_s_;
    result_.wall_s = seconds_since(start);
    finish(k);
  }

 private:
  /// Null of a material in this process.
  static std::shared_ptr<StressOffload<Dim>> workers_of(const ProblemIn<Dim>& problem) {
    const bool apart = !adapters::start_of(&problem.material->table()).task.empty();
    return apart ? std::make_shared<StressOffload<Dim>>(problem.setup) : nullptr;
  }

  static mpm::Setup<Dim> setup_of(const ProblemIn<Dim>& problem, const ExactSolutionPtr& exact,
                                  const std::shared_ptr<StressOffload<Dim>>& workers) {
    mpm::Setup<Dim> setup = problem.setup;
    setup.exact = exact;
    if (workers) setup.offload = StressOffload<Dim>::offload_of(workers);
    return setup;
  }

  double wave_speed() const {
    return control_ ? control_->wave_speed() : std::max(problem_.wave_speed, problem_.reference_wave_speed);
  }

  /// The step of the plan that has been taken by a time.
  std::int64_t planned_step(double t) const {
    constexpr double rounding = 1e-6;  // of a step
    return t >= problem_.scene.time.end ? problem_.steps
                                        : static_cast<std::int64_t>(std::floor(t / problem_.dt + rounding));
  }

  /// What is due after one of the steps (before, now] of the plan, at time t.
  void observe(std::int64_t before, std::int64_t now, double t) {
    const auto due = [&](const std::set<std::int64_t>& steps) {
      const auto next = steps.upper_bound(before);
      return next != steps.end() && *next <= now;
    };
    const bool each = control_ && problem_.scene.output.each_step_from.value_or(INFINITY) <= t;
    const bool shot = due(due_.shots) || each, sample = due(due_.samples) || (shot && sampler_);
    const bool account = accounts_ && (sample || due(due_.accounts));
    if (!shot && !sample && !account) return;
    const double cpu_at_start = cpu_seconds();
    auto start = Clock::now();
    if (sample) {
      const ErrorSample found = sampler_->sample(simulation_.state(), t, simulation_.velocity_time());
      if (due(due_.samples)) result_.history.push_back(found);
      largest_displacement_ = std::max(largest_displacement_, sampler_->exact_displacement());
      sampling_s_ += seconds_since(start);
    }
    start = Clock::now();
    if (sample && !shot) snapshots_.remember(simulation_.state(), *sampler_, t);
    if (shot) {
      snapshots_.add(simulation_.state(), sampler_ ? &*sampler_ : nullptr, t, simulation_.velocity_time());
      output_s_ += seconds_since(start);
    }
    if (account) accounts_->check(simulation_.state());
    observing_cpu_s_ += cpu_seconds() - cpu_at_start;
  }

  void record(const mpm::Finding& finding) {
    result_.outcome = finding.kind == mpm::Finding::Kind::unstable ? "unstable" : "material_failed";
    const mpm::State<Dim>& s = simulation_.state();
    const auto p = static_cast<std::size_t>(finding.particle);
    const auto X = [&](int d) {
      return rounded_text(problem_.scene.units.scale("m").from_si(s.column(mpm::Column::reference_position, d)[p]), 6);
    };
    result_.reason = finding.reason + ": particle " + std::to_string(finding.particle) + " of reference position (" +
                     X(0) + ", " + X(1) + (Dim == 3 ? ", " + X(2) : "") + ") " + problem_.scene.units.name("m") +
                     " at t = " + problem_.scene.units.text(result_.t.value_or(0), "s", 6);
    if (finding.step) result_.failed_step = std::make_shared<const FailedStep>(*finding.step);
  }

  void finish(std::int64_t steps) {
    const mpm::State<Dim>& s = simulation_.state();
    result_.dt = control_ && steps > 0 ? result_.t.value_or(0) / static_cast<double>(steps) : problem_.dt;
    if (control_) result_.material_calls += control_->material_calls();
    result_.steps = steps;
    result_.particles = problem_.particles();
    result_.moving_particles = static_cast<std::int64_t>(s.particles);
    result_.particle_steps = steps * static_cast<std::int64_t>(s.particles);
    result_.material_calls += s.material_calls;
    double stepping = 0;
    for (const mpm::PassTime& time : simulation_.times()) {
      const double handing = workers_ && time.updates_material ? workers_->hand_over_s() : 0;
      result_.passes.push_back({time.name, time.seconds - handing, static_cast<double>(time.bytes_per_particle)});
      stepping += time.seconds;
    }
    if (workers_) result_.passes.push_back({"isolation", workers_->hand_over_s(), 0});
    result_.observed_s = sampling_s_ + output_s_;
    if (sampler_) {
      result_.passes.push_back({"error_sampling", sampling_s_, 0});
      result_.error =
          figures_of(result_.history, 0.5 * problem_.period(), problem_.scene.time.end, largest_displacement_);
      warn_of_stillness(problem_, largest_displacement_, result_);
    }
    if (!due_.shots.empty()) result_.passes.push_back({"snapshots", output_s_, 0});
    if (stepping > 0) result_.particle_steps_per_s = static_cast<double>(result_.particle_steps) / stepping;
    if (problem_.setup.traction) result_.growth = growth_of(result_.history);
    if (result_.growth)
      result_.warnings.push_back(growth_sentence(*result_.growth, problem_.setup.traction->form, problem_.scene.units));
    if (accounts_) result_.drift = accounts_->drift();
    result_.health = health_.figures();
    for (const std::string& sentence : health_.sentences()) result_.warnings.push_back(sentence);
  }

  ProblemIn<Dim>& problem_;
  Snapshots<Dim>& snapshots_;
  Result& result_;
  std::shared_ptr<StressOffload<Dim>> workers_;  ///< of a material that runs in processes of its own
  mpm::Simulation<Dim> simulation_;
  HealthWatch<Dim> health_;
  std::optional<TimeControl<Dim>> control_;
  std::int64_t good_interval_;  ///< steps between two states that are kept
  std::optional<ErrorSampler<Dim>> sampler_;
  std::optional<Accounts<Dim>> accounts_;
  Observations due_;
  double sampling_s_ = 0, output_s_ = 0, observing_cpu_s_ = 0, largest_displacement_ = 0;
};

}  // namespace

template <int Dim>
void simulate(ProblemIn<Dim>& problem, const ExactSolutionPtr& exact, Snapshots<Dim>& snapshots, Progress& progress,
              Result& result) {
  auto start = Clock::now();
  Run<Dim> run(problem, exact, snapshots, result);
  result.setup_s += seconds_since(start);
  start = Clock::now();
  try {
    run.loop(progress);
  } catch (const MaterialFailure&) {  // of what is taken along
    result.wall_s = seconds_since(start);
    throw;
  }
}

template void simulate(ProblemIn<2>&, const ExactSolutionPtr&, Snapshots<2>&, Progress&, Result&);
template void simulate(ProblemIn<3>&, const ExactSolutionPtr&, Snapshots<3>&, Progress&, Result&);

}  // namespace assay::drivers
