/**
 * unknown CK10: the names of the newest version.
 *
 * Version 1: ./v1.js
 */
export * from "./v1.js";
export declare const VERSIONS: readonly ("1")[];
/** The module of a version. Throws RangeError for a version that the spec does not have. */
export declare function forVersion(version: "1"): Promise<typeof import("./v1.js")>;
export declare function forVersion(version: string): Promise<typeof import("./v1.js")>;
