// SPDX-License-Identifier: BSD-3-Clause
// A script that looks at a page as its reader does, and writes what is wrong into it.
#pragma once

namespace assay::drivers {

/// Lines of <pre id="probe">: labels of an SVG that overlap or leave it, texts under 9 CSS pixels or with a contrast
/// under 4.5 (WCAG 2) to what is behind them, a body that scrolls sideways; "texts N" and "done" at the end.
inline constexpr const char* page_probe = R"html(<script>
(() => {
  const found = [], named = e => e.textContent.trim().replace(/\s+/g, ' ').slice(0, 60);
  const numbers = c => (c.match(/[\d.]+/g) || []).map(Number);
  const luminance = c => { const [r, g, b] = c.slice(0, 3).map(v => { v /= 255;
    return v <= .04045 ? v / 12.92 : ((v + .055) / 1.055) ** 2.4; }); return .2126 * r + .7152 * g + .0722 * b; };
  const behind = e => { for (; e; e = e.parentElement) { const c = numbers(getComputedStyle(e).backgroundColor);
    if (c.length === 3 || c[3] > .99) return c; } return [255, 255, 255]; };
  let texts = 0;
  for (const svg of document.querySelectorAll('svg')) {
    const frame = svg.getBoundingClientRect(), scale = frame.width / svg.viewBox.baseVal.width, seen = [];
    for (const text of svg.querySelectorAll('text')) {
      const box = text.getBoundingClientRect();
      for (const part of [text, ...text.querySelectorAll('tspan')]) {
        const size = parseFloat(getComputedStyle(part).fontSize) * scale;
        if (size < 9) found.push('small: ' + named(part) + ' of ' + named(text) + ' ' + size.toFixed(1));
      }
      if (box.left < frame.left - .5 || box.right > frame.right + .5 || box.top < frame.top - .5 ||
          box.bottom > frame.bottom + .5) found.push('outside: ' + named(text));
      for (const [other, b] of seen) {
        const across = Math.min(box.right, b.right) - Math.max(box.left, b.left);
        const down = Math.min(box.bottom, b.bottom) - Math.max(box.top, b.top);
        if (across > 1 && down > 1) found.push('overlap: ' + named(text) + ' on ' + named(other));
      }
      seen.push([text, box]);
    }
  }
  for (const e of document.querySelectorAll('body *')) {
    if (e.closest('script, title, defs') || e.tagName === 'tspan') continue;
    if (![...e.childNodes].some(n => n.nodeType === 3 && n.data.trim()) && e.tagName !== 'text') continue;
    const style = getComputedStyle(e), drawn = e.tagName === 'text';
    const a = luminance(numbers(drawn ? style.fill : style.color)), b = luminance(behind(e));
    const contrast = (Math.max(a, b) + .05) / (Math.min(a, b) + .05);
    if (contrast < 4.5) found.push('faint: ' + named(e) + ' ' + contrast.toFixed(2));
    if (!drawn && parseFloat(style.fontSize) < 9) found.push('small: ' + named(e) + ' ' + style.fontSize);
    ++texts;
  }
  const root = document.documentElement;
  if (root.scrollWidth > root.clientWidth) found.push('sideways: ' + root.scrollWidth + ' in ' + root.clientWidth);
  const pre = document.createElement('pre');
  pre.id = 'probe';
  const dark = matchMedia('(prefers-color-scheme: dark)').matches ? ' dark' : ' light';
  pre.textContent = '\n' + [...found, 'texts ' + texts, 'done ' + innerWidth + dark].join('\n') + '\n';
  document.body.append(pre);
})();
</script>)html";

}  // namespace assay::drivers
