// Account of an import: data translated, approximated and left out.
import { dialog } from '../state/look';
import { imported } from '../state/openFiles';
import { Dialog } from './Dialog';

function Group({ title, lines }: { title: string; lines: readonly string[] }) {
  if (lines.length === 0) return null;
  return <><h3>{title}</h3><ul>{lines.map((line) => <li key={line}>{line}</li>)}</ul></>;
}

export function ImportDialog() {
  const done = imported.value;
  const close = (): void => { dialog.value = null; };
  if (!done) return null;
  const { translated, approximated, left_out: leftOut } = done.account;
  const texts = (matters: boolean): string[] => leftOut.filter((x) => x.matters === matters).map((x) => x.text);
  return (
    <Dialog title={`Imported from ${done.name}`} close={close} wide>
      <p>The model is new and not saved. It refers to the files that were given, which are in its folder now.</p>
      <div class="account">
        <Group title="Left out, and it matters" lines={texts(true)} />
        <Group title="Approximated" lines={approximated} />
        <Group title="Translated" lines={translated} />
        <Group title="Left out; loads and motions do not depend on it" lines={texts(false)} />
      </div>
      <footer><button type="button" class="main" onClick={close}>Close</button></footer>
    </Dialog>
  );
}
