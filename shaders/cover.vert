// A triangle that covers the whole of a texture.

void main() {
  gl_Position = vec4(covering_corner(gl_VertexID), 0.0, 1.0);
}
