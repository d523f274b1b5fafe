/**
 * TOYO TC100: the names of the newest version.
 *
 * Version before-2.0: ./before_2_0.js
 *
 * Version 2.0: ./v2_0.js
 */
export * from "./v2_0.js";

const VERSIONS_BY_NAME = {
  __proto__: null,
  "before-2.0": () => import("./before_2_0.js"),
  "2.0": () => import("./v2_0.js"),
};
export const VERSIONS = Object.freeze(["before-2.0", "2.0"]);

/** The module of a version. Throws RangeError for a version that the spec does not have. */
export async function forVersion(version) {
  const load = VERSIONS_BY_NAME[version];
  if (load === undefined) {
    throw new RangeError(`tc100 has the versions ${VERSIONS.join(", ")}`);
  }
  return load();
}
