/** A raw value: bytes, and numbers that JSON does not have, as text; numbers of more than 48 bits are bigints. */
export type ExplainedValue =
  | number | bigint | boolean | string | null | readonly ExplainedValue[] | { readonly [name: string]: ExplainedValue };

/** A name of a value, or of some of its bits: `bits` is `3`, or `9..10`. */
export interface Meaning {
  readonly name: string | null;
  readonly label: string | null;
  readonly text: string | null;
  readonly bits: string | null;
}

/**
 * Some bytes of a frame and their meaning. `offset` and `length` count bytes of the frame as it is sent. In a CAN frame,
 * `can_place` is `identifier`, or the number of the first byte in the data.
 */
export interface ExplanationRow {
  readonly kind: "mark" | "part" | "field" | "register" | "unexplained";
  readonly offset: number;
  readonly can_place: string | null;
  readonly length: number;
  readonly raw: string;
  readonly characters: string | null;
  readonly path: string | null;
  readonly fact: string | null;
  readonly printed_name: string | null;
  readonly label: string | null;
  readonly doc: string | null;
  readonly number: ExplainedValue;
  readonly value: string | null;
  readonly meanings: readonly Meaning[];
  readonly verdict: string | null;
  readonly reason: string | null;
  readonly source: string | null;
  readonly notes: readonly string[];
  readonly errata: readonly string[];
  readonly address: number | null;
  readonly words?: number | null;
  readonly bits?: number | null;
  readonly access: string | null;
}

/** What a frame may be. */
export interface Reading {
  readonly link: string;
  readonly direction: "request" | "response";
  readonly message: string | null;
  readonly error: boolean;
}

/** What a manual misprints. */
export interface Erratum {
  readonly id: string;
  readonly fact: string;
  readonly printed: Readonly<Record<string, unknown>>;
  readonly reason: string;
}

/** The explanation of a frame, with the keys of `fieldspec decode --format json`. */
export interface Explanation {
  readonly device: string;
  readonly version: string;
  readonly frame: string;
  readonly link: string;
  readonly direction: "request" | "response";
  readonly direction_name: string;
  readonly message: string | null;
  readonly error: boolean;
  readonly wrong: boolean;
  readonly reasons: readonly string[];
  readonly chosen: "only" | "request" | "mark" | "likeliest" | "closest";
  readonly readings: readonly Reading[];
  readonly remarks: readonly string[];
  readonly values: Readonly<Record<string, ExplainedValue>>;
  readonly rows: readonly ExplanationRow[];
  readonly registers: readonly ExplanationRow[];
  readonly errata: readonly Erratum[];
}

/** What is known of a frame; names are those of the device. `request` is the frame that a response answers. */
export interface FrameOptions {
  readonly link?: string;
  readonly direction?: string;
  readonly message?: string;
  readonly request?: Uint8Array | string;
}

export interface Explainer {
  /** The explanation of a frame: bytes, or a text with its bytes in any usual spelling. */
  explain(input: Uint8Array | string, options?: FrameOptions): Explanation;
  /** The explanations of the lines of a log, with their numbers. */
  explainLog(
    text: string, options?: FrameOptions,
  ): Generator<(Explanation & { readonly line: number }) | { readonly line: number; readonly error: string }>;
}
