// How far the numbers of a plot's lines reach. Where a line has none they are null.

// How far the line that changes most does so.
export const spreadOf = ({lines}) => {
  let spread = 0;
  for (const {values} of lines) {
    let low = Infinity, high = -Infinity;
    for (const value of values) {
      if (value === null) continue;
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    spread = Math.max(spread, high - low);
  }
  return spread;
};

export const largestOf = ({lines}) => {
  let largest = 0;
  for (const {values} of lines)
    for (const value of values) if (value !== null) largest = Math.max(largest, Math.abs(value));
  return largest;
};
