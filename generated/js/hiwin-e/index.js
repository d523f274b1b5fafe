/**
 * HIWIN E1/E2 PROFINET: the names of the newest version.
 *
 * Version 2.14.4: ./v2_14_4.js
 *
 * Version 3.14.4: ./v2_14_4.js
 *
 * Version 4.14.4: ./v2_14_4.js
 */
import { versionOf } from "../runtime/firmware.js";
export * from "./v2_14_4.js";

const VERSIONS_BY_NAME = {
  __proto__: null,
  "2.14.4": () => import("./v2_14_4.js"),
  "3.14.4": () => import("./v2_14_4.js"),
  "4.14.4": () => import("./v2_14_4.js"),
};
const LINES = [["2.14.4"], ["3.14.4"], ["4.14.4"]];
export const VERSIONS = Object.freeze(["2.14.4", "3.14.4", "4.14.4"]);

/** The module of a version. Throws RangeError for a version that the spec does not have. */
export async function forVersion(version) {
  const load = VERSIONS_BY_NAME[version];
  if (load === undefined) {
    throw new RangeError(`hiwin_e has the versions ${VERSIONS.join(", ")}`);
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
 */
export async function forFirmware(firmware, { nearest = false } = {}) {
  return forVersion(versionOf(LINES, firmware, nearest));
}
