// Prints what the glTF validator says of a file, as JSON: its counts and messages of issues.
const validator = require("gltf-validator");
const { readFileSync } = require("node:fs");

validator.validateBytes(new Uint8Array(readFileSync(process.argv[2])))
  .then((report) => console.log(JSON.stringify(report.issues)));
