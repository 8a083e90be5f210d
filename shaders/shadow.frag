// Marks what a body hides from the main light, and how high it is; the highest body counts.

in float v_height;  // from the lowest of all bodies (0) to the highest (1)
out vec4 o_color;

void main() { o_color = vec4(1.0, v_height, 0.0, 0.0); }
