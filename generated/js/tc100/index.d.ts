/**
 * TOYO TC100: the names of the newest version.
 *
 * Version before-2.0: ./before_2_0.js
 *
 * Version 2.0: ./v2_0.js
 */
export * from "./v2_0.js";
export declare const VERSIONS: readonly ("before-2.0" | "2.0")[];
/** The module of a version. Throws RangeError for a version that the spec does not have. */
export declare function forVersion(version: "before-2.0"): Promise<typeof import("./before_2_0.js")>;
export declare function forVersion(version: "2.0"): Promise<typeof import("./v2_0.js")>;
export declare function forVersion(version: string): Promise<typeof import("./before_2_0.js") | typeof import("./v2_0.js")>;
