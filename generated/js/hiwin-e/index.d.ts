/**
 * HIWIN E1/E2 PROFINET: the names of the newest version.
 *
 * Version 2.14.4: ./v2_14_4.js
 *
 * Version 3.14.4: ./v2_14_4.js
 *
 * Version 4.14.4: ./v2_14_4.js
 */
export * from "./v2_14_4.js";
export declare const VERSIONS: readonly ("2.14.4" | "3.14.4" | "4.14.4")[];
/** The module of a version. Throws RangeError for a version that the spec does not have. */
export declare function forVersion(version: "2.14.4"): Promise<typeof import("./v2_14_4.js")>;
export declare function forVersion(version: "3.14.4"): Promise<typeof import("./v2_14_4.js")>;
export declare function forVersion(version: "4.14.4"): Promise<typeof import("./v2_14_4.js")>;
export declare function forVersion(version: string): Promise<typeof import("./v2_14_4.js")>;
/**
 * The module of the firmware that a device reports. Blanks around the version, a `v` before it and leading or
 * trailing zeros do not matter: ` v02.0 ` is 2.0. The version `before-2.0` of a spec is all firmware below 2.0.
 * With `nearest`, a version that the spec does not list gets the module of the newest version below it on its
 * line; the caller answers for that choice.
 *
 * Throws UnknownFirmwareError, which lists the known versions, for every other firmware. Nothing is guessed.
 */
export declare function forFirmware(firmware: string, options?: { readonly nearest?: boolean }): Promise<typeof import("./v2_14_4.js")>;
