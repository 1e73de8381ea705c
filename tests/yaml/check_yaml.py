# SPDX-License-Identifier: BSD-3-Clause
"""YAML of this tree, and YAML that the program has written, read by others than the program.

  check_yaml.py shipped ASSAY SOURCE_DIR   scenes, studies, descriptions, templates, and the YAML blocks of the pages
  check_yaml.py written ASSAY BUILD_DIR    what the tests have left in a build folder
  check_yaml.py faults  ASSAY SOURCE_DIR   planted faults are found

Each file must be the same to a reader of YAML 1.1 (PyYAML) and to one of YAML 1.2 (its core schema); scenes and studies
must satisfy `assay schema` by the package jsonschema. Exit status: 0 good, 1 a fault. Without one of the two packages
it prints a line that begins with "skipped: ".
"""
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(f"skipped: {missing} (Debian packages python3-yaml and python3-jsonschema)")
    sys.exit(0)

if not hasattr(jsonschema, "Draft202012Validator"):
    print("skipped: the package jsonschema is older than 4.0")
    sys.exit(0)

Reader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)  # the same rules; in C it is ten times as fast


class Reader12(Reader):
    """Scalars by the core schema of YAML 1.2 (section 10.3.2)."""


def core_schema():
    Reader12.yaml_implicit_resolvers = {}
    for tag, pattern, first in (
        ("null", r"^(?:~|null|Null|NULL|)$", ["~", "n", "N", ""]),
        ("bool", r"^(?:true|True|TRUE|false|False|FALSE)$", list("tTfF")),
        ("int", r"^(?:[-+]?[0-9]+|0o[0-7]+|0x[0-9a-fA-F]+)$", list("-+0123456789")),
        ("float", r"^(?:[-+]?(?:\.[0-9]+|[0-9]+(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?"
                  r"|[-+]?\.(?:inf|Inf|INF)|\.(?:nan|NaN|NAN))$", list("-+.0123456789")),
        ("merge", r"^<<$", ["<"]),  # of no schema of 1.2, and read by nearly everybody
    ):
        Reader12.add_implicit_resolver("tag:yaml.org,2002:" + tag, re.compile(pattern), first)

    def whole(loader, node):
        base = {"0o": 8, "0x": 16}.get(node.value[:2], 10)
        return int(node.value[2:] if base != 10 else node.value, base)

    def number(loader, node):
        return float(re.sub(r"^([-+]?)\.(inf|nan)$", r"\1\2", node.value.lower()))

    Reader12.add_constructor("tag:yaml.org,2002:int", whole)
    Reader12.add_constructor("tag:yaml.org,2002:float", number)


core_schema()


def difference(a, b, path=""):
    """Where two values are not the same, types included; None where they are."""
    if type(a) is not type(b):
        return f"{path or 'the whole'}: {a!r} to YAML 1.1, {b!r} to YAML 1.2"
    if isinstance(a, dict):
        for (key, inside), (other, opposite) in zip(a.items(), b.items()):
            found = difference(key, other, f"{path}.{key}") or difference(inside, opposite, f"{path}.{key}")
            if found:
                return found
        return None if len(a) == len(b) else f"{path}: keys differ"
    if isinstance(a, list):
        for at, (inside, opposite) in enumerate(zip(a, b)):
            found = difference(inside, opposite, f"{path}[{at}]")
            if found:
                return found
        return None if len(a) == len(b) else f"{path}: lengths differ"
    if isinstance(a, float):
        same = (math.isnan(a) and math.isnan(b)) or (a == b and math.copysign(1, a) == math.copysign(1, b))
        return None if same else f"{path}: {a!r} to YAML 1.1, {b!r} to YAML 1.2"
    return None if a == b else f"{path}: {a!r} to YAML 1.1, {b!r} to YAML 1.2"


def read(text):
    """The value, and what is wrong with the text."""
    try:
        value, other = yaml.load(text, Reader), yaml.load(text, Reader12)
    except (yaml.YAMLError, ValueError) as error:
        return None, " ".join(str(error).split())
    return value, difference(value, other)


class Schema:
    def __init__(self, assay, *words):
        schema = json.loads(subprocess.run([assay, "schema", *words], check=True, capture_output=True).stdout)
        kind = jsonschema.validators.validator_for(schema)
        if kind is not jsonschema.Draft202012Validator:
            sys.exit(f"assay schema {' '.join(words)} is of another draft: {schema.get('$schema')}")
        kind.check_schema(schema)
        self.validator = kind(schema)

    def fault(self, value):
        errors = sorted(self.validator.iter_errors(value), key=lambda e: list(map(str, e.path)))
        if not errors:
            return None
        best = jsonschema.exceptions.best_match(errors)
        return ".".join(map(str, best.absolute_path)) + ": " + best.message[:300]


def description_fault(value):
    """Descriptions of materials have no schema: what is to be a number is one."""
    def numbers(inside, path):
        if isinstance(inside, dict):
            for key, more in inside.items():
                if key not in ("unit", "doc", "kind"):
                    yield from numbers(more, f"{path}.{key}")
        elif isinstance(inside, list):  # of names, or of initial values
            return
        elif inside is None:
            return
        elif isinstance(inside, bool) or not isinstance(inside, (int, float)):
            yield f"{path}: {inside!r} is no number"

    if not isinstance(value, dict) or not isinstance(value.get("library"), str):
        return "library: is no text"
    for key in ("parameters", "properties", "density", "temperature", "time_limit", "memory_limit"):
        for fault in numbers(value.get(key, 1), key):
            return fault
    return None


class Check:
    def __init__(self, assay):
        self.scenes, self.studies, self.paths = Schema(assay), Schema(assay, "--study"), Schema(assay, "--path")
        self.counts, self.faults = {}, []

    def fault_of(self, text, kind):
        value, fault = read(text)
        if fault:
            return fault
        if kind == "scene":
            return self.scenes.fault(value)
        if kind == "study":
            return self.studies.fault(value)
        if kind == "path":
            return self.paths.fault(value)
        return description_fault(value) if kind == "description" else None

    def take(self, name, text, kind):
        self.counts[kind] = self.counts.get(kind, 0) + 1
        fault = self.fault_of(text, kind)
        if fault:
            self.faults.append(f"{name}: {fault}")

    def kind_of(self, path, text):
        """Of a file of the tree."""
        if path.parent.name == "studies":
            return "study"
        if re.search(r"^(path|stages):", text, re.M):
            return "path"
        return "description" if re.search(r"^library:", text, re.M) else "scene"

    def end(self, least):
        """Says what was found. A check that saw too few files is a fault of the check."""
        said = ", ".join(f"{count} {kind}" for kind, count in sorted(self.counts.items()))
        for kind, count in least.items():
            if self.counts.get(kind, 0) < count:
                self.faults.append(f"only {self.counts.get(kind, 0)} of kind {kind}, at least {count} expected")
        print("\n".join(self.faults + [f"{said}: {len(self.faults)} faults"]))
        return 1 if self.faults else 0


def shipped(assay, source):
    check = Check(assay)
    for path in sorted(source.glob("configs/**/*.yaml")) + sorted(source.glob("tests/**/*.yaml")):
        text = path.read_text()
        check.take(path, text, check.kind_of(path, text))
    for path in sorted(source.glob("drivers/templates/*/*.yaml.in")):
        text = re.sub("@([A-Z]+)@", "a_word", path.read_text())
        check.take(path, text, check.kind_of(path, text))
    for path in [source / "README.md", *sorted(source.glob("docs/*.md"))]:
        for at, block in enumerate(re.findall(r"^```yaml[^\n]*\n(.*?)^```", path.read_text(), re.M | re.S)):
            if not re.search("^jobs:", block, re.M):  # a workflow of GitHub, whose key `on` is true to YAML 1.1
                check.take(f"{path}, block {at + 1}", block, "block")
    return check.end({"scene": 100, "study": 8, "path": 5, "description": 5, "block": 5})


def written(assay, build):
    check = Check(assay)
    kept = build / "yaml_of_tests"
    since = pathlib.Path(assay).stat().st_mtime  # what is older was written by another program

    def fresh(pattern):
        return [path for path in sorted(build.glob(pattern)) if path.stat().st_mtime >= since]

    for pattern in ("scenes/**/resolved.yaml", "studies/**/resolved.yaml", "studies/**/case.yaml"):
        for path in fresh(pattern):
            text = path.read_text()
            check.take(path, text, check.kind_of(path, text) if path.parent.name != "studies" else "scene")
    for path in fresh("scenes/**/replay*.yaml"):
        check.take(path, path.read_text(), "scene" if path.name == "replay_scene.yaml" else "plain")
    for path in fresh("yaml_of_tests/*.yaml"):
        kind = path.name.split(".")[0]
        check.take(path, path.read_text(), kind)
        if kind == "values":
            expected = json.loads(path.with_suffix(".json").read_text())
            value = read(path.read_text())[0]
            if isinstance(value, dict):  # a whole number is one to JSON's reader only where it has no point
                value["numbers"] = [float(number) for number in value["numbers"]]
                expected["numbers"] = [float(number) for number in expected["numbers"]]
                fault = difference(value, expected)
                if fault:
                    check.faults.append(f"{path}, and what was to be written: {fault}")
    for path in kept.glob("*"):
        if path.stat().st_mtime < since:
            path.unlink(missing_ok=True)
    return check.end({"scene": 90, "values": 1})


def faults(assay, source):
    """Each of these must be found, and nothing in what they were made from."""
    check = Check(assay)
    scene = (source / "configs/paper/vortex_cpdi.yaml").read_text()
    study = (source / "configs/studies/quick.yaml").read_text()
    material = (source / "tests/adapters/foreign/umat_neo_hookean.yaml").read_text()
    planted = [
        ("scene", scene, "", "", None),
        ("scene", scene, "E: 1.0e+3", "E: 1.0e3", "material.parameters.E: '1.0e3' to YAML 1.1"),
        ("scene", scene, "E: 1.0e+3", "E: 1e-08", "material.parameters.E: '1e-08' to YAML 1.1"),
        ("scene", scene, "E: 1.0e+3", "E: '1.0e+3'", "not of type 'number'"),
        ("scene", scene, "E: 1.0e+3", "E: 0100", "64 to YAML 1.1, 100 to YAML 1.2"),
        ("scene", scene, "E: 1.0e+3", "E: 1:30", "90 to YAML 1.1, '1:30' to YAML 1.2"),
        ("scene", scene, "E: 1.0e+3", "E: 1_000", "1000 to YAML 1.1, '1_000' to YAML 1.2"),
        ("scene", scene, "title: ", "title: no #", "title: False to YAML 1.1, 'no' to YAML 1.2"),
        ("scene", scene, "title: ", "title: 2001-12-14 #", "to YAML 1.1, '2001-12-14' to YAML 1.2"),
        ("scene", scene, "title: ", "title: = #", "could not determine a constructor"),
        ("scene", scene, "\ngrid:", "\ngird:", "'gird' does not match"),
        ("scene", scene, "spacing: ", "spacings: ", "'spacings' does not match"),
        ("scene", scene, "\ngrid:", "\nx-soft: &soft {E: 1}\ngrid:", None),
        ("scene", "x-soft: &soft {E: 1.0e+3}\n" + scene, "{E: 1.0e+3, nu", "{<<: *soft, nu", None),
        ("scene", "x-soft: &soft {E: soft}\n" + scene, "{E: 1.0e+3, nu", "{<<: *soft, nu", "'soft' is not of type"),
        ("scene", scene, "spacing: ", "x-spacing: ", "'x-spacing' does not match"),
        ("scene", scene, "basis: cpdi", "basis: cpdi9", "'cpdi9' is not one of"),
        ("scene", scene, "title: ", "titles: {", "while parsing"),
        ("study", study, "", "", None),
        ("study", study, "\naxes:", "\naxis:", "'axis' does not match"),
        ("study", study, "\nscene:", "\n#", "'scene' is a required property"),
        ("description", material, "", "", None),
        ("description", material, "E: 1.0e+3", "E: 1.0e3", "'1.0e3' to YAML 1.1"),
        ("description", material, "E: 1.0e+3", "E: soft", "'soft' is no number"),
    ]
    for kind, text, before, after, said in planted:
        if before not in text:
            check.faults.append(f"nothing to plant {after!r} in: {before!r} is not there")
            continue
        with tempfile.NamedTemporaryFile("w+", suffix=".yaml") as file:
            file.write(text.replace(before, after, 1))
            file.flush()
            found = check.fault_of(pathlib.Path(file.name).read_text(), kind)
        if (found is None) != (said is None) or (said and said not in found):
            check.faults.append(f"{kind} with {after!r}: expected {said!r}, found {found!r}")
    json_of = [({"a": 1}, {"a": 1.0}), ([1], [1, 2]), (0.0, -0.0), ({"a": 1}, {"a": 1, "b": 2}), ("1", 1), (True, 1)]
    check.faults += [f"{a!r} and {b!r} are told apart by nothing" for a, b in json_of if not difference(a, b)]
    print("\n".join(check.faults + [f"{len(planted)} planted: {len(check.faults)} faults"]))
    return 1 if check.faults else 0


if __name__ == "__main__":
    checks = {"shipped": shipped, "written": written, "faults": faults}
    if len(sys.argv) != 4 or sys.argv[1] not in checks:
        sys.exit(__doc__)
    sys.exit(checks[sys.argv[1]](sys.argv[2], pathlib.Path(sys.argv[3])))
