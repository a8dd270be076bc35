/** Programs and the sample buffer in WebGL 2. */

export type Program = ReturnType<typeof programOf>;

export function programOf(gl: WebGL2RenderingContext, vertex: string, fragment: string) {
  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]] as const) {
    const shader = gl.createShader(kind);
    if (!shader) throw new Error('the graphics context is lost');
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    gl.deleteShader(shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
    const logs = (gl.getAttachedShaders(program) ?? []).map((shader) => gl.getShaderInfoLog(shader));
    throw new Error(`a shader does not compile: ${[...logs, gl.getProgramInfoLog(program)].filter(Boolean).join(' ')}`);
  }
  const locations = new Map<string, WebGLUniformLocation | null>();
  return {
    program,
    /** Location of a uniform. */
    at(name: string): WebGLUniformLocation | null {
      if (!locations.has(name)) locations.set(name, gl.getUniformLocation(program, name));
      return locations.get(name) ?? null;
    },
  };
}

/** Sample buffer: depths, and colours whose alpha is greater than 0 where there is a splat or a mesh. */
export type Target = ReturnType<typeof targetOf>;

export function targetOf(gl: WebGL2RenderingContext, width: number, height: number) {
  const [frame, color, depth] = [gl.createFramebuffer(), gl.createTexture(), gl.createRenderbuffer()];
  gl.bindTexture(gl.TEXTURE_2D, color);
  // Shaders write and read linear light; it is stored as 8-bit sRGB.
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.SRGB8_ALPHA8, width, height);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
  gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT32F, width, height);
  gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, color, 0);
  gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  return {
    frame,
    color,
    width,
    height,
    dispose(): void {
      gl.deleteFramebuffer(frame);
      gl.deleteTexture(color);
      gl.deleteRenderbuffer(depth);
    },
  };
}
