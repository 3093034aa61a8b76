/** Lets the page answer while much is drawn. */

/** Milliseconds of drawing after which the page may answer: within them nobody notices that it does not. */
const LONG = 30;
/** Milliseconds until a page that is not seen, and shows no picture any more, counts as having answered. */
const UNSEEN = 100;

/** A function to be awaited between two pieces of drawing: where the last ones took long, the page draws itself and answers. */
export function breath(): () => Promise<void> {
  let last = performance.now();
  return async () => {
    if (performance.now() - last < LONG) return;
    await shown();
    last = performance.now();
  };
}

/** Wait until the page has shown a picture of itself, and has dealt with what its user did meanwhile. */
async function shown(): Promise<void> {
  await new Promise<void>((done) => {
    const late = setTimeout(done, UNSEEN);
    requestAnimationFrame(() => {
      clearTimeout(late);
      setTimeout(done);
    });
  });
}
