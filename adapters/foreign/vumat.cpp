// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/vumat.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "adapters/foreign/foreign_library.hpp"
#include "adapters/foreign/foreign_state.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::adapters {

namespace {

/// Points a call: models dimension arrays of their own for no more than Abaqus hands over, 136.
constexpr std::size_t most_points = 128;
/// Of jblock: nblock, points, layers and sections, then the element of each point.
constexpr std::size_t block_numbers = 4 + most_points;
constexpr StateLayout vumat_layout{explicit_order, plain_shear, plain_shear};

/// Where a point's own state begins.
enum VumatState : std::size_t { vumat_stress = 0, vumat_internal = 6, vumat_inelastic = 7, vumat_time = 8 };

/// A number that no model computes: one that is no number, with a mark.
constexpr std::uint64_t mark_of_unwritten = 0x7ff8a55a7c0ffee1;
double unwritten() { return std::bit_cast<double>(mark_of_unwritten); }
bool is_unwritten(double value) { return std::bit_cast<std::uint64_t>(value) == mark_of_unwritten; }

/// 1 J/kg in units of the model.
double specific_energy(const ModelUnits& units) { return units.length * units.length / (units.time * units.time); }

/// 1 kg/m^3 in units of the model.
double unit_density(const ModelUnits& units) {
  return units.length * units.length / (units.stress * units.time * units.time);
}

/// By how much the material turns more than the frame of R, in that frame.
Vector3 relative_spin(const Tensor& F0, const Tensor& F1, const CorotationalStep& step) {
  const Tensor l = 2 * (F1 - F0) * (F0 + F1).inverse(), w = 0.5 * (l - l.transpose()) - step.spin;
  const Tensor in_frame = step.R1.transpose() * w * step.R1;
  return {in_frame(2, 1), in_frame(0, 2), in_frame(1, 0)};
}

/// A call has one time for all its points: the clock of the host, but dt in the first increment of points, whenever it
/// is, and never dt in a later one.
double end_of_step(const assay_step& step, bool loaded) {
  if (!loaded) return step.dt;
  return step.t > 0 ? step.t + step.dt : 2 * step.dt;
}

}  // namespace

std::vector<ForeignVariable> Vumat::state_of(const ForeignModel& model) {
  using Kind = ForeignVariable::Kind;
  std::vector<ForeignVariable> all{
      {"STRESS", Kind::symmetric_tensor, "Pa", "Cauchy stress in the frame of the polar rotation", {}},
      {"ENERINTERN", Kind::scalar, "J/kg", "internal energy", {}},
      {"ENERINELAS", Kind::scalar, "J/kg", "inelastic energy", {}},
      {"TIME", Kind::scalar, "s", "since the beginning of the point", {}}};
  all.insert(all.end(), model.state.begin(), model.state.end());
  return all;
}

Vumat::Vumat(const ForeignTable& table, const double* properties) : AbaqusBridge(table, properties) {}

Vumat::Block::Block(std::size_t points, const ForeignModel& model, std::size_t fence)
    : n(points), arrays(fence), rotation(points) {
  const auto size = static_cast<std::size_t>(foreign_state_size(model.state));
  stress[1] = arrays.add("stressNew", 6 * n);
  state[1] = arrays.add("stateNew", size * n);
  internal[1] = arrays.add("enerInternNew", n);
  inelastic[1] = arrays.add("enerInelasNew", n);
  inputs.begin(arrays);
  const auto input = [&](WrittenInput name, const std::string& words, std::size_t components,
                         InputWatch::Change change = InputWatch::every_call) {
    return inputs.add_array(arrays, words, components * n, name, change);
  };
  props = inputs.add_array(arrays, "props", model.properties.size(), written_props);
  coords = input(written_others, "coordMp", 3);
  lengths = input(written_others, "charLength", 1);
  density = input(written_others, "density", 1);
  strain = input(written_strain_inc, "strainInc", 6);
  spin = input(written_others, "relSpinInc", 3);
  for (const int end : {0, 1}) {
    const std::string when = end ? "New" : "Old";
    temperature[end] = input(written_temperatures, "temp" + when, 1);
    stretch[end] = input(written_stretch, "stretch" + when, 6);
    gradient[end] = input(written_defgrad, "defgrad" + when, 9);
    fields[end] = input(written_others, "field" + when, std::max<std::size_t>(model.fields.size(), 1),
                        model.varying.empty() ? InputWatch::once : InputWatch::every_call);
  }
  stress[0] = input(written_stress_old, "stressOld", 6);
  state[0] = input(written_state_old, "stateOld", size);
  internal[0] = input(written_energies, "enerInternOld", 1);
  inelastic[0] = input(written_energies, "enerInelasOld", 1);
}

void Vumat::Block::hold(const HostValues& values) {
  for (const int end : {0, 1}) {
    arrays.fill(fields[end], 0);
    const std::size_t count = std::min(values.fields.size(), arrays.size(fields[end]) / n);
    for (std::size_t k = 0; k < count; ++k) std::fill_n(arrays[fields[end]] + k * n, n, values.fields[k]);
  }
  inputs.forget();
}

void Vumat::hold(const HostValues& values) {
  host_ = values;
  for (const auto& block : blocks_) block->hold(host_);
}

void Vumat::widen() {
  blocks_.clear();
  fence_ = GuardedArrays::widest_fence;
}

Vumat::Block& Vumat::block_of(std::size_t n) {
  const auto found = std::find_if(blocks_.begin(), blocks_.end(), [n](const auto& block) { return block->n == n; });
  if (found != blocks_.end()) return **found;
  constexpr std::size_t most = 4;
  if (blocks_.size() == most) blocks_.erase(blocks_.begin());
  blocks_.push_back(std::make_unique<Block>(n, model_, fence_));
  blocks_.back()->hold(host_);
  return *blocks_.back();
}

void Vumat::initial_state(const Tensor& cauchy, double* state) {
  std::fill_n(state, own_state, 0.0);
  write_symmetric(cauchy, standard_order, plain_shear, state + vumat_stress);
  write_initial(model_.state, state + own_state);
  const double I[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  // Abaqus asks for an elastic response at time zero before the first step; what it leaves in the state is not kept.
  Block& block = block_of(1);
  hand_over(block, {0, 1, I, I}, {1, 0}, state);
  constexpr double fictitious = 1e-8, brief = 1e-7;  // a strain; a step that is none too long for anybody [s]
  block.arrays[block.strain][0] = fictitious;
  call(block, 0, brief);
}

/// Of points that begin at `state0`, which end at `state1`; both have their fields behind all else.
void Vumat::hand_over_fields(Block& block, const Part& part, const double* state0, const double* state1) {
  GuardedArrays& a = block.arrays;
  const std::size_t first = own_state + static_cast<std::size_t>(foreign_state_size(model_.state));
  const auto put = [&](const std::string& name, const std::size_t(&arrays)[2], std::size_t row, double shift) {
    const auto at = place_of_varying(model_, name);
    if (!at) return;
    for (const int end : {0, 1}) {
      const double* values = (end ? state1 : state0) + (first + *at) * part.of + part.begin;
      for (std::size_t p = 0; p < block.n; ++p) a[arrays[end]][row * block.n + p] = values[p] + shift;
    }
  };
  put(temperature_field, block.temperature, 0, host_.temperature - model_.temperature);
  for (std::size_t k = 0; k < model_.fields.size(); ++k)
    put(model_.fields[k].name, block.fields, k, host_.field_shift(model_, k));
}

void Vumat::hand_over(Block& block, const assay_step& step, const Part& part, const double* state0) {
  GuardedArrays& a = block.arrays;
  const std::size_t n = block.n;
  const auto size = static_cast<std::size_t>(foreign_state_size(model_.state));
  std::copy(properties_.begin(), properties_.end(), a[block.props]);
  for (std::size_t k = 0; k < 3; ++k) std::fill_n(a[block.coords] + k * n, n, host_.place[k]);
  for (const std::size_t array : {block.temperature[0], block.temperature[1]}) a.fill(array, host_.temperature);
  a.fill(block.lengths, host_.length);
  std::vector<double> ours(own_state + size), theirs(size);
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor F0 = tensor_at(step.F0, part.of, part.begin + p), F1 = tensor_at(step.F1, part.of, part.begin + p);
    const CorotationalStep c = corotational_step(F0, F1, model_.kinematics);
    block.rotation[p] = c.R1;
    a[block.density][p] = host_.density_times * model_.density / F1.determinant() * unit_density(model_.units);
    write_symmetric(c.strain, explicit_order, plain_shear, a[block.strain] + p, n);
    const Vector3 spin = relative_spin(F0, F1, c);
    for (int k = 0; k < 3; ++k) a[block.spin][static_cast<std::size_t>(k) * n + p] = spin(k);
    write_symmetric(c.U0, explicit_order, plain_shear, a[block.stretch[0]] + p, n);
    write_symmetric(c.U1, explicit_order, plain_shear, a[block.stretch[1]] + p, n);
    write_tensor(F0, explicit_tensor_order, a[block.gradient[0]] + p, n);
    write_tensor(F1, explicit_tensor_order, a[block.gradient[1]] + p, n);
    for (std::size_t k = 0; k < ours.size(); ++k) ours[k] = state0[k * part.of + part.begin + p];
    const Tensor before = read_symmetric(ours.data() + vumat_stress, standard_order, plain_shear) / model_.units.stress;
    to_foreign(vumat_layout, model_.state, ours.data() + own_state, theirs.data());
    write_symmetric(before, explicit_order, plain_shear, a[block.stress[0]] + p, n);
    for (std::size_t k = 0; k < 6; ++k) a[block.stress[1]][k * n + p] = unwritten();
    for (const int end : {0, 1}) {  // a model may leave what does not change of its state
      for (std::size_t k = 0; k < size; ++k) a[block.state[end]][k * n + p] = theirs[k];
      a[block.internal[end]][p] = ours[vumat_internal] / specific_energy(model_.units);
      a[block.inelastic[end]][p] = ours[vumat_inelastic] / specific_energy(model_.units);
    }
  }
}

/// Of a component of stressNew that nobody has written.
void Vumat::require_written(const Block& block) {
  static constexpr const char* places[] = {"11", "22", "33", "12", "23", "31"};
  const double* stress = block.arrays[block.stress[1]];
  for (std::size_t k = 0; k < 6 * block.n; ++k) {
    if (!is_unwritten(stress[k])) continue;
    throw PointFailure(overrun_words + ("the VUMAT leaves stressNew " + std::string(places[k / block.n]) +
                                        " unwritten, or computes it from itself, at point " +
                                        std::to_string(k % block.n + 1) + " of " + std::to_string(block.n)));
  }
}

void Vumat::note_state(Block& block, bool counts) {
  const std::size_t size = block.arrays.size(block.state[1]);
  surroundings_.state_written.resize(size), surroundings_.state_left.resize(size);
  for (std::size_t k = 0; k < size; ++k) {
    double& found = block.arrays[block.state[1]][k];
    const bool left = is_unwritten(found);
    if (counts) (left ? surroundings_.state_left : surroundings_.state_written)[k] = 1;
    if (left) found = block.arrays[block.state[0]][k];
  }
}

void Vumat::call(Block& block, double time, double dt) {
  const auto name = cmname_of(model_);
  int nblock[block_numbers] = {static_cast<int>(block.n), host_.point, host_.layer, host_.section};
  std::fill_n(nblock + 4, most_points, host_.element);
  int ndir = 3, nshr = 3, nstatev = foreign_state_size(model_.state), nfieldv = static_cast<int>(model_.fields.size()),
      nprops = static_cast<int>(properties_.size()), lanneal = 0;
  double total_time = time / model_.units.time, step_time = host_.step_time_times * total_time,
         length = dt / model_.units.time;
  GuardedArrays& a = block.arrays;
  block.inputs.keep(a);
  const bool lent = surroundings_.lent() && block.n == 1;
  if (lent) surroundings_.lend(a), a.fill(block.state[1], unwritten());
  if (host_.outputs_before != 0) a.fill(block.state[1], host_.outputs_before);
  probe_.lend(a);
  const auto ended = ended_in([&] {
    reinterpret_cast<VumatEntry>(table_.entry)(
        nblock, &ndir, &nshr, &nstatev, &nfieldv, &nprops, &lanneal, &step_time, &total_time, &length, name.data(),
        a[block.coords], a[block.lengths], a[block.props], a[block.density], a[block.strain], a[block.spin],
        a[block.temperature[0]], a[block.stretch[0]], a[block.gradient[0]], a[block.fields[0]], a[block.stress[0]],
        a[block.state[0]], a[block.internal[0]], a[block.inelastic[0]], a[block.temperature[1]], a[block.stretch[1]],
        a[block.gradient[1]], a[block.fields[1]], a[block.stress[1]], a[block.state[1]], a[block.internal[1]],
        a[block.inelastic[1]], name.size());
  });
  for (std::size_t k = 0; host_.outputs_before != 0 && k < a.size(block.state[1]); ++k) {
    if (a[block.state[1]][k] == host_.outputs_before) a[block.state[1]][k] = a[block.state[0]][k];
  }
  probe_.take_back(a);
  if (lent) surroundings_.take_back(a), note_state(block, !ended && time > 0);
  const auto broken = block.inputs.broken_fence(a, time > 0);
  if (ended) throw PointFailure("the VUMAT " + *ended);
  if (broken) throw PointFailure(overrun_words + ("the VUMAT " + *broken));
}

void Vumat::update_batch(const assay_step& step, std::size_t n, const double* state0, double* state1, double* cauchy) {
  const double* age = state0 + vumat_time * n;
  const auto loaded = [age](std::size_t p) { return age[p] > 0; };
  for (std::size_t begin = 0, end = 0; begin < n; begin = end) {
    for (++end; end < n && end - begin < most_points && loaded(end) == loaded(begin);) ++end;
    mark_point(begin);
    Block& block = block_of(end - begin);
    const auto answer = [&] {
      hand_over(block, step, {n, begin}, state0);
      hand_over_fields(block, {n, begin}, state0, state1);
      call(block, end_of_step(step, loaded(begin)), step.dt);
    };
    answer();
    require_written(block);
    if (probe_.is_due()) probe_.look(block.arrays, {block.stress[1], block.state[1]}, "stateOld", answer);
    take_back(block, {n, begin}, state1, cauchy);
    for (std::size_t p = begin; p < end; ++p) state1[vumat_time * n + p] = age[p] + step.dt;
  }
}

void Vumat::take_back(Block& block, const Part& part, double* state1, double* cauchy) {
  const GuardedArrays& a = block.arrays;
  const auto size = static_cast<std::size_t>(foreign_state_size(model_.state));
  std::vector<double> ours(own_state + size), theirs(size);
  for (std::size_t p = 0; p < block.n; ++p) {
    const std::size_t at = part.begin + p;
    const Tensor T = model_.units.stress * read_symmetric(a[block.stress[1]] + p, explicit_order, plain_shear, block.n);
    const Tensor sigma = block.rotation[p] * T * block.rotation[p].transpose();
    for (std::size_t c = 0; c < 9; ++c) cauchy[c * part.of + at] = component(sigma, static_cast<int>(c));
    write_symmetric(T, standard_order, plain_shear, ours.data() + vumat_stress);
    ours[vumat_internal] = a[block.internal[1]][p] * specific_energy(model_.units);
    ours[vumat_inelastic] = a[block.inelastic[1]][p] * specific_energy(model_.units);
    for (std::size_t k = 0; k < size; ++k) theirs[k] = a[block.state[1]][k * block.n + p];
    from_foreign(vumat_layout, model_.state, theirs.data(), ours.data() + own_state);
    for (std::size_t k = 0; k < ours.size(); ++k) state1[k * part.of + at] = ours[k];
  }
}

}  // namespace assay::adapters
