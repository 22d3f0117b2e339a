// Ruler, and export of the picture to the clipboard or to a file.
import type { RefObject } from 'preact';
import { download } from '../../components/download';
import { fixedIn, text, unitName } from '../../logic/show';
import { fileName, title } from '../../state/model';
import { say, sayError } from '../../state/notices';
import { measured, ruler } from '../../state/picture';
import type { View3D } from '../../view/view3d';
import { snapshot } from './snapshot';

interface Props { box: RefObject<HTMLElement>; view: RefObject<View3D | null> }

const nameOfFile = (): string => `${(fileName.value || title.value).replace(/\.ya?ml$/, '').replace(/[^\w.-]+/g, '-') || 'picture'}.png`;

async function save({ box, view }: Props): Promise<void> {
  try { download(nameOfFile(), await snapshot(box.current!, view.current)); } catch (error) { sayError(error); }
}

async function copy({ box, view }: Props): Promise<void> {
  try {
    // the browser requires the content type at the click
    await navigator.clipboard.write([new ClipboardItem({ 'image/png': snapshot(box.current!, view.current) })]);
    say('Picture copied');
  } catch { say('The browser does not support copying pictures: save the picture instead'); }
}

function Reading() {
  const points = ruler.value, m = measured.value;
  if (!points) return null;
  if (!m) return <p class="measured" role="status" data-clear>{points.length === 0 ? 'Click the first point' : 'Click the second point'}, Esc ends</p>;
  const part = (name: string, value: number, hint: string) => <span title={hint}>{name} {fixedIn(value, 'm', 2)}</span>;
  return (
    <p class="measured" role="status" data-clear>
      <b>{text(m.distance, 'm', 5)}</b> {part('dx', m.astern, 'Astern positive')} {part('dy', m.port, 'To port positive')}
      {' '}{m.up === null ? null : part('dz', m.up, 'Upwards positive')} {unitName('m')}
    </p>
  );
}

export function Tools(props: Props) {
  const on = ruler.value !== null;
  return (
    <div class="picturetools" data-clear>
      <Reading />
      <button type="button" aria-pressed={on} title="Measure between two clicks" onClick={() => { ruler.value = on ? null : []; }}>ruler</button>
      <button type="button" title="Copy the picture to the clipboard" onClick={() => void copy(props)}>copy</button>
      <button type="button" title="Save the picture as PNG" onClick={() => void save(props)}>PNG</button>
    </div>
  );
}
