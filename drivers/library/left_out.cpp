// SPDX-License-Identifier: BSD-3-Clause
// What the library does without, in place of weak symbols of the floors. The linker then leaves out what only these
// call, which is a third of the library:
// - the effects of a step, whose keys in a scene (`remedies`) are read past;
// - what is expected of a run, which is read past;
// - foreign models in this process: they run in workers;
// - children of this process, in which the program tries a library and works on with it: here workers try it.
#include "adapters/foreign/foreign_table.hpp"
#include "adapters/library.hpp"
#include "adapters/worker/probe.hpp"
#include "drivers/format/particle_tables.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/system/supervisor.hpp"
#include "mpm/compose.hpp"

namespace assay {

namespace mpm {

template <>
const std::vector<EffectRecord<2>>& effects() {
  static const std::vector<EffectRecord<2>> none;
  return none;
}

template <>
const std::vector<EffectRecord<3>>& effects() {
  static const std::vector<EffectRecord<3>> none;
  return none;
}

template <>
std::optional<Contradiction> contradiction<2>(const Method&, const EffectOptions&) {
  return std::nullopt;
}

}  // namespace mpm

namespace adapters {

const assay_material* foreign_table(const ForeignModel&) {
  throw ModelRefused("isolation", "inside a host a foreign model runs in workers: leave out material.isolation");
}

void try_library(const std::string&) {}

}  // namespace adapters

void drivers::supervise(const std::string&) {}

void drivers::read_particle_hdf5(const std::string&, const TakeTable&) {}

std::vector<drivers::Expectation> drivers::read_expectations(const Tree&, const ExpectationWords&) { return {}; }

}  // namespace assay
