import { ACCEPTED } from "./values.js";
import { py } from "./python.js";

/** The meaning of every byte of a frame. */

/**
 * The meaning of every byte of a frame.
 *
 * `rows` cover every byte of the frame once, in order. `registers` are the registers that the frame reads or writes,
 * by address; their bytes, if the frame carries them, are in `rows` too. `accessed` are the addresses of the first and
 * the last word or bit that a message with `accesses` reads or writes; None where the frame does not tell. `message`
 * is empty if the message is unknown. `error` marks an exception response. `values` are the raw values of the header,
 * without the length, and of the fields in the body, by name. `errata` are the ids of those about the message and
 * about the link as a whole.
 */
export class Explanation {
  constructor({ link, direction, message, error, frame, rows, registerRows, values, errata = [], accessed = null }) {
    this.link = link;
    this.direction = direction;
    this.message = message;
    this.error = error;
    this.frame = frame;
    this.rows = rows;
    this.registerRows = registerRows;
    this.values = values;
    this.errata = errata;
    this.accessed = accessed;
  }

  /** The rows of the registers. They are made on demand, because most readings of a frame are dropped. */
  get registers() {
    return this.registerRows.rows;
  }

  /** The reasons for which a codec refuses the frame, as its errors name them; empty if it accepts the frame. */
  get reasons() {
    return [...this.rows].filter((row) => !py.has(ACCEPTED, row.reason)).map((row) => row.reason);
  }
}
