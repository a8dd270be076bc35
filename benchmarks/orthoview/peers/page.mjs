// The page of trees as a client. It draws by itself when its pose changes, before the measured frames.
window.client = {
  see: (pose) => window.orthoview.setPose(pose),
  async draw() {},
  /** Draws at once, since pictures of earlier tasks are not preserved. */
  paint: () => window.orthoview.time(),
  /** Number of missing views of the cut and of coarse cells. */
  get missing() {
    const { waiting, holes, kept } = window.orthoview.facts;
    return kept === 0 ? 1 : waiting + holes;
  },
  get facts() {
    return { ...window.orthoview.facts };
  },
};
