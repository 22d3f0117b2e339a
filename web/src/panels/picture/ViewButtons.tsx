// Buttons of the views: 3-D views, and drawings in elevation, section and plan.
import { shownDrawings, shownViews, type ViewName } from '../../logic/views';
import { mode } from '../../state/picture';
import { calmLay } from '../../state/shown';

const titles = {
  side: 'Drawing from the side; roller boxes can be dragged',
  section: 'Section across the pipe, at the selected box or at the cursor',
  plan: 'Plan, north up',
} as const;

interface Props { ready: boolean; go: (name: ViewName) => void }

const keyHint = (key: string): string => (key ? ` (key ${key} in the picture)` : '');

export function ViewButtons({ ready, go }: Props) {
  const lay = calmLay.value, known = lay !== null;
  const show = (name: ViewName): void => { mode.value = '3d'; go(name); };
  return (
    <div class="viewbuttons" role="toolbar" aria-label="Views" data-clear>
      {shownViews(lay).map(([name, key]) => (
        <button key={name} type="button" title={`View: ${name}${keyHint(key)}`} disabled={!ready || !known} onClick={() => show(name)}>{name}</button>
      ))}
      {shownDrawings(lay).map(([name, key]) => (
        <button
          key={name}
          type="button"
          aria-pressed={mode.value === name}
          title={`${titles[name]}${keyHint(key)}`}
          disabled={!known}
          onClick={() => { mode.value = mode.value === name ? '3d' : name; }}
        >
          {name}
        </button>
      ))}
    </div>
  );
}

/** Keys 1 to 9 in the picture. */
export function viewKey(key: string, go: (name: ViewName) => void): void {
  const lay = calmLay.value;
  const view = shownViews(lay).find((v) => v[1] === key), drawing = shownDrawings(lay).find((v) => v[1] !== '' && v[1] === key);
  if (view) { mode.value = '3d'; go(view[0]); } else if (drawing) mode.value = drawing[0];
}
