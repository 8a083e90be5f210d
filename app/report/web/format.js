// Numbers and elements as the page writes them.

const DIGITS = 5;

// Five significant digits, with a true minus sign.
export const number = (value, digits = DIGITS) => {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  const text = size !== 0 && (size < 1e-3 || size >= 1e6)
    ? value.toExponential(digits - 2).replace(/\.?0+e/, "e")
    : Number(value.toPrecision(digits)).toString();
  return text.replaceAll("-", "−");
};

// Decimals that show five digits of a number of this size, so that those of one plot line up.
export const decimalsOf = (size) =>
  size > 0 ? Math.min(Math.max(DIGITS - 1 - Math.floor(Math.log10(size)), 0), 12) : 0;

export const fixed = (value, decimals) => {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace("-", "") : text.replace("-", "−");
};

export const grouped = (count) => count.toLocaleString("en-US").replaceAll(",", "\u202f");

// The factor and the letter of the prefix by which a number of this size is written shortly.
const prefixes = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""]];
export const prefixOf = (size) => prefixes.find(([factor]) => size >= factor) ?? [1, ""];

export const at = (id) => document.getElementById(id);

export const element = (tag, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
};

export const button = (text, title, onclick) => element("button", {type: "button", textContent: text, title, onclick});

// A number of the page's head with what it is of.
export const tile = (label, value, note = "") =>
  element("div", {className: "tile"}, element("span", {textContent: label}),
          element("b", {textContent: value}), element("i", {textContent: note}));
