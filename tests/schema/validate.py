"""Validates plans against the plan's schema with Python's jsonschema. Plans are read as YAML 1.1 and
as YAML 1.2, in which yes and no are strings. Requires jsonschema (4.0 or newer) and PyYAML."""

import json
import pathlib
import re
import sys

import jsonschema
import yaml

root = pathlib.Path(__file__).resolve().parents[2]


class Yaml12(yaml.SafeLoader):
    """YAML 1.2: only true and false are logical values."""


Yaml12.yaml_implicit_resolvers = {
    letter: [(tag, rule) for tag, rule in rules if tag != "tag:yaml.org,2002:bool"]
    for letter, rules in yaml.SafeLoader.yaml_implicit_resolvers.items()
}
Yaml12.add_implicit_resolver(
    "tag:yaml.org,2002:bool", re.compile("^(?:true|True|TRUE|false|False|FALSE)$"),
    list("tTfF"),
)

schema = json.loads((root / "inst/schema/plan.schema.json").read_text("utf-8"))
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)

failures = []
checked = 0


def expect(name, text, right):
    global checked
    for loader in (yaml.SafeLoader, Yaml12):
        checked += 1
        if validator.is_valid(yaml.load(text, Loader=loader)) != right:
            failures.append(f"{name} read by {loader.__name__} is not {'right' if right else 'wrong'}")


for file in sorted((root / "inst/gears").glob("*.yaml")):
    expect(file.name, file.read_text("utf-8"), True)

trawl = (root / "inst/extdata/two_seam_trawl.yaml").read_text("utf-8").partition("\nnet:")[0]
expect("net: my_net.csv", trawl + "\nnet: my_net.csv", True)
expect("net: ''", trawl + "\nnet: ''", False)

cases = yaml.safe_load((root / "tests/testthat/right-and-wrong.yaml").read_text("utf-8"))
for verdict in ("right", "wrong"):
    for old, replacement in cases[verdict]:
        # PyYAML reads 1e2 as a string, by the rules of YAML 1.1
        if replacement in ("1e2", 100.0):
            continue
        assert old in cases["plan"], old
        expect(repr(replacement), cases["plan"].replace(old, str(replacement)), verdict == "right")

print("\n".join(failures) or f"{checked} plans judged as expected")
sys.exit(1 if failures else 0)
