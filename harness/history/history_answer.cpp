// SPDX-License-Identifier: BSD-3-Clause
// The side that answers.
#include <stdexcept>

#include "harness/history/history_fields.hpp"
#include "harness/history/history_task.hpp"
#include "harness/history/troop.hpp"
#include "harness/motion/registry.hpp"

namespace assay {

namespace {

using Kind = HistoryTaskKind;

template <class Parts>
Parts part_of(NumberReader& reader) {
  Parts parts{};
  reader(parts);
  return parts;
}

const FailureFacts no_failure;

}  // namespace

/// With what its histories point to.
struct HistoryTasks::Gathered {
  Gathered(const Material& material, Path of, CourseFacts facts, std::vector<double> xi, const HistoryOptions& options)
      : path(std::move(of)), course(material, path, std::move(facts)), troop(course, std::move(xi), options) {}
  Path path;
  Course course;
  Troop troop;
};

HistoryTasks::HistoryTasks(Material material) : material_(std::move(material)) {}

HistoryTasks::~HistoryTasks() = default;

std::vector<double> HistoryTasks::answer(std::span<const double> task) {
  try {
    return result(task);
  } catch (const MaterialFailure& failure) {
    return numbers_of(FailureFacts{FailureFacts::Kind::material, failure.what(), failure});
  } catch (const std::exception& error) {
    return numbers_of(FailureFacts{FailureFacts::Kind::other, error.what(), {}});
  }
}

/// Reads the path of a task, the last one where it is that.
void HistoryTasks::renew_path(const PathFacts& facts) {
  if (path_.recipe.empty() || path_.recipe != facts.recipe) path_ = path_of_recipe(facts.recipe);
  path_.parameter = facts.parameter;
  path_.material_direction = facts.direction;
  path_.initial_cauchy = tensor_of(facts.initial_cauchy.data());
}

std::vector<double> HistoryTasks::result(std::span<const double> task) {
  NumberReader reader(task);
  const Kind kind = part_of<Kind>(reader);
  if (kind == Kind::advance) {
    const auto found = troops_.find(part_of<std::uint64_t>(reader));
    if (found == troops_.end()) throw std::runtime_error("there are no such histories");
    found->second->troop.advance(part_of<double>(reader));
    return numbers_of(no_failure, found->second->troop.trails());
  }
  if (kind == Kind::disband) {
    troops_.erase(part_of<std::uint64_t>(reader));
    return numbers_of(no_failure);
  }
  renew_path(part_of<PathFacts>(reader));
  if (kind == Kind::coarse) return numbers_of(no_failure, march_coarsely(material_, path_, part_of<double>(reader)));
  auto course = part_of<CourseFacts>(reader);
  const auto options = part_of<HistoryOptions>(reader);
  if (kind == Kind::gather) {
    const auto troop = part_of<std::uint64_t>(reader);
    troops_[troop] =
        std::make_unique<Gathered>(material_, path_, std::move(course), part_of<std::vector<double>>(reader), options);
    return numbers_of(no_failure);
  }
  const auto xi = part_of<double>(reader);
  const auto times = part_of<std::vector<double>>(reader);
  return numbers_of(no_failure, follow_here(Course(material_, path_, std::move(course)), xi, options, times));
}

}  // namespace assay
