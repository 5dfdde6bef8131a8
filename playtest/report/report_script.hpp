/// What moves on the page: the last ten seconds of each incident, played on the level's plan, and links that lead to
/// the replays within the page. Without a script the page has the still pictures, and the replays below them.
#pragma once

#include <string_view>

namespace surefoot::playtest {

inline constexpr std::string_view page_script = R"(<script>
'use strict';
(() => {
const wide = 480, high = 210, profile = 70;
const mix = (a, b, share) => a + (b - a) * share;
const turn = (a, b, share) => a + (((b - a) % 360 + 540) % 360 - 180) * share;

// A link to a replay hands over the one that the page holds.
for (const link of document.querySelectorAll('a[data-run]'))
  link.addEventListener('click', event => {
    const run = document.getElementById(link.dataset.run);
    if (run) { event.preventDefault(); run.click(); }
  });

const plans = {};
const planOf = name => {
  if (!plans[name]) {
    const style = getComputedStyle(document.querySelector('.' + name));
    plans[name] = new Image();
    plans[name].src = style.backgroundImage.slice(5, -2);
  }
  return plans[name];
};

// Four numbers a sample, x, y, z in centimetres and an angle in degrees; between samples it goes on evenly, unless it
// was put somewhere else.
const sample = (list, at) => {
  const last = list.length / 4 - 1;
  const i = Math.min(Math.floor(at), last), k = Math.min(i + 1, last);
  const a = list.slice(4 * i, 4 * i + 4), b = list.slice(4 * k, 4 * k + 4);
  const share = Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) > 400 ? 0 : Math.min(at - i, 1);
  return {x: mix(a[0], b[0], share) / 100, y: mix(a[1], b[1], share) / 100, z: mix(a[2], b[2], share) / 100,
          angle: turn(a[3], b[3], share)};
};

for (const box of document.querySelectorAll('.clip')) {
  const clip = JSON.parse(box.dataset.clip), home = box.closest('.incidents').dataset;
  const count = clip.p.length / 4;
  if (count < 2) continue;
  const all = Array.from({length: count}, (_, i) => sample(clip.p, i));
  const span = axis => [Math.min(...all.map(p => p[axis])), Math.max(...all.map(p => p[axis]))];
  const [west, east] = span('x'), [north, south] = span('z'), [low, top] = span('y');
  const zoom = Math.min(24, wide / (east - west + 8), high / (south - north + 8));
  const x = p => (p.x - (west + east) / 2) * zoom + wide / 2;
  const y = p => (p.z - (north + south) / 2) * zoom + high / 2;
  const up = height => high + profile - 12 - (height - low) / Math.max(2, top - low) * (profile - 26);

  const canvas = document.createElement('canvas'), bar = document.createElement('div');
  canvas.width = wide;
  canvas.height = high + profile;
  const button = document.createElement('button'), slider = document.createElement('input');
  const clock = document.createElement('span');
  button.textContent = 'Play';
  Object.assign(slider, {type: 'range', min: 0, max: count - 1, step: 'any', value: count - 1});
  slider.setAttribute('aria-label', 'the last seconds');
  bar.className = 'bar';
  bar.append(button, slider, clock);
  const pen = canvas.getContext('2d'), plan = planOf(home.plan);

  const line = (from, to, colour, place) => {
    pen.strokeStyle = colour;
    pen.lineWidth = 2;
    pen.beginPath();
    for (let i = from; i <= to; ++i) {
      const p = all[i], before = all[Math.max(i - 1, 0)];
      const isPut = Math.hypot(p.x - before.x, p.y - before.y, p.z - before.z) > 4;
      if (i === from || isPut) pen.moveTo(...place(p, i)); else pen.lineTo(...place(p, i));
    }
    pen.stroke();
  };
  const draw = () => {
    const at = Number(slider.value), hero = sample(clip.p, at), now = Math.floor(at);
    pen.fillStyle = '#dfe5ea';
    pen.fillRect(0, 0, wide, high + profile);
    pen.save();
    pen.beginPath();
    pen.rect(0, 0, wide, high);
    pen.clip();
    const scale = zoom / home.scale;
    if (plan.complete && plan.width > 0)
      pen.drawImage(plan, x({x: Number(home.west)}), y({z: Number(home.north)}), plan.width * scale,
                    plan.height * scale);
    for (const mover of clip.m) {
      const p = sample(mover.p, at / mover.n);
      if (p.y < -9000) continue;
      pen.save();
      pen.translate(x(p), y(p));
      pen.rotate(-p.angle * Math.PI / 180);
      pen.fillStyle = mover.e ? 'rgba(201,47,69,.9)' : 'rgba(70,90,190,.45)';
      pen.strokeStyle = '#fff';
      pen.lineWidth = 1;
      pen.beginPath();
      if (mover.e) pen.arc(0, 0, Math.max(4, mover.w * zoom), 0, 7);
      else pen.rect(-mover.w * zoom, -mover.d * zoom, 2 * mover.w * zoom, 2 * mover.d * zoom);
      pen.fill();
      pen.stroke();
      pen.restore();
    }
    line(0, count - 1, 'rgba(10,88,202,.25)', p => [x(p), y(p)]);
    line(0, now, '#0a58ca', p => [x(p), y(p)]);
    const look = hero.angle * Math.PI / 180;
    pen.fillStyle = 'rgba(238,127,48,.35)';
    pen.beginPath();
    pen.moveTo(x(hero), y(hero));
    pen.arc(x(hero), y(hero), 26, -look - Math.PI / 2 - .5, -look - Math.PI / 2 + .5);
    pen.fill();
    pen.fillStyle = '#ee7f30';
    pen.strokeStyle = '#fff';
    pen.beginPath();
    pen.arc(x(hero), y(hero), Math.max(5, .35 * zoom), 0, 7);
    pen.fill();
    pen.stroke();
    pen.restore();
    // How high the feet are, over time.
    const along = i => 40 + i / (count - 1) * (wide - 50);
    pen.fillStyle = '#f4f4f0';
    pen.fillRect(0, high, wide, profile);
    pen.fillStyle = '#555';
    pen.font = '11px system-ui,sans-serif';
    pen.fillText(top.toFixed(1) + ' m', 2, up(top) + 4);
    if (up(low) - up(top) > 12) pen.fillText(low.toFixed(1) + ' m', 2, up(low) + 4);
    line(0, count - 1, 'rgba(10,88,202,.25)', (p, i) => [along(i), up(p.y)]);
    line(0, now, '#0a58ca', (p, i) => [along(i), up(p.y)]);
    pen.fillStyle = '#ee7f30';
    pen.beginPath();
    pen.arc(along(at), up(hero.y), 4, 0, 7);
    pen.fill();
    clock.textContent = (clip.t + at * clip.dt).toFixed(1) + ' s';
  };
  let began = 0, from = 0, plays = false;
  const go = time => {
    if (!plays) return;
    began = began || time;
    const at = from + (time - began) / 1000 / clip.dt;
    slider.value = at;
    draw();
    if (at < count - 1) requestAnimationFrame(go); else stop();
  };
  const stop = () => { plays = false; button.textContent = 'Play'; };
  button.addEventListener('click', () => {
    if (plays) { stop(); return; }
    plays = true;
    button.textContent = 'Pause';
    began = 0;
    from = Number(slider.value) >= count - 1 ? 0 : Number(slider.value);
    requestAnimationFrame(go);
  });
  slider.addEventListener('input', () => { stop(); draw(); });
  plan.addEventListener('load', draw);
  box.replaceChildren(canvas, bar);
  draw();
}
})();
</script>
)";

}  // namespace surefoot::playtest
