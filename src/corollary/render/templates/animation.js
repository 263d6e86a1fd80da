"use strict";
// A film of an exercise's motion: places between two frames by the cubic that has their velocities.
function animate(figure) {
  const reel = JSON.parse(figure.querySelector(".reel").textContent), times = reel.t, end = times[times.length - 1];
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  const button = figure.querySelector(".play"), scrub = figure.querySelector(".scrub"), clock = figure.querySelector(".clock");
  const drawn = [...figure.querySelectorAll(".body")], ropes = [...figure.querySelectorAll(".ropes line")];
  const comma = /^(de|nb)/.test(document.documentElement.lang), playing = button.textContent, SECONDS = 5, JUMPS = 8;
  let now = 0, running = 0, last = 0;

  const text = value => {
    const digits = Math.abs(value) < 1e-9 * Math.max(reel.mostE, reel.mostP) ? "0" : String(Number(value.toPrecision(3)));
    return (comma ? digits.replace(".", ",") : digits).replace("-", "−");
  };
  function moment(time) {
    let low = 0, high = times.length - 1;
    while (high - low > 1) { const middle = (low + high) >> 1; if (times[middle] <= time) low = middle; else high = middle; }
    const span = times[high] - times[low], part = span ? Math.min(1, Math.max(0, (time - times[low]) / span)) : 0;
    return {low, high, span, part};
  }
  function body(each, {low, high, span, part: s}) {
    const mix = (a, b) => a + s * (b - a), flip = [1, -1], place = [0, 1].map(axis => {
      const a = each.p[low][axis], b = each.p[high][axis];
      const u = flip[axis] * each.v[low][axis] * span * reel.scale, w = flip[axis] * each.v[high][axis] * span * reel.scale;
      return (1 + 2 * s) * (1 - s) ** 2 * a + s * (1 - s) ** 2 * u + s * s * (3 - 2 * s) * b + s * s * (s - 1) * w;
    });
    return {place, velocity: [0, 1].map(axis => mix(each.v[low][axis], each.v[high][axis]))};
  }
  function arrow(path, x, y, aside) {
    const length = Math.hypot(x, y);
    if (length < 2) return path.setAttribute("d", "");
    const [c, s] = [x / length, y / length], head = Math.min(9, length), [ox, oy] = [-s * aside, c * aside];
    const at = (along, off) => `${(ox + c * along - s * off).toFixed(1)} ${(oy + s * along + c * off).toFixed(1)}`;
    path.setAttribute("d", `M${at(0, 0)}L${at(length, 0)}M${at(length - head, head / 2)}L${at(length, 0)}L${at(length - head, -head / 2)}`);
  }
  function show(time) {
    now = Math.min(end, Math.max(0, time));
    const at = moment(now), total = {x: 0, y: 0, kinetic: 0, stored: 0}, spots = [];
    reel.bodies.forEach((each, i) => {
      const {place, velocity: [vx, vy]} = body(each, at), group = drawn[i];
      spots.push(place);
      group.setAttribute("transform", `translate(${place[0].toFixed(2)} ${place[1].toFixed(2)})`);
      arrow(group.querySelector(".velocity"), vx * reel.perV, -vy * reel.perV, each.m === null ? 0 : -3);
      if (each.m === null) return;
      arrow(group.querySelector(".momentum"), each.m * vx * reel.perP, -each.m * vy * reel.perP, 3);
      total.x += each.m * vx; total.y += each.m * vy; total.kinetic += each.m * (vx * vx + vy * vy) / 2;
    });
    ropes.forEach((line, i) => {
      const [x, y] = spots[reel.ropes[i][2]];
      line.setAttribute("x2", x.toFixed(1)); line.setAttribute("y2", y.toFixed(1));
    });
    if (reel.stored) total.stored = reel.stored[at.low] + at.part * (reel.stored[at.high] - reel.stored[at.low]);
    total.energy = total.kinetic + total.stored;
    for (const bar of figure.querySelectorAll("[data-total]")) {
      const value = total[bar.dataset.total];
      const share = Math.max(-1, Math.min(1, value / (bar.classList.contains("signed") ? 2 * reel.mostP : reel.mostE)));
      bar.style.width = `${(100 * Math.abs(share)).toFixed(1)}%`;
      if (bar.classList.contains("signed")) bar.style.marginLeft = `${(50 + Math.min(0, 100 * share)).toFixed(1)}%`;
    }
    for (const cell of figure.querySelectorAll("[data-value]")) cell.textContent = text(total[cell.dataset.value]);
    scrub.value = String(Math.round(1000 * now / end));
    clock.textContent = `${text(now)} s`;
    scrub.setAttribute("aria-valuetext", clock.textContent);
  }
  function stop() { cancelAnimationFrame(running); clearTimeout(running); running = 0; button.textContent = playing; }
  function step(at) {
    const pace = Number(figure.querySelector(".pace").value);
    show(now + (last ? (at - last) / 1000 : 0) * pace * end / SECONDS);
    last = at;
    if (now >= end || !figure.isConnected) return stop();
    running = requestAnimationFrame(step);
  }
  function jump() { // for whom motion is too much: one still after another
    show(now + end / JUMPS);
    if (now >= end || !figure.isConnected) return stop();
    running = setTimeout(jump, 900);
  }
  button.addEventListener("click", () => {
    if (running) return stop();
    if (now >= end) show(0);
    last = 0;
    button.textContent = button.dataset.pause;
    running = still.matches ? setTimeout(jump, 900) : requestAnimationFrame(step);
  });
  scrub.addEventListener("input", () => { stop(); show(end * Number(scrub.value) / 1000); });
  for (const what of ["velocity", "momentum"]) figure.querySelector(`.show-${what}`).addEventListener("change", event => figure.classList.toggle(`no-${what}`, !event.target.checked));
  show(0);
}
