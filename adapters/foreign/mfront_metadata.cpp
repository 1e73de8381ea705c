// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/mfront_metadata.hpp"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <optional>

#include "adapters/elf_symbols.hpp"
#include "adapters/foreign/foreign_state.hpp"

namespace assay::adapters {

namespace {

/// Bytes of a symbol, as its library says; 0 where it does not.
std::size_t size_of_symbol(const void* address) {
  Dl_info info;
  void* symbol = nullptr;
  const bool found = dladdr1(address, &info, &symbol, RTLD_DL_SYMENT) != 0 && symbol;
  return found ? static_cast<const ElfW(Sym)*>(symbol)->st_size : 0;
}

/// The symbols of one behaviour; what is said for the hypothesis goes before what is said for all.
class Symbols {
 public:
  Symbols(void* library, std::string behaviour, std::string hypothesis)
      : library_(library), behaviour_(std::move(behaviour)), hypothesis_(std::move(hypothesis)) {}
  const std::string& hypothesis() const { return hypothesis_; }

  void* find(const std::string& what) const {
    if (void* own = dlsym(library_, (behaviour_ + "_" + hypothesis_ + "_" + what).c_str())) return own;
    return dlsym(library_, (behaviour_ + "_" + what).c_str());
  }

  /// The value of a symbol; nothing where there is none.
  template <class T>
  std::optional<T> value(const std::string& what) const {
    const void* found = find(what);
    return found ? std::optional<T>(*static_cast<const T*>(found)) : std::nullopt;
  }

  unsigned number(const std::string& what, unsigned otherwise = 0) const {
    return value<unsigned short>(what).value_or(otherwise);
  }

  std::string text(const std::string& what) const {
    const char* words = value<const char*>(what).value_or(nullptr);
    return words ? words : "";
  }

  /// nWHAT names, and their types where `types` names an array of them.
  std::vector<MfrontVariable> variables(const std::string& what, const std::string& types) const {
    std::vector<MfrontVariable> list(number("n" + what));
    const auto* names =
        static_cast<const char* const*>(list.empty() ? nullptr : array(what, list.size() * sizeof(char*)));
    const auto* kinds =
        static_cast<const int*>(list.empty() || types.empty() ? nullptr : array(types, list.size() * sizeof(int)));
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (!names || !names[k]) throw ModelRefused("library", "its symbol for " + what + " is missing");
      list[k].name = names[k];
      list[k].type = kinds ? kinds[k] : 0;
    }
    return list;
  }

  /// A symbol of at least so many bytes.
  const void* array(const std::string& what, std::size_t bytes) const {
    const void* found = find(what);
    const std::size_t size = found ? size_of_symbol(found) : 0;
    if (size != 0 && size < bytes)
      throw ModelRefused("library", "its symbol for " + what + " is shorter than its count");
    return found;
  }

 private:
  void* library_;
  std::string behaviour_, hypothesis_;
};

/// Constants that come before the listed properties although they are not listed.
std::vector<std::string> prepended(const Symbols& symbols, bool orthotropic, std::size_t symmetric) {
  using Names = std::vector<std::string>;
  Names names, expansions;
  if (symbols.number("requiresStiffnessTensor") != 0)
    names = symbols.number("ElasticSymmetryType") == 0
                ? Names{"YoungModulus", "PoissonRatio"}
                : Names{"YoungModulus1",  "YoungModulus2",  "YoungModulus3",  "PoissonRatio12", "PoissonRatio23",
                        "PoissonRatio13", "ShearModulus12", "ShearModulus23", "ShearModulus13"};
  constexpr std::size_t normal = 3;
  if (names.size() > 2) names.resize(2 * normal + symmetric - normal);  // a shear modulus for each shear
  if (symbols.number("requiresThermalExpansionCoefficientTensor") != 0)
    expansions =
        orthotropic ? Names{"ThermalExpansion1", "ThermalExpansion2", "ThermalExpansion3"} : Names{"ThermalExpansion"};
  names.insert(names.end(), expansions.begin(), expansions.end());
  return names;
}

void require_served(const Symbols& symbols, MfrontBehaviour& behaviour) {
  const std::string interface = symbols.text("mfront_interface");
  if (interface != "Generic") {
    throw ModelRefused("symbol", "behaviour '" + behaviour.name + "' was made for MFront's interface '" + interface +
                                     "', not for the generic one");
  }
  const unsigned version = symbols.number("api_version");
  if (version != 1) {
    throw ModelRefused("library", "its generic interface has api_version " + std::to_string(version) +
                                      ", and 1 is served, which TFEL 3.4.1 and later ones generate");
  }
  constexpr unsigned small_strain_type = 1, finite_strain_type = 2, small_kinematic = 1, cauchy_kinematic = 3;
  const unsigned type = symbols.number("BehaviourType"), kinematic = symbols.number("BehaviourKinematic");
  behaviour.finite_strain = type == finite_strain_type && kinematic == cauchy_kinematic;
  if (!behaviour.finite_strain && !(type == small_strain_type && kinematic == small_kinematic)) {
    throw ModelRefused("symbol", "behaviour '" + behaviour.name + "' is of type " + std::to_string(type) +
                                     " and kinematic " + std::to_string(kinematic) +
                                     ": small strains and F with Cauchy's stress are served");
  }
}

/// The one gradient and the one force that belong to the type and the kinematic, and the hypothesis among those named.
void require_consistent(const Symbols& symbols, const MfrontBehaviour& behaviour) {
  const auto require_one = [&](const char* what, int type) {
    const std::vector<MfrontVariable> list = symbols.variables(what, what + std::string("Types"));
    if (list.size() == 1 && list[0].type == type) return;
    throw ModelRefused("library", "its symbols for " + std::string(what) + " contradict its type: " +
                                      (list.size() == 1 ? "a variable of kind " + std::to_string(list[0].type)
                                                        : std::to_string(list.size()) + " variables") +
                                      ", not one of kind " + std::to_string(type));
  };
  constexpr int symmetric_tensor = 1, tensor = 3;
  require_one("Gradients", behaviour.finite_strain ? tensor : symmetric_tensor);
  require_one("ThermodynamicForces", symmetric_tensor);
  const std::vector<MfrontVariable> hypotheses = symbols.variables("ModellingHypotheses", "");
  if (has_name(hypotheses, symbols.hypothesis())) return;
  throw ModelRefused(
      "hypothesis",
      "behaviour '" + behaviour.name + "' does not name the hypothesis " + symbols.hypothesis() + " among its own",
      hypotheses.empty() ? "none" : listed_names(hypotheses));
}

/// "p[0]" in names of symbols: p_mfront_index_0.
std::string symbol_word(std::string name) {
  const std::size_t open = name.find('[');
  if (open == std::string::npos || name.back() != ']') return name;
  return name.substr(0, open) + "_mfront_index_" + name.substr(open + 1, name.size() - open - 2);
}

/// Of a property; infinite where nothing is said.
MfrontVariable with_bounds(const Symbols& symbols, MfrontVariable variable) {
  const auto bound = [&](const char* which, double otherwise) {
    const auto said = symbols.value<long double>(symbol_word(variable.name) + which);
    return said ? static_cast<double>(*said) : otherwise;
  };
  variable.lower = bound("_LowerPhysicalBound", variable.lower);
  variable.upper = bound("_UpperPhysicalBound", variable.upper);
  return variable;
}

void read_parameters(const Symbols& symbols, MfrontBehaviour& behaviour) {
  constexpr int real_number = 0;
  for (const MfrontVariable& parameter : symbols.variables("Parameters", "ParametersTypes")) {
    if (parameter.type != real_number) continue;
    const auto value = symbols.value<double>(symbol_word(parameter.name) + "_ParameterDefaultValue");
    if (value) behaviour.parameters.push_back({parameter.name, *value});
  }
}

}  // namespace

const std::vector<std::string>& mfront_hypotheses() {
  static const std::vector<std::string> names{"Tridimensional", "PlaneStrain", "GeneralisedPlaneStrain",
                                              "Axisymmetrical"};
  return names;
}

std::vector<std::string> mfront_behaviours(const std::string& path) {
  const std::string ending = "_mfront_ept";
  std::vector<std::string> names;
  for (const std::string& symbol : exported_symbols(path)) {
    if (symbol.ends_with(ending)) names.push_back(symbol.substr(0, symbol.size() - ending.size()));
  }
  // of a behaviour that says it for each hypothesis too
  std::erase_if(names, [&](const std::string& name) {
    return std::ranges::any_of(names, [&](const auto& other) {
      return std::ranges::any_of(mfront_hypotheses(), [&](const auto& each) { return name == other + "_" + each; });
    });
  });
  return names;
}

MfrontBehaviour mfront_behaviour(void* library, const std::string& name, const std::vector<std::string>& known,
                                 const std::string& hypothesis) {
  std::string list;
  for (const std::string& each : known) list += (list.empty() ? "" : ", ") + each;
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw ModelRefused("symbol", "the library has no behaviour '" + name + "'", list.empty() ? "none" : list);
  const Symbols symbols(library, name, hypothesis);
  MfrontBehaviour behaviour;
  if (hypothesis != "Tridimensional") behaviour.symmetric = 4, behaviour.tensor = 5;
  behaviour.name = name;
  behaviour.set_parameter = symbols.find("setParameter");
  behaviour.version = symbols.text("tfel_version");
  require_served(symbols, behaviour);
  behaviour.entry = dlsym(library, (name + "_" + hypothesis).c_str());
  if (!behaviour.entry) {
    throw ModelRefused("hypothesis", "behaviour '" + name + "' has no function for the hypothesis " + hypothesis);
  }
  require_consistent(symbols, behaviour);
  behaviour.orthotropic = symbols.number("SymmetryType") != 0;
  behaviour.temperature = symbols.number("TemperatureRemovedFromExternalStateVariables", 1) != 0;
  behaviour.prepended = prepended(symbols, behaviour.orthotropic, behaviour.symmetric);
  for (const MfrontVariable& property : symbols.variables("MaterialProperties", "")) {
    behaviour.properties.push_back(with_bounds(symbols, property));
  }
  behaviour.internal = symbols.variables("InternalStateVariables", "InternalStateVariablesTypes");
  behaviour.external = symbols.variables("ExternalStateVariables", "ExternalStateVariablesTypes");
  read_parameters(symbols, behaviour);
  return behaviour;
}

}  // namespace assay::adapters
