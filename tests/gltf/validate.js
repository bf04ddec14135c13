// Prints the result of the glTF validator for a file, as JSON: counts and messages of issues.
const validator = require("gltf-validator");
const { readFileSync } = require("node:fs");

validator.validateBytes(new Uint8Array(readFileSync(process.argv[2])))
  .then((report) => console.log(JSON.stringify(report.issues)));
