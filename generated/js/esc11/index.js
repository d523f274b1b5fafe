/**
 * TAIYO ESC11-B: the names of the newest version.
 *
 * Version 1.17: ./v1_17.js
 */
import { versionOf } from "../runtime/firmware.js";
export * from "./v1_17.js";

const VERSIONS_BY_NAME = {
  __proto__: null,
  "1.17": () => import("./v1_17.js"),
};
const LINES = [["1.17"]];
export const VERSIONS = Object.freeze(["1.17"]);

/** The value of the device that tells its version. */
export const DETECTED_BY = "messages/read_version/response/version";

/** The module of a version. Throws RangeError for a version that the spec does not have. */
export async function forVersion(version) {
  const load = VERSIONS_BY_NAME[version];
  if (load === undefined) {
    throw new RangeError(`esc11 has the versions ${VERSIONS.join(", ")}`);
  }
  return load();
}

/**
 * The module of the firmware that a device reports. Blanks around the version, a `v` before it and leading or
 * trailing zeros do not matter: ` v02.0 ` is 2.0. The version `before-2.0` of a spec is all firmware below 2.0.
 * With `nearest`, a version that the spec does not list gets the module of the newest version below it on its
 * line; the caller answers for that choice.
 *
 * Throws UnknownFirmwareError, which lists the known versions, for every other firmware. Nothing is guessed.
 *
 * The device tells its version in `messages/read_version/response/version`.
 */
export async function forFirmware(firmware, { nearest = false } = {}) {
  return forVersion(versionOf(LINES, firmware, nearest));
}
