#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The files by which a project is cited, packaged and joined agree with the tree and the program.

  test_project_files.py SOURCE_DIR [ASSAY]   the files of the tree; with the program, its verbs and options, too
  test_project_files.py --faults SOURCE_DIR  planted faults are found

Without ASSAY the verbs are the files of drivers/verbs, which tests/house/test_verbs.cpp compares with the program.
Exit status: 0 good, 1 a fault. Without PyYAML it prints a line that begins with "skipped: ".
"""
import ast
import re
import subprocess
import sys
from pathlib import Path

try:
    import yaml
except ImportError as missing:
    print(f"skipped: {missing} (Debian package python3-yaml)")
    sys.exit(0)

NEXT = "0.2.0"  # the release that these files were made for
YAML = ["CITATION.cff", "action.yml", "packaging/judge/action.yml", ".pre-commit-hooks.yaml", "packaging/conda/meta.yaml",
        ".github/ISSUE_TEMPLATE/bug.yml", ".github/ISSUE_TEMPLATE/model.yml", ".github/ISSUE_TEMPLATE/config.yml"]
LICENSED = YAML + ["packaging/spack/package.py", "packaging/conda/build.sh", "packaging/pre-commit/each_file.sh"]
PLAIN = ["SECURITY.md", "CODE_OF_CONDUCT.md", "CONTRIBUTING.md", ".github/PULL_REQUEST_TEMPLATE.md", "docs/paper.md",
         "docs/paper.bib"]
# What CMake finds, and the packages that hold it.
SPACK = {"Eigen3": {"eigen"}, "Boost": {"boost"}, "yaml-cpp": {"yaml-cpp"}, "CLI11": {"cli11"}, "fmt": {"fmt"},
         "muparser": {"muparser"}, "nlohmann_json": {"nlohmann-json"}, "ZLIB": {"zlib", "zlib-api"}, "STB": {"stb"},
         "HDF5": {"hdf5"}, "Threads": set()}
CONDA = {"Eigen3": {"eigen"}, "Boost": {"libboost-headers"}, "yaml-cpp": {"yaml-cpp"}, "CLI11": {"cli11"},
         "fmt": {"fmt"}, "muparser": {"muparser"}, "nlohmann_json": {"nlohmann_json"}, "ZLIB": {"zlib"}, "STB": {"stb"},
         "HDF5": {"hdf5"}, "Threads": set()}
TOOLS = {"c", "cxx", "fortran", "cmake", "ninja", "googletest", "libxml2"}  # of the build and of the tests


class Tree:
    """The files of a source folder; `changed` has texts in place of some."""

    def __init__(self, root, changed=None):
        self.root, self.changed = Path(root), changed or {}

    def text(self, path):
        if path in self.changed:
            return self.changed[path]
        return (self.root / path).read_text(encoding="utf-8")

    def has(self, path):
        return path in self.changed or (self.root / path).is_file()


def found_by_cmake(tree):
    text = re.sub(r"#.*", "", tree.text("CMakeLists.txt"))
    found = set(re.findall(r"^find_package\(([\w-]+)", text, re.M))
    return found | set(re.findall(r"^find_path\((\w+)_INCLUDE_DIR\b", text, re.M))


def versions(tree):
    heading = re.search(r"^## \[?(\d+\.\d+\.\d+)", tree.text("CHANGELOG.md"), re.M)
    return {heading[1] if heading else "no version in CHANGELOG.md", NEXT}


def verbs(tree, assay):
    if assay:
        text = subprocess.run([assay, "--help"], check=True, capture_output=True, text=True).stdout
        return set(re.findall(r"^ {1,8}([a-z][a-z-]+) ", text.split("Subcommands:")[1], re.M))
    return {path.stem.replace("_", "-") for path in (tree.root / "drivers/verbs").glob("*.cpp")}


def options(tree, assay, verb):
    """The long options of a verb; None if nobody can be asked."""
    if not assay:
        return None
    return set(re.findall(r"--[a-z][a-z-]*", subprocess.run([assay, verb, "--help"], check=True, capture_output=True,
                                                             text=True).stdout))


def parsed(tree):
    """The values of all YAML files that can be read, and what is wrong with the others."""
    values, faults = {}, []
    for path in YAML:
        try:
            values[path] = yaml.safe_load(tree.text(path))
        except (OSError, yaml.YAMLError) as error:
            faults.append(f"{path}: {' '.join(str(error).split())}")
    return values, faults


def citation(tree, cff):
    required = ["cff-version", "message", "title", "authors", "version", "license", "type", "abstract", "keywords"]
    for key in required:
        if not cff.get(key):
            yield f"no {key}"
    if str(cff.get("cff-version")) != "1.2.0":
        yield f"cff-version is {cff.get('cff-version')}, not 1.2.0"
    if str(cff.get("version")) not in versions(tree):
        yield f"version {cff.get('version')} is none of {sorted(versions(tree))}"
    if cff.get("license") != "BSD-3-Clause":
        yield f"license {cff.get('license')}"
    if not all(author.get("name") or author.get("family-names") for author in cff.get("authors") or []):
        yield "an author without a name"
    paper = next((each for each in cff.get("references") or []
                  if {"Brannon", "Kamojjala", "Sadeghirad"} <=
                  {author.get("family-names") for author in each.get("authors", [])}), None)
    if not paper:
        yield "the paper of Brannon, Kamojjala and Sadeghirad is missing"
    elif not (paper.get("type") and paper.get("title")):
        yield "the paper has no type or no title"


def issue_form(form):
    for key in ("name", "description", "body"):
        if not form.get(key):
            yield f"no {key}"
    seen = set()
    for element in form.get("body") or []:
        kind = element.get("type")
        if kind not in ("markdown", "textarea", "input", "dropdown", "checkboxes"):
            yield f"type {kind}"
        if kind == "markdown":
            continue
        name = element.get("id")
        if not name or name in seen:
            yield f"id {name}: missing, or there twice"
        seen.add(name)
        if not element.get("attributes", {}).get("label"):
            yield f"{name}: no label"


def action(tree, assay, value, path="action.yml", wanted=("model", "props", "statev", "parameters", "junit")):
    text = tree.text(path)
    declared, used = set(value.get("inputs") or {}), set(re.findall(r"\binputs\.([\w-]+)", text))
    for name in sorted(used - declared):
        yield f"input {name} is used and not declared"
    for name in sorted(declared - used):
        yield f"input {name} is declared and not used"
    for name in sorted(set(wanted) - declared):
        yield f"no input {name}"
    if value.get("runs", {}).get("using") != "composite":
        yield "runs.using is not composite"
    steps = value.get("runs", {}).get("steps") or []
    for step in steps:
        if "run" in step and not step.get("shell"):
            yield f"step {step.get('name')}: no shell"
        if "${{" in step.get("run", ""):
            yield f"step {step.get('name')}: an expression in a script is code to whoever sets it; take env"
    known = verbs(tree, assay)
    for step in steps:
        script = step.get("run", "")
        for verb in re.findall(r"^\s*assay ([a-z][a-z-]*)", script, re.M):
            if verb not in known:
                yield f"assay has no verb {verb}"
            else:
                there = options(tree, assay, verb)
                taken = {each for line in re.findall(r"arguments\+?=\((.*)\)", script)
                         for each in re.findall(r"--[a-z][a-z-]*", line)}
                for option in sorted(taken - there if there is not None else ()):
                    yield f"assay {verb} has no option {option}"


def hooks(tree, assay, value):
    wanted = {"assay-check": "check", "assay-scene": "explain"}
    for name in sorted(set(wanted) - {hook.get("id") for hook in value or []}):
        yield f"no hook {name}"
    for hook in value or []:
        name = hook.get("id")
        for key in ("id", "name", "entry", "language"):
            if not hook.get(key):
                yield f"{name}: no {key}"
        program, *words = str(hook.get("entry")).split()
        verb = words[0] if words else ""
        if hook.get("language") == "script" and not tree.has(program):
            yield f"{name}: no file {program}"
        if verb not in verbs(tree, assay):
            yield f"{name}: assay has no verb '{verb}'"
        elif wanted.get(name, verb) != verb:
            yield f"{name}: calls {verb}"
        else:
            there = options(tree, assay, verb)
            for option in hook.get("args") or []:
                if there is not None and option.startswith("--") and option not in there:
                    yield f"{name}: assay {verb} has no option {option}"
        try:
            re.compile(hook.get("files", ""))
        except re.error as error:
            yield f"{name}: files: {error}"


def compared(tree, names, where):
    """Faults of a list of dependencies against what CMakeLists.txt finds."""
    found = found_by_cmake(tree)
    for name in sorted(found - set(where)):
        yield f"CMakeLists.txt finds {name}: this test and the recipes do not know it"
    known = set()
    for name in sorted(found & set(where)):
        known |= where[name]
        if where[name] and not where[name] & names:
            yield f"{name} of CMakeLists.txt is no dependency"
    for name in sorted(names - known - TOOLS):
        yield f"{name} is a dependency, and CMakeLists.txt does not find it"


def spack(tree):
    try:
        module = ast.parse(tree.text("packaging/spack/package.py"))
    except SyntaxError as error:
        yield f"line {error.lineno}: {error.msg}"
        return
    recipe = next((each for each in module.body if isinstance(each, ast.ClassDef)), None)
    if not recipe or recipe.name != "Assay" or "CMakePackage" not in [ast.unparse(base) for base in recipe.bases]:
        yield "no class Assay(CMakePackage)"
        return
    names = set()
    for call in ast.walk(recipe):
        if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "depends_on":
            names.add(re.match(r"[\w-]+", call.args[0].value)[0])
    yield from compared(tree, names, SPACK)
    least = re.search(r"cmake_minimum_required\(VERSION ([\d.]+)\)", tree.text("CMakeLists.txt"))[1]
    if f'"cmake@{least}:"' not in tree.text("packaging/spack/package.py"):
        yield f"cmake is not that of CMakeLists.txt, {least}"


def conda(tree, value):
    version = str(value.get("package", {}).get("version"))
    if version not in versions(tree):
        yield f"version {version} is none of {sorted(versions(tree))}"
    names = {re.match(r"[\w-]+", line)[0] for line in value.get("requirements", {}).get("host", [])}
    yield from compared(tree, names, CONDA)


def paper(tree):
    text, books = tree.text("docs/paper.md"), tree.text("docs/paper.bib")
    there = set(re.findall(r"^@\w+\{([^,\s]+),", books, re.M))
    cited = set(re.findall(r"@([a-z]+\d{4}[a-z]*)", text.split("\n---\n", 1)[1]))
    for key in sorted(cited - there):
        yield f"{key} is cited and not in paper.bib"
    for key in sorted(there - cited):
        yield f"{key} is in paper.bib and not cited"
    try:
        head = yaml.safe_load(text.split("\n---\n", 1)[0].lstrip("-"))
    except yaml.YAMLError as error:
        yield f"its first block is no YAML: {' '.join(str(error).split())}"
        return
    for key in ("title", "tags", "authors", "affiliations", "date", "bibliography"):
        if not head.get(key):
            yield f"no {key}"


def faults_of(tree, assay=None):
    """All faults, each as "FILE: what"."""
    values, faults = parsed(tree)
    for path in LICENSED:
        lines = tree.text(path).splitlines()[:2] if tree.has(path) else []
        if not any("SPDX-License-Identifier: BSD-3-Clause" in line for line in lines):
            faults.append(f"{path}: no licence in its first two lines, or no such file")
    faults += [f"{path}: no such file" for path in PLAIN if not tree.has(path)]
    checks = {"CITATION.cff": lambda value: citation(tree, value),
              "action.yml": lambda value: action(tree, assay, value),
              "packaging/judge/action.yml": lambda value: action(tree, assay, value, "packaging/judge/action.yml",
                                                                 ("scene", "runs", "map", "h", "order", "junit")),
              ".pre-commit-hooks.yaml": lambda value: hooks(tree, assay, value),
              "packaging/conda/meta.yaml": lambda value: conda(tree, value),
              ".github/ISSUE_TEMPLATE/bug.yml": issue_form,
              ".github/ISSUE_TEMPLATE/model.yml": issue_form}
    for path, check in checks.items():
        if path in values:
            faults += [f"{path}: {fault}" for fault in check(values[path])]
    faults += [f"packaging/spack/package.py: {fault}" for fault in spack(tree)]
    faults += [f"docs/paper.md: {fault}" for fault in paper(tree)]
    return faults


PLANTED = [
    ("CITATION.cff", "version: 0.2.0", "version: 0.0.9", "version 0.0.9 is none of"),
    ("CITATION.cff", "message:", "massage:", "no message"),
    ("CITATION.cff", "family-names: Kamojjala", "family-names: Somebody", "is missing"),
    ("CITATION.cff", "authors:\n", "authors: [\n", "CITATION.cff: while parsing"),
    ("action.yml", "${{ inputs.props }}", "${{ inputs.prop }}", "input prop is used and not declared"),
    ("action.yml", "      shell: bash\n", "", "no shell"),
    ("action.yml", "assay check ", "assay chek ", "no verb chek"),
    ("action.yml", '"$MODEL" --junit', '"${{ inputs.model }}" --junit', "an expression in a script"),
    ("packaging/judge/action.yml", "assay judge ", "assay jugde ", "no verb jugde"),
    (".pre-commit-hooks.yaml", "each_file.sh explain", "each_file.sh explian", "no verb 'explian'"),
    (".pre-commit-hooks.yaml", "each_file.sh check", "no_file.sh check", "no file"),
    (".pre-commit-hooks.yaml", "id: assay-scene\n  name", "id: assay-seen\n  name", "no hook assay-scene"),
    (".github/ISSUE_TEMPLATE/bug.yml", "id: scene", "id: version", "there twice"),
    ("packaging/spack/package.py", 'depends_on("fmt@9:")', "pass", "fmt of CMakeLists.txt is no dependency"),
    ("packaging/spack/package.py", 'depends_on("stb")', 'depends_on("stb")\n    depends_on("netcdf-c")', "netcdf-c is a dep"),
    ("packaging/spack/package.py", "return [\n", "return [[\n", "package.py: line"),
    ("packaging/spack/package.py", "cmake@3.25:", "cmake@3.10:", "cmake is not"),
    ("packaging/conda/meta.yaml", "- zlib\n", "- zstd\n", "ZLIB of CMakeLists.txt is no dependency"),
    ("CMakeLists.txt", "find_package(fmt REQUIRED)", "find_package(LLVM REQUIRED)", "CMakeLists.txt finds LLVM"),
    ("docs/paper.md", "[@roache2002manufactured]", "[@roache2003manufactured]", "roache2003manufactured is cited"),
    ("packaging/conda/build.sh", "SPDX-License-Identifier", "SPDX", "build.sh: no licence"),
]


def planted_faults(root):
    """Each planted fault is found, and nothing in what it was planted in."""
    misjudged = [f"without a planted fault: {fault}" for fault in faults_of(Tree(root))]
    for path, before, after, said in PLANTED:
        text = Tree(root).text(path)
        if before not in text:
            misjudged.append(f"nothing to plant in {path}: {before!r} is not there")
        elif not any(said in fault for fault in faults_of(Tree(root, {path: text.replace(before, after, 1)}))):
            misjudged.append(f"not found in {path}: {after!r}")
    print("\n".join(misjudged + [f"{len(PLANTED)} planted: {len(misjudged)} faults"]))
    return 1 if misjudged else 0


def main(words):
    if len(words) == 2 and words[0] == "--faults":
        return planted_faults(words[1])
    if len(words) not in (1, 2) or words[0].startswith("-"):
        print(__doc__.strip())
        return 2
    faults = faults_of(Tree(words[0]), words[1] if len(words) == 2 else None)
    print("\n".join(faults + [f"{len(LICENSED) + len(PLAIN)} files: {len(faults)} faults"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
