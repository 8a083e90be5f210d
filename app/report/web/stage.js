// The replay with what is around it: the views, the toggles and the clock's slider.
import {at, button, element, number} from "./format.js";
import {pressureBar} from "./pressure.js";
import {Replay} from "./replay.js";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 50];
const SLIDER_STEPS = 10000;
const KEY_STEPS = 200;  // a key moves the time by this part of the run

export const color = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const look = () => ({water: color("--water"), waterLine: color("--water-line"), ground: color("--ground"),
                     groundLine: color("--ground-line"), path: color("--ink")});

// The 3-D replay of a run; null where the browser cannot draw it.
// @param other   A second run that is drawn over it (replay.js).
export const makeReplay = (run, clock, other) => {
  try {
    return new Replay(run, clock, at("replay"), at("label"), look(), other);
  } catch (error) {
    at("replay").hidden = true;
    at("hint").hidden = at("label").hidden = true;
    at("view").append(element("p", {className: "notice", textContent:
      `The 3-D replay needs WebGL, which this browser does not give (${error.message}).`}));
    return null;
  }
};

// The slider of the time, and the keys that move it.
export const makeTransport = (clock) => {
  const play = button("▶", "Play or pause (space)", () => clock.play(!clock.playing));
  play.id = "play";
  const slider = element("input", {type: "range", id: "time", min: 0, max: SLIDER_STEPS, value: 0,
                                   ariaLabel: "Time"});
  slider.addEventListener("input", () => {
    clock.play(false);
    clock.seek(clock.start + (clock.end - clock.start) * slider.value / SLIDER_STEPS);
  });
  const shown = element("output", {id: "clock"});
  const speed = element("select", {title: "Speed of the replay"}, ...SPEEDS.map((s) =>
    element("option", {value: s, textContent: `${s} ×`, selected: s === clock.speed})));
  speed.addEventListener("change", () => { clock.speed = Number(speed.value); });
  at("transport").append(play, slider, shown, speed);
  const digits = Math.max(1, 2 - Math.floor(Math.log10(Math.max(clock.end - clock.start, 1e-9))) + 1);
  const update = () => {
    play.textContent = clock.playing ? "⏸" : "▶";
    slider.value = SLIDER_STEPS * (clock.time - clock.start) / Math.max(clock.end - clock.start, 1e-12);
    shown.textContent = `${clock.time.toFixed(Math.min(digits, 6))} / ${number(clock.end)} s`;
  };
  clock.onChange(update);
  update();
  document.addEventListener("keydown", (event) => {
    if (event.target.matches("input, select, textarea, button")) return;
    const step = (clock.end - clock.start) / KEY_STEPS;
    const moves = {ArrowLeft: -step, ArrowRight: step, Home: -Infinity, End: Infinity};
    if (event.key === " ") clock.play(!clock.playing);
    else if (event.key in moves) clock.seek(clock.time + moves[event.key]);
    else return;
    event.preventDefault();
  });
};

// Which of the two is seen, and from where.
export const makeViews = (run, replay) => {
  const tabs = [];
  const show = (picture, tab) => {
    if (run.frames) at("picture").hidden = !picture;
    at("replay").style.visibility = picture ? "hidden" : "";
    at("hint").hidden = at("label").hidden = picture;
    for (const scale of document.querySelectorAll("#tension, #pressure")) scale.hidden = picture;
    for (const other of tabs) other.classList.toggle("on", other === tab);
  };
  const addTab = (text, title, action) => {
    const tab = button(text, title, () => { action(); });
    tabs.push(tab);
    at("views").append(tab);
    return tab;
  };
  if (replay) {
    const views = [["3-D", "scene", run.camera ? "From the scene's camera" : "All bodies"],
                   ["Side", "side", "From −y"], ["Front", "front", "From +x"], ["Top", "top", "From above"]];
    for (const [text, view, title] of views) {
      const tab = addTab(text, title, () => { show(false, tab); replay.look(view); });
    }
  }
  if (run.frames) {
    const tab = addTab("Pictures", "The pictures of the run", () => show(true, tab));
    if (!replay) show(true, tab);
  }
  tabs[0]?.classList.add("on");
};

export const makeToggles = (replay) => {
  const toggle = (text, on, change) => {
    const box = element("input", {type: "checkbox", checked: on, onchange: () => change(box.checked)});
    at("toggles").append(element("label", {}, box, text));
  };
  toggle("follow", replay.following, (on) => replay.follow(on));
  if (replay.water) toggle("water", true, (on) => { replay.water.group.visible = on; replay.wake(); });
  if (replay.riggings.length > 0)
    toggle("rigging", true, (on) => { replay.rigging.visible = on; replay.wake(); });
  if (replay.pressure) {
    const bar = pressureBar(replay.run.pressure);
    at("view").append(bar);
    toggle("pressure", true, (on) => { replay.pressure.group.visible = on; bar.style.display = on ? "" : "none"; replay.wake(); });
  }
  toggle("path", true, (on) => { replay.path.visible = on; replay.wake(); });
  toggle("axes", true, (on) => { replay.axes.visible = on; replay.wake(); });
};
