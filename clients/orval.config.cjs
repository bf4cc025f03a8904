/** Orval: one file of functions over fetch. */
module.exports = {
  brinell: {
    input: '../api/openapi.json',
    output: {
      target: 'generated/orval.ts',
      client: 'fetch',
      mode: 'single',
      override: { mutator: { path: 'typescript/orval-fetch.ts', name: 'fetchText' } },
    },
  },
};
