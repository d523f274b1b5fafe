/**
 * TAIYO ESC11-B: the names of the newest version.
 *
 * Version before-1.17: ./before_1_17.js
 *
 * Version 1.17: ./v1_17.js
 */
export * from "./v1_17.js";
export declare const VERSIONS: readonly ("before-1.17" | "1.17")[];
/** The module of a version. Throws RangeError for a version that the spec does not have. */
export declare function forVersion(version: "before-1.17"): Promise<typeof import("./before_1_17.js")>;
export declare function forVersion(version: "1.17"): Promise<typeof import("./v1_17.js")>;
export declare function forVersion(version: string): Promise<typeof import("./before_1_17.js") | typeof import("./v1_17.js")>;
