// The page of trees as a client. It draws by itself when its pose changes, before the frames that are measured.
window.client = {
  see: (pose) => window.orthoview.setPose(pose),
  async draw() {},
  /** Draw at once: what was drawn before a task is not kept. */
  paint: () => window.orthoview.time(),
  /** Views of the cut and of the coarse cells that are not there. */
  get missing() {
    const { waiting, holes, kept } = window.orthoview.facts;
    return kept === 0 ? 1 : waiting + holes;
  },
  get facts() {
    return { ...window.orthoview.facts };
  },
};
