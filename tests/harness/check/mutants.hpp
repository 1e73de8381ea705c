// SPDX-License-Identifier: BSD-3-Clause
// Models that are right, and the same models each with one planted defect.
#pragma once

#include <string>
#include <vector>

#include "harness/check/battery.hpp"
#include "harness/material/material.hpp"

namespace assay::check_tests {

/// A model and what the battery must say of it.
struct Subject {
  std::string name;
  Material material;
  std::string cause;  ///< of causes::; empty: nothing
};

/// Increments in J2 plasticity with back stress: Hughes-Winget, Green-Naghdi, logarithmic, rotations of second order;
/// and their mutants.
namespace incremental_mutants {
std::vector<Subject> subjects();
}

/// Total laws (neo-Hookean and others), with tangent and energy; and their mutants.
namespace total_mutants {
std::vector<Subject> subjects();
}

/// A generalised Maxwell solid, a Maxwell liquid, a Newtonian fluid; and their mutants.
namespace viscous_mutants {
std::vector<Subject> subjects();
}
namespace fluid_mutants {
std::vector<Subject> subjects();
}

/// A cone with an apex, and a soil that needs an initial pressure; and their mutants.
namespace soil_mutants {
std::vector<Subject> subjects();
}

/// Damage by the largest energy, with the energy that is left; and its mutants.
namespace damage_mutants {
std::vector<Subject> subjects();
}

/// A total law and one in increments that offer their rate, wave speed and closed form; and their mutants.
namespace extension_mutants {
std::vector<Subject> subjects();
}

/// Fibres along a direction of the state; and their mutants.
namespace fibre_mutants {
std::vector<Subject> subjects();
}

/// Rubber without an energy, a law that has none; and their mutants.
namespace potential_mutants {
std::vector<Subject> subjects();
}

/// A melt whose state goes with the current body, with its energy; and its mutants.
namespace melt_mutants {
std::vector<Subject> subjects();
}

/// Crystals and Hill's plasticity that declare a class of symmetry; and their mutants.
namespace crystal_mutants {
std::vector<Subject> subjects();
}
namespace hill_mutants {
std::vector<Subject> subjects();
}

/// Built-in models that misreport components of their stress.
namespace component_mutants {
std::vector<Subject> subjects();
}

/// What goes wrong around the equations of a model: in batches, by addresses, by chance, in the last digits.
namespace call_mutants {
std::vector<Subject> subjects();
}

/// All of them.
std::vector<Subject> all_subjects();

/// What every change waits for: all that are right, and of each cause two, on two kinds of model where there are two.
std::vector<Subject> few_subjects();

/// `run_battery` of a subject as the first of a process: what mutants keep in statics is forgotten.
check::Report battery_of(const Subject& subject, const check::Options& options = {});

}  // namespace assay::check_tests
