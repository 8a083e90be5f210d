// The time that everything on the page shows.

export class Clock {
  constructor(start, end) {
    this.start = start;
    this.end = end;
    this.time = start;
    this.speed = 1;
    this.playing = false;
    this.listeners = [];
  }

  onChange(listener) { this.listeners.push(listener); }
  tell() { for (const listener of this.listeners) listener(this); }

  seek(time) {
    const t = Math.min(Math.max(time, this.start), this.end);
    if (t === this.time) return;
    this.time = t;
    this.tell();
  }

  play(on) {
    if (on === this.playing) return;
    this.playing = on;
    if (on && this.time >= this.end) this.time = this.start;
    if (on) this.run();
    this.tell();
  }

  run() {
    let last;
    const frame = (now) => {
      if (!this.playing) return;
      const passed = last === undefined ? 0 : (now - last) / 1000;
      last = now;
      this.time = Math.min(this.time + passed * this.speed, this.end);
      if (this.time >= this.end) this.playing = false;
      this.tell();
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }
}
