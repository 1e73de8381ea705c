// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/foreign_table.hpp"

#include <dlfcn.h>

#include <array>

#include "adapters/elf_symbols.hpp"
#include "adapters/foreign/foreign_calls.hpp"
#include "adapters/foreign/foreign_library.hpp"
#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/lsdyna.hpp"
#include "adapters/foreign/mfront.hpp"
#include "adapters/foreign/umat.hpp"
#include "adapters/foreign/usermat.hpp"
#include "adapters/foreign/vumat.hpp"

namespace assay::adapters {

namespace {

using Kind = ForeignVariable::Kind;

template <class Bridge>
const void* bridge_extension(const assay_material* table, const char* id) {
  using Calls = ForeignCalls<Bridge>;
  const assay_symmetry& symmetry = static_cast<const ForeignTable*>(table)->material_class;
  if (std::string(id) == ASSAY_EXTENSION_SYMMETRY) return symmetry.material_class ? &symmetry : nullptr;
  static const assay_reason reason{sizeof(assay_reason), Calls::reason};
  if (std::string(id) == ASSAY_EXTENSION_REASON) return &reason;
  if constexpr (requires { &Bridge::tangent; }) {
    static const assay_tangent tangent{sizeof(assay_tangent), Calls::tangent};
    if (std::string(id) == ASSAY_EXTENSION_TANGENT) return &tangent;
  }
  if constexpr (std::is_base_of_v<AbaqusBridge, Bridge>) {
    static const HostAccess access{sizeof(HostAccess), Calls::bridge_of};
    if (std::string(id) == host_access) return &access;
  }
  return nullptr;
}

template <class Bridge>
std::vector<ForeignVariable> bind(ForeignTable& table) {
  using Calls = ForeignCalls<Bridge>;
  table.create_of = Calls::create;
  table.destroy = Calls::destroy;
  table.initial_state = Calls::initial_state;
  table.update = Calls::update;
  table.extension_of = bridge_extension<Bridge>;
  return Bridge::state_of(table.model);
}

/// Whether the model keeps its tensors in axes of its own.
bool rotates_itself(const ForeignModel& model, bool own) {
  if (model.interface != ForeignInterface::vumat && model.interface != ForeignInterface::mfront)
    return model.axes == Axes::corotational;
  return model.interface == ForeignInterface::vumat || !(model.finite_strain && own);
}

const char* kept(ForeignTable& table, std::string text) {
  table.words.push_back(std::move(text));
  return table.words.back().c_str();
}

void write_lists(ForeignTable& table, const std::vector<ForeignVariable>& state) {
  const ForeignModel& model = table.model;
  for (const ForeignProperty& p : model.properties) {
    table.parameter_list.push_back(
        {kept(table, p.name), kept(table, p.unit), p.value, p.lower, p.upper, kept(table, p.doc)});
  }
  const std::size_t own = state.size() - model.state.size();
  for (std::size_t k = 0; k < state.size(); ++k) {
    const bool tensor = state[k].kind != Kind::scalar;
    const std::int32_t role = tensor && rotates_itself(model, k < own) ? ASSAY_ROLE_ROTATES_ITSELF : ASSAY_ROLE_PLAIN;
    table.state_list.push_back({kept(table, state[k].name), kept(table, state[k].unit), abi_kind(state[k].kind), role,
                                kept(table, state[k].doc)});
  }
  for (const ForeignField& field : varying_fields(model)) {
    table.state_list.push_back({kept(table, field.name), "", ASSAY_SCALAR, ASSAY_ROLE_FIELD, "field of the host"});
  }
  table.parameter_count = static_cast<std::uint32_t>(table.parameter_list.size());
  table.parameters = table.parameter_list.data();
  table.state_count = static_cast<std::uint32_t>(table.state_list.size());
  table.state = table.state_list.data();
}

/// Names that look like entry points, for a message.
std::string candidates(const std::string& path, const std::string& word) {
  std::string names;
  for (const std::string& symbol : exported_symbols(path)) {
    if (::strcasestr(symbol.c_str(), word.c_str())) names += (names.empty() ? "" : ", ") + symbol;
  }
  return names;
}

void* entry_of(const ForeignTable& table, const std::string& word) {
  if (void* entry = dlsym(table.library, table.model.symbol.c_str())) return entry;
  throw ModelRefused("symbol", "'" + table.model.library + "' has no symbol '" + table.model.symbol + "'",
                     candidates(table.model.library, word));
}

/// UEXTERNALDB with LOP = 0: the analysis begins.
void begin_analysis(void* library) {
  void* entry = dlsym(library, "uexternaldb_");
  if (!entry) return;
  int begin = 0, no_restart = 0, step = 1, increment = 1;
  double time[2] = {0, 0}, dtime = 0;
  reinterpret_cast<UexternaldbEntry>(entry)(&begin, &no_restart, time, &dtime, &step, &increment);
}

std::vector<ForeignVariable> bind_interface(ForeignTable& table) {
  const ForeignInterface interface = table.model.interface;
  if (interface != ForeignInterface::mfront) {
    const char* word = names_of(interface)[static_cast<std::size_t>(interface)];
    table.entry = entry_of(table, interface == ForeignInterface::lsdyna ? "umat" : word);
    if (interface == ForeignInterface::usermat) return bind<Usermat>(table);
    if (interface == ForeignInterface::lsdyna) return bind<Lsdyna>(table);
    begin_analysis(table.library);
    return interface == ForeignInterface::umat ? bind<Umat>(table) : bind<Vumat>(table);
  }
  const std::vector<std::string> known = mfront_behaviours(table.model.library);
  if (table.model.symbol.empty() && known.size() == 1) table.model.symbol = known.front();
  table.behaviour = std::make_shared<MfrontBehaviour>(
      mfront_behaviour(table.library, table.model.symbol, known, table.model.hypothesis));
  table.entry = table.behaviour->entry;
  Mfront::describe(*table.behaviour, table.model);
  return bind<Mfront>(table);
}

/// The rules of native tables, at the key that breaks them; of MFront that is the library.
void require_sound(const ForeignTable& table) {
  const bool library_says = table.model.interface == ForeignInterface::mfront;
  const auto require = [&](const char* key, const std::optional<std::string>& defect) {
    if (defect) throw ModelRefused(library_says ? "library" : key, "cannot serve: " + *defect);
  };
  require("properties", defect_of_parameters(table));
  require("state", defect_of_state(table));
}

}  // namespace

std::vector<ForeignField> varying_fields(const ForeignModel& model) {
  std::vector<ForeignField> all;
  for (const std::string& name : model.varying) {
    const auto field = std::ranges::find(model.fields, name, &ForeignField::name);
    const bool is_temperature = model.interface != ForeignInterface::mfront && name == temperature_field;
    if (!is_temperature && field == model.fields.end()) {
      const std::string names = listed_names(model.fields);
      throw ModelRefused("varying." + name, "the model has no field of that name",
                         temperature_field + (names.empty() ? "" : ", " + names));
    }
    all.push_back({name, is_temperature ? model.temperature : field->value});
  }
  return all;
}

std::optional<std::size_t> place_of_varying(const ForeignModel& model, const std::string& name) {
  const auto found = std::ranges::find(model.varying, name);
  if (found == model.varying.end()) return std::nullopt;
  return static_cast<std::size_t>(found - model.varying.begin());
}

std::vector<ForeignVariable> bridge_state(const ForeignModel& model) {
  ForeignModel bare = model;
  bare.state.clear();
  // in the order of the interfaces
  constexpr std::array state_of{Umat::state_of, Vumat::state_of, Mfront::state_of, Usermat::state_of, Lsdyna::state_of};
  return state_of[static_cast<std::size_t>(model.interface)](bare);
}

// weak: libassay has another in its place
[[gnu::weak]] const assay_material* foreign_table(const ForeignModel& model) {
  auto table = std::make_unique<ForeignTable>();
  static_cast<assay_material&>(*table) = assay_material{};
  table->model = model;
  const LoadedLibrary library = load_foreign_library(model.library, model.folder);
  table->library = library.handle;
  table->missing = library.missing;
  const std::vector<ForeignVariable> state = bind_interface(*table);
  write_lists(*table, state);
  require_sound(*table);
  table->abi_major = ASSAY_ABI_MAJOR;
  table->struct_size = sizeof(assay_material);
  table->name = kept(*table, table->model.name);
  table->version = kept(*table, table->model.version);
  table->licence = kept(*table, table->model.licence);
  const std::string lacks = missing_words(table->missing);
  table->doc = kept(*table, table->model.doc + (lacks.empty() ? "" : "; " + lacks));
  table->symmetry = table->model.symmetry;
  table->material_class = {sizeof(assay_symmetry), table->model.material_class};
  table->flags = (table->model.flags | ASSAY_USES_INCREMENT) & ~static_cast<std::uint32_t>(ASSAY_THREAD_SAFE);
  if (!serves_all_components(table->model)) table->flags |= ASSAY_IN_PLANE;
  static std::mutex guard;
  static std::vector<std::unique_ptr<ForeignTable>> all;
  const std::lock_guard lock(guard);
  all.push_back(std::move(table));
  return all.back().get();
}

}  // namespace assay::adapters
