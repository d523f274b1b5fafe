// Prints the Python that Kaitai Struct makes of a .ksy file: node kaitai.js FILE
const fs = require("fs");
const yaml = require("js-yaml");
const compiler = require("kaitai-struct-compiler");

const text = fs.readFileSync(process.argv[2], "utf8");
compiler
  .compile("python", yaml.load(text), null, false)
  .then((files) => Object.values(files).forEach((file) => process.stdout.write(file)))
  .catch((error) => {
    console.error(error);
    process.exit(1);
  });
