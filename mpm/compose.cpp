// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/compose.hpp"

#include <algorithm>
#include <array>

#include "mpm/data/dimension.hpp"
#include "mpm/spine.hpp"

namespace assay::mpm {

// cmake/file_list.cmake writes a line for each file of mpm/effects.
#define ASSAY_EFFECT(name) \
  template <int Dim>       \
  EffectRecord<Dim> name##_effect();
#include "effect_list.inc"
#undef ASSAY_EFFECT

template <int Dim>
const std::vector<EffectRecord<Dim>>& effects() {
  static const std::vector<EffectRecord<Dim>> list = [] {
    std::vector<EffectRecord<Dim>> all;
    const auto add = [&](const char* name, EffectRecord<Dim> record) {
      record.name = name;
      for (ColumnRecord<Dim>& column : record.columns) column.effect = name;
      all.push_back(std::move(record));
    };
#define ASSAY_EFFECT(name) add(#name, name##_effect<Dim>());
#include "effect_list.inc"
#undef ASSAY_EFFECT
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.place < b.place; });
    return all;
  }();
  return list;
}

template <int Dim>
const ColumnRecord<Dim>& record_of(Column column) {
  static const std::vector<ColumnRecord<Dim>> list = [] {
    std::vector<ColumnRecord<Dim>> all = spine_columns<Dim>();
    for (const auto& effect : effects<Dim>()) all.insert(all.end(), effect.columns.begin(), effect.columns.end());
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.column < b.column; });
    return all;
  }();
  return list.at(static_cast<std::size_t>(column));
}

namespace {

/// Of the main parts of phases the pass takes the place of the one that is there, and is of that one's effects, too.
template <int Dim>
void add_pass(std::vector<Pass<Dim>>& step, Pass<Dim> pass) {
  const auto same = std::find_if(step.begin(), step.end(), [&](const Pass<Dim>& other) {
    return pass.slot.part == Part::main && other.slot == pass.slot;
  });
  if (same == step.end()) return step.push_back(std::move(pass));
  pass.effects.insert(pass.effects.begin(), same->effects.begin(), same->effects.end());
  *same = std::move(pass);
}

}  // namespace

template <int Dim>
std::vector<Pass<Dim>> compose(const Setup<Dim>& setup) {
  std::vector<Pass<Dim>> step = spine_passes(setup);
  for (const EffectRecord<Dim>& effect : effects<Dim>()) {
    if (!effect.passes || !effect.called_for(setup)) continue;
    for (Pass<Dim>& pass : effect.passes(setup)) {
      pass.effects.insert(pass.effects.begin(), effect.name);
      add_pass(step, std::move(pass));
    }
  }
  std::stable_sort(step.begin(), step.end(), [](const auto& a, const auto& b) { return a.slot < b.slot; });
  return step;
}

template <int Dim>
std::vector<ColumnUse> columns_of(const std::vector<Pass<Dim>>& passes, const Setup<Dim>& setup) {
  std::vector<ColumnUse> columns;
  for (std::size_t k = 0; k < column_count; ++k) {
    ColumnUse use{static_cast<Column>(k), 0, {}, {}};
    for (const auto& pass : passes) {
      const auto names = [&](const std::vector<Column>& list) {
        return std::find(list.begin(), list.end(), use.column) != list.end();
      };
      if (names(pass.reads) || names(pass.writes)) use.passes.push_back(pass.name);
    }
    if (use.passes.empty() && use.column != Column::reference_position) continue;
    const ColumnRecord<Dim>& record = record_of<Dim>(use.column);
    use.bytes = record.bytes(setup);
    if (!record.effect.empty()) use.effect = record.effect;
    columns.push_back(std::move(use));
  }
  return columns;
}

template <int Dim>
std::vector<GridFieldUse> grid_fields_of(const Setup<Dim>& setup) {
  std::vector<GridFieldUse> fields = spine_fields(setup);
  for (const EffectRecord<Dim>& effect : effects<Dim>()) {
    if (!effect.grid_fields || !effect.called_for(setup)) continue;
    for (GridFieldUse& field : effect.grid_fields(setup)) {
      auto at = std::find_if(fields.begin(), fields.end(), [&](const auto& other) { return other.name == field.name; });
      if (at == fields.end()) at = fields.insert(at, std::move(field));
      at->effects.push_back(effect.name);
    }
  }
  std::stable_partition(fields.begin(), fields.end(), [](const GridFieldUse& field) { return !field.is_last; });
  std::erase_if(fields, [](const GridFieldUse& field) { return field.bytes == 0; });
  for (GridFieldUse& field : fields) {
    if (field.holds.empty()) field.holds = {field.name};
  }
  return fields;
}

template <int Dim>
std::size_t grid_bytes_per_node(const Setup<Dim>& setup) {
  std::size_t bytes = 0;
  for (const GridFieldUse& field : grid_fields_of(setup)) bytes += field.bytes;
  return bytes;
}

template const std::vector<EffectRecord<ASSAY_DIMENSION>>& effects();
template const ColumnRecord<ASSAY_DIMENSION>& record_of(Column);
template std::vector<Pass<ASSAY_DIMENSION>> compose(const Setup<ASSAY_DIMENSION>&);
template std::vector<ColumnUse> columns_of(const std::vector<Pass<ASSAY_DIMENSION>>&, const Setup<ASSAY_DIMENSION>&);
template std::vector<GridFieldUse> grid_fields_of(const Setup<ASSAY_DIMENSION>&);
template std::size_t grid_bytes_per_node(const Setup<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
