export { CodecError } from "./error.js";
export { canBytes, canFrame } from "./escapes.js";
export { UnknownFirmwareError } from "./firmware.js";
export { Framer } from "./framer.js";
