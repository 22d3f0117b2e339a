// A minimal document to draw components without a browser.
import { render, type ComponentChild } from 'preact';

type Listener = (this: LightNode, event: { type: string }) => void;

export class LightNode {
  childNodes: LightNode[] = [];
  parentNode: LightNode | null = null;
  attributes: { name: string; value: string }[] = [];
  style: Record<string, string> = {};
  data = '';
  onclick: Listener | null = null;
  private listeners: Record<string, Listener> = {};

  constructor(readonly nodeType: number, readonly localName: string) {}

  get firstChild(): LightNode | null {
    return this.childNodes[0] ?? null;
  }

  get nextSibling(): LightNode | null {
    const all = this.parentNode?.childNodes ?? [];
    return all[all.indexOf(this) + 1] ?? null;
  }

  insertBefore(child: LightNode, before: LightNode | null): LightNode {
    child.remove();
    const place = before ? this.childNodes.indexOf(before) : this.childNodes.length;
    this.childNodes.splice(place, 0, child);
    child.parentNode = this;
    return child;
  }

  appendChild(child: LightNode): LightNode {
    return this.insertBefore(child, null);
  }

  removeChild(child: LightNode): void {
    child.remove();
  }

  remove(): void {
    if (this.parentNode) this.parentNode.childNodes = this.parentNode.childNodes.filter((child) => child !== this);
    this.parentNode = null;
  }

  setAttribute(name: string, value: string): void {
    this.removeAttribute(name);
    this.attributes.push({ name, value });
  }

  removeAttribute(name: string): void {
    this.attributes = this.attributes.filter((attribute) => attribute.name !== name);
  }

  addEventListener(type: string, listener: Listener): void {
    this.listeners[type] = listener;
  }

  click(): void {
    this.listeners['click']!.call(this, { type: 'click' });
  }

  attribute(name: string): string | undefined {
    return this.attributes.find((attribute) => attribute.name === name)?.value;
  }

  get text(): string {
    return this.nodeType === 3 ? this.data : this.childNodes.map((child) => child.text).join('');
  }

  /** Elements below this one with a name, "td" or "td.over", in order. */
  all(selector: string): LightNode[] {
    const [name, look] = selector.split('.');
    const fits = (node: LightNode): boolean =>
      (!name || node.localName === name) && (!look || (node.attribute('class') ?? '').split(' ').includes(look));
    return this.childNodes.flatMap((child) => [...(fits(child) ? [child] : []), ...child.all(selector)]);
  }

  get html(): string {
    if (this.nodeType === 3) return this.data;
    const attributes = this.attributes.map(({ name, value }) => ` ${name}="${value}"`).join('');
    const content = this.childNodes.map((child) => child.html).join('');
    return this.localName === 'root' ? content : `<${this.localName}${attributes}>${content}</${this.localName}>`;
  }
}

const lightDocument = {
  createElementNS: (_space: string, name: string) => new LightNode(1, name),
  createElement: (name: string) => new LightNode(1, name),
  createTextNode: (text: string) => Object.assign(new LightNode(3, '#text'), { data: text }),
};

/** Draws into a separate root, which further drawings change. */
export function drawn(content: ComponentChild): LightNode {
  Object.assign(globalThis, { document: lightDocument });
  const root = new LightNode(1, 'root');
  render(content, root as unknown as HTMLElement);
  return root;
}
