/**
 * TAIYO ESC11-B: the names of the newest version.
 *
 * Version 1.17: ./v1_17.js
 */
export * from "./v1_17.js";
export declare const VERSIONS: readonly ("1.17")[];
/** The value of the device that tells its version. */
export declare const DETECTED_BY: "messages/read_version/response/version";
/** The module of a version. Throws RangeError for a version that the spec does not have. */
export declare function forVersion(version: "1.17"): Promise<typeof import("./v1_17.js")>;
export declare function forVersion(version: string): Promise<typeof import("./v1_17.js")>;
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
export declare function forFirmware(firmware: string, options?: { readonly nearest?: boolean }): Promise<typeof import("./v1_17.js")>;
