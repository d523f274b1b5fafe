/** Why bytes or values are refused. */
export type Reason =
  | "incomplete"
  | "wrong_length"
  | "wrong_mark"
  | "wrong_checksum"
  | "not_hex"
  | "unknown_code"
  | "unknown_value"
  | "wrong_const"
  | "wrong_measure"
  | "out_of_range"
  | "wrong_type"
  | "missing_value"
  | "unknown_field"
  | "read_only"
  | "write_only";

/** Bytes or values that a codec refuses. `offset` is the byte at which it shows, null for values. */
export declare class CodecError extends Error {
  constructor(reason: Reason, detail: string, offset?: number | null);
  readonly reason: Reason;
  readonly detail: string;
  readonly offset: number | null;
}

/** Firmware that a spec does not list: `firmware` is the requested one, `known` are the versions of the spec. */
export declare class UnknownFirmwareError extends RangeError {
  readonly firmware: string;
  readonly known: readonly string[];
}

/**
 * The identifier and the data of a CAN frame, as drivers take and give them; `isExtended` means 29 bits. A remote
 * request has no data, and asks for `dlc` bytes.
 */
export interface CanFrame {
  readonly identifier: number;
  readonly data?: Uint8Array;
  readonly isExtended?: boolean;
  readonly isRemote?: boolean;
  readonly dlc?: number;
}

/** The identifier and the data of a frame as encoders of a CAN bus return it. */
export declare function canFrame(bytes: Uint8Array): CanFrame & { readonly data: Uint8Array };

/** The frame of an identifier and its data, as decoders of a CAN bus take it. */
export declare function canBytes(frame: CanFrame): Uint8Array;

/** A quantity: a number, a text with decimals, which is exact, or a bigint. */
export type Quantity = number | string | bigint;

/** The unit of counts. */
export interface Unit {
  readonly unit: string;
  /** The quantity of a count, rounded once; null for a count that stands for no quantity. */
  inUnit(count: number | bigint): number | null;
  /** The nearest count of a quantity. Throws CodecError out of range. */
  fromUnit(quantity: Quantity): number | bigint;
}

/** The states of a value that is read: of those that stand for no quantity, and `out_of_range`. */
export interface AbsentValues {
  /** The values by the names of their states: the least of those that stand for it. A NaN means any NaN. */
  readonly values: Readonly<Record<string, number | bigint>>;
  /** The name of the state that a value stands for, or `out_of_range`, which is a quantity; null for any other value. */
  nameOf(value: number | bigint): string | null;
}

/** The unit of counts whose scale is a power of ten, of which another register has the exponent. */
export interface PowerUnit {
  readonly unit: string;
  /**
   * The quantity of a count, rounded once; null for a count that stands for no quantity, and for such an exponent.
   * Throws CodecError for an exponent that is none.
   */
  inUnit(count: number | bigint, exponent: number | bigint): number | null;
  /** The nearest count of a quantity. Throws CodecError out of range, and for an exponent that is none. */
  fromUnit(quantity: Quantity, exponent: number | bigint): number | bigint;
}

/** A share of a reference. */
export interface Conversion {
  /** The quantity of a count, the raw value. */
  fromRaw(raw: number, reference: Quantity): number;
  /** The nearest count of a quantity. Throws CodecError out of range. */
  toRaw(quantity: Quantity, reference: Quantity): number;
}

/** A record: its values are plain objects. */
export interface RecordCodec<T, U = object, A = object> {
  readonly name: string;
  /** The bytes that it has at least and at most. */
  readonly least: number;
  readonly most: number;
  /** The quantities of its fields. */
  readonly units: U;
  /** The values of its fields that stand for a state; of a field that another one decides, those of each type. */
  readonly absent: A;
  /** The value of exactly these bytes. Throws CodecError. */
  decode(bytes: Uint8Array): T;
  /** The bytes of a value. Throws CodecError. */
  encode(value: T): Uint8Array;
}

/** A message; `code` is null where frames do not carry one, and a bigint only where a number does not have it exactly. */
export interface Message<N extends string, Q, R, C = number> {
  readonly name: N;
  readonly code: C | null;
  /** The code of the response: that of the request where the manual states no other. */
  readonly responseCode: C | null;
  readonly number: number | null;
  /** Null if only the device sends the message. */
  readonly request: [Q] extends [never] ? null : RecordCodec<Q>;
  /** Null if the device never answers. */
  readonly response: [R] extends [never] ? null : RecordCodec<R>;
}

/** A message with the data of a request. */
export type RequestOf<M> = M extends Message<string, infer Q, unknown, unknown> ? { readonly message: M; readonly data: Q } : never;

type DataOf<M, D extends "request" | "response"> =
  M extends Message<string, infer Q, infer R, unknown> ? (D extends "request" ? Q : R) : never;

/** What a frame of one direction says: `name` is that of its message, and tells the type of `data`. */
export type FrameOf<M, D extends "request" | "response", H> =
  M extends Message<infer N, unknown, unknown, unknown>
    ? { readonly kind: D; readonly name: N; readonly header: H; readonly message: M; readonly data: DataOf<M, D> }
    : never;

/**
 * What an exception response says: why, and its `code`. This is that of the usual response, which is that of the request
 * unless a message has another one; or that of all exception responses.
 */
export interface ExceptionFrame<M, H, E, C = number> {
  readonly kind: "exception";
  readonly name: string | null;
  readonly header: H;
  readonly message: M | null;
  readonly code: C;
  readonly data: E;
}

/** A link: its header in requests `Q` and in responses `R`, its messages `M`, the data of an exception response `E`, its unit addresses `A`, and its codes `C`. */
export interface Link<Q, R, M, E, A = number, C = number> {
  readonly name: string;
  readonly messages: readonly M[];
  readonly unitAddresses: { readonly ranges: readonly (readonly [A, A])[] | null; readonly broadcast: A | null } | null;
  encodeRequest<K extends M>(header: Q, message: K, data: DataOf<K, "request">): Uint8Array;
  encodeResponse<K extends M>(header: R, message: K, data: DataOf<K, "response">): Uint8Array;
  /** The exception response in place of the usual response with a code; null where frames carry none. Throws CodecError. */
  encodeExceptionResponse(header: R, code: C | null, data: E): Uint8Array;
  decodeRequest<K extends M = M>(frame: Uint8Array, message?: K): FrameOf<K, "request", Q>;
  decodeResponse<K extends M = M>(frame: Uint8Array, message?: K): FrameOf<K, "response", R> | ([E] extends [never] ? never : ExceptionFrame<M, R, E, C>);
}

/** Finds frames in a stream of bytes that arrives in pieces of any size. */
export declare class Framer {
  private constructor();
  /** The number of bytes that belong to no frame. */
  readonly dropped: number;
  /** The frames that these bytes complete, each with its delimiters and checksum. */
  feed(piece: Uint8Array): Uint8Array[];
  /** To be called when the line has been silent: the frames in the bytes so far; the rest is dropped. */
  idle(): Uint8Array[];
  /** Drops all bytes so far. */
  reset(): void;
}

/** A word of flags. The bits `K` have no 0 that goes without saying: they have to be given. */
export interface Flags<T, N, K extends keyof T = never> {
  /** The bits of a number by name. */
  of(raw: N): T;
  /** The number with the bits that an object gives; all others have their defaults, or are 0. Throws CodecError. */
  raw(bits: Partial<T> & Pick<T, K>): N;
  /** A number with bits set as an object says; all other bits are those of `raw`. Throws CodecError. */
  raw(bits: Partial<T>, raw: N): N;
}

/** A value in registers: what is read has the type `T`, what may be written the type `W`. */
export interface Register<T, U = Unit | null, W = T> {
  readonly name: string;
  readonly address: number;
  readonly words: number;
  readonly access: "ro" | "rw" | "wo" | "";
  /** The address space, empty where the device has only one. */
  readonly space: string;
  /** All words must be accessed in one request. */
  readonly atomic: boolean;
  /** Writing starts an action. */
  readonly trigger: boolean;
  readonly units: U;
  /** The states of what is read; null where it has none. */
  readonly absent: AbsentValues | null;
  /** The value of exactly all of its bytes. Throws CodecError. */
  decode(bytes: Uint8Array): T;
  /** The bytes of a value. Throws CodecError. */
  encode(value: W): Uint8Array;
}

/** Equal registers, `stride` words apart, numbered from `first`. */
export interface RegisterArray<T, U = Unit | null, W = T> extends Iterable<Register<T, U, W>> {
  readonly name: string;
  readonly address: number;
  readonly first: number;
  readonly stride: number;
  readonly length: number;
  /** The register with a number. Throws RangeError. */
  at(number: number): Register<T, U, W>;
}

/** Records in registers, `stride` words apart, numbered from `first`. */
export interface RecordTable<T> {
  readonly name: string;
  readonly address: number;
  readonly first: number;
  readonly stride: number;
  readonly length: number;
  readonly record: RecordCodec<T>;
  /** The register with the number of records that the device has; null where it has all of them. */
  readonly countBy: Register<unknown> | null;
  /** The register with the address of the first record, of which `address` is the usual one; null where the table does not move. */
  readonly baseBy: Register<unknown> | null;
  /** The record with a number, as a register. Throws RangeError. */
  at(number: number): Register<T, null>;
  /** The records of a device that has so many. Throws RangeError for more than there can be. */
  present(number: number | bigint): Register<T, null>[];
  /** The table of a device that has its first record at an address. Throws RangeError for what is no such address. */
  atBase(base: number | bigint): RecordTable<T>;
}

/** A numbered parameter. */
export interface Parameter<T, U = Unit | null> {
  readonly name: string;
  readonly number: number;
  readonly wireNumber: number;
  /** Its name or number as the manual prints it. */
  readonly printedName: string;
  readonly type: string;
  readonly size: number;
  readonly access: "ro" | "rw" | "wo" | "";
  /** Whether the element with an index can be read and written. */
  accessOf(subindex: number): "ro" | "rw" | "wo" | "";
  readonly default: number | string | null;
  readonly elements: number | null;
  readonly units: U;
  /** The states of what is read; null where it has none. */
  readonly absent: AbsentValues | null;
  /** The same of the element with an index. */
  absentOf(subindex: number): AbsentValues | null;
  decode(bytes: Uint8Array): T;
  encode(value: T): Uint8Array;
  /** The value of a raw value in a message, for the element with an index. Throws CodecError. */
  fromRaw(raw: number | bigint | boolean | string | Uint8Array, subindex?: number): T;
  /** The value of exactly all of the bytes that a message carries, for the element with an index. Throws CodecError. */
  fromBytes(bytes: Uint8Array, subindex?: number): T;
  /** The bytes of a value for a message, for the element with an index. Throws CodecError. */
  toBytes(value: T, subindex?: number): Uint8Array;
  /**
   * The raw value of a value for a message: with a sign where the field of the message has one, and without where
   * `unsigned` is set. Throws CodecError.
   */
  toRaw(value: T, options?: { readonly subindex?: number; readonly unsigned?: boolean }): number | bigint | string | Uint8Array;
}

/** The parameters of a set. */
export interface ParameterSet<P> {
  readonly setName: string;
  /** The parameters by name; an array where several are equal. */
  readonly parameters: Readonly<P>;
  /** The parameter with a number on the wire, if there is one. */
  byNumber(wireNumber: number): Parameter<unknown> | undefined;
}
