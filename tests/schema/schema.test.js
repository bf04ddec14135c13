// Validates plans against the plan's schema with ajv, a standard validator of JSON Schema. Plans
// are read as YAML 1.2, in which yes and no are strings.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import Ajv from "ajv/dist/2020.js";
import YAML from "yaml";

const root = new URL("../../", import.meta.url);
const text = (path) => readFileSync(new URL(path, root), "utf8");

// strictTypes requires the type of a quantity next to each of its bounds; here it is in the
// definition
const ajv = new Ajv({ strict: true, strictTypes: false, allowUnionTypes: true, strictRequired: false });
ajv.addKeyword("x-dimension");
const valid = ajv.compile(JSON.parse(text("inst/schema/plan.schema.json")));

for (const file of readdirSync(new URL("inst/gears/", root))) {
  test(`schema accepts ${file}`, () => {
    const plan = YAML.parse(text(`inst/gears/${file}`));
    assert.ok(valid(plan), JSON.stringify(valid.errors));
  });
}

for (const [net, verdict] of [["my_net.csv", true], ["", false], [7, false]]) {
  test(`schema judges net: ${JSON.stringify(net)} as ${verdict ? "right" : "wrong"}`, () => {
    const plan = YAML.parse(text("inst/extdata/two_seam_trawl.yaml"));
    assert.equal(valid({ ...plan, net }), verdict);
  });
}

const cases = YAML.parse(text("tests/testthat/right-and-wrong.yaml"));
for (const verdict of ["right", "wrong"]) {
  for (const [old, replacement] of cases[verdict]) {
    test(`schema judges ${JSON.stringify(replacement)} for ${JSON.stringify(old)} as ${verdict}`, () => {
      assert.ok(cases.plan.includes(old));
      const plan = YAML.parse(cases.plan.replaceAll(old, String(replacement)));
      assert.equal(valid(plan), verdict === "right");
    });
  }
}
