// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/table_pack.hpp"

#include <stdexcept>
#include <type_traits>

#include "adapters/worker/operations.hpp"

namespace assay::adapters {

namespace {

/// What is packed, which is written into values where `reads`, and else made of them.
struct Pack {
  std::string bytes;
  bool reads = false;
  std::deque<std::string>* words = nullptr;  ///< that keep the texts that are read
  std::size_t at = 0;

  void raw(void* value, std::size_t size) {
    if (!reads) bytes.append(static_cast<const char*>(value), size);
    if (reads && size > bytes.size() - at) throw std::runtime_error("the worker's answer is cut");
    if (reads) bytes.copy(static_cast<char*>(value), size, at);
    at += size;
  }
  template <class T>
  void item(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    raw(&value, sizeof value);
  }
  void item(const char*& text) {
    std::string copy = !reads && text ? text : "";
    size(copy);
    raw(copy.data(), copy.size());
    if (reads) text = words->emplace_back(std::move(copy)).c_str();
  }
  void size(auto& list) {
    std::size_t count = list.size();
    item(count);
    if (reads && count > bytes.size() - at) throw std::runtime_error("the worker's answer is cut");
    list.resize(count);
  }
};

void pass(Pack& pack, UnpackedTable& t) {
  const auto all = [&](auto&... items) { (pack.item(items), ...); };
  all(t.table.name, t.table.version, t.table.licence, t.table.doc, t.table.symmetry, t.table.flags);
  pack.size(t.parameters);
  for (assay_parameter& p : t.parameters) all(p.name, p.unit, p.doc, p.default_value, p.lower, p.upper);
  pack.size(t.state);
  for (assay_state_variable& v : t.state) all(v.name, v.unit, v.doc, v.kind, v.role);
  pack.size(t.example);
  for (double& value : t.example) all(value);
  all(t.offered, t.material_class);
}

template <class... Extensions>
std::uint32_t offered_by(const assay_material& table, FunctionList<Extensions...> list) {
  std::uint32_t offered = 0;
  ((offered |= Offer<Extensions>(table, nullptr) ? 1u << place_in<Extensions>(list) : 0), ...);
  return offered;
}

/// An extension that is values; null where it is too short.
template <class Values>
const Values* values_of(const assay_material& table, const char* id) {
  const auto* found = static_cast<const Values*>(extension_of(&table, id));
  return found && found->struct_size >= sizeof(Values) ? found : nullptr;
}

}  // namespace

std::string packed(const assay_material& table) {
  UnpackedTable t;
  t.table.name = table.name, t.table.version = table.version, t.table.licence = table.licence;
  t.table.doc = table.doc, t.table.symmetry = table.symmetry, t.table.flags = table.flags;
  t.parameters.assign(table.parameters, table.parameters + table.parameter_count);
  t.state.assign(table.state, table.state + table.state_count);
  t.offered = offered_by(table, StatusExtensions{});
  static_cast<void>(Offer<assay_reason>(table, nullptr));  // which may throw, too
  const auto* example = values_of<assay_example>(table, ASSAY_EXTENSION_EXAMPLE);
  if (example && example->parameters) t.example.assign(example->parameters, example->parameters + t.parameters.size());
  const auto* symmetry = values_of<assay_symmetry>(table, ASSAY_EXTENSION_SYMMETRY);
  if (symmetry) t.material_class = symmetry->material_class;
  Pack pack;
  pass(pack, t);
  return pack.bytes;
}

void unpack(const std::string& bytes, UnpackedTable& out) {
  Pack pack{bytes, true, &out.words};
  pass(pack, out);
  out.table.abi_major = ASSAY_ABI_MAJOR;
  out.table.struct_size = sizeof(assay_material);
  out.table.parameter_count = static_cast<std::uint32_t>(out.parameters.size());
  out.table.state_count = static_cast<std::uint32_t>(out.state.size());
  out.table.parameters = out.parameters.data();
  out.table.state = out.state.data();
}

std::size_t state_size_of(const assay_material& table) {
  std::size_t size = 0;
  for (std::uint32_t k = 0; k < table.state_count; ++k)
    size += static_cast<std::size_t>(components_of_kind(table.state[k].kind));
  return size;
}

}  // namespace assay::adapters
