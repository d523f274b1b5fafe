/**
 * unknown CK10: the names of the newest version.
 *
 * Version 1: ./v1.js
 */
export * from "./v1.js";

const VERSIONS_BY_NAME = {
  __proto__: null,
  "1": () => import("./v1.js"),
};
export const VERSIONS = Object.freeze(["1"]);

/** The module of a version. Throws RangeError for a version that the spec does not have. */
export async function forVersion(version) {
  const load = VERSIONS_BY_NAME[version];
  if (load === undefined) {
    throw new RangeError(`ck10 has the versions ${VERSIONS.join(", ")}`);
  }
  return load();
}
