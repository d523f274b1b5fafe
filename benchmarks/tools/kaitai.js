// Prints the code that Kaitai Struct makes of a .ksy file, Python unless said otherwise:
// node kaitai.js FILE [--read-write | --javascript]
const fs = require("fs");
const yaml = require("js-yaml");

const [source, form] = process.argv.slice(2);
const schema = yaml.load(fs.readFileSync(source, "utf8"));

// The desktop compiler has the option --read-write. This build of the same compiler can do it, but its function does not
// take the option; so the option's initial values are changed: classes write, too, and do not read when they are made.
const WRITING = [
  ["__f_readWrite = readWrite;", "__f_readWrite = true;"],
  ["__f_autoRead = autoRead;", "__f_autoRead = false;"],
];

function compilerOf(changes) {
  let text = fs.readFileSync(require.resolve("kaitai-struct-compiler"), "utf8");
  for (const [initial, wanted] of changes) {
    if (text.split(initial).length !== 2) throw new Error(`the compiler does not hold ${initial} once`);
    text = text.replace(initial, wanted);
  }
  const made = { exports: {} };
  new Function("module", "exports", "require", text)(made, made.exports, require);
  return made.exports;
}

compilerOf(form === "--read-write" ? WRITING : [])
  .compile(form === "--javascript" ? "javascript" : "python", schema, null, false)
  .then((files) => Object.values(files).forEach((file) => process.stdout.write(file)))
  .catch((error) => {
    console.error(error);
    process.exit(1);
  });
