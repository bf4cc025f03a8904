/** The address of the page, and what is begun for it. */

export class Address {
  #followed = location.hash;
  #visit = new AbortController();

  /** Of what is begun for the address that is followed now: aborted when another one is followed. */
  get signal() {
    return this.#visit.signal;
  }

  /**
   * Whether another address is asked for, of which the event is still to come: what arrives
   * meanwhile must not replace it.
   */
  get isLeft() {
    return location.hash !== this.#followed;
  }

  /** Begins to follow the address that the page has now. @returns {AbortSignal} */
  follow() {
    this.#visit.abort();
    this.#visit = new AbortController();
    this.#followed = location.hash;
    return this.signal;
  }

  /**
   * Names what is shown by another address. What was begun goes on.
   * @param {'pushState' | 'replaceState'} how
   * @param {string} address
   */
  name(how, address) {
    history[how](null, '', address);
    this.#followed = location.hash;
  }
}
