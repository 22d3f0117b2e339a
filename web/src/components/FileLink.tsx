// Link to a file that the program makes.
import type { ComponentChildren } from 'preact';
import { transport } from '../api/client';
import { address } from '../api/http';
import { sayError } from '../state/notices';
import { download } from './download';

/** `path` below /api. A program within the page has no addresses: the file is made on a click. */
export function FileLink({ path, name, title, children }: { path: string; name: string; title?: string; children: ComponentChildren }) {
  if (!transport.local) return <a class="button" href={address(path)} download={name} title={title}>{children}</a>;
  const save = (): void => { transport.file(path).then((file) => download(name, file)).catch(sayError); };
  return <button type="button" class="button" title={title} onClick={save}>{children}</button>;
}
