// The pictures of the run, as a strip that plays along and one at a time.
import {rowAt} from "./data.js";
import {element, number} from "./format.js";

export class Strip {
  constructor(frames, clock, host, picture) {
    this.frames = frames;
    this.clock = clock;
    this.picture = picture;
    this.host = host;
    this.sources = frames.images.map((image) => `data:image/png;base64,${image}`);
    this.items = this.sources.map((src, i) => {
      const item = element("button", {type: "button", title: `${number(frames.times[i])} s`,
                                      onclick: () => { clock.play(false); clock.seek(frames.times[i]); }},
        element("img", {src, alt: "", loading: "lazy"}),
        element("span", {textContent: `${number(frames.times[i], 3)} s`}));
      host.append(item);
      return item;
    });
    host.hidden = false;
    clock.onChange(() => this.update());
    this.update();
  }

  update() {
    const now = rowAt(this.frames.times, this.clock.time + 1e-9);
    if (now === this.now) return;
    this.items[this.now]?.classList.remove("now");
    this.now = now;
    const item = this.items[now];
    item.classList.add("now");
    this.picture.src = this.sources[now];
    const middle = item.offsetLeft + item.offsetWidth / 2 - this.host.clientWidth / 2;
    this.host.scrollTo({left: middle, behavior: "smooth"});
  }
}
