// The bar above the plots: which body they are of, and what part of the run.
import {button, element, grouped, number} from "./format.js";

export const USAGE = "drag in a plot to zoom · click a name to hide its line";

// @param names    Of the bodies.
// @param usage    Said while nothing is zoomed.
// @param change   Called with the index of the body to show.
// @return the function that selects a body.
export const addChooser = (host, names, plots, usage, change) => {
  const list = element("select", {id: "body", title: "Body"}, ...names.map((name, i) =>
    element("option", {value: i, textContent: name})));
  const select = (body) => {
    list.value = body;
    change(Number(body));
  };
  const step = (by) => () => select((Number(list.value) + by + names.length) % names.length);
  list.addEventListener("change", () => select(Number(list.value)));
  const reset = button("Whole run", "Reset the zoom (double click in a plot)", () => plots.setZoom(null));
  reset.id = "reset";
  const hint = element("span", {className: "dim"});
  plots.onZoom = (zoom) => {
    reset.disabled = zoom === null;
    hint.textContent = zoom ? `${number(zoom[0], 4)} … ${number(zoom[1], 4)} s` : usage;
  };
  plots.onZoom(null);
  host.append(list);
  if (names.length > 1)
    host.append(button("‹", "Previous body", step(-1)), button("›", "Next body", step(1)),
                element("span", {className: "dim", textContent: `of ${grouped(names.length)}`}));
  host.append(element("span", {className: "grow"}), hint, reset);
  return select;
};
