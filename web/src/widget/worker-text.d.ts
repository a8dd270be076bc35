/** The script of the workers as text, which the build puts in: notebooks have no place for files beside theirs. */
declare module 'worker-text' {
  const text: string;
  export default text;
}
