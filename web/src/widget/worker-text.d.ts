/** Script of the workers as text, inserted by the build, because notebooks cannot load further files. */
declare module 'worker-text' {
  const text: string;
  export default text;
}
