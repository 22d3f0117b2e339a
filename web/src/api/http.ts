// The program over HTTP, with the access token of its present start.
import type { Listeners, Transport } from './transport';

let token = typeof location === 'undefined' ? '' : new URLSearchParams(location.search).get('token') ?? '';
export const currentToken = (): string => token;
export const setToken = (given: string): void => { token = given; };

export function address(path: string): string {
  return `/api/${path}${path.includes('?') ? '&' : '?'}token=${encodeURIComponent(token)}`;
}

export const http: Transport = {
  local: false,

  async request(method, path, body) {
    const headers = { 'X-Overbend-Token': token, ...(body === undefined ? {} : { 'Content-Type': 'application/json' }) };
    const answer = await fetch(`/api/${path}`, { method, headers, ...(body === undefined ? {} : { body }) });
    return { status: answer.status, text: await answer.text() };
  },

  async file(path) {
    return (await fetch(address(path))).blob();
  },

  /** Server-sent events; the browser reconnects by itself after an interruption. */
  listen(on: Listeners, state) {
    const source = new EventSource(address('events'));
    source.onopen = () => state(true);
    source.onerror = () => state(false);
    for (const [name, act] of Object.entries(on)) {
      source.addEventListener(name, (event) => act(JSON.parse((event as MessageEvent<string>).data) as never));
    }
    return () => source.close();
  },
};
