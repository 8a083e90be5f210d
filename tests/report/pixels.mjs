// What is drawn in a plot.

// Pixels of a plot's canvas in a colour: lines have one, axes and grid are nearly grey.
const GREY = 60;  // of 255, between the largest and the least of red, green and blue
export const LINE = 50;  // pixels that the shortest line has at least
export const coloredPixels = (chart) => chart.$eval("canvas", (canvas, grey) => {
  const {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  for (let i = 0; i < data.length; i += 4) {
    const rgb = data.subarray(i, i + 3);
    if (data[i + 3] > 128 && Math.max(...rgb) - Math.min(...rgb) > grey) ++count;
  }
  return count;
}, GREY);
