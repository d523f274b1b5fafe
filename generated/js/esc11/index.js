/**
 * TAIYO ESC11-B: the names of the newest version.
 *
 * Version before-1.17: ./before_1_17.js
 *
 * Version 1.17: ./v1_17.js
 */
export * from "./v1_17.js";

const VERSIONS_BY_NAME = {
  __proto__: null,
  "before-1.17": () => import("./before_1_17.js"),
  "1.17": () => import("./v1_17.js"),
};
export const VERSIONS = Object.freeze(["before-1.17", "1.17"]);

/** The module of a version. Throws RangeError for a version that the spec does not have. */
export async function forVersion(version) {
  const load = VERSIONS_BY_NAME[version];
  if (load === undefined) {
    throw new RangeError(`esc11 has the versions ${VERSIONS.join(", ")}`);
  }
  return load();
}
