/** Messages about requests without a usable answer. */

/** No answer: the connection failed, or the time is over. */
export const NOTHING = 0;
/** An answer that cannot be read, or not of this service. */
export const UNREADABLE = -1;

/** Statuses after which a retry may succeed. */
const PASSING = new Set([NOTHING, UNREADABLE, 429, 502, 503, 504]);

/**
 * @param {number} status
 * @returns {boolean} whether the same question may soon have another answer
 */
export const isPassing = (status) => PASSING.has(status);

/** @param {number} status of an answer that says nothing more @returns {string} */
export function wordsOf(status) {
  switch (status) {
    case NOTHING:
    case 502:
    case 504:
      return 'the service does not answer';
    case UNREADABLE:
      return 'something else than the service answers, such as a sign-in page: load this page again if that stays';
    case 401:
      return 'the service asks for an API key';
    case 413:
      return 'this is too large for the service: try fewer points or loads';
    case 429:
      return 'the service has too much to do';
    case 503:
      return 'the service is not ready';
    default:
      return status >= 500
        ? 'the service is at fault, not what you asked'
        : 'the service does not take this';
  }
}
