// Shapes and colours of lines, as plain numbers: x y z of each point.

const TURN_POINTS = 16;  // points in a turn of a coil
const END = 0.1;         // straight part at each end of a spring

const mix = (a, b, part) => a.map((x, k) => x + part * (b[k] - x));

// A line from end to end whose inner points lie off its chord as `shape` tells, between two rows.
export const lineShape = (first, second, shape, points, {row, next, part}) => {
  const inner = 3 * (points - 2), line = new Float32Array(3 * points);
  for (let i = 0; i < points; ++i) {
    const p = mix(first, second, i / (points - 1));
    const off = 3 * (i - 1);
    for (let k = 0; k < 3; ++k) {
      let shift = 0;
      if (shape && i > 0 && i + 1 < points) {
        const a = shape[row * inner + off + k], b = shape[next * inner + off + k];
        shift = a + part * (b - a);
      }
      line[3 * i + k] = p[k] + shift;
    }
  }
  return line;
};

// A line through places that are known at each row, between two of them.
export const pathShape = (path, points, {row, next, part}) => {
  const line = new Float32Array(3 * points);
  for (let i = 0; i < line.length; ++i) {
    const a = path[row * line.length + i], b = path[next * line.length + i];
    line[i] = a + part * (b - a);
  }
  return line;
};

// A coil spring from end to end.
export const coil = (first, second, {radius, turns}) => {
  const whole = second.map((x, k) => x - first[k]), length = Math.hypot(...whole);
  const along = length > 0 ? whole.map((x) => x / length) : [0, 0, 1];
  const flat = Math.hypot(along[0], along[1]);
  const side = flat > 1e-6 ? [-along[1] / flat, along[0] / flat, 0] : [1, 0, 0];
  const other = [along[1] * side[2] - along[2] * side[1], along[2] * side[0] - along[0] * side[2],
                 along[0] * side[1] - along[1] * side[0]];
  const steps = turns * TURN_POINTS, points = [...first, ...mix(first, second, END)];
  for (let i = 0; i <= steps; ++i) {
    const part = i / steps, angle = 2 * Math.PI * turns * part;
    const middle = mix(first, second, END + (1 - 2 * END) * part);
    for (let k = 0; k < 3; ++k)
      points.push(middle[k] + radius * (Math.cos(angle) * side[k] + Math.sin(angle) * other[k]));
  }
  points.push(...mix(first, second, 1 - END), ...second);
  return points;
};

// What hangs down from an end.
export const hanging = (end, length) => [...end, end[0], end[1], end[2] - length];

// Colour of a tension on the scale {top, colors, push}.
export const tensionColor = ({top, colors, push}, tension) => {
  const share = top > 0 ? Math.min(Math.max(tension / top, -1), 1) : 0;
  if (share < 0) return mix(colors[0], push, -share);
  const place = share * (colors.length - 1), low = Math.min(Math.floor(place), colors.length - 2);
  return mix(colors[low], colors[low + 1], place - low);
};
