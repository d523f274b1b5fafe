export { CodecError } from "./error.js";
export { Framer } from "./framer.js";
