// Contrast of text against its background.
import type { Page } from 'playwright-core';

/** Texts with a contrast below 4.5, each with its location. Disabled controls and text over pictures are left out. */
export function faint(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    type Colour = [number, number, number, number];
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = 1;
    const context = canvas.getContext('2d', { willReadFrequently: true })!;
    const known = new Map<string, Colour>();
    /** Red, green and blue (0 to 255) and opacity of any colour that the browser writes. */
    const read = (css: string): Colour => {
      let colour = known.get(css);
      if (!colour) {
        context.clearRect(0, 0, 1, 1);
        context.fillStyle = css;
        context.fillRect(0, 0, 1, 1);
        const [r, g, b, a] = context.getImageData(0, 0, 1, 1).data;
        colour = [r!, g!, b!, a! / 255];
        known.set(css, colour);
      }
      return colour;
    };
    const over = (top: Colour, below: Colour): Colour => {
      const mix = (i: 0 | 1 | 2): number => top[i] * top[3] + below[i] * (1 - top[3]);
      return [mix(0), mix(1), mix(2), 1];
    };
    const luminance = (c: Colour): number => {
      const linear = (v: number): number => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4);
      return 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
    };
    const chain = (el: Element): Element[] => { const out: Element[] = []; for (let ancestor: Element | null = el; ancestor; ancestor = ancestor.parentElement) out.push(ancestor); return out; };
    /** Null for text that is only visible under the pointer. */
    const contrast = (el: Element, css: string): number | null => {
      const above = chain(el);
      let behind: Colour = [255, 255, 255, 1];
      for (const layer of [...above].reverse()) behind = over(read(getComputedStyle(layer).backgroundColor), behind);
      const colour = read(css), opacity = above.reduce((sum, layer) => sum * Number(getComputedStyle(layer).opacity), colour[3]);
      if (opacity === 0) return null;
      const [light, dark] = [luminance(over([colour[0], colour[1], colour[2], opacity], behind)), luminance(behind)].sort((a, b) => b - a) as [number, number];
      return (light + 0.05) / (dark + 0.05);
    };
    const seen = (el: Element, r: DOMRect): boolean => r.width > 1 && r.height > 1 && getComputedStyle(el).visibility === 'visible'
      && el.closest('canvas, svg, .labels3d, .hidden, :disabled, .cm-editor, .u-wrap, [aria-hidden=true]') === null;
    const out = new Set<string>();
    const judge = (el: Element, css: string, text: string): void => {
      const ratio = contrast(el, css);
      if (ratio !== null && ratio < 4.495) out.add(`${ratio.toFixed(2)} "${text.trim().slice(0, 30)}" in ${chain(el).slice(0, 3).map((ancestor) => `${ancestor.tagName.toLowerCase()}.${ancestor.getAttribute('class') ?? ''}`).join(' < ')}`);
    };
    const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), range = document.createRange();
    for (let node = texts.nextNode(); node; node = texts.nextNode()) {
      const el = node.parentElement!;
      if (!node.textContent!.trim() || /^(SCRIPT|STYLE|OPTION)$/.test(el.tagName)) continue;
      range.selectNodeContents(node);
      if (seen(el, range.getBoundingClientRect())) judge(el, getComputedStyle(el).color, node.textContent!);
    }
    for (const field of document.querySelectorAll<HTMLInputElement>('input:not([type=range], [type=checkbox], [type=file]), select, textarea')) {
      if (!seen(field, field.getBoundingClientRect())) continue;
      const empty = field.value === '' && field.placeholder;
      judge(field, getComputedStyle(field, empty ? '::placeholder' : null).color, field.value || field.placeholder || field.id);
    }
    return [...out];
  });
}
